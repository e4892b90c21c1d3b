#include "morphcl/numerics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphcl {

namespace {

constexpr int fraction_bits = 10, min_exponent = -14;

// To the nearest integer, ties to even, of 0 <= value < 2^51: by the rounding of a sum.
double to_integer(double value) {
  constexpr double shift = 0x1p52;
  return (value + shift) - shift;
}

}  // namespace

std::uint16_t to_half(double value) {
  const auto sign = static_cast<std::uint16_t>(std::signbit(value) ? 0x8000 : 0);
  const double size = std::abs(value);
  constexpr double overflow = 65520;  // half an ulp above the largest half
  if (std::isnan(value)) return static_cast<std::uint16_t>(sign | 0x7e00);
  if (size >= overflow) return static_cast<std::uint16_t>(sign | 0x7c00);
  if (size == 0) return sign;  // which has no exponent
  int exponent = 0;
  std::frexp(size, &exponent);
  const int binade = std::max(exponent - 1, min_exponent);
  // In ulps; a carry into the next binade is right as an integer sum.
  const auto ulps = static_cast<int>(to_integer(std::ldexp(size, fraction_bits - binade)));
  const int biased = (binade - min_exponent) << fraction_bits;
  return static_cast<std::uint16_t>(sign | (biased + ulps));
}

double from_half(std::uint16_t bits) {
  const double sign = (bits & 0x8000) != 0 ? -1 : 1;
  const int exponent = (bits >> fraction_bits) & 31, fraction = bits & 1023;
  if (exponent == 31)
    return fraction != 0 ? std::numeric_limits<double>::quiet_NaN() : sign * std::numeric_limits<double>::infinity();
  if (exponent == 0) return sign * std::ldexp(fraction, min_exponent - fraction_bits);
  return sign * std::ldexp(1024 + fraction, exponent - 1 + min_exponent - fraction_bits);
}

HalfRange half_range(std::span<const double> values) {
  if (values.empty()) return {};
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  HalfRange range{0.5 * *low + 0.5 * *high, 1};
  const double reach = std::max(*high - range.bias, range.bias - *low);
  int exponent = 0;
  const double fraction = std::frexp(reach, &exponent);
  // 2^exponent > reach, and reach itself where it is a power of two.
  if (reach > 0) range.scale = std::ldexp(1.0, fraction == 0.5 ? exponent - 1 : exponent);
  return range;
}

}  // namespace morphcl
