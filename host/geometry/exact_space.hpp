// What exact decisions about points in space share: determinants without rounding, points between others, and the
// projection of a plane along an axis, which keeps coordinates as they are.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "host/math/exact_number.hpp"

namespace morphcl {

// Twice the signed area of a, b, c; its sign is orientation(a, b, c).
ExactNumber exact_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

// Six times the signed volume of a, b, c, d; its sign is that of orientation(a, b, c, d).
ExactNumber exact_volume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

// (from weight_from + to weight_to) / (weight_from + weight_to), each coordinate rounded once; the sum is not 0.
template <int N>
glm::vec<N, double> point_between(const glm::vec<N, double>& from, const ExactNumber& weight_from,
                                  const glm::vec<N, double>& to, const ExactNumber& weight_to) {
  const ExactNumber sum = weight_from + weight_to;
  glm::vec<N, double> point(0.0);
  for (int i = 0; i < N; ++i)
    point[i] = quotient(ExactNumber(from[i]) * weight_from + ExactNumber(to[i]) * weight_to, sum);
  return point;
}

// The point without its coordinate `axis`; seen against the axis, right-handed.
inline glm::dvec2 projected(const glm::dvec3& point, int axis) {
  return {point[(axis + 1) % 3], point[(axis + 2) % 3]};
}

// An axis along which a, b and c are projected to a triangle with area; none where they are on one line.
std::optional<int> projection_axis(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace morphcl
