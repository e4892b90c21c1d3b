#include "host/render/reference/shade.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/render/frame/raster_grid.hpp"
#include "host/render/frame/sample_pattern.hpp"
#include "host/render/reference/areas.hpp"
#include "host/render/reference/light.hpp"

namespace morphcl::reference {

float eye_distance(const FramePlan& plan, float depth) {
  return plan.camera.parallel ? -depth : plan.camera.near / depth;
}

namespace {

struct Weights {
  float vertex[3];
  float distance = 0;  // of the place, interpolated like an attribute
  float total() const { return vertex[0] + vertex[1] + vertex[2]; }
};

// Where a pixel is shaded.
struct Place {
  int x, y;            // sub-pixels
  float stored_depth;  // of the depth buffer there, where one sample a pixel decides what is seen
  bool has_depth;
};

// Whether a triangle of this orientation owns what lies at (x, y), as the raster has it.
bool covers(const ScreenVertex corner[3], bool positive, int x, int y) {
  for (int i = 0; i < 3; ++i) {
    const ScreenVertex &from = corner[positive ? i : 2 - i], &to = corner[positive ? (i + 1) % 3 : (4 - i) % 3];
    const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
    const std::int64_t value = dx * (y - from.y) - dy * (x - from.x);
    const bool owns_edge = dy < 0 || (dy == 0 && dx > 0);
    if (owns_edge ? value < 0 : value <= 0) return false;
  }
  return true;
}

// The mean of all samples of the pixel that the triangle covers.
SubPixelOffset centroid_of_coverage(const ScreenVertex corner[3], const Place& centre, int samples) {
  const std::int64_t area = std::int64_t{corner[1].x - corner[0].x} * (corner[2].y - corner[0].y) -
                            std::int64_t{corner[2].x - corner[0].x} * (corner[1].y - corner[0].y);
  PixelPart part;
  for (const SampleOffset& sample : sample_pattern(samples))
    if (covers(corner, area > 0, centre.x + sample.subpixels_x(), centre.y + sample.subpixels_y())) part.add(sample);
  return part.centroid(samples);
}

Weights screen_weights(const FramePlan& plan, const ScreenVertex corner[3], const Areas& areas, const Place& place) {
  Weights w;
  for (int i = 0; i < 3; ++i) {
    w.vertex[i] = areas.corner[i];
    if (!plan.camera.parallel) w.vertex[i] *= corner[i].inverse_w;
  }
  if (is_forward(plan.depth_format)) {  // its corners have their distance in place of depth
    w.distance =
        std::fma(w.vertex[0], corner[0].depth, std::fma(w.vertex[1], corner[1].depth, w.vertex[2] * corner[2].depth)) /
        w.total();
  } else if (!place.has_depth) {
    // The weights are areas over w: in perspective their sum over that of the areas is the mean of 1 / w.
    const float* const a = areas.corner;
    w.distance =
        plan.camera.parallel
            ? -(std::fma(a[0], corner[0].depth, std::fma(a[1], corner[1].depth, a[2] * corner[2].depth)) / w.total())
            : (a[0] + a[1] + a[2]) / w.total();
  } else {
    w.distance = eye_distance(plan, place.stored_depth);
  }
  return w;
}

Weights source_weights(const Weights& cut, const Piece& piece) {
  Weights w;
  w.distance = cut.distance;
  for (int i = 0; i < 3; ++i)
    w.vertex[i] = std::fma(cut.vertex[0], piece.weight[0][i],
                           std::fma(cut.vertex[1], piece.weight[1][i], cut.vertex[2] * piece.weight[2][i]));
  return w;
}

template <class Vector>
glm::vec3 interpolate(const Weights& w, const Vector& a, const Vector& b, const Vector& c) {
  glm::vec3 sum;
  for (int i = 0; i < 3; ++i) sum[i] = std::fma(w.vertex[0], a[i], std::fma(w.vertex[1], b[i], w.vertex[2] * c[i]));
  return sum;
}

float interpolate_alpha(const Weights& w, const Vertex& a, const Vertex& b, const Vertex& c) {
  return std::fma(w.vertex[0], a.color.a, std::fma(w.vertex[1], b.color.a, w.vertex[2] * c.color.a));
}

glm::vec3 eye_position(const FramePlan& plan, const Place& place, float distance) {
  constexpr float pixel = 1.0f / layout::subpixels;
  const float across = std::fma(static_cast<float>(place.x) * pixel, plan.camera.ray[0], plan.camera.ray[1]);
  const float up = std::fma(static_cast<float>(place.y) * pixel, plan.camera.ray[2], plan.camera.ray[3]);
  if (!plan.camera.parallel) return {across * distance, up * distance, -distance};
  return {std::fma(distance, plan.camera.slant[0], across), std::fma(distance, plan.camera.slant[1], up), -distance};
}

// Alpha of a blended draw. `tint`: the vertices' share.
float alpha_of(const Draw& draw, float tint) {
  const float alpha = std::min(std::max(draw.base_color[3] * tint, 0.0f), 1.0f);
  if (draw.alpha_cutoff < 0.0f) return alpha;
  return alpha >= draw.alpha_cutoff ? 1.0f : 0.0f;
}

// `centroid`: where the centre is not in the triangle; none: that of all it covers of the pixel.
ShadedSurface shade_at(const FramePlan& plan, const Visibility& visible, const Sample& sample,
                       const std::vector<std::vector<Vertex>>& vertices, Place place,
                       std::optional<SubPixelOffset> centroid) {
  const Draw& draw = plan.draws[sample.draw];
  ShadedSurface surface{{draw.base_color[0], draw.base_color[1], draw.base_color[2]},
                        draw.blended ? alpha_of(draw, 1.0f) : 1.0f};
  glm::vec3& color = surface.color;
  if (draw.shading == Shading::wireframe) return surface;

  const glm::uvec3 triangle = draw.mesh->triangles[sample.primitive];
  const Vertex *a = &vertices[sample.draw][triangle[0]], *b = &vertices[sample.draw][triangle[1]],
               *c = &vertices[sample.draw][triangle[2]];
  Face face;
  if (draw.shading == Shading::flat) {
    face = face_of(plan, draw, a->position, b->position, c->position);
    if (!draw.lit_per_pixel) color *= lambert(plan, face.normal, face.centre);
  }
  if (draw.shading != Shading::smooth && !draw.lit_per_pixel && !draw.vertex_colors) return surface;

  const bool is_cut = sample.piece != no_piece;
  const ScreenVertex whole[3] = {a->screen, b->screen, c->screen};
  const ScreenVertex* const corner = is_cut ? visible.pieces[sample.piece].corner : whole;
  Areas areas = areas_at(corner, place.x, place.y);
  if (!place.has_depth && !areas.inside()) {
    if (!centroid) centroid = centroid_of_coverage(corner, place, visible.samples_a_pixel);
    place.x += centroid->x;
    place.y += centroid->y;
    areas = areas_at(corner, place.x, place.y);
  }
  Weights w = screen_weights(plan, corner, within_triangle(draw, areas), place);
  if (is_cut) w = source_weights(w, visible.pieces[sample.piece]);
  if (draw.shading == Shading::smooth || draw.lit_per_pixel) {
    glm::vec3 normal = face.normal;
    if (draw.shading == Shading::smooth) {
      normal = interpolate(w, a->normal, b->normal, c->normal);
      // The weights carry the sign of the orientation on the screen, negative for front faces of unmirrored objects.
      if (draw.double_sided ? !draw.mirrored : w.total() < 0.0f) normal = -normal;
    }
    color *= lambert(plan, normal, eye_position(plan, place, w.distance));
  }
  if (draw.vertex_colors) {
    const glm::vec3 tint = interpolate(w, a->color, b->color, c->color);
    for (int i = 0; i < 3; ++i) color[i] *= tint[i] / w.total();
    if (draw.blended) surface.alpha = alpha_of(draw, interpolate_alpha(w, *a, *b, *c) / w.total());
  }
  return surface;
}

}  // namespace

ShadedSurface shade_centre(const FramePlan& plan, const Visibility& visible, const Sample& sample,
                           const std::vector<std::vector<Vertex>>& vertices, int x, int y) {
  return shade_at(plan, visible, sample, vertices, {pixel_centre(x), pixel_centre(y), sample.depth, true},
                  std::nullopt);
}

ShadedSurface shade_part(const FramePlan& plan, const Visibility& visible, const Sample& sample,
                         const std::vector<std::vector<Vertex>>& vertices, int x, int y,
                         std::optional<SubPixelOffset> centroid) {
  return shade_at(plan, visible, sample, vertices, {pixel_centre(x), pixel_centre(y), 0, false}, centroid);
}

}  // namespace morphcl::reference
