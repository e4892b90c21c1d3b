#include "morphcl/track.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace morphcl {

namespace {

// The interval before or after a key.
struct Interval {
  double time, slope;
};

double parabola_tangent(const Interval& before, const Interval& after) {
  const double whole = before.time + after.time;
  return before.slope * (after.time / whole) + after.slope * (before.time / whole);
}

double limited_tangent(const Interval& before, const Interval& after) {
  const bool turns_round = !(before.slope > 0 && after.slope > 0) && !(before.slope < 0 && after.slope < 0);
  if (turns_round) return 0;
  const double limit = 3 * std::min(std::abs(before.slope), std::abs(after.slope));
  return std::clamp(parabola_tangent(before, after), -limit, limit);
}

// Frame numbers like 0.1, 0.2, 0.3 are even but for their rounding.
bool is_even(const Interval& before, const Interval& after) {
  return std::abs(after.time - before.time) <= 1e-9 * (before.time + after.time);
}

template <typename Inner>
std::vector<double> tangents(std::span<const double> times, std::span<const double> values, Inner inner) {
  const auto interval = [&](std::size_t i) {
    const double time = times[i + 1] - times[i];
    return Interval{time, (values[i + 1] - values[i]) / time};
  };
  std::vector<double> result(times.size());
  result.front() = interval(0).slope;
  result.back() = interval(times.size() - 2).slope;
  for (std::size_t i = 1; i + 1 < times.size(); ++i) result[i] = inner(i, interval(i - 1), interval(i));
  return result;
}

}  // namespace

std::vector<double> default_tangents(std::span<const double> times, std::span<const double> values) {
  return tangents(times, values, [&](std::size_t i, const Interval& before, const Interval& after) {
    if (is_even(before, after)) return (values[i + 1] - values[i - 1]) / (times[i + 1] - times[i - 1]);
    return limited_tangent(before, after);
  });
}

std::vector<double> monotone_tangents(std::span<const double> times, std::span<const double> values) {
  return tangents(times, values, [](std::size_t, const Interval& before, const Interval& after) {
    return limited_tangent(before, after);
  });
}

}  // namespace morphcl
