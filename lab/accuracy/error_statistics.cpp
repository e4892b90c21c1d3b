#include "lab/accuracy/error_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace morphcl::accuracy {

double ulp_at(double magnitude, Format format) {
  const int exponent = magnitude > 0 ? std::max(std::ilogb(magnitude), format.min_exponent) : format.min_exponent;
  return std::ldexp(1.0, exponent - format.bits + 1);
}

void ErrorStatistics::add(double error, double exact, double magnitude) {
  ++count_;
  const double ulps = error / ulp_at(exact, format_);
  max_absolute_ = std::max(max_absolute_, error);
  max_ulp_ = std::max(max_ulp_, ulps);
  squares_ += error * error;
  ulp_squares_ += ulps * ulps;
  if (!(magnitude > 0)) return;
  scaled_ = true;
  max_scaled_ = std::max(max_scaled_, error / std::ldexp(magnitude, -format_.bits));
}

void ErrorStatistics::write(Figures& figures) const {
  const double n = static_cast<double>(count_), infinity = std::numeric_limits<double>::infinity();
  figures[Measure::not_finite] = static_cast<double>(not_finite_);
  figures[Measure::max_ulp] = count_ == 0 ? infinity : max_ulp_;
  figures[Measure::rms_ulp] = count_ == 0 ? infinity : std::sqrt(ulp_squares_ / n);
  figures[Measure::max_absolute] = count_ == 0 ? infinity : max_absolute_;
  figures[Measure::rms_absolute] = count_ == 0 ? infinity : std::sqrt(squares_ / n);
  if (scaled_ || count_ == 0) figures[Measure::max_scaled] = count_ == 0 ? infinity : max_scaled_;
}

}  // namespace morphcl::accuracy
