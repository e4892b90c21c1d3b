// The classic way to rotate about any axis, for teaching: seven steps that each can be printed, drawn and undone.
#pragma once

#include "host/math/composite_transform.hpp"

namespace morphcl {

// Counter-clockwise seen from `to`, like CompositeTransform::rotate_about_axis, but step by step. With the axis'
// direction (a, b, c), D = sqrt(b^2 + c^2) and L = sqrt(a^2 + b^2 + c^2):
//
//   1 translate        `from` to the origin
//   2 rotate about x   the axis into the xz plane: sin b/D, cos c/D
//   3 rotate about y   the axis onto z: sin -a/L, cos D/L
//   4 rotate about z   by the angle
//   5, 6, 7            3, 2 and 1 undone
//
// Error(usage) where these formulas have no answer: an axis of length 0, and one parallel to x (D = 0), for which step
// 2 is undefined although the rotation is not. They are computed as they stand: where squares underflow or overflow (D
// or L outside 1e-160 to 1e150) the steps are wrong. Use rotate_about_axis for everything but teaching.
CompositeTransform rotation_in_seven_steps(const glm::dvec3& from, const glm::dvec3& to, double degrees);

}  // namespace morphcl
