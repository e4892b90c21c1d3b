// The nine entries that the matrix operations compare.
#pragma once

#include <array>

namespace morphcl::accuracy {

using Entries3x3 = std::array<double, 9>;  // row after row

// Of the upper left 3 x 3 of one of GLM's matrices.
template <class Matrix>
Entries3x3 entries_3x3(const Matrix& m) {
  Entries3x3 entries;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) entries[3 * row + column] = static_cast<double>(m[column][row]);
  return entries;
}

}  // namespace morphcl::accuracy
