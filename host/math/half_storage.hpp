// Numbers stored in 16 bits: as halves, and as halves about the middle of their range.
//
// A double is rounded to the half directly, to nearest, ties to even: by way of fp32 it would be rounded twice, and
// 1 + 2^-11 + 2^-40 come out as 1 instead of 1 + 2^-10.
#pragma once

#include <cstdint>
#include <span>

namespace morphcl {

// The bits of the nearest half; infinity from 65520 on, NaN for NaN.
std::uint16_t to_half(double value);
double from_half(std::uint16_t bits);  // exact

// value = bias + scale * half. Halves are spaced by half a unit at 1000, so coordinates far from the origin are stored
// about their middle: the error is at most 2^-12 of half the range.
struct HalfRange {
  double bias = 0;
  double scale = 1;  // a power of two that brings all values into [-1, 1]

  std::uint16_t store(double value) const { return to_half((value - bias) / scale); }
  double load(std::uint16_t bits) const { return bias + scale * from_half(bits); }
};

// The range of finite values; of none, {0, 1}.
HalfRange half_range(std::span<const double> values);

}  // namespace morphcl
