#include "morphcl/rotation.hpp"

#include <algorithm>
#include <cmath>

#include "host/math/kahan.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

double dot(const glm::dquat& a, const glm::dquat& b) {
  return std::fma(a.x, b.x, std::fma(a.y, b.y, std::fma(a.z, b.z, a.w * b.w)));
}

double length(const glm::dquat& q) { return std::sqrt(dot(q, q)); }

glm::dquat scaled_to_one(const glm::dquat& q) {
  int exponent = 0;
  std::frexp(std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z), std::abs(q.w)}), &exponent);
  return {std::ldexp(q.w, -exponent), std::ldexp(q.x, -exponent), std::ldexp(q.y, -exponent),
          std::ldexp(q.z, -exponent)};
}

// Both scaled to one; the angle between them, sign ignored.
double angle_of_scaled(const glm::dquat& a, const glm::dquat& b) {
  const glm::dvec3 planes_xyz = kahan_cross(glm::dvec3(a.x, a.y, a.z), glm::dvec3(b.x, b.y, b.z));
  const glm::dvec3 planes_w(difference_of_products(a.w, b.x, a.x, b.w), difference_of_products(a.w, b.y, a.y, b.w),
                            difference_of_products(a.w, b.z, a.z, b.w));
  const double wedge = std::sqrt(glm::dot(planes_xyz, planes_xyz) + glm::dot(planes_w, planes_w));
  return arc_tangent(wedge, std::abs(dot(a, b)));
}

double sinc(double x) { return x == 0 ? 1 : sine(x) / x; }

// b or -b, whichever is nearer to a.
glm::dquat towards(const glm::dquat& a, const glm::dquat& b) { return dot(a, b) < 0 ? -b : b; }

}  // namespace

glm::dquat normalized(const glm::dquat& q) {
  const glm::dquat scaled = scaled_to_one(q);
  return scaled / length(scaled);
}

glm::dmat3 rotation_matrix(const glm::dquat& q) {
  const glm::dquat scaled = scaled_to_one(q);
  const double w = scaled.w, x = scaled.x, y = scaled.y, z = scaled.z;
  const double ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  const double n = (ww + xx) + (yy + zz);
  glm::dmat3 m;
  m[0] = {(ww + xx) - (yy + zz), 2 * (x * y + w * z), 2 * (x * z - w * y)};
  m[1] = {2 * (x * y - w * z), (ww + yy) - (xx + zz), 2 * (y * z + w * x)};
  m[2] = {2 * (x * z + w * y), 2 * (y * z - w * x), (ww + zz) - (xx + yy)};
  // Adding 0 turns -0 into +0.
  for (int column = 0; column < 3; ++column) m[column] = m[column] / n + 0.0;
  return m;
}

double angle_between(const glm::dquat& a, const glm::dquat& b) {
  return angle_of_scaled(scaled_to_one(a), scaled_to_one(b));
}

glm::dquat slerp(const glm::dquat& a, const glm::dquat& b, double t) {
  const glm::dquat from = normalized(a), to = towards(from, normalized(b));
  const double angle = angle_between(a, b);
  const double whole = sinc(angle);
  const double from_weight = (1 - t) * sinc((1 - t) * angle) / whole;
  const double to_weight = t * sinc(t * angle) / whole;
  const glm::dquat q = from * from_weight + to * to_weight;
  return q / length(q);
}

}  // namespace morphcl
