#include "host/geometry/exact_space.hpp"

#include <cmath>

#include "morphcl/numerics.hpp"

namespace morphcl {

ExactNumber exact_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const auto difference = [](double p, double q) { return ExactNumber(p) - ExactNumber(q); };
  return difference(a.x, c.x) * difference(b.y, c.y) - difference(a.y, c.y) * difference(b.x, c.x);
}

ExactNumber exact_volume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const auto difference = [&d](const glm::dvec3& p, int i) { return ExactNumber(p[i]) - ExactNumber(d[i]); };
  const auto minor = [&](int i, int j) {
    return difference(b, j) * difference(c, i) - difference(b, i) * difference(c, j);
  };
  return difference(a, 0) * minor(1, 2) + difference(a, 1) * minor(2, 0) + difference(a, 2) * minor(0, 1);
}

std::optional<int> projection_axis(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 normal = glm::abs(glm::cross(b - a, c - a));
  // The largest component as computed first: nearly always the answer.
  const int first = normal.x > normal.y ? (normal.x > normal.z ? 0 : 2) : (normal.y > normal.z ? 1 : 2);
  for (int i = 0; i < 3; ++i) {
    const int axis = (first + i) % 3;
    if (orientation(projected(a, axis), projected(b, axis), projected(c, axis)) != 0) return axis;
  }
  return std::nullopt;
}

}  // namespace morphcl
