// Sine and cosine of a reduced angle with about 70 bits: the first of two phases of the correctly rounded functions.
//
// r in [0, pi/4], known as a sum of two doubles. Taylor series in r^2, the leading terms in double-double arithmetic,
// the others in double. Relative error of either at most 2^-68: the terms left out are below 2^-82; the double part
// begins with r^8/9! < 2^-21 (sine) and r^10/10! < 2^-25 (cosine) of the value and is within 4u relative, 2^-72; each
// of the ten double-double operations adds less than 2^-102.
#pragma once

#include "host/math/double_double.hpp"

namespace morphcl {

constexpr double sine_kernel_error = 0x1p-68;

MORPHCL_INLINED DoubleDouble sine_kernel(const DoubleDouble& r) {
  const DoubleDouble z = r * r;
  // 1/9! - z/11! + ... + z^6/21!
  double tail = 0x1.71b8ef6dcf572p-66;
  tail = std::fma(tail, z.high, -0x1.2f49b46814157p-57);
  tail = std::fma(tail, z.high, 0x1.952c77030ad4ap-49);
  tail = std::fma(tail, z.high, -0x1.ae7f3e733b81fp-41);
  tail = std::fma(tail, z.high, 0x1.6124613a86d09p-33);
  tail = std::fma(tail, z.high, -0x1.ae64567f544e4p-26);
  tail = std::fma(tail, z.high, 0x1.71de3a556c734p-19);
  DoubleDouble sum = fast_two_sum(-0x1.a01a01a01a01ap-13, std::fma(tail, z.high, -0x1.a01a01a01a01ap-73));  // 1/7!
  sum = add_smaller({0x1.1111111111111p-7, 0x1.1111111111111p-63}, z * sum);                                // 1/5!
  sum = add_smaller({-0x1.5555555555555p-3, -0x1.5555555555555p-57}, z * sum);                              // 1/3!
  return add_smaller(r, (r * z) * sum);
}

MORPHCL_INLINED DoubleDouble cosine_kernel(const DoubleDouble& r) {
  const DoubleDouble z = r * r;
  // 1/10! - z/12! + ... + z^6/22!, negated
  double tail = -0x1.0ce396db7f853p-70;
  tail = std::fma(tail, z.high, 0x1.e542ba4020225p-62);
  tail = std::fma(tail, z.high, -0x1.6827863b97d97p-53);
  tail = std::fma(tail, z.high, 0x1.ae7f3e733b81fp-45);
  tail = std::fma(tail, z.high, -0x1.93974a8c07c9dp-37);
  tail = std::fma(tail, z.high, 0x1.1eed8eff8d898p-29);
  tail = std::fma(tail, z.high, -0x1.27e4fb7789f5cp-22);
  DoubleDouble sum = fast_two_sum(0x1.a01a01a01a01ap-16, std::fma(tail, z.high, 0x1.a01a01a01a01ap-76));  // 1/8!
  sum = add_smaller({-0x1.6c16c16c16c17p-10, 0x1.f49f49f49f49fp-65}, z * sum);                            // 1/6!
  sum = add_smaller({0x1.5555555555555p-5, 0x1.5555555555555p-59}, z * sum);                              // 1/4!
  sum = add_smaller({-0.5, 0}, z * sum);
  return add_smaller({1, 0}, z * sum);
}

}  // namespace morphcl
