// The pipeline once more, for one point and in 113 bits, from the parameters of the scene: formulas on points, no
// matrix.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <vector>

#include "morphcl/scene.hpp"

namespace morphcl::test {

using Quad = boost::multiprecision::cpp_bin_float_quad;
using Point = std::array<Quad, 3>;
using Homogeneous = std::array<Quad, 4>;

inline Quad quad_radians(double degrees) { return Quad(degrees) * boost::math::constants::pi<Quad>() / 180; }
inline Point quad(const glm::dvec3& v) { return {Quad(v.x), Quad(v.y), Quad(v.z)}; }
inline Quad quad_dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point quad_cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point combined(const Point& a, const Quad& s, const Point& b) {
  return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
inline Point scaled_to_unit(const Point& a) {
  const Quad length = sqrt(quad_dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

// Rodrigues about the line through `from`.
inline Point turned(const Point& p, const Point& from, const Point& axis, const Quad& angle) {
  const Point n = scaled_to_unit(axis), d = combined(p, -1, from), side = quad_cross(n, d);
  const Quad s = sin(angle), half = sin(angle / 2), c1 = 2 * half * half;
  Point moved = combined(combined(p, s, side), c1, quad_cross(n, side));
  return moved;
}

// By the rotation of a quaternion of any length.
inline Point turned(const Point& p, const glm::dquat& q) {
  const Point v = {Quad(q.x), Quad(q.y), Quad(q.z)};
  const Quad w = q.w, norm = w * w + quad_dot(v, v);
  const Point first = quad_cross(v, p), second = quad_cross(v, first);
  return combined(combined(p, 2 * w / norm, first), 2 / norm, second);
}

inline Point seen_from(const Point& p, const Point& eye, const Point& target, const Point& up) {
  const Point back = scaled_to_unit(combined(eye, -1, target)), right = scaled_to_unit(quad_cross(up, back));
  const Point d = combined(p, -1, eye);
  return {quad_dot(right, d), quad_dot(quad_cross(back, right), d), quad_dot(back, d)};
}

// Clip coordinates of a point in eye space; windows are stretched.
struct QuadProjection {
  Point p;
  Quad aspect;

  Quad distance() const { return -p[2]; }
  static Quad between(const Quad& value, double low, double high) {
    return (2 * value - Quad(low) - Quad(high)) / (Quad(high) - Quad(low));
  }
  Quad perspective_depth(double near, double far) const {
    const Quad d = distance();
    if (std::isinf(far)) return d - 2 * Quad(near);
    const Quad n = near, f = far;
    return (d * (f + n) - 2 * f * n) / (f - n);
  }
  Homogeneous of_view(const Quad& half_width, const Quad& half_height, double near, double far) const {
    return {p[0] / half_width, p[1] / half_height, perspective_depth(near, far), distance()};
  }
  template <class Planes>
  Homogeneous through(const Planes& w, const Quad& at) const {
    const Quad d = distance();
    return {d * between(p[0] * at / d, w.left, w.right), d * between(p[1] * at / d, w.bottom, w.top),
            perspective_depth(w.near, w.far), d};
  }
  Homogeneous operator()(const Perspective& v) const {
    const Quad half = tan(quad_radians(v.fovy_degrees) / 2);
    return of_view(half * aspect, half, v.near, v.far);
  }
  Homogeneous operator()(const HorizontalPerspective& v) const {
    const Quad half = tan(quad_radians(v.fovx_degrees) / 2);
    return of_view(half, half / aspect, v.near, v.far);
  }
  Homogeneous operator()(const Frustum& v) const { return through(v, v.near); }
  Homogeneous operator()(const CentralProjection& v) const { return through(v, v.board); }
  Homogeneous operator()(const Orthographic& v) const {
    return {between(p[0], v.left, v.right), between(p[1], v.bottom, v.top), between(distance(), v.near, v.far), 1};
  }
  Homogeneous operator()(const Oblique& v) const {
    const Quad behind = distance() - Quad(v.plane);
    return {between(p[0] + behind * Quad(v.shear.x), v.left, v.right),
            between(p[1] + behind * Quad(v.shear.y), v.bottom, v.top), between(distance(), v.near, v.far), 1};
  }
};

}  // namespace morphcl::test
