#include "morphcl/batch.hpp"

#include <algorithm>
#include <cmath>

#include "host/math/kahan.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

using Linear = std::array<glm::dvec3, 3>;

double largest_entry(const Linear& rows) {
  double largest = 0;
  for (const glm::dvec3& row : rows)
    for (int column = 0; column < 3; ++column) largest = std::max(largest, std::abs(row[column]));
  return largest;
}

// Times the power of two that brings the largest entry to [1/2, 1). Two steps, as one factor may not be a double.
Linear scaled_to_one(Linear rows) {
  int exponent = 0;
  std::frexp(largest_entry(rows), &exponent);
  for (glm::dvec3& row : rows)
    for (int column = 0; column < 3; ++column) row[column] = std::ldexp(row[column], -exponent);
  return rows;
}

// -1 where the determinant is certainly negative, else 1. Cofactors are within 2 u64; the three products and two sums
// add three roundings more, so the error is below 5.01 u64 times the sum of the absolute products.
double determinant_sign(const glm::dvec3& row, const glm::dvec3& cofactors) {
  double determinant = 0, magnitude = 0;
  for (int column = 0; column < 3; ++column) {
    determinant += row[column] * cofactors[column];
    magnitude += std::abs(row[column] * cofactors[column]);
  }
  return determinant < -0x1.6p-51 * magnitude ? -1 : 1;
}

template <class Real>
glm::dvec3 linear_part(const MatrixRow<Real>& row) {
  for (int column = 0; column < 3; ++column)
    if (!std::isfinite(row[column]))
      throw Error(ErrorKind::usage, "", "a matrix for normals holds an infinity or NaN; its entries must be finite");
  return {row[0], row[1], row[2]};
}

}  // namespace

template <class Real>
AffineRows<Real> normal_rows(const AffineRows<Real>& rows) {
  // Scaled before, so that no product overflows, and after, so that none of the vertices do.
  const auto [x, y, z] = scaled_to_one({linear_part(rows.x), linear_part(rows.y), linear_part(rows.z)});
  const Linear cofactors = {kahan_cross(y, z), kahan_cross(z, x), kahan_cross(x, y)};
  const double sign = determinant_sign(x, cofactors[0]);
  const Linear scaled = scaled_to_one(cofactors);
  AffineRows<Real> normals{{}, {}, {}};
  MatrixRow<Real>* const out[3] = {&normals.x, &normals.y, &normals.z};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) (*out[row])[column] = static_cast<Real>(sign * scaled[row][column]);
  return normals;
}

template AffineRows<float> normal_rows(const AffineRows<float>&);
template AffineRows<double> normal_rows(const AffineRows<double>&);

}  // namespace morphcl
