#include "host/render/reference/clip_polygon.hpp"

#include <cmath>

#include "host/render/frame/kernel_layout.hpp"

namespace morphcl::reference {

namespace {

enum Plane {
  near_plane = NEAR_PLANE,
  left_plane = LEFT_PLANE,
  right_plane = RIGHT_PLANE,
  bottom_plane = BOTTOM_PLANE,
  top_plane = TOP_PLANE
};

float plane_distance(const ClipPoint& p, Plane plane, const FramePlan& frame, const RasterGrid& grid) {
  switch (plane) {
    case near_plane:
      return near_distance(p.z, p.w, frame);
    case left_plane:
      return std::fma(grid.guard_x, p.w, p.x);
    case right_plane:
      return std::fma(grid.guard_x, p.w, -p.x);
    case bottom_plane:
      return std::fma(grid.guard_y, p.w, p.y);
    case top_plane:
      break;
  }
  return std::fma(grid.guard_y, p.w, -p.y);
}

// From the inner to the outer end, whichever way round the polygon runs; the plane's own coordinate is set.
Corner cut(const Corner& inner, const Corner& outer, float inner_distance, float outer_distance, Plane plane,
           const FramePlan& frame, const RasterGrid& grid) {
  const float t = inner_distance / (inner_distance - outer_distance);
  // Exact where both ends agree, so that what lies on the near plane stays on it.
  const auto mix = [&](float in, float out) { return std::fma(t, out, std::fma(-t, in, in)); };
  Corner c;
  c.clip = {mix(inner.clip.x, outer.clip.x), mix(inner.clip.y, outer.clip.y), mix(inner.clip.z, outer.clip.z),
            mix(inner.clip.w, outer.clip.w)};
  for (int i = 0; i < 3; ++i) c.weight[i] = mix(inner.weight[i], outer.weight[i]);
  if (plane == near_plane) {
    c.clip.w = frame.camera.near_w;
    c.clip.z = frame.camera.near_depth * c.clip.w;
  }
  if (plane == left_plane) c.clip.x = -grid.guard_x * c.clip.w;
  if (plane == right_plane) c.clip.x = grid.guard_x * c.clip.w;
  if (plane == bottom_plane) c.clip.y = -grid.guard_y * c.clip.w;
  if (plane == top_plane) c.clip.y = grid.guard_y * c.clip.w;
  return c;
}

}  // namespace

std::vector<Corner> clip_polygon(std::vector<Corner> corners, const FramePlan& frame, const RasterGrid& grid) {
  const bool segment = corners.size() == 2;
  for (int number = 0; number < CLIP_PLANES; ++number) {
    const auto plane = static_cast<Plane>(number);
    std::vector<Corner> left;
    const auto keep = [&](const Corner& corner) {
      if (left.size() < layout::clip_vertices) left.push_back(corner);
    };
    const std::size_t edges = segment && !corners.empty() ? 1 : corners.size();
    for (std::size_t i = 0; i < edges; ++i) {
      const Corner &a = corners[i], &b = corners[(i + 1) % corners.size()];
      const float da = plane_distance(a.clip, plane, frame, grid), db = plane_distance(b.clip, plane, frame, grid);
      if (da >= 0.0f) keep(a);
      if (da >= 0.0f && db < 0.0f) keep(cut(a, b, da, db, plane, frame, grid));
      if (da < 0.0f && db >= 0.0f) keep(cut(b, a, db, da, plane, frame, grid));
    }
    if (segment && !corners.empty() && plane_distance(corners[1].clip, plane, frame, grid) >= 0.0f) keep(corners[1]);
    corners = std::move(left);
  }
  return corners;
}

}  // namespace morphcl::reference
