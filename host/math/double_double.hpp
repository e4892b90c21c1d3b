// Unevaluated sums of two doubles: numbers of about 106 bits, and the test whether such a number says how its exact
// original is rounded to a double.
//
// Method: TwoSum (Knuth), FastTwoSum (Dekker), products with fma; relative errors, u = 2^-53, after Joldes, Muller and
// Popescu (2017): sum 3u^2 where the signs agree, product 5u^2, quotient 15u^2; barring overflow and underflow.
#pragma once

#include <cmath>
#include <optional>

#include "host/math/hardware_fma.hpp"

namespace morphcl {

struct DoubleDouble {
  double high = 0, low = 0;  // |low| <= ulp(high) / 2
};

// a + b exactly; |a| >= |b|, or a = 0.
MORPHCL_INLINED DoubleDouble fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// a + b exactly.
MORPHCL_INLINED DoubleDouble two_sum(double a, double b) {
  const double sum = a + b, b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

// a * b exactly.
MORPHCL_INLINED DoubleDouble two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

MORPHCL_INLINED DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

MORPHCL_INLINED DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = two_sum(a.high, b.high), low = two_sum(a.low, b.low);
  const DoubleDouble sum = fast_two_sum(high.high, high.low + low.high);
  return fast_two_sum(sum.high, sum.low + low.low);
}

MORPHCL_INLINED DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

// a + b for |a| >= 2 |b|, in half the time; within 6u^2.
MORPHCL_INLINED DoubleDouble add_smaller(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = fast_two_sum(a.high, b.high);
  return fast_two_sum(high.high, high.low + (a.low + b.low));
}

MORPHCL_INLINED DoubleDouble operator*(const DoubleDouble& a, double b) {
  const DoubleDouble product = two_product(a.high, b);
  return fast_two_sum(product.high, std::fma(a.low, b, product.low));
}

MORPHCL_INLINED DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = two_product(a.high, b.high);
  return fast_two_sum(product.high, product.low + std::fma(a.high, b.low, a.low * b.high));
}

MORPHCL_INLINED DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double quotient = a.high / b.high;
  const DoubleDouble rest = a - b * quotient;
  return fast_two_sum(quotient, rest.high / b.high);
}

// The double nearest to every number within `relative_error` of `value`, if there is one such: Ziv's rounding test.
// value.high is no larger than half the largest double and no smaller than 2^-960.
MORPHCL_INLINED std::optional<double> rounded(const DoubleDouble& value, double relative_error) {
  const double margin = std::abs(value.high) * relative_error;
  const double below = value.high + (value.low - margin), above = value.high + (value.low + margin);
  if (below != above) return std::nullopt;
  return below;
}

}  // namespace morphcl
