#include "morphcl/rotation.hpp"

#include <cmath>

#include "host/math/direction.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {

namespace {

// 1 - cos a without cancellation, and exactly 1 at 90 degrees and 2 at 180.
template <typename HalfSine>
double one_minus_cosine(double cosine, HalfSine half_sine) {
  if (cosine < 0.5) return 1 - cosine;
  const double sine = half_sine();
  return 2 * sine * sine;
}

AxisRotation rodrigues(const glm::dvec3& axis, double sine, double versine) {
  const glm::dvec3 n = unit(axis);
  AxisRotation rotation;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    rotation.identity_minus[i][i] = versine * std::fma(n[j], n[j], n[k] * n[k]);
    rotation.matrix[i][i] = 1 - rotation.identity_minus[i][i];
    // Entries (row j, column i) and (row i, column j).
    const double symmetric = versine * n[i] * n[j];
    const double antisymmetric = sine * n[k];
    rotation.matrix[i][j] = symmetric + antisymmetric + 0.0;
    rotation.matrix[j][i] = symmetric - antisymmetric + 0.0;
    rotation.identity_minus[i][j] = 0.0 - rotation.matrix[i][j];
    rotation.identity_minus[j][i] = 0.0 - rotation.matrix[j][i];
  }
  return rotation;
}

}  // namespace

AxisRotation axis_rotation(const glm::dvec3& axis, double degrees) {
  const SinCos angle = sin_cos_degrees(degrees);
  const auto half_sine = [degrees] { return sin_cos_degrees(0.5 * degrees).sin; };
  return rodrigues(axis, angle.sin, one_minus_cosine(angle.cos, half_sine));
}

AxisRotation axis_rotation_radians(const glm::dvec3& axis, double radians) {
  const auto half_sine = [radians] { return sine(0.5 * radians); };
  return rodrigues(axis, sine(radians), one_minus_cosine(cosine(radians), half_sine));
}

glm::dmat4 rotation_about_line(const glm::dvec3& point, const glm::dvec3& axis, double degrees) {
  const AxisRotation rotation = axis_rotation(axis, degrees);
  glm::dmat4 matrix(rotation.matrix);
  for (int row = 0; row < 3; ++row) {
    const glm::dmat3& m = rotation.identity_minus;
    matrix[3][row] = std::fma(m[0][row], point.x, std::fma(m[1][row], point.y, m[2][row] * point.z)) + 0.0;
  }
  return matrix;
}

}  // namespace morphcl
