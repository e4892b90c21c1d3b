// Cutting a triangle or a line at the near plane and at the guard band, in clip space and in high precision
// (Sutherland and Hodgman's algorithm, plane after plane: near, left, right, bottom, top).
#pragma once

#include <array>

#include "lab/frame_error/precise_camera.hpp"

namespace morphcl::accuracy {

template <class Real>
struct Corner {
  Real x, y, w, distance;
  std::array<Real, 3> weight;  // of the source primitive's vertices, sum 1
};

// A triangle cut by five planes has at most eight corners; a line has two, the last weight 0.
template <class Real>
struct Polygon {
  std::array<Corner<Real>, 8> corner;
  int size = 0;
  void push_back(const Corner<Real>& c) {
    if (size < 8) corner[static_cast<std::size_t>(size++)] = c;
  }
};

template <class Real>
class Clipper {
 public:
  explicit Clipper(const PreciseCamera<Real>& camera) : camera_(camera) {}

  Polygon<Real> triangle(Polygon<Real> corners) const { return clip(std::move(corners), true); }
  Polygon<Real> line(Polygon<Real> ends) const { return clip(std::move(ends), false); }

 private:
  enum Plane { near_plane, left, right, bottom, top };

  Real inside(const Corner<Real>& c, Plane plane) const {
    if (plane == near_plane) return c.distance - camera_.near;
    if (plane == left) return camera_.guard_x * c.w + c.x;
    if (plane == right) return camera_.guard_x * c.w - c.x;
    if (plane == bottom) return camera_.guard_y * c.w + c.y;
    return camera_.guard_y * c.w - c.y;
  }

  // From the inner to the outer end, so that both triangles at an edge cut it at the same point.
  Corner<Real> cut(const Corner<Real>& in, const Corner<Real>& out, Plane plane) const {
    const Real here = inside(in, plane), t = here / (here - inside(out, plane));
    const auto mix = [&](const Real& from, const Real& to) -> Real { return from + t * (to - from); };
    Corner<Real> c{mix(in.x, out.x), mix(in.y, out.y), mix(in.w, out.w), mix(in.distance, out.distance), {}};
    for (std::size_t i = 0; i < 3; ++i) c.weight[i] = mix(in.weight[i], out.weight[i]);
    if (plane == near_plane) {
      c.distance = camera_.near;
      c.w = camera_.eye_to_clip[3][3] - camera_.eye_to_clip[3][2] * camera_.near;
    }
    if (plane == left) c.x = -camera_.guard_x * c.w;
    if (plane == right) c.x = camera_.guard_x * c.w;
    if (plane == bottom) c.y = -camera_.guard_y * c.w;
    if (plane == top) c.y = camera_.guard_y * c.w;
    return c;
  }

  Polygon<Real> clip(Polygon<Real> corners, bool closed) const {
    for (const Plane plane : {near_plane, left, right, bottom, top}) {
      Polygon<Real> rest;
      const int edges = closed ? corners.size : corners.size - 1;
      for (int i = 0; i < edges; ++i) {
        const Corner<Real>&a = corners.corner[static_cast<std::size_t>(i)],
              &b = corners.corner[static_cast<std::size_t>((i + 1) % corners.size)];
        const bool a_inside = inside(a, plane) >= 0, b_inside = inside(b, plane) >= 0;
        if (a_inside) rest.push_back(a);
        if (a_inside && !b_inside) rest.push_back(cut(a, b, plane));
        if (!a_inside && b_inside) rest.push_back(cut(b, a, plane));
        if (!closed && b_inside) rest.push_back(b);
      }
      corners = rest;
    }
    return corners;
  }

  const PreciseCamera<Real>& camera_;
};

}  // namespace morphcl::accuracy
