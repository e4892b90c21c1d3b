// The reference's view of kernels/two_float.h: numbers of about 48 bits.
#pragma once

#include <cmath>
#include <cstdint>

namespace morphcl::reference {

struct TwoFloat {
  float high = 0, low = 0;  // |low| <= ulp(high) / 2
};

inline TwoFloat fast_two_sum(float a, float b) {
  const float sum = a + b;
  return {sum, b - (sum - a)};
}

inline TwoFloat two_sum(float a, float b) {
  const float sum = a + b, b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

inline TwoFloat two_product(float a, float b) {
  const float product = a * b;
  return {product, std::fma(a, b, -product)};
}

inline TwoFloat operator+(const TwoFloat& a, const TwoFloat& b) {
  const TwoFloat high = two_sum(a.high, b.high), low = two_sum(a.low, b.low);
  const TwoFloat sum = fast_two_sum(high.high, high.low + low.high);
  return fast_two_sum(sum.high, sum.low + low.low);
}

inline TwoFloat operator-(const TwoFloat& a, const TwoFloat& b) { return a + TwoFloat{-b.high, -b.low}; }

inline TwoFloat operator*(const TwoFloat& a, const TwoFloat& b) {
  const TwoFloat product = two_product(a.high, b.high);
  return fast_two_sum(product.high, product.low + std::fma(a.high, b.low, a.low * b.high));
}

inline TwoFloat operator/(const TwoFloat& a, const TwoFloat& b) {
  const float quotient = a.high / b.high;
  const TwoFloat rest = a - b * TwoFloat{quotient, 0.0f};
  return fast_two_sum(quotient, rest.high / b.high);
}

// Exact up to 2^48 in magnitude.
inline TwoFloat from_integer(std::int64_t value) {
  const auto high = static_cast<float>(value);
  return {high, static_cast<float>(value - static_cast<std::int64_t>(high))};
}

}  // namespace morphcl::reference
