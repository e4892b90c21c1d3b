// Numbers of about 48 bits: unevaluated sums of two floats, sixteen at a time.
//
// Method: TwoSum (Knuth), FastTwoSum (Dekker), products with fma; relative errors, u = 2^-24, after Joldes, Muller and
// Popescu (2017): sum 3 u^2, product 5 u^2, quotient 15 u^2, barring overflow and underflow.

#ifndef MORPHCL_TWO_FLOAT_H
#define MORPHCL_TWO_FLOAT_H

#include "vector.h"

typedef struct {
  float16 high, low;  // |low| <= ulp(high) / 2
} TwoFloats;

ALWAYS_INLINE TwoFloats two_floats(float16 high, float16 low) {
  TwoFloats value;
  value.high = high;
  value.low = low;
  return value;
}

// a + b exactly; |a| >= |b|, or a = 0.
ALWAYS_INLINE TwoFloats fast_two_sum(float16 a, float16 b) {
  const float16 sum = a + b;
  return two_floats(sum, b - (sum - a));
}

// a + b exactly.
ALWAYS_INLINE TwoFloats two_sum(float16 a, float16 b) {
  const float16 sum = a + b, b_part = sum - a;
  return two_floats(sum, (a - (sum - b_part)) + (b - b_part));
}

// a * b exactly.
ALWAYS_INLINE TwoFloats two_product(float16 a, float16 b) {
  const float16 product = a * b;
  return two_floats(product, fma(a, b, -product));
}

ALWAYS_INLINE TwoFloats sum_of(TwoFloats a, TwoFloats b) {
  const TwoFloats high = two_sum(a.high, b.high), low = two_sum(a.low, b.low);
  const TwoFloats sum = fast_two_sum(high.high, high.low + low.high);
  return fast_two_sum(sum.high, sum.low + low.low);
}

ALWAYS_INLINE TwoFloats difference_of(TwoFloats a, TwoFloats b) { return sum_of(a, two_floats(-b.high, -b.low)); }

ALWAYS_INLINE TwoFloats product_of(TwoFloats a, TwoFloats b) {
  const TwoFloats product = two_product(a.high, b.high);
  return fast_two_sum(product.high, product.low + fma(a.high, b.low, a.low * b.high));
}

ALWAYS_INLINE TwoFloats quotient_of(TwoFloats a, TwoFloats b) {
  const float16 quotient = a.high / b.high;
  const TwoFloats rest = difference_of(a, product_of(b, two_floats(quotient, (float16)0.0f)));
  return fast_two_sum(quotient, rest.high / b.high);
}

// Exact up to 2^48 in magnitude.
ALWAYS_INLINE TwoFloats from_longs(long16 value) {
  const float16 high = convert_float16(value);
  return two_floats(high, convert_float16(value - convert_long16(high)));
}
ALWAYS_INLINE TwoFloats from_ints(int16 value) {
  const float16 high = convert_float16(value);
  return two_floats(high, convert_float16(value - convert_int16(high)));
}

#endif
