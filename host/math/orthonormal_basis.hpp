// A right-handed basis around a unit normal, without a square root and without a case in which it fails.
//
// Method: Duff, Burgess, Christensen, Hery, Kensler, Liani and Villemin, "Building an Orthonormal Basis, Revisited"
// (2017): the sign of z is copied, so that what is divided by is never below 1 in size. Frisvad's form, which divides
// by 1 + z, loses all digits near -z.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace morphcl {

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
