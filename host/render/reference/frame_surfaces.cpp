#include "host/render/reference/frame_surfaces.hpp"

#include <utility>

#include "host/render/reference/triangle_box.hpp"

namespace morphcl::reference {

FrameSurfaces::FrameSurfaces(const FramePlan& plan, const RasterGrid& grid,
                             const std::vector<std::vector<Vertex>>& vertices)
    : plan_(plan) {
  surfaces_.width = plan.width;
  surfaces_.height = plan.height;
  surfaces_.stored = this;
  struct Visitor {
    FrameSurfaces& of;
    void triangle(const ScreenTriangle& triangle, const PrimitiveIdentity& identity) { of.add(triangle, identity); }
    void line(const ScreenLine& /*line*/, const PrimitiveIdentity& /*identity*/) { of.has_lines_ = true; }
  };
  for_each_screen_primitive(plan, grid, vertices, Visitor{*this});
}

void FrameSurfaces::add(const ScreenTriangle& triangle, const PrimitiveIdentity& identity) {
  ScreenVertex a = triangle.a, b = triangle.b, c = triangle.c;
  std::int64_t area = std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
  if (area == 0 || (area < 0 && !triangle.double_sided)) return;
  if (area < 0) {
    std::swap(b, c);
    area = -area;
  }
  const TriangleBox box(plan_, a, b, c);
  visibility::Surface surface;
  surface.corner = {glm::ivec2(a.x, a.y), glm::ivec2(b.x, b.y), glm::ivec2(c.x, c.y)};
  surface.box = {std::max(box.first_x, 0), std::max(box.first_y, 0), box.last_x, box.last_y};
  if (surface.box.empty()) return;
  set_depth(plan_, a, b, c, surface);
  surface.blended = plan_.draws[identity.draw].blended;
  Sample sample{0, 0, identity.order, identity.draw, identity.primitive, no_piece};
  if (triangle.piece != nullptr) {
    sample.piece = static_cast<std::uint32_t>(pieces_.size());
    pieces_.push_back(*triangle.piece);
  }
  surfaces_.surfaces.push_back(surface);
  drawn_.push_back({sample, SurfaceDepth(plan_, a, b, c, area, triangle.piece == nullptr)});
}

Sample FrameSurfaces::sample(visibility::SurfaceId surface, int x, int y) const {
  const Drawn& drawn = drawn_[surface];
  const StoredDepth stored = drawn.depth.at(x, y);
  Sample sample = drawn.identity;
  sample.depth = stored.depth;
  sample.key = stored.key;
  return sample;
}

bool FrameSurfaces::shows(visibility::SurfaceId surface, int x, int y) const {
  const StoredDepth stored = drawn_[surface].depth.at(x, y);
  return stored.in_range && (is_forward(plan_.depth_format) || stored.depth >= plan_.camera.far_depth);
}

bool FrameSurfaces::is_in_front(visibility::SurfaceId a, visibility::SurfaceId b, int x, int y) const {
  const Sample of_a = sample(a, x, y), of_b = sample(b, x, y);
  if (!is_as_far(plan_, of_a, of_b)) return is_nearer(plan_, of_a, of_b);
  const bool blended = surfaces_[a].blended;
  if (blended != surfaces_[b].blended) return blended;
  return blended ? of_a.order > of_b.order : of_a.order < of_b.order;
}

}  // namespace morphcl::reference
