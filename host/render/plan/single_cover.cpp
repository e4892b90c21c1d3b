#include "host/render/plan/single_cover.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/math/unit_roundoff.hpp"
#include "host/render/frame/normalized_depth.hpp"
#include "host/render/frame/scene_vertices.hpp"
#include "host/render/plan/screen_boundary.hpp"

namespace morphcl {

namespace {

using reference::ScreenVertex;
using reference::Vertex;

// The proof takes about 0.1 us a triangle and saves up to 2 % of a frame: it is for the large triangles of small
// meshes.
constexpr std::size_t max_triangles = 64;

std::vector<Vertex> project(const FramePlan& plan) {
  Draw draw = plan.draws[0];
  draw.shading = Shading::unlit;
  draw.vertex_colors = false;  // positions are enough
  draw.normals = NormalSource::none;
  return reference::project_vertices(draw, plan, RasterGrid(plan.width, plan.height));
}

// At least as much as the depth that renderers compute at a pixel of this triangle can leave the interval of its
// corners'. Renderers measure from a corner to the pixel, at most a tile beyond the triangle's box: two
// products of differences and one of depths each, over the area, and on to a sample, 20 roundings at most.
double depth_rounding(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, double area) {
  const double extent = std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), std::abs(c.x - a.x), std::abs(c.y - a.y),
                                  std::abs(c.x - b.x), std::abs(c.y - b.y)});
  const double rise = std::max(std::abs(double{b.depth} - a.depth), std::abs(double{c.depth} - a.depth)) +
                      std::abs(double{c.depth} - b.depth);
  return 20 * unit_roundoff<float> *
         (std::abs(a.depth) + rise * (1 + 4 * extent * (extent + layout::tile * layout::subpixels) / area));
}

// Whether no pixel of the triangle can reach the far plane. Forward depth buffers add up its corners' normalized depth
// by areas that are not negative: where that is positive, the sum is.
bool stays_before_far_plane(const FramePlan& plan, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
                            std::int64_t area) {
  if (is_forward(plan.depth_format)) {
    const auto before_far = [&](const ScreenVertex& v) {
      return reference::normalized_depth_of(v.depth, plan).high > 0.0f;
    };
    return before_far(a) && before_far(b) && before_far(c);
  }
  const double lowest = std::min({a.depth, b.depth, c.depth});
  return lowest - depth_rounding(a, b, c, static_cast<double>(area)) > plan.camera.far_depth;
}

// The outline of the frame's only draw; nothing where the frame is no candidate, or some depth may reach the far plane.
std::optional<ScreenBoundary> find_boundary(const FramePlan& plan) {
  if (plan.draws.size() != 1 || plan.clips) return std::nullopt;
  const Draw& draw = plan.draws[0];
  const std::vector<glm::uvec3>& triangles = draw.mesh->triangles;
  if (draw.double_sided || draw.shading == Shading::wireframe || triangles.size() > max_triangles ||
      draw.mesh->positions.size() > 3 * max_triangles)
    return std::nullopt;
  const std::vector<Vertex> vertices = project(plan);
  ScreenBoundary boundary(triangles.size());
  // On the screen y points down: to give front faces a positive area, two corners change places.
  const int second = draw.mirrored ? 1 : 2, third = draw.mirrored ? 2 : 1;
  for (const glm::uvec3& triangle : triangles) {
    const Vertex &a = vertices[triangle[0]], &b = vertices[triangle[second]], &c = vertices[triangle[third]];
    if ((a.outcode | b.outcode | c.outcode) != 0) return std::nullopt;
    const ScreenVertex &p = a.screen, &q = b.screen, &r = c.screen;
    const std::int64_t area = doubled_area({p.x, p.y}, {q.x, q.y}, {r.x, r.y});
    if (area <= 0) continue;
    if (!stays_before_far_plane(plan, p, q, r, area)) return std::nullopt;
    boundary.add({p.x, p.y}, {q.x, q.y}, {r.x, r.y});
  }
  boundary.finish();
  return boundary;
}

}  // namespace

bool is_covered_once(const FramePlan& plan) {
  const std::optional<ScreenBoundary> boundary = find_boundary(plan);
  return boundary && boundary->is_star_shaped();
}

bool has_convex_outline(const FramePlan& plan) {
  const std::optional<ScreenBoundary> boundary = find_boundary(plan);
  return boundary && boundary->is_convex();
}

}  // namespace morphcl
