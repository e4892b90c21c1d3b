// Matrices for the batch transforms, by rows, in the precision of the vertices. Real is float or double.
#pragma once

#include <array>

namespace morphcl {

// One row of a matrix that multiplies column vectors (x, y, z, 1).
template <class Real>
using MatrixRow = std::array<Real, 4>;

// The upper three rows of an affine matrix, translation last.
template <class Real>
struct AffineRows {
  MatrixRow<Real> x{1, 0, 0, 0}, y{0, 1, 0, 0}, z{0, 0, 1, 0};
};

template <class Real>
struct ProjectiveRows {
  MatrixRow<Real> x{1, 0, 0, 0}, y{0, 1, 0, 0}, z{0, 0, 1, 0}, w{0, 0, 0, 1};
};

}  // namespace morphcl
