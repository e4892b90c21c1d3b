// Input for the batch transforms, from fixed sequences.
#pragma once

#include <cstdint>
#include <vector>

#include "host/device/point_arrays.hpp"

namespace morphcl::testing {

struct Points {
  std::vector<float> x, y, z;

  explicit Points(std::size_t count, float value = 0) : x(count, value), y(count, value), z(count, value) {}
  PointArrays arrays() { return {x, y, z}; }
  ConstPointArrays arrays() const { return {x, y, z}; }
};

enum class Family {
  benign,     // coordinates in [-1, 1]
  wide,       // magnitudes from 2^-20 to 2^20
  cancelling  // coordinates close to 1, for matrices whose rows nearly cancel there
};

Points make_points(std::size_t count, Family family, std::uint64_t seed);

// A rotation by no round angle with unequal scales, mirrored, and a translation.
AffineRows general_matrix();
// Rows whose sums at (1, 1, 1) are lost but for the last places.
AffineRows cancelling_matrix();
// general_matrix() with w = 1/2 - z: about half of the benign points lie behind the eye.
ProjectiveRows perspective_matrix();

}  // namespace morphcl::testing
