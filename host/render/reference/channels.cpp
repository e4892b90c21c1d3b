#include "host/render/reference/channels.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "host/render/frame/kernel_layout.hpp"
#include "host/render/frame/raster_grid.hpp"
#include "host/render/reference/areas.hpp"

namespace morphcl::reference {

namespace {

static_assert(crypto_ranks == CRYPTO_RANKS);

// A vertex's share of a place in its primitive, for each of the mesh's three; of lines the third has none.
struct Shares {
  std::array<float, 3> of_vertex;

  float mean(float a, float b, float c) const {
    return std::fma(of_vertex[0], a, std::fma(of_vertex[1], b, of_vertex[2] * c));
  }
  template <class Vector>
  glm::vec3 mean(const Vector& a, const Vector& b, const Vector& c) const {
    return {mean(a[0], b[0], c[0]), mean(a[1], b[1], c[1]), mean(a[2], b[2], c[2])};
  }
};

struct PlaceInPrimitive {
  Shares shares;
  float distance;  // along the view axis
  bool is_back;    // seen from behind
};

// What is left of a line to its other end, and to this one, along its longer axis.
Areas lengths_at(const ScreenVertex corner[3], int px, int py) {
  const ScreenVertex &a = corner[0], &b = corner[1];
  const bool steep = std::abs(b.corner_y() - a.corner_y()) > std::abs(b.corner_x() - a.corner_x());
  const std::int64_t at = std::int64_t{steep ? py : px} * layout::corner_units;
  return {{static_cast<float>((steep ? b.corner_y() : b.corner_x()) - at),
           static_cast<float>(at - (steep ? a.corner_y() : a.corner_x())), 0.0f}};
}

PlaceInPrimitive place_in_primitive(const FramePlan& plan, const Visibility& visible, const Sample& sample,
                                    const std::array<const Vertex*, 3>& vertex, int x, int y) {
  const Draw& draw = plan.draws[sample.draw];
  const bool line = draw.shading == Shading::wireframe, is_cut = sample.piece != no_piece;
  ScreenVertex corner[3] = {vertex[0]->screen, vertex[1]->screen, vertex[2]->screen};
  if (is_cut) std::copy_n(visible.pieces[sample.piece].corner, 3, corner);
  if (line) corner[2] = ScreenVertex{};
  const int px = pixel_centre(x), py = pixel_centre(y);
  const Areas areas = within_triangle(draw, line ? lengths_at(corner, px, py) : areas_at(corner, px, py));
  float weight[3];
  for (int i = 0; i < 3; ++i)
    weight[i] = plan.camera.parallel ? areas.corner[i] : areas.corner[i] * corner[i].inverse_w;
  const float total = weight[0] + weight[1] + weight[2];
  PlaceInPrimitive place{};
  place.is_back = draw.mirrored ? total < 0.0f : total > 0.0f;
  Shares& shares = place.shares;
  shares = {{weight[0] / total, weight[1] / total, weight[2] / total}};
  if (plan.camera.parallel) {
    const float at = shares.mean(corner[0].depth, corner[1].depth, corner[2].depth);
    place.distance = is_forward(plan.depth_format) ? at : -at;
  } else {
    place.distance = (areas.corner[0] + areas.corner[1] + areas.corner[2]) / total;
  }
  if (is_cut) {
    const auto& of_corner = visible.pieces[sample.piece].weight;
    const Shares of_corners = shares;
    for (std::size_t v = 0; v < 3; ++v)
      shares.of_vertex[v] = of_corners.mean(of_corner[0][v], of_corner[1][v], of_corner[2][v]);
  }
  return place;
}

float length_of(const glm::vec3& v) { return std::sqrt(std::fma(v.x, v.x, std::fma(v.y, v.y, v.z * v.z))); }

glm::vec3 unit_in_world(const FramePlan& plan, glm::vec3 normal) {
  const float largest = std::max(std::fabs(normal.x), std::max(std::fabs(normal.y), std::fabs(normal.z)));
  const float scale = largest > 0.0f ? largest : 1.0f;
  for (int c = 0; c < 3; ++c) normal[c] /= scale;
  glm::vec3 world;
  for (int row = 0; row < 3; ++row) {
    const Row& m = plan.eye_to_world[static_cast<std::size_t>(row)];
    world[row] = row_times_vector({m[0], m[1], m[2]}, normal);
  }
  const float length = length_of(world), divisor = length > 0.0f ? length : 1.0f;
  return {world.x / divisor, world.y / divisor, world.z / divisor};
}

glm::vec3 world_normal(const FramePlan& plan, const Draw& draw, const std::array<const Vertex*, 3>& vertex,
                       const PlaceInPrimitive& place) {
  if (draw.normals == NormalSource::faces)
    return unit_in_world(plan,
                         face_of(plan, draw, vertex[0]->position, vertex[1]->position, vertex[2]->position).normal);
  const glm::vec3 normal = place.shares.mean(vertex[0]->normal, vertex[1]->normal, vertex[2]->normal);
  return unit_in_world(plan, draw.double_sided && place.is_back ? -normal : normal);
}

glm::vec3 world_position(const FramePlan& plan, float distance, int px, int py) {
  float across = std::fma(static_cast<float>(px) + 0.5f, plan.camera.ray[0], plan.camera.ray[1]);
  float up = std::fma(static_cast<float>(py) + 0.5f, plan.camera.ray[2], plan.camera.ray[3]);
  if (plan.camera.parallel) {
    across = std::fma(distance, plan.camera.slant[0], across);
    up = std::fma(distance, plan.camera.slant[1], up);
  } else {
    across *= distance;
    up *= distance;
  }
  glm::vec3 world;
  for (int row = 0; row < 3; ++row) world[row] = row_times_point(plan.eye_to_world[row], {across, up, -distance});
  return world;
}

// x, y and w of clip space.
glm::vec3 mean_clip_point(const Shares& shares, const ClipPoint& a, const ClipPoint& b, const ClipPoint& c) {
  return {shares.mean(a.x, b.x, c.x), shares.mean(a.y, b.y, c.y), shares.mean(a.w, b.w, c.w)};
}

// 0 where the place is behind the next eye, or a number is too large.
glm::vec2 velocity_of(const FramePlan& plan, const Shares& shares, const std::array<const Vertex*, 3>& vertex,
                      const std::array<const Vertex*, 3>& next_vertex) {
  const glm::vec3 now = mean_clip_point(shares, vertex[0]->clip, vertex[1]->clip, vertex[2]->clip),
                  next = mean_clip_point(shares, next_vertex[0]->clip, next_vertex[1]->clip, next_vertex[2]->clip);
  const float u = (next.x / next.z - now.x / now.z) * (static_cast<float>(plan.width) * 0.5f),
              v = (next.y / next.z - now.y / now.z) * (static_cast<float>(plan.height) * 0.5f);
  constexpr float max = std::numeric_limits<float>::max();
  if (!(next.z > 0.0f && std::fabs(u) <= max && std::fabs(v) <= max)) return {0.0f, 0.0f};
  return {u, v};
}

std::uint32_t bits_of_name(const Draw& draw, CryptoNames names) {
  return std::bit_cast<std::uint32_t>(names == CryptoNames::objects ? draw.crypto_object : draw.crypto_material);
}

struct NameInPixel {
  std::uint32_t bits, samples, first_draw;
};

}  // namespace

Centres::Centres(const FramePlan& plan, const std::vector<std::vector<Vertex>>& vertices,
                 const std::vector<std::vector<Vertex>>& next)
    : plan_(plan), vertices_(vertices), next_(next) {
  for (const Draw& draw : plan.draws)
    edges_.push_back(draw.shading == Shading::wireframe ? wireframe_edges(*draw.mesh) : std::vector<glm::uvec2>());
}

// Of a line the third is none.
std::array<std::uint32_t, 3> Centres::vertices_of(const Sample& sample) const {
  const Draw& draw = plan_.draws[sample.draw];
  if (draw.shading == Shading::wireframe) {
    const glm::uvec2 edge = edges_[sample.draw][sample.primitive];
    return {edge[0], edge[1], edge[1]};
  }
  const glm::uvec3 triangle = draw.mesh->triangles[sample.primitive];
  return {triangle[0], triangle[1], triangle[2]};
}

Centre Centres::at(const Visibility& visible, const Sample& sample, int x, int y) const {
  Centre centre;
  if (sample.order == no_order) return centre;
  const Draw& draw = plan_.draws[sample.draw];
  centre.object_id = draw.object_id;
  centre.material_id = draw.material_id;
  if (plan_.has(Channel::albedo))
    for (int c = 0; c < 3; ++c) centre.albedo[c] = draw.albedo[static_cast<std::size_t>(c)];
  constexpr ChannelSet of_places{Channel::normal, Channel::position, Channel::velocity, Channel::uv, Channel::albedo};
  if ((plan_.channels & of_places).empty()) return centre;

  const std::array<std::uint32_t, 3> index = vertices_of(sample);
  const auto of_primitive = [&](const std::vector<std::vector<Vertex>>& of_draws) {
    const std::vector<Vertex>& own = of_draws[sample.draw];
    return std::array<const Vertex*, 3>{&own[index[0]], &own[index[1]], &own[index[2]]};
  };
  const std::array<const Vertex*, 3> vertex = of_primitive(vertices_);
  const PlaceInPrimitive place = place_in_primitive(plan_, visible, sample, vertex, x, y);
  if (plan_.has(Channel::albedo) && draw.vertex_colors)
    centre.albedo *= place.shares.mean(vertex[0]->color, vertex[1]->color, vertex[2]->color);
  if (draw.normals != NormalSource::none) centre.normal = world_normal(plan_, draw, vertex, place);
  if (plan_.has(Channel::position)) centre.position = world_position(plan_, place.distance, x, y);
  if (draw.moves) centre.velocity = velocity_of(plan_, place.shares, vertex, of_primitive(next_));
  if (const std::vector<glm::vec2>& uvs = draw.mesh->uvs; plan_.has(Channel::uv) && !uvs.empty())
    for (int c = 0; c < 2; ++c) centre.uv[c] = place.shares.mean(uvs[index[0]][c], uvs[index[1]][c], uvs[index[2]][c]);
  return centre;
}

float coverage_of(std::span<const Sample> samples) {
  const auto covered =
      std::count_if(samples.begin(), samples.end(), [](const Sample& sample) { return sample.order != no_order; });
  return static_cast<float>(covered) * (1.0f / static_cast<float>(samples.size()));
}

CryptoRanks crypto_ranks_of(const FramePlan& plan, std::span<const Sample> samples, CryptoNames names) {
  std::vector<NameInPixel> found;
  for (const Sample& sample : samples) {
    if (sample.order == no_order) continue;
    const std::uint32_t bits = bits_of_name(plan.draws[sample.draw], names);
    const auto at =
        std::find_if(found.begin(), found.end(), [&](const NameInPixel& name) { return name.bits == bits; });
    if (at == found.end()) {
      found.push_back({bits, 1, sample.draw});
    } else {
      ++at->samples;
      at->first_draw = std::min(at->first_draw, sample.draw);
    }
  }
  std::sort(found.begin(), found.end(), [](const NameInPixel& a, const NameInPixel& b) {
    return a.samples != b.samples ? a.samples > b.samples : a.first_draw < b.first_draw;
  });
  CryptoRanks ranks{};
  for (std::size_t rank = 0; rank < std::min(found.size(), crypto_ranks); ++rank)
    ranks[rank] = {std::bit_cast<float>(found[rank].bits),
                   static_cast<float>(found[rank].samples) * (1.0f / static_cast<float>(samples.size()))};
  return ranks;
}

}  // namespace morphcl::reference
