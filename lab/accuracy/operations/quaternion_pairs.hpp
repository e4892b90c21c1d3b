// Pairs of rotations that are a given angle apart, and that angle exactly.
#pragma once

#include <array>
#include <cmath>

#include "lab/accuracy/random.hpp"

namespace morphcl::accuracy {

// Planes 0 to 3: x y z w of a unit quaternion (within a few u64); 4 to 7: of one about `radians` of rotation from it,
// on the same half of the sphere.
inline void draw_quaternion_pair(Random& random, double radians, double* in) {
  std::array<double, 4> a, direction;
  const auto normalize = [](std::array<double, 4>& q) {
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double& component : q) component /= length;
  };
  for (std::size_t k = 0; k < 4; ++k) {
    a[k] = random.uniform(-1, 1);
    direction[k] = random.uniform(-1, 1);
  }
  normalize(a);
  double along = 0;
  for (std::size_t k = 0; k < 4; ++k) along += a[k] * direction[k];
  for (std::size_t k = 0; k < 4; ++k) direction[k] -= along * a[k];
  normalize(direction);
  std::array<double, 4> b;
  const double tangent = 0.5 * radians;
  for (std::size_t k = 0; k < 4; ++k) b[k] = a[k] + tangent * direction[k];
  normalize(b);
  for (std::size_t k = 0; k < 4; ++k) {
    in[k] = a[k];
    in[k + 4] = b[k];
  }
}

// Makes both exactly of length 1 and returns the angle between them as vectors, half of the rotation's.
template <class Number>
Number exact_angle(std::array<Number, 4>& a, std::array<Number, 4>& b) {
  const auto normalize = [](std::array<Number, 4>& q) {
    const Number length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (Number& component : q) component /= length;
  };
  normalize(a);
  normalize(b);
  Number apart = 0, together = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    apart += (a[k] - b[k]) * (a[k] - b[k]);
    together += (a[k] + b[k]) * (a[k] + b[k]);
  }
  return 2 * atan2(sqrt(apart), sqrt(together));
}

}  // namespace morphcl::accuracy
