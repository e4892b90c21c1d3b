// Rows of the catalogue of extreme cases: each is an operation, inputs on which its naive form fails, and a demand.
//
// A row measures a form of the operation by the worst of its errors, in units of what is demanded: 1 or less meets the
// demand. Every row is measured twice, for morphcl's own function and for the naive form (naive_forms.hpp), which must
// miss: otherwise the row would show nothing.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>
#include <limits>

namespace morphcl::accuracy {

using Real = boost::multiprecision::cpp_bin_float_50;  // 168 bits

constexpr double u32 = 0x1p-24, u64 = 0x1p-53;
constexpr double missed = std::numeric_limits<double>::infinity();

// The worst of many errors.
class Worst {
 public:
  // |computed - exact| in units of `bound`; what is not finite misses every demand.
  void add(double computed, const Real& exact, double bound) {
    if (!std::isfinite(computed)) return add(missed);
    add(static_cast<double>(Real(abs(Real(Real(computed) - exact)))) / bound);
  }
  void add_relative(double computed, const Real& exact, double bound) {
    add(computed, exact, bound * static_cast<double>(Real(abs(exact))));
  }
  // A demand that is met or not.
  void add_exact(bool met) { add(met ? 0 : missed); }

  double value() const { return value_; }

 private:
  void add(double error) { value_ = std::max(value_, std::isnan(error) ? missed : error); }
  double value_ = 0;
};

inline void expect_demand(const Worst& stable, const Worst& naive) {
  std::printf("error in units of the demand: %.3g; naive form %.3g\n", stable.value(), naive.value());
  EXPECT_LE(stable.value(), 1) << "the demand is missed";
  EXPECT_GT(naive.value(), 1) << "the naive form meets the demand on these inputs: the row shows nothing";
}

// An ulp of fp32 or fp64 at the exact value.
inline double ulp(double exact, int bits) {
  int exponent = 0;
  std::frexp(exact, &exponent);
  return std::ldexp(1.0, exponent - bits);
}
inline double ulp32(const Real& exact) { return ulp(static_cast<double>(exact), 24); }
inline double ulp64(const Real& exact) { return ulp(static_cast<double>(exact), 53); }

}  // namespace morphcl::accuracy
