// From the fp64 of the host to the fp32 of the devices: each number is rounded once, to nearest, ties to even.
//
// Throws Error(usage) when a number is not finite or too large for fp32. What is too small becomes a denormal or 0.
#pragma once

#include <glm/glm.hpp>

namespace morphcl {

float to_fp32(double value);
glm::vec3 to_fp32(const glm::dvec3& vector);
glm::vec4 to_fp32(const glm::dvec4& vector);
glm::mat3 to_fp32(const glm::dmat3& matrix);
glm::mat4 to_fp32(const glm::dmat4& matrix);

}  // namespace morphcl
