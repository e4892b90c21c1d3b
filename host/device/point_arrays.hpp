// What the batch transforms work on: matrices by rows and coordinates as one array each.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace morphcl {

// One row of a matrix that multiplies column vectors (x, y, z, 1).
using MatrixRow = std::array<float, 4>;

// The upper three rows of an affine matrix, translation last.
struct AffineRows {
  MatrixRow x{1, 0, 0, 0}, y{0, 1, 0, 0}, z{0, 0, 1, 0};
};

struct ProjectiveRows {
  MatrixRow x{1, 0, 0, 0}, y{0, 1, 0, 0}, z{0, 0, 1, 0}, w{0, 0, 0, 1};
};

// Element i of each span belongs to point i; all three have the same size.
struct ConstPointArrays {
  std::span<const float> x, y, z;
};

struct PointArrays {
  std::span<float> x, y, z;

  operator ConstPointArrays() const { return {x, y, z}; }
};

// The number of points. Error(usage) if the six sizes differ, if two of the outputs share memory, or if an output
// shares memory with an input other than by being the same array.
std::size_t checked_size(const ConstPointArrays& in, const PointArrays& out);

}  // namespace morphcl
