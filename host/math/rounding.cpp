#include "morphcl/transform.hpp"

#include <fmt/core.h>

#include <cmath>

#include "morphcl/error.hpp"

namespace morphcl {

float to_fp32(double value) {
  // The least double that rounds to infinity: the largest float plus half its ulp.
  constexpr double overflow = 0x1.ffffffp+127;
  if (!(std::abs(value) < overflow))
    throw Error(ErrorKind::usage, "",
                fmt::format("{} does not fit into 32-bit floating point; magnitudes up to 3.4e38 do", value));
  return static_cast<float>(value);
}

glm::vec3 to_fp32(const glm::dvec3& vector) { return {to_fp32(vector.x), to_fp32(vector.y), to_fp32(vector.z)}; }

glm::vec4 to_fp32(const glm::dvec4& vector) { return {to_fp32(glm::dvec3(vector)), to_fp32(vector.w)}; }

glm::mat3 to_fp32(const glm::dmat3& matrix) { return {to_fp32(matrix[0]), to_fp32(matrix[1]), to_fp32(matrix[2])}; }

glm::mat4 to_fp32(const glm::dmat4& matrix) {
  return {to_fp32(matrix[0]), to_fp32(matrix[1]), to_fp32(matrix[2]), to_fp32(matrix[3])};
}

}  // namespace morphcl
