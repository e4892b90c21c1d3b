#include "host/render/reference/visibility.hpp"

#include <algorithm>
#include <cmath>

#include "host/render/frame/kernel_layout.hpp"
#include "host/render/frame/raster_grid.hpp"
#include "host/render/reference/clip_polygon.hpp"
#include "host/render/reference/depth_plane.hpp"

namespace morphcl::reference {

namespace {

int first_pixel(int low) { return (low + layout::half_pixel - 1) >> layout::subpixel_bits; }
int last_pixel(int high) { return (high - layout::half_pixel) >> layout::subpixel_bits; }

class Rasterizer {
 public:
  Rasterizer(const FramePlan& plan, Visibility& visible) : plan_(plan), visible_(visible) {}

  // `identity` holds everything of the samples but their depth.
  void triangle(ScreenVertex a, ScreenVertex b, ScreenVertex c, bool double_sided, bool may_be_small,
                const Sample& identity) {
    std::int64_t area = std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
    if (area == 0 || (area < 0 && !double_sided)) return;
    if (area < 0) {
      std::swap(b, c);
      area = -area;
    }
    const int low_x = std::min({a.x, b.x, c.x}), high_x = std::max({a.x, b.x, c.x});
    const int low_y = std::min({a.y, b.y, c.y}), high_y = std::max({a.y, b.y, c.y});
    const int first_x = first_pixel(low_x), first_y = first_pixel(low_y);
    const int last_x = std::min(last_pixel(high_x), plan_.width - 1),
              last_y = std::min(last_pixel(high_y), plan_.height - 1);
    const Rows rows = visible_.rows;
    const auto fill = [&](const auto& depth_at) {
      for (int y = rows.next_from(std::max(first_y, 0)); y <= last_y; y += rows.step)
        for (int x = std::max(first_x, 0); x <= last_x; ++x)
          if (inside(a, b, x, y) && inside(b, c, x, y) && inside(c, a, x, y)) cover(x, y, depth_at(x, y), identity);
    };
    if (is_forward(plan_.depth_format)) {
      const NormalizedDepthPlane plane(plan_, a, b, c, area);
      fill([&](int x, int y) { return plane.at(x, y); });
      return;
    }
    // Small triangles measure depth from their own box, the others from the tile's corner, starting at the farthest
    // vertex.
    const int max_extent = layout::tile * layout::subpixels;
    const bool small = may_be_small && high_x - low_x < max_extent && high_y - low_y < max_extent &&
                       last_x - first_x < layout::small_pixels && last_y - first_y < layout::small_pixels;
    if (!small) turn_farthest_first(a, b, c);
    const ReversedPlane plane(a, b, c, area);
    fill([&](int x, int y) {
      return small ? plane.at(x, y, first_x, first_y)
                   : plane.at(x, y, x / layout::tile * layout::tile, y / layout::tile * layout::tile);
    });
  }

  void line(ScreenVertex a, ScreenVertex b, const Sample& identity) {
    const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    if (steep ? b.y < a.y : b.x < a.x) std::swap(a, b);
    const std::int64_t start = steep ? a.y : a.x, stop = steep ? b.y : b.x, across = steep ? a.x : a.y;
    const std::int64_t run = stop - start, rise = steep ? b.x - a.x : b.y - a.y;
    if (run == 0) return;
    const int limit = steep ? plan_.height : plan_.width;
    for (int along = 0; along < limit; ++along) {
      const std::int64_t offset = pixel_centre(along) - start;
      if (offset < 0 || offset >= run) continue;
      const std::int64_t numerator = across * run + rise * offset, denominator = run * layout::subpixels;
      const std::int64_t other = numerator / denominator - (numerator % denominator < 0 ? 1 : 0);
      if (other < 0 || other >= (steep ? plan_.width : plan_.height)) continue;
      const int x = steep ? static_cast<int>(other) : along, y = steep ? along : static_cast<int>(other);
      if (visible_.rows.next_from(y) == y) cover(x, y, depth_on_line(plan_, a, b, offset, run), identity);
    }
  }

 private:
  static void turn_farthest_first(ScreenVertex& a, ScreenVertex& b, ScreenVertex& c) {
    const ScreenVertex first = a, second = b, third = c;
    if (b.depth < a.depth && b.depth <= c.depth) {
      a = second;
      b = third;
      c = first;
    } else if (c.depth < a.depth && c.depth < b.depth) {
      a = third;
      b = first;
      c = second;
    }
  }

  // Centres on an edge belong to the triangle whose top or left edge it is.
  static bool inside(const ScreenVertex& from, const ScreenVertex& to, int x, int y) {
    const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
    const std::int64_t value = dx * (pixel_centre(y) - from.y) - dy * (pixel_centre(x) - from.x);
    const bool owns_edge = dy < 0 || (dy == 0 && dx > 0);
    return owns_edge ? value >= 0 : value > 0;
  }

  void cover(int x, int y, const StoredDepth& stored, const Sample& identity) {
    if (!stored.in_range) return;
    Sample& held = visible_.samples[visible_.index(x, y)];
    const bool forward = is_forward(plan_.depth_format);
    const bool nearer = forward ? stored.key > held.key : stored.depth > held.depth;
    const bool equal = forward ? stored.key == held.key : stored.depth == held.depth;
    if (nearer || (equal && identity.order < held.order)) {
      held = identity;
      held.depth = stored.depth;
      held.key = stored.key;
    }
  }

  const FramePlan& plan_;
  Visibility& visible_;
};

}  // namespace

Visibility find_visible(const FramePlan& plan, const RasterGrid& grid,
                        const std::vector<std::vector<Vertex>>& vertices) {
  Visibility visible;
  find_visible(plan, grid, vertices, {}, visible);
  return visible;
}

void find_visible(const FramePlan& plan, const RasterGrid& grid, const std::vector<std::vector<Vertex>>& vertices,
                  const Rows& rows, Visibility& visible) {
  visible.rows = rows;
  visible.width = plan.width;
  visible.pieces.clear();
  visible.samples.assign(static_cast<std::size_t>(plan.width) * rows.count(plan.height),
                         {plan.camera.far_depth, 0, no_order, 0, 0, no_piece});
  Rasterizer rasterizer(plan, visible);
  std::uint64_t order = 0;
  for (std::uint32_t d = 0; d < plan.draws.size(); ++d) {
    const Draw& draw = plan.draws[d];
    const bool lines = draw.shading == Shading::wireframe;
    const std::vector<glm::uvec2> edges = lines ? wireframe_edges(*draw.mesh) : std::vector<glm::uvec2>();
    const std::size_t count = lines ? edges.size() : draw.mesh->triangles.size();
    // On the screen y points down: to give front faces a positive area, two corners change places.
    const int second = draw.mirrored ? 1 : 2, third = draw.mirrored ? 2 : 1;
    for (std::uint32_t p = 0; p < count; ++p, order += 8) {
      std::vector<const Vertex*> v;
      for (int i = 0; i < (lines ? 2 : 3); ++i)
        v.push_back(&vertices[d][lines ? edges[p][i] : draw.mesh->triangles[p][i]]);
      int some = 0, all = ~0;
      for (const Vertex* vertex : v) {
        some |= vertex->outcode;
        all &= vertex->outcode;
      }
      Sample identity{0, 0, order, d, p, no_piece};
      if (some == 0) {
        if (lines)
          rasterizer.line(v[0]->screen, v[1]->screen, identity);
        else
          rasterizer.triangle(v[0]->screen, v[second]->screen, v[third]->screen, draw.double_sided, true, identity);
        continue;
      }
      if (all != 0 || (some & OUT_INVALID) != 0) continue;
      std::vector<Corner> corners;
      for (std::size_t i = 0; i < v.size(); ++i)
        corners.push_back({v[i]->clip, {i == 0 ? 1.0f : 0.0f, i == 1 ? 1.0f : 0.0f, i == 2 ? 1.0f : 0.0f}});
      corners = clip_polygon(std::move(corners), plan, grid);
      if (lines) {
        if (corners.size() == 2)
          rasterizer.line(to_screen(corners[0].clip, grid, plan), to_screen(corners[1].clip, grid, plan), identity);
        continue;
      }
      for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        Piece piece;
        const Corner* const fan[3] = {&corners[0], &corners[i], &corners[i + 1]};
        for (int k = 0; k < 3; ++k) {
          piece.corner[k] = to_screen(fan[k]->clip, grid, plan);
          std::copy(fan[k]->weight, fan[k]->weight + 3, piece.weight[k]);
        }
        identity.order = order + i;
        identity.piece = static_cast<std::uint32_t>(visible.pieces.size());
        visible.pieces.push_back(piece);
        rasterizer.triangle(piece.corner[0], piece.corner[second], piece.corner[third], draw.double_sided, false,
                            identity);
      }
    }
  }
}

}  // namespace morphcl::reference
