// An affine map taken apart: translation * rotation * shear * scale.
#pragma once

#include <glm/glm.hpp>

namespace morphcl {

struct Decomposition {
  glm::dvec3 translation;
  glm::dmat3 rotation;  // orthonormal within 16u64, determinant +1
  glm::dvec3 shear;     // xy, xz, yz: x' = x + xy*y + xz*z, y' = y + yz*z
  glm::dvec3 scale;     // x and y positive; z negative for a mirroring map

  glm::dmat4 matrix() const;
};

// The decomposition is unique: the x axis of the rotation is the image of x, its xy plane that of x and y (Gram and
// Schmidt in cross products, which do not cancel). Error(usage) when the map is not affine or finite, or singular.
Decomposition decompose(const glm::dmat4& affine);

}  // namespace morphcl
