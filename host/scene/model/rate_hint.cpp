#include "host/scene/model/rate_hint.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace morphcl {

std::optional<TimeBase> exact_rate(double frames_per_second) {
  if (!(frames_per_second >= 0.001 && frames_per_second <= 1000)) return std::nullopt;
  constexpr double rounding = 0.0051;  // of a rate that is written with two decimals
  const auto whole = static_cast<std::int64_t>(std::lround(frames_per_second));
  if (static_cast<double>(whole) != frames_per_second)
    for (const std::int64_t rate : {24, 30, 48, 60, 120})
      if (std::fabs(frames_per_second - static_cast<double>(rate) * 1000 / 1001) < rounding)
        return TimeBase{.fps_numerator = rate * 1000, .fps_denominator = 1001};
  const auto thousandths = static_cast<std::int64_t>(std::lround(frames_per_second * 1000));
  const std::int64_t divisor = std::gcd(thousandths, std::int64_t{1000});
  return TimeBase{.fps_numerator = thousandths / divisor, .fps_denominator = 1000 / divisor};
}

std::optional<TimeBase> rate_in_text(std::string_view text) {
  const char* const end = text.data() + text.size();
  if (const std::size_t slash = text.find('/'); slash != std::string_view::npos) {
    TimeBase rate;
    const char* const middle = text.data() + slash;
    const auto n = std::from_chars(text.data(), middle, rate.fps_numerator);
    const auto d = std::from_chars(middle + 1, end, rate.fps_denominator);
    const bool read = n.ec == std::errc() && n.ptr == middle && d.ec == std::errc() && d.ptr == end;
    return read && rate.fps_numerator > 0 && rate.fps_denominator > 0 ? std::optional(rate) : std::nullopt;
  }
  double number = 0;
  const auto read = std::from_chars(text.data(), end, number);
  return read.ec == std::errc() && read.ptr == end ? exact_rate(number) : std::nullopt;
}

}  // namespace morphcl
