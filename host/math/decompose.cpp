#include "morphcl/transform.hpp"

#include <algorithm>
#include <cmath>

#include "host/math/direction.hpp"
#include "host/math/finite.hpp"
#include "host/math/kahan.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

// Of the first three columns, over each column's length.
double largest_difference(const glm::dmat4& a, const glm::dmat4& b) {
  double largest = 0;
  for (int column = 0; column < 3; ++column) {
    const ScaledVector scaled = scale_to_one(glm::dvec3(b[column]));
    const double length = glm::length(scaled.vector);
    for (int row = 0; row < 3; ++row)
      largest = std::max(largest, std::abs(std::ldexp(a[column][row] - b[column][row], -scaled.exponent)) / length);
  }
  return largest;
}

}  // namespace

Decomposition decompose(const glm::dmat4& affine) {
  const bool is_affine = affine[0][3] == 0 && affine[1][3] == 0 && affine[2][3] == 0 && affine[3][3] == 1;
  if (!is_affine || !is_finite(affine))
    throw Error(ErrorKind::usage, "", "only finite affine maps can be decomposed; the last row must be 0 0 0 1");
  if (!try_affine_inverse(affine))
    throw Error(ErrorKind::usage, "", "a singular transform cannot be decomposed; no scale in it may be 0");

  const glm::dvec3 x_image(affine[0]), y_image(affine[1]), z_image(affine[2]);
  const glm::dvec3 x = unit(x_image);
  const glm::dvec3 z = unit(kahan_cross(scale_to_one(x_image).vector, scale_to_one(y_image).vector));
  const glm::dvec3 y = kahan_cross(z, x);

  Decomposition parts;
  parts.translation = glm::dvec3(affine[3]);
  parts.rotation = {x, y, z};
  parts.scale = {glm::dot(x_image, x), glm::dot(y_image, y), glm::dot(z_image, z)};
  parts.shear = {glm::dot(y_image, x) / parts.scale.y, glm::dot(z_image, x) / parts.scale.z,
                 glm::dot(z_image, y) / parts.scale.z};
  parts.residual = largest_difference(parts.matrix(), affine);
  // Of unit vectors: x and the plane of y, and the rest of z.
  parts.volume = std::abs(glm::dot(unit(y_image), y)) * std::abs(glm::dot(unit(z_image), z));
  return parts;
}

glm::dmat4 Decomposition::matrix() const {
  const glm::dmat3 sheared(1, 0, 0, shear.x, 1, 0, shear.y, shear.z, 1);
  glm::dmat3 linear = rotation * sheared;
  for (int column = 0; column < 3; ++column) linear[column] *= scale[column];
  glm::dmat4 affine(linear);
  affine[3] = glm::dvec4(translation, 1);
  return affine;
}

}  // namespace morphcl
