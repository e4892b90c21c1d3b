#include "host/math/direction.hpp"

#include <algorithm>
#include <cmath>

#include "host/math/finite.hpp"

namespace morphcl {

ScaledVector scale_to_one(const glm::dvec3& vector) {
  const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
  int exponent = 0;
  std::frexp(largest, &exponent);
  const auto scaled = [exponent](double component) { return std::ldexp(component, -exponent); };
  return {{scaled(vector.x), scaled(vector.y), scaled(vector.z)}, exponent};
}

glm::dvec3 unit(const glm::dvec3& vector) {
  const glm::dvec3 v = scale_to_one(vector).vector;
  const double length = std::sqrt(std::fma(v.x, v.x, std::fma(v.y, v.y, v.z * v.z)));
  return length > 0 ? v / length : v;
}

Difference direction_from_to(const glm::dvec3& from, const glm::dvec3& to) {
  glm::dvec3 a = to, b = from;
  if (!is_finite(a - b)) {
    a *= 0.5;
    b *= 0.5;
  }
  // Knuth's TwoSum of a and -b.
  const glm::dvec3 high = a - b;
  const glm::dvec3 b_part = high - a;
  return {high, (a - (high - b_part)) + (-b - b_part)};
}

}  // namespace morphcl
