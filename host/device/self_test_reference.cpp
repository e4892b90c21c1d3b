#include "host/device/self_test_reference.hpp"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <iterator>

static_assert(FLT_EVAL_METHOD == 0, "float expressions must be evaluated in float");

namespace morphcl {

namespace {

std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value); }

constexpr float special_values[] = {
    0.0f,
    -0.0f,
    1.0f,
    -1.0f,
    3.0f,
    0x1.555556p-2f,  // 1/3
    0x1.000002p0f,   // next to 1, above and below
    0x1.fffffep-1f,
    0x1p-149f,  // smallest and largest denormal, smallest normal, and what products take below it
    0x0.fffffep-126f,
    0x1p-126f,
    -0x1.8p-75f,
    0x1.8p-74f,
    0x1p-25f,  // below, at and above half the smallest half; the smallest normal half
    0x1.8p-24f,
    0x1.000002p-25f,
    0x1p-14f,
    0x1.004p0f,  // ties between two halves: to the even one below, to the even one above
    0x1.00cp0f,
    65504.0f,  // the largest half, the last float that rounds to it, the first that overflows
    65519.996f,
    65520.0f,
    8388608.5f,  // ties between integers, and an integer between floats
    0x1.921fb6p1f,
    0x1.fffffep127f,
    INFINITY,
};

// SplitMix64 (Steele, Lea, Flood 2014).
class Sequence {
 public:
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  float any_finite() {
    for (;;) {
      const float value = std::bit_cast<float>(static_cast<std::uint32_t>(next()));
      if (std::isfinite(value)) return value;
    }
  }
  float one_to_two() { return std::bit_cast<float>(0x3f800000u | static_cast<std::uint32_t>(next() & 0x7fffff)); }

 private:
  std::uint64_t state_ = 1;
};

// Rounds to nearest, ties to even; written with integers so that it owes nothing to the hardware's conversion.
std::uint32_t half_bits(float value) {
  const std::uint32_t bits = bits_of(value), sign = bits >> 16 & 0x8000, magnitude = bits & 0x7fffffff;
  if (magnitude >= 0x47800000) return sign | 0x7c00;  // from 2^16 on, infinity included
  // The significand and how many of its bits fall off; below 2^-14 more of them do, until none is left.
  const int exponent = std::max<int>(static_cast<int>(magnitude >> 23), 1);
  const std::uint32_t significand = (magnitude & 0x7fffff) | (magnitude >> 23 ? 0x800000u : 0u);
  const int dropped = exponent >= 113 ? 13 : std::min(13 + 113 - exponent, 31);
  const std::uint32_t kept = significand >> dropped, rest = significand & ((1u << dropped) - 1);
  const std::uint32_t half_way = 1u << (dropped - 1);
  const std::uint32_t rounded = kept + (rest > half_way || (rest == half_way && kept & 1));
  // A carry out of the significand moves into the exponent, up to infinity, as it should.
  return sign | (rounded + (exponent >= 113 ? static_cast<std::uint32_t>(exponent - 113) << 10 : 0));
}

float half_value(std::uint32_t half) {
  const int exponent = static_cast<int>(half >> 10 & 31), significand = static_cast<int>(half & 0x3ff);
  const float magnitude = exponent == 0 ? std::ldexp(static_cast<float>(significand), -24)
                                        : std::ldexp(static_cast<float>(significand + 1024), exponent - 25);
  return half & 0x8000 ? -magnitude : magnitude;
}

// A finite half made of a's bits, as the kernel makes it.
std::uint32_t finite_half(float a) {
  const std::uint32_t bits = bits_of(a), magnitude = bits & 0x7fff;
  return (magnitude >= 0x7c00 ? magnitude & 0x3ff : magnitude) | (bits >> 16 & 0x8000);
}

std::int32_t nearest_int(float a) {
  constexpr float limit = 0x1.fffffep30f;
  return static_cast<std::int32_t>(std::nearbyint(std::clamp(a, -limit, limit)));
}

// Sign and magnitude to a number line.
std::int64_t ordered(std::uint32_t bits, std::uint32_t sign_bit) {
  const std::int64_t magnitude = bits & (sign_bit - 1);
  return bits & sign_bit ? -magnitude : magnitude;
}

}  // namespace

const char* self_test_name(SelfTest test) {
  static constexpr const char* names[self_test_count] = {
      "a+b",           "a-b",           "a*b",          "a/b",          "sqrt",  "fma",  "a*b+c",
      "float to half", "half to float", "int to float", "float to int", "a+b-a", "a*b/b"};
  return names[static_cast<int>(test)];
}

bool is_vector_only(SelfTest test) { return test == SelfTest::float_to_half || test == SelfTest::half_to_float; }

SelfTestOperands self_test_operands() {
  SelfTestOperands operands;
  const auto add = [&](float a, float b, float c) {
    operands.a.push_back(a);
    operands.b.push_back(b);
    operands.c.push_back(c);
  };
  constexpr std::size_t specials = std::size(special_values);
  static_assert(specials * specials <= self_test_elements * 3 / 4, "room for the other families");
  for (std::size_t i = 0; i < specials; ++i)
    for (std::size_t j = 0; j < specials; ++j)
      add(special_values[i], special_values[j], special_values[(i * 7 + j * 3) % specials]);
  Sequence sequence;
  while (operands.a.size() < self_test_elements) {
    // The rounding error of a*b is all that is left of a*b+c when it is fused, and nothing when it is not.
    const float a = sequence.one_to_two(), b = sequence.one_to_two();
    add(a, b, -(a * b));
    if (operands.a.size() == self_test_elements) break;
    const float x = sequence.any_finite(), y = sequence.any_finite();
    add(x, y, sequence.any_finite());
  }
  return operands;
}

std::uint32_t self_test_answer(SelfTest test, float a, float b, float c) {
  switch (test) {
    case SelfTest::sum:
      return bits_of(a + b);
    case SelfTest::difference:
      return bits_of(a - b);
    case SelfTest::product:
      return bits_of(a * b);
    case SelfTest::quotient:
      return bits_of(a / b);
    case SelfTest::square_root:
      return bits_of(std::sqrt(std::abs(a)));
    case SelfTest::fused_multiply_add:
      return bits_of(std::fma(a, b, c));
    case SelfTest::multiply_then_add:
      return bits_of(a * b + c);
    case SelfTest::float_to_half:
      return half_bits(a);
    case SelfTest::half_to_float:
      return bits_of(half_value(finite_half(a)));
    case SelfTest::int_to_float:
      return bits_of(static_cast<float>(std::bit_cast<std::int32_t>(a)));
    case SelfTest::float_to_int:
      return static_cast<std::uint32_t>(nearest_int(a));
    case SelfTest::add_then_subtract:
      return bits_of((a + b) - a);
    case SelfTest::multiply_then_divide:
      return bits_of(a * b / b);
  }
  std::abort();
}

std::uint64_t self_test_distance(SelfTest test, std::uint32_t answer, std::uint32_t result) {
  if (answer == result) return 0;
  const auto distance = [](std::int64_t a, std::int64_t b) { return static_cast<std::uint64_t>(std::abs(a - b)); };
  if (test == SelfTest::float_to_int)
    return distance(static_cast<std::int32_t>(answer), static_cast<std::int32_t>(result));
  if (test == SelfTest::float_to_half)
    return std::max<std::uint64_t>(1, distance(ordered(answer, 0x8000), ordered(result, 0x8000)));
  if (std::isnan(std::bit_cast<float>(answer)) && std::isnan(std::bit_cast<float>(result))) return 0;
  // Zeros of different sign are 0 apart on the number line, yet not the same.
  return std::max<std::uint64_t>(1, distance(ordered(answer, 0x80000000), ordered(result, 0x80000000)));
}

}  // namespace morphcl
