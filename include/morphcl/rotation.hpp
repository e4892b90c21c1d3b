// Rotations: as matrices, as quaternions, and bases around a normal.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#pragma GCC visibility push(default)
namespace morphcl {

// ---- rotation -------------------------------------------------------------------------------------------------------
//
// Rotation matrices (right-handed, column vectors): counter-clockwise for an observer towards whom the axis points.
//
// Method: Rodrigues, R = I + sin a [n]x + (1 - cos a)([n]x)^2, with 1 - cos a = 2 sin^2(a/2) where it would cancel.

// Exactly 0 and +-1 for coordinate axes and multiples of 90 degrees. Each entry within 16u64 absolute.
struct AxisRotation {
  glm::dmat3 matrix;          // R
  glm::dmat3 identity_minus;  // I - R, without the cancellation of the subtraction
};

// The axis is finite and not 0, which is not tested; its length does not matter. Error(usage) for a NaN or infinite
// angle.
AxisRotation axis_rotation(const glm::dvec3& axis, double degrees);

// The same for an angle in radians, of any size, taken as the exact value of the double.
AxisRotation axis_rotation_radians(const glm::dvec3& axis, double radians);

// About the line through `point` along `axis`: x -> R x + (I - R) point. Arguments as axis_rotation.
glm::dmat4 rotation_about_line(const glm::dvec3& point, const glm::dvec3& axis, double degrees);

// ---- quaternion -----------------------------------------------------------------------------------------------------
//
// Rotations as quaternions, and the way between two of them.
//
// A quaternion need not have unit length: what it rotates by does not depend on it. Length 0 is no rotation of any kind
// and must not be passed.

// Unit length within 4u64; scaled by a power of two first, so lengths from 1e-300 to 1e300 are safe.
glm::dquat normalized(const glm::dquat& q);

// The rotation's matrix in the form divided by |q|^2: exactly 0 and +-1 for quarter turns about coordinate axes.
glm::dmat3 rotation_matrix(const glm::dquat& q);

// Angle in radians, in [0, pi/2], between two quaternions as 4-vectors, sign ignored; half the angle of the rotation
// from a to b. atan2(|a ^ b|, |a . b|) with Kahan differences in the wedge product: within 24u64 relative however
// nearly equal the two are and whatever their lengths, where acos has no correct digit left.
double angle_between(const glm::dquat& a, const glm::dquat& b);

// Spherical interpolation along the shorter arc at t in [0, 1]; unit length within 8u64. With sinc in place of sin the
// same formula serves every angle down to 0. Where the rotations are 180 degrees apart both ways are equally short: it
// goes to b where a . b >= 0, else to -b.
glm::dquat slerp(const glm::dquat& a, const glm::dquat& b, double t);

// ---- orthonormal basis ----------------------------------------------------------------------------------------------
//
// A right-handed basis around a unit normal, without a square root and without a case in which it fails.
//
// Method: Duff, Burgess, Christensen, Hery, Kensler, Liani and Villemin, "Building an Orthonormal Basis, Revisited"
// (2017): the sign of z is copied, so that what is divided by is never below 1 in size. Frisvad's form, which divides
// by 1 + z, loses all digits near -z.

// Columns: tangent, bitangent, normal; for a normal within e of unit length each entry is within 4u + 4e of an exactly
// orthonormal basis'. T is float or double.
template <typename T>
glm::mat<3, 3, T> orthonormal_basis(const glm::vec<3, T>& normal) {
  const T sign = std::copysign(T{1}, normal.z);
  const T a = -1 / (sign + normal.z);
  const T b = normal.x * normal.y * a;
  const glm::vec<3, T> tangent(std::fma(sign * normal.x * normal.x, a, T{1}), sign * b, -sign * normal.x);
  const glm::vec<3, T> bitangent(b, std::fma(normal.y * normal.y, a, sign), -normal.y);
  return {tangent, bitangent, normal};
}

}  // namespace morphcl
#pragma GCC visibility pop
