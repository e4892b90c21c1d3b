// Rotation matrices (right-handed, column vectors): counter-clockwise for an observer towards whom the axis points.
//
// Method: Rodrigues, R = I + sin a [n]x + (1 - cos a)([n]x)^2, with 1 - cos a = 2 sin^2(a/2) where it would cancel.
#pragma once

#include <glm/glm.hpp>

namespace morphcl {

// Exactly 0 and +-1 for coordinate axes and multiples of 90 degrees. Each entry within 16u64 absolute.
struct AxisRotation {
  glm::dmat3 matrix;          // R
  glm::dmat3 identity_minus;  // I - R, without the cancellation of the subtraction
};

// The axis is finite and not 0; its length does not matter.
AxisRotation axis_rotation(const glm::dvec3& axis, double degrees);

// The same for an angle in radians; it is the double that is meant, however large.
AxisRotation axis_rotation_radians(const glm::dvec3& axis, double radians);

// About the line through `point` along `axis`: x -> R x + (I - R) point.
glm::dmat4 rotation_about_line(const glm::dvec3& point, const glm::dvec3& axis, double degrees);

}  // namespace morphcl
