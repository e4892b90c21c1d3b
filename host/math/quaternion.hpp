// Rotations as quaternions, and the way between two of them.
//
// A quaternion need not have unit length: what it rotates by does not depend on it. Length 0 is no rotation of any kind
// and must not be passed. u = 2^-53.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace morphcl {

// Unit length within 4u; scaled by a power of two first, so lengths from 1e-300 to 1e300 are safe.
glm::dquat normalized(const glm::dquat& q);

// The rotation's matrix in the form divided by |q|^2: exactly 0 and +-1 for quarter turns about coordinate axes.
glm::dmat3 rotation_matrix(const glm::dquat& q);

// Angle in radians, in [0, pi/2], between two quaternions as 4-vectors, sign ignored; half the angle of the rotation
// from a to b. atan2(|a ^ b|, |a . b|) with Kahan differences in the wedge product: within 24u relative however nearly
// equal the two are and whatever their lengths, where acos has no correct digit left.
double angle_between(const glm::dquat& a, const glm::dquat& b);

// Spherical interpolation along the shorter arc at t in [0, 1]; unit length within 8u. With sinc in place of sin the
// same formula serves every angle down to 0. Which way is taken between opposite rotations (180 degrees) is the sign's
// of b.
glm::dquat slerp(const glm::dquat& a, const glm::dquat& b, double t);

}  // namespace morphcl
