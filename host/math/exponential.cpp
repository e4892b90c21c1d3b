#include "morphcl/numerics.hpp"

#include <cmath>
#include <limits>

#include "host/math/double_double.hpp"
#include "host/math/fixed_256.hpp"

namespace morphcl {

namespace {

constexpr double exponential_error = 0x1p-66;

constexpr Fixed256 ln_2{{0x8a0d175b8baafa2b, 0x40f343267298b62d, 0xc9e3b39803f2f6af, 0xb17217f7d1cf79ab, 0}};

// e^x = 2^power * (1 + rest).
struct Exponential {
  int power;
  DoubleDouble rest;
};

// |x| < 710.
MORPHCL_INLINED Exponential fast_exponential(double x) {
  constexpr double one_over_ln_2 = 0x1.71547652b82fep+0, to_integer = 0x1.8p+52;
  const double k = (std::fma(x, one_over_ln_2, to_integer))-to_integer;
  // k times the leading 42 bits of ln 2 is exact, and so is the difference.
  const double near = x - k * 0x1.62e42fefa3800p-1;
  const DoubleDouble correction = DoubleDouble{0x1.ef35793c76730p-45, 0x1.f97b57a079a19p-103} * k;
  const DoubleDouble far = two_sum(near, -correction.high);
  DoubleDouble r = fast_two_sum(far.high, far.low - correction.low);
  r.high *= 0.125;
  r.low *= 0.125;

  // 1/4! + r/5! + ... + r^8/12!
  double tail = 0x1.1eed8eff8d898p-29;
  tail = std::fma(tail, r.high, 0x1.ae64567f544e4p-26);
  tail = std::fma(tail, r.high, 0x1.27e4fb7789f5cp-22);
  tail = std::fma(tail, r.high, 0x1.71de3a556c734p-19);
  tail = std::fma(tail, r.high, 0x1.a01a01a01a01ap-16);
  tail = std::fma(tail, r.high, 0x1.a01a01a01a01ap-13);
  tail = std::fma(tail, r.high, 0x1.6c16c16c16c17p-10);
  tail = std::fma(tail, r.high, 0x1.1111111111111p-7);
  tail = std::fma(tail, r.high, 0x1.5555555555555p-5);
  DoubleDouble sum = fast_two_sum(0x1.5555555555555p-3, std::fma(tail, r.high, 0x1.5555555555555p-57));  // 1/3!
  sum = add_smaller({0.5, 0}, r * sum);
  DoubleDouble rest = add_smaller(r, (r * r) * sum);
  for (int squaring = 0; squaring < 3; ++squaring) rest = rest * add_smaller({2, 0}, rest);
  return {static_cast<int>(k), rest};
}

// e^x = 2^power * mantissa with the mantissa in [1, 2), within 2^-240. |x| < 760.
struct AccurateExponential {
  int power;
  Fixed256 mantissa;
};

AccurateExponential accurate_exponential(double x) {
  const Fixed256 size = to_fixed_256(to_float_256(std::abs(x)));
  AccurateExponential result{static_cast<int>(std::floor(x / 0.6931471805599453)), {}};
  const auto multiple = [](int k) {
    Fixed256 integer;
    integer.limb[4] = static_cast<std::uint64_t>(k);
    return integer * ln_2;
  };
  Fixed256 r;
  if (x >= 0) {
    if (size < multiple(result.power)) --result.power;
    r = size - multiple(result.power);
  } else {
    if (multiple(-result.power) < size) --result.power;
    r = multiple(-result.power) - size;
  }
  if (!(r < ln_2)) {
    r = r - ln_2;
    ++result.power;
  }
  constexpr unsigned terms = 60;
  result.mantissa = fixed_one;
  for (unsigned n = terms; n > 0; --n) result.mantissa = fixed_one + r * result.mantissa / n;
  return result;
}

double accurately_rounded_exponential(double x) {
  const AccurateExponential e = accurate_exponential(x);
  return to_double(to_float_256(e.mantissa, e.power));
}

double accurately_rounded_exponential_minus_1(double x) {
  const AccurateExponential e = accurate_exponential(x);
  // Where e^x is above 2^200 the 1 is below the precision.
  if (e.power > 200) return to_double(to_float_256(e.mantissa, e.power));
  if (e.power >= 0) return to_double(to_float_256(e.mantissa - shifted_right(fixed_one, e.power), e.power));
  return -to_double(to_float_256(fixed_one - shifted_right(e.mantissa, -e.power)));
}

constexpr double tiny_exponent = 0x1p-54;

}  // namespace

MORPHCL_WITH_HARDWARE_FMA double exponential(double x) {
  if (std::isnan(x)) return x;
  if (x > 710) return std::numeric_limits<double>::infinity();
  if (x < -746) return 0;
  if (std::abs(x) < tiny_exponent) return 1;
  // Beyond these the result may be subnormal or infinite.
  if (x > -708 && x < 709) {
    const Exponential e = fast_exponential(x);
    if (const auto mantissa = rounded(add_smaller({1, 0}, e.rest), exponential_error))
      return std::ldexp(*mantissa, e.power);
  }
  return accurately_rounded_exponential(x);
}

MORPHCL_WITH_HARDWARE_FMA double exponential_minus_1(double x) {
  if (std::isnan(x)) return x;
  if (x > 710) return std::numeric_limits<double>::infinity();
  if (x < -38) return -1;  // e^x is less than a quarter of an ulp
  if (std::abs(x) < tiny_exponent) return x;
  if (x < 709) {
    const Exponential e = fast_exponential(x);
    DoubleDouble value = e.rest;
    if (e.power != 0) {
      const double scale = std::ldexp(1.0, e.power);
      value = DoubleDouble{value.high * scale, value.low * scale} + (DoubleDouble{scale, 0} - DoubleDouble{1, 0});
    }
    if (const auto result = rounded(value, exponential_error)) return *result;
  }
  return accurately_rounded_exponential_minus_1(x);
}

}  // namespace morphcl
