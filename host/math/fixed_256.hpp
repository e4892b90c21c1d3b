// Numbers of 256 bits in integer arithmetic: what the elementary functions compute with where twice the precision of a
// double cannot tell to which double their value is rounded.
//
// Nothing is rounded but by leaving out what lies below 2^-256 (Fixed256) or below 2^-256 of the value (Float256).
// Numbers are not negative; callers keep signs aside.
#pragma once

#include <array>
#include <cstdint>

namespace morphcl {

// Sum of limb[i] * 2^(64 i - 256): 64 bits before the point, 256 behind it.
struct Fixed256 {
  std::array<std::uint64_t, 5> limb{};
};

// mantissa * 2^exponent, the mantissa in [1/2, 1), or 0.
struct Float256 {
  Fixed256 mantissa;
  int exponent = 0;
};

constexpr Fixed256 fixed_one{{0, 0, 0, 0, 1}};

// Modulo 2^64; a - b for a >= b; products truncated.
Fixed256 operator+(const Fixed256& a, const Fixed256& b);
Fixed256 operator-(const Fixed256& a, const Fixed256& b);
Fixed256 operator*(const Fixed256& a, const Fixed256& b);
Fixed256 operator/(const Fixed256& a, std::uint64_t divisor);  // divisor > 0
Fixed256 operator/(const Fixed256& a, const Fixed256& b);      // a < 2 b < 2^63
bool operator<(const Fixed256& a, const Fixed256& b);
bool is_zero(const Fixed256& a);
Fixed256 shifted_left(const Fixed256& a, int bits);   // 0 <= bits < 64; modulo 2^64
Fixed256 shifted_right(const Fixed256& a, int bits);  // 0 <= bits

Float256 operator*(const Float256& a, const Float256& b);
Float256 operator/(const Float256& a, const Float256& b);  // b not 0

Float256 to_float_256(const Fixed256& value, int exponent = 0);  // value * 2^exponent
Float256 to_float_256(double value);                             // value >= 0, finite
Fixed256 to_fixed_256(const Float256& value);                    // value < 2^64; truncated

// To nearest; subnormal and infinite where it must be. The value is taken for a little larger than its bits say: half
// an ulp is rounded up.
double to_double(const Float256& value);

}  // namespace morphcl
