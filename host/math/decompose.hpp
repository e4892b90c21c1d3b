// An affine map taken apart: translation * rotation * shear * scale.
#pragma once

#include <glm/glm.hpp>

namespace morphcl {

struct Decomposition {
  glm::dvec3 translation;
  glm::dmat3 rotation;  // orthonormal within 16u64, determinant +1
  glm::dvec3 shear;     // xy, xz, yz: x' = x + xy*y + xz*z, y' = y + yz*z
  glm::dvec3 scale;     // x and y positive; z negative for a mirroring map
  // How far the parts put together are from the map: the largest difference of two entries of a column over the
  // column's length. Less than 120u64.
  double residual = 0;
  // How much of a box the images of the axes span: |determinant| over the product of their lengths, 1 where they are
  // at right angles. The closer to 0, the closer the map is to a singular one, and the more an error of its entries
  // matters to rotation and shear: about 1 / volume times as much.
  double volume = 1;

  glm::dmat4 matrix() const;
};

// The decomposition is unique: the x axis of the rotation is the image of x, its xy plane that of x and y (Gram and
// Schmidt in cross products, which do not cancel). Error(usage) when the map is not affine or finite, or singular: when
// its volume is below 8u64, so that rounding may have made it.
Decomposition decompose(const glm::dmat4& affine);

}  // namespace morphcl
