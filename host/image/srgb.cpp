#include "host/image/srgb.hpp"

#include <half.h>

#include <algorithm>

#include "host/math/fifth_root.hpp"

namespace morphcl {

namespace {

constexpr float max_half = 65504.0f;
constexpr double max_code = 65535;
constexpr std::size_t middle_code = 128;  // of the 257 codes of 16 bits that have one code of 8 bits, counted from 0
constexpr std::size_t codes_per_code8 = 257;  // 65535 / 255

// The value of the code `twice` / 2, of 65535: code/12.92 up to 0.04045, then ((code + 0.055) / 1.055)^2.4.
// Below, one division of whole numbers; above, within 2^-49.
double linear_from_half_codes(std::int64_t twice) {
  const double half_codes = static_cast<double>(twice);
  if (half_codes <= 2 * max_code * 0.04045) return half_codes * 25 / (646 * max_code);
  const double base = (half_codes / (2 * max_code) + 0.055) / 1.055;
  const double square = base * base;
  return square * fifth_root(square);
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

std::vector<double> make_boundaries() {
  std::vector<double> boundaries(65535);
  for (std::size_t code = 0; code < boundaries.size(); ++code)
    boundaries[code] = linear_from_half_codes(static_cast<std::int64_t>(2 * code + 1));
  return boundaries;
}

// A code is the number of rounding boundaries at or below the value.
std::uint16_t code16(double value) {
  const std::vector<double>& boundaries = srgb16_boundaries();
  return static_cast<std::uint16_t>(std::upper_bound(boundaries.begin(), boundaries.end(), value) - boundaries.begin());
}

std::array<std::uint16_t, 65536> make_srgb16() {
  std::array<std::uint16_t, 65536> table{};
  for (std::size_t bits = 0; bits < table.size(); ++bits) {
    const float value = displayable_from_half()[bits];
    table[bits] = srgb16_of(value);
  }
  return table;
}

std::array<std::uint8_t, 65536> make_srgb8() {
  std::array<std::uint8_t, 65536> table{};
  for (std::size_t bits = 0; bits < table.size(); ++bits) table[bits] = srgb8_from_srgb16(srgb16_from_half()[bits]);
  return table;
}

}  // namespace

const std::vector<double>& srgb16_boundaries() {
  static const std::vector<double> boundaries = make_boundaries();
  return boundaries;
}

const std::array<float, 65536>& displayable_from_half() {
  static const std::array<float, 65536> table = make_displayable();
  return table;
}

const std::array<std::uint16_t, 65536>& srgb16_from_half() {
  static const std::array<std::uint16_t, 65536> table = make_srgb16();
  return table;
}

const std::array<std::uint8_t, 65536>& srgb8_from_half() {
  static const std::array<std::uint8_t, 65536> table = make_srgb8();
  return table;
}

std::uint16_t srgb16_of(double value) {
  return value >= 1 ? std::uint16_t{65535} : value > 0 ? code16(value) : std::uint16_t{0};
}

std::uint16_t srgb16_of_ratio(float color, float alpha, double gain) { return srgb16_of(gain * color / alpha); }

// Of the boundaries of 8 bits code k has that of the 16-bit code 257 k + 128.
std::uint8_t srgb8_from_srgb16(std::uint16_t code) {
  return static_cast<std::uint8_t>((code + middle_code) / codes_per_code8);
}

std::uint8_t srgb8(float linear) { return srgb8_from_half()[half(linear).bits()]; }

double linear_from_srgb16(std::uint16_t code) { return linear_from_half_codes(2 * std::int64_t{code}); }

float linear_from_srgb8(std::uint8_t code) {
  return static_cast<float>(linear_from_srgb16(static_cast<std::uint16_t>(code * codes_per_code8)));
}

}  // namespace morphcl
