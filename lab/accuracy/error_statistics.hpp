// Errors of many results against their exact values, summed up.
//
// An ulp is that of the exact value in the format of the results: 2^(e - bits + 1) for a value in [2^e, 2^(e+1)), and
// the smallest denormal for values below the smallest normal number.
#pragma once

#include <cstddef>

#include "lab/accuracy/figures.hpp"
#include "lab/accuracy/number.hpp"

namespace morphcl::accuracy {

// The format that errors are counted in.
struct Format {
  int bits;          // of the significand, the hidden one included
  int min_exponent;  // of a normal number
};
constexpr Format binary32{24, -126}, binary64{53, -1022};

// An exact result, and the sum of the absolute values of the terms that it is made of; 0 where that says nothing.
template <class N>
struct ExactValue {
  using Number = N;
  Number value = 0, magnitude = 0;
};

double ulp_at(double magnitude, Format format);

class ErrorStatistics {
 public:
  explicit ErrorStatistics(Format format) : format_(format) {}

  template <class Number>
  void add(double computed, const ExactValue<Number>& exact) {
    if (!is_finite(computed)) {
      ++not_finite_;
      return;
    }
    const Number error = abs(Number(computed) - exact.value);
    add(static_cast<double>(error), static_cast<double>(abs(exact.value)), static_cast<double>(exact.magnitude));
  }
  void add_not_finite() { ++not_finite_; }
  // The error's size, that of the exact value, and of its terms.
  void add(double error, double exact, double magnitude);

  double max_absolute() const { return max_absolute_; }
  // Sets max_ulp to rms_absolute (max_scaled where there were terms) and not_finite. Nothing finite was added: those
  // are infinite.
  void write(Figures& figures) const;

 private:
  static bool is_finite(double value) { return value - value == 0; }

  Format format_;
  std::size_t count_ = 0, not_finite_ = 0;
  bool scaled_ = false;
  double max_absolute_ = 0, max_ulp_ = 0, max_scaled_ = 0, squares_ = 0, ulp_squares_ = 0;
};

}  // namespace morphcl::accuracy
