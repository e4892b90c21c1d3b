// The matrix of the point transforms in its precisions: a rotation about the line through a pivot along (1, 2, 3), by
// 30 degrees. A batch's constants are the pivot.
#pragma once

#include <array>

#include "lab/accuracy/planar_operation.hpp"

namespace morphcl::accuracy {

using Rows32 = std::array<std::array<float, 4>, 3>;
using Rows64 = std::array<std::array<double, 4>, 3>;
constexpr std::array<double, 3> pivot_axis = {1, 2, 3};
constexpr double pivot_degrees = 30;

// By the product's CompositeTransform.
Rows64 composed_in_fp64(const Batch& batch);
// Translation, rotation by Rodrigues' formula and translation back, multiplied in fp32 with the C library's functions.
Rows32 composed_in_fp32(const Batch& batch);

Rows32 rounded(const Rows64& rows);
Rows64 widened(const Rows32& rows);
Rows64 rest_of(const Rows64& rows);  // what rounding to fp32 leaves
std::array<float, 3> pivot32(const Batch& batch);

// pivot + R (p - pivot); terms as the composed matrix adds them up.
template <class Exact>
void exact_pivot_rotation(const Inputs& in, std::size_t i, Exact* results) {
  using Number = typename Exact::Number;
  static const auto axis = [] {
    const Number length = sqrt(Number(1 + 4 + 9));
    return std::array<Number, 3>{1 / length, 2 / length, 3 / length};
  }();
  static const ExactSinCos<Number> angle = exact_sin_cos<Number>(pivot_degrees);
  for (std::size_t row = 0; row < 3; ++row) {
    Number linear = 0, shift = in.constant(row), terms = 0;
    for (std::size_t column = 0; column < 3; ++column) {
      Number entry = (1 - angle.cos) * axis[row] * axis[column];
      if (row == column) entry += angle.cos;
      if ((row + 2) % 3 == column) entry += angle.sin * axis[(row + 1) % 3];
      if ((row + 1) % 3 == column) entry -= angle.sin * axis[(row + 2) % 3];
      const Number term = entry * in(column, i);
      linear += term;
      terms += abs(term);
      shift -= entry * in.constant(column);
    }
    results[row].value = linear + shift;
    results[row].magnitude = terms + abs(shift);
  }
}

}  // namespace morphcl::accuracy
