#include "lab/frame_error/stored_number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphcl::accuracy {

namespace {

// Of a binary format with `bits` of significand whose least normal number is 2^min_exponent.
double spacing(double value, int bits, int min_exponent) {
  const int exponent = value == 0 || !std::isfinite(value) ? min_exponent : std::ilogb(value);
  return std::ldexp(1.0, std::max(exponent, min_exponent) - (bits - 1));
}

}  // namespace

double half_spacing(double value) { return spacing(value, 11, -14); }
double float_spacing(double value) { return spacing(value, 24, -126); }

double nearest_half(double value) {
  if (!std::isfinite(value)) return value;
  const double step = half_spacing(value), nearest = std::nearbyint(value / step) * step;
  return std::abs(nearest) > 65504 ? std::copysign(std::numeric_limits<double>::infinity(), value) : nearest;
}

double nearest_float(double value) { return static_cast<double>(static_cast<float>(value)); }

}  // namespace morphcl::accuracy
