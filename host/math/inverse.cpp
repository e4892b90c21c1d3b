#include "morphcl/transform.hpp"

#include <algorithm>
#include <cmath>

#include "host/math/direction.hpp"
#include "host/math/finite.hpp"
#include "host/math/kahan.hpp"
#include "host/math/unit_roundoff.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

double dot(const glm::dvec3& a, const glm::dvec3& b) { return std::fma(a.x, b.x, std::fma(a.y, b.y, a.z * b.z)); }

glm::dvec3 ldexp(const glm::dvec3& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

// The upper 3x3 with each column scaled into [0.5, 1), and its cofactors.
struct Cofactors {
  ScaledVector columns[3];
  glm::dvec3 cofactors[3];  // cofactors[i] . columns[j].vector = determinant where i == j, 0 elsewhere
  double determinant;

  explicit Cofactors(const glm::dmat4& m)
      : columns{scale_to_one(glm::dvec3(m[0])), scale_to_one(glm::dvec3(m[1])), scale_to_one(glm::dvec3(m[2]))} {
    for (int i = 0; i < 3; ++i) cofactors[i] = kahan_cross(columns[(i + 1) % 3].vector, columns[(i + 2) % 3].vector);
    determinant = dot(columns[0].vector, cofactors[0]);
  }
};

}  // namespace

std::optional<glm::dmat4> try_affine_inverse(const glm::dmat4& affine) {
  if (!is_finite(affine)) return std::nullopt;
  const Cofactors c(affine);
  double lengths = 1;
  for (const ScaledVector& column : c.columns) lengths *= glm::length(column.vector);
  constexpr double rounding = 8 * unit_roundoff<double>;
  if (!(std::abs(c.determinant) > rounding * lengths)) return std::nullopt;

  glm::dmat4 inverse(1.0);
  for (int row = 0; row < 3; ++row) {
    const glm::dvec3 entries = ldexp(c.cofactors[row] / c.determinant, -c.columns[row].exponent);
    for (int column = 0; column < 3; ++column) inverse[column][row] = entries[column];
    inverse[3][row] = -dot(entries, glm::dvec3(affine[3]));
  }
  if (!is_finite(inverse)) return std::nullopt;
  return inverse;
}

glm::dmat4 affine_inverse(const glm::dmat4& affine) {
  const std::optional<glm::dmat4> inverse = try_affine_inverse(affine);
  if (!inverse)
    throw Error(ErrorKind::usage, "",
                "a transform has no inverse; a scale of 0 or parallel columns must not occur in it");
  return *inverse;
}

glm::dmat4 rigid_inverse(const glm::dmat4& rigid) {
  glm::dmat4 inverse(glm::transpose(glm::dmat3(rigid)));
  const glm::dvec3 translation(rigid[3]);
  // Adding 0 turns -0 into +0.
  for (int row = 0; row < 3; ++row) inverse[3][row] = 0.0 - dot(glm::dvec3(rigid[row]), translation);
  return inverse;
}

glm::dmat3 normal_matrix(const glm::dmat4& affine) {
  const Cofactors c(affine);
  // Cofactor i lacks the scale of column i's two neighbours; only the differences between the three matter.
  int exponents[3];
  int largest = -4 * 1074;
  for (int i = 0; i < 3; ++i) {
    const ScaledVector scaled = scale_to_one(c.cofactors[i]);
    exponents[i] = c.columns[(i + 1) % 3].exponent + c.columns[(i + 2) % 3].exponent;
    if (scaled.vector != glm::dvec3(0)) largest = std::max(largest, exponents[i] + scaled.exponent);
  }
  const double outward = c.determinant < 0 ? -1 : 1;
  glm::dmat3 normals;
  for (int i = 0; i < 3; ++i) normals[i] = ldexp(outward * c.cofactors[i], exponents[i] - largest);
  return normals;
}

}  // namespace morphcl
