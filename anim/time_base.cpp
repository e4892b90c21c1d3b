#include "morphcl/track.hpp"

#include <fmt/core.h>

#include <cmath>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

__extension__ using Wide = __int128;

// value / 2^shift to nearest, ties to even; 0 <= shift.
Wide shift_right_to_even(Wide value, int shift) {
  if (shift == 0) return value;
  if (shift > 126) return 0;
  const Wide floor = value >> shift;
  const Wide rest = value - (floor << shift);
  const Wide half = Wide{1} << (shift - 1);
  const bool up = rest > half || (rest == half && (floor & 1) != 0);
  return floor + (up ? 1 : 0);
}

// value * factor without any rounding but the last one; 0 < factor <= 10^12.
std::int64_t product_in_ticks(double value, std::int64_t factor, const char* unit) {
  constexpr double limit = 0x1p62;
  if (!(std::abs(value * static_cast<double>(factor)) <= limit))
    throw Error(ErrorKind::bad_input, "",
                fmt::format("a time of {} {} is not finite or beyond the timeline's 2^62 ticks", value, unit));
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const Wide product = Wide{mantissa} * factor;  // less than 2^93
  const int shift = 53 - exponent;
  const Wide ticks = shift >= 0 ? shift_right_to_even(product, shift) : product * (Wide{1} << -shift);
  return static_cast<std::int64_t>(ticks);
}

}  // namespace

std::int64_t TimeBase::seconds_to_ticks(double seconds) const {
  return product_in_ticks(seconds, ticks_per_second(), "seconds");
}

std::int64_t TimeBase::float_seconds_to_ticks(float seconds) const {
  const std::int64_t ticks = seconds_to_ticks(seconds);
  const double frame = std::nearbyint(static_cast<double>(ticks) / static_cast<double>(ticks_per_frame()));
  const double frame_seconds = frame * static_cast<double>(fps_denominator) / static_cast<double>(fps_numerator);
  const bool on_frame = static_cast<float>(frame_seconds) == seconds;
  return on_frame ? static_cast<std::int64_t>(frame) * ticks_per_frame() : ticks;
}

std::int64_t TimeBase::frames_to_ticks(double frame) const {
  return product_in_ticks(frame, ticks_per_frame(), "frames");
}

}  // namespace morphcl
