// The exact sign of an expression in + - * of doubles.
//
// Method: a floating filter that carries its own error bound through every operation, and where the value does not
// exceed it, the same expression in ExactNumber. So no bound is derived by hand, for any expression; overflow makes the
// bound infinite or the value NaN, underflow is part of it, and the exact evaluation decides both.
#pragma once

#include <cmath>

#include "host/math/exact_number.hpp"
#include "host/math/unit_roundoff.hpp"

namespace morphcl {

// value, within error of the exact one. Each error is rounded up by its last factor: it is computed in at most 6
// roundings of u each, the least of which may be an underflow of 2^-1075.
class BoundedNumber {
 public:
  explicit BoundedNumber(double value) : value_(value) {}

  friend BoundedNumber operator+(const BoundedNumber& a, const BoundedNumber& b) {
    const double sum = a.value_ + b.value_;
    return {sum, (a.error_ + b.error_ + u * std::abs(sum)) * up};  // a sum never underflows
  }
  friend BoundedNumber operator-(const BoundedNumber& a, const BoundedNumber& b) { return a + -b; }
  friend BoundedNumber operator*(const BoundedNumber& a, const BoundedNumber& b) {
    const double product = a.value_ * b.value_;
    const double inherited = std::abs(a.value_) * b.error_ + std::abs(b.value_) * a.error_ + a.error_ * b.error_;
    return {product, (inherited + u * std::abs(product)) * up + underflow};
  }
  BoundedNumber operator-() const { return {-value_, error_}; }

  int sign() const { return value_ > error_ ? 1 : value_ < -error_ ? -1 : 0; }  // 0: unknown

 private:
  BoundedNumber(double value, double error) : value_(value), error_(error) {}

  static constexpr double u = unit_roundoff<double>;
  static constexpr double up = 1 + 16 * u;
  static constexpr double underflow = 0x1p-1070;

  double value_, error_ = 0;
};

// `expression(number)` takes what makes a number of a double and returns the number whose sign is asked for:
//   exact_sign([&](auto number) { return number(a) * number(b) - number(c) * number(d); })
// Error(usage) where a double is not finite: the filter never decides then.
template <class Expression>
int exact_sign(const Expression& expression) {
  const int sign = expression([](double value) { return BoundedNumber(value); }).sign();
  return sign != 0 ? sign : expression([](double value) { return ExactNumber(value); }).sign();
}

}  // namespace morphcl
