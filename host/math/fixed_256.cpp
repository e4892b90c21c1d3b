#include "host/math/fixed_256.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace morphcl {

namespace {

__extension__ using Wide = unsigned __int128;
constexpr std::size_t limbs = 5;

std::uint64_t low(Wide value) { return static_cast<std::uint64_t>(value); }

}  // namespace

Fixed256 operator+(const Fixed256& a, const Fixed256& b) {
  Fixed256 sum;
  Wide carry = 0;
  for (std::size_t i = 0; i < limbs; ++i) {
    carry += Wide{a.limb[i]} + b.limb[i];
    sum.limb[i] = low(carry);
    carry >>= 64;
  }
  return sum;
}

Fixed256 operator-(const Fixed256& a, const Fixed256& b) {
  Fixed256 difference;
  std::uint64_t borrow = 0;
  for (std::size_t i = 0; i < limbs; ++i) {
    const Wide part = Wide{a.limb[i]} - b.limb[i] - borrow;
    difference.limb[i] = low(part);
    borrow = low(part >> 64) != 0 ? 1 : 0;
  }
  return difference;
}

Fixed256 operator*(const Fixed256& a, const Fixed256& b) {
  std::array<std::uint64_t, 2 * limbs> product{};
  for (std::size_t i = 0; i < limbs; ++i) {
    Wide carry = 0;
    for (std::size_t j = 0; j < limbs; ++j) {
      carry += Wide{a.limb[i]} * b.limb[j] + product[i + j];
      product[i + j] = low(carry);
      carry >>= 64;
    }
    product[i + limbs] = low(carry);
  }
  Fixed256 result;
  for (std::size_t i = 0; i < limbs; ++i) result.limb[i] = product[i + 4];
  return result;
}

Fixed256 operator/(const Fixed256& a, std::uint64_t divisor) {
  Fixed256 quotient;
  Wide rest = 0;
  for (std::size_t i = limbs; i-- > 0;) {
    rest = rest << 64 | a.limb[i];
    quotient.limb[i] = low(rest / divisor);
    rest %= divisor;
  }
  return quotient;
}

// Long division, bit by bit.
Fixed256 operator/(const Fixed256& a, const Fixed256& b) {
  Fixed256 quotient, rest = a;
  for (int bit = 256; bit >= 0; --bit) {
    if (!(rest < b)) {
      rest = rest - b;
      quotient.limb[static_cast<std::size_t>(bit / 64)] |= std::uint64_t{1} << bit % 64;
    }
    rest = shifted_left(rest, 1);
  }
  return quotient;
}

bool operator<(const Fixed256& a, const Fixed256& b) {
  for (std::size_t i = limbs; i-- > 0;)
    if (a.limb[i] != b.limb[i]) return a.limb[i] < b.limb[i];
  return false;
}

bool is_zero(const Fixed256& a) { return a.limb == Fixed256{}.limb; }

Fixed256 shifted_left(const Fixed256& a, int bits) {
  if (bits == 0) return a;
  Fixed256 result;
  for (std::size_t i = 0; i < limbs; ++i)
    result.limb[i] = a.limb[i] << bits | (i == 0 ? 0 : a.limb[i - 1] >> (64 - bits));
  return result;
}

Fixed256 shifted_right(const Fixed256& a, int bits) {
  Fixed256 result;
  const auto whole = static_cast<std::size_t>(bits / 64);
  const int part = bits % 64;
  for (std::size_t i = 0; i + whole < limbs; ++i) {
    const std::size_t from = i + whole;
    const std::uint64_t above = part == 0 || from + 1 == limbs ? 0 : a.limb[from + 1] << (64 - part);
    result.limb[i] = a.limb[from] >> part | above;
  }
  return result;
}

Float256 operator*(const Float256& a, const Float256& b) {
  // Both mantissas doubled, so that the truncated product in [1, 4) keeps 256 bits.
  return to_float_256(shifted_left(a.mantissa, 1) * shifted_left(b.mantissa, 1), a.exponent + b.exponent - 2);
}

Float256 operator/(const Float256& a, const Float256& b) {
  return to_float_256(a.mantissa / b.mantissa, a.exponent - b.exponent);
}

Float256 to_float_256(const Fixed256& value, int exponent) {
  if (is_zero(value)) return {};
  Float256 result{value, exponent};
  for (; result.mantissa.limb[4] == 0 && result.mantissa.limb[3] == 0; result.exponent -= 64) {
    for (std::size_t i = 3; i > 0; --i) result.mantissa.limb[i] = result.mantissa.limb[i - 1];
    result.mantissa.limb[0] = 0;
  }
  if (result.mantissa.limb[4] != 0) {
    const int bits = 64 - std::countl_zero(result.mantissa.limb[4]);
    return {shifted_right(result.mantissa, bits), result.exponent + bits};
  }
  const int bits = std::countl_zero(result.mantissa.limb[3]);
  return {shifted_left(result.mantissa, bits), result.exponent - bits};
}

Float256 to_float_256(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  Float256 result;
  result.mantissa.limb[3] = static_cast<std::uint64_t>(std::ldexp(fraction, 64));
  result.exponent = exponent;
  return result;
}

Fixed256 to_fixed_256(const Float256& value) {
  if (value.exponent <= 0) return shifted_right(value.mantissa, -value.exponent);
  // At most 64 bits to the left: one limb less the rest to the right.
  Fixed256 limb_higher;
  for (std::size_t i = 1; i < limbs; ++i) limb_higher.limb[i] = value.mantissa.limb[i - 1];
  return shifted_right(limb_higher, 64 - value.exponent);
}

double to_double(const Float256& value) {
  if (is_zero(value.mantissa)) return 0;
  constexpr int min_exponent = -1074;
  const int ulp_exponent = std::max(value.exponent - 53, min_exponent);
  const int bits = value.exponent - ulp_exponent;  // that the double has: 53, or fewer where it is subnormal
  if (bits < 0) return 0;
  // One bit more than the double's: the half.
  const std::uint64_t doubled = value.mantissa.limb[3] >> (63 - bits);
  const std::uint64_t ulps = (doubled + 1) / 2;
  return std::ldexp(static_cast<double>(ulps), ulp_exponent);
}

}  // namespace morphcl
