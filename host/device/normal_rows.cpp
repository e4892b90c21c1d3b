#include "host/device/normal_rows.hpp"

#include <algorithm>
#include <cmath>

#include "host/error.hpp"

namespace morphcl {

namespace {

using Vector = std::array<double, 3>;

Vector linear_part(const MatrixRow& row) {
  for (int column = 0; column < 3; ++column)
    if (!std::isfinite(row[column]))
      throw Error(ErrorKind::usage, "", "a matrix for normals holds an infinity or NaN; its entries must be finite");
  return {row[0], row[1], row[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// -1 where the determinant is certainly negative, else 1. Cofactors carry one rounding; the three products and two sums
// add three more, so the error is below 4.01 u64 times the sum of the absolute products.
double determinant_sign(const Vector& row, const Vector& cofactors) {
  double determinant = 0, magnitude = 0;
  for (int column = 0; column < 3; ++column) {
    determinant += row[column] * cofactors[column];
    magnitude += std::abs(row[column] * cofactors[column]);
  }
  return determinant < -0x1.2p-51 * magnitude ? -1 : 1;
}

}  // namespace

AffineRows normal_rows(const AffineRows& rows) {
  const Vector x = linear_part(rows.x), y = linear_part(rows.y), z = linear_part(rows.z);
  const Vector cofactors[3] = {cross(y, z), cross(z, x), cross(x, y)};
  double largest = 0;
  for (const Vector& row : cofactors)
    for (const double entry : row) largest = std::max(largest, std::abs(entry));
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double sign = determinant_sign(x, cofactors[0]);
  AffineRows normals{{}, {}, {}};
  MatrixRow* const out[3] = {&normals.x, &normals.y, &normals.z};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      (*out[row])[column] = static_cast<float>(sign * std::ldexp(cofactors[row][column], -exponent));
  return normals;
}

}  // namespace morphcl
