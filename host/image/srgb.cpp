#include "host/image/srgb.hpp"

#include <half.h>

#include <algorithm>
#include <cmath>

namespace morphcl {

namespace {

constexpr float max_half = 65504.0f;

// x^2.4 for x in [0.05, 1], within 7u: x^2 times the square of the fifth root, which Newton's method finds from
// the fourth in six steps. Not pow, whose last bits depend on the C library and the processor.
double power_2_4(double x) {
  double root = std::sqrt(std::sqrt(x));
  for (int step = 0; step < 6; ++step) {
    const double fourth = (root * root) * (root * root);
    root = 0.2 * (4 * root + x / fourth);
  }
  return (x * x) * (root * root);
}

double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : power_2_4((encoded + 0.055) / 1.055);
}

half half_from_bits(std::size_t bits) {
  half value;
  value.setBits(static_cast<std::uint16_t>(bits));
  return value;
}

std::array<float, 65536> make_displayable() {
  std::array<float, 65536> table{};
  for (std::size_t bits = 0; bits < table.size(); ++bits) {
    const float value = half_from_bits(bits);
    table[bits] = value > 0 ? std::min(value, max_half) : 0.0f;  // NaN is not > 0
  }
  return table;
}

// A code is the number of rounding boundaries below the value. The boundaries are irrational (or, on the straight
// piece, no halves), so no half lies on one and a last bit of the power decides nothing.
std::array<std::uint8_t, 65536> make_srgb8() {
  std::array<double, 255> boundaries{};
  for (std::size_t code = 0; code < boundaries.size(); ++code)
    boundaries[code] = linear_from_srgb((static_cast<double>(code) + 0.5) / 255);
  std::array<std::uint8_t, 65536> table{};
  for (std::size_t bits = 0; bits < table.size(); ++bits) {
    const double value = displayable_from_half()[bits];
    table[bits] =
        static_cast<std::uint8_t>(std::lower_bound(boundaries.begin(), boundaries.end(), value) - boundaries.begin());
  }
  return table;
}

}  // namespace

const std::array<float, 65536>& displayable_from_half() {
  static const std::array<float, 65536> table = make_displayable();
  return table;
}

const std::array<std::uint8_t, 65536>& srgb8_from_half() {
  static const std::array<std::uint8_t, 65536> table = make_srgb8();
  return table;
}

std::uint8_t srgb8(float linear) { return srgb8_from_half()[half(linear).bits()]; }

float linear_from_srgb8(std::uint8_t code) { return static_cast<float>(linear_from_srgb(code / 255.0)); }

}  // namespace morphcl
