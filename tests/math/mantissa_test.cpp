// Floats of fewer mantissa bits, judged by exact integers.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"

namespace morphcl {
namespace {

constexpr float largest_float = std::numeric_limits<float>::max();
constexpr float infinite_float = std::numeric_limits<float>::infinity();

float float_of(std::uint32_t bits) { return std::bit_cast<float>(bits); }
std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value); }

float rounded_to(float value, int bits, float kept = 0) {
  round_mantissas({&value, 1}, bits, kept);
  return value;
}

// 24 bits with the hidden one, in units of the last place of `like`'s binade; `value` is of that binade or is the power
// of two above it.
std::int64_t units_of(std::uint32_t value, std::uint32_t like) {
  const std::uint32_t exponent = value >> 23 & 0xff, unit = like >> 23 & 0xff;
  const std::int64_t mantissa = (value & 0x7fffff) | 0x800000;
  return mantissa << (exponent - unit);
}

// |x - r| / |x| <= u / (1 + u) with u = 2^-(bits + 1), as |x - r| (2^(bits + 1) + 1) <= |x| in integers; what is
// dropped is 0; no other value of as many bits is nearer.
void expect_nearest(std::uint32_t x, std::uint32_t r, int bits) {
  const int dropped = float_mantissa_bits - bits;
  ASSERT_EQ(r >> 31, x >> 31) << std::hex << x;
  ASSERT_EQ(r & ((1u << dropped) - 1), 0u) << std::hex << x << " became " << r;
  const std::int64_t exact = units_of(x, x), off = std::abs(exact - units_of(r, x));
  ASSERT_LE(off * ((std::int64_t{1} << (bits + 1)) + 1), exact) << std::hex << x << " became " << r;
  ASSERT_LE(2 * off, std::int64_t{1} << dropped) << std::hex << x << " became " << r;
}

TEST(Mantissa, EveryMantissaKeepsTheDerivedBound) {
  constexpr std::uint32_t block = 1 << 16;
  std::vector<float> values(block);
  for (const int bits : {0, 9, 19, 22})
    for (const std::uint32_t sign_and_exponent : {0x00800000u, 0x3f800000u, 0xc0000000u})
      for (std::uint32_t first = 0; first < 1u << 23; first += block) {
        for (std::uint32_t i = 0; i < block; ++i) values[i] = float_of(sign_and_exponent | (first + i));
        round_mantissas(values, bits);
        for (std::uint32_t i = 0; i < block; ++i) {
          const std::uint32_t x = sign_and_exponent | (first + i), r = bits_of(values[i]);
          const int dropped = float_mantissa_bits - bits;
          const std::int64_t exact = units_of(x, x), off = std::abs(exact - units_of(r, x));
          if ((r & ((1u << dropped) - 1)) != 0 || 2 * off > std::int64_t{1} << dropped ||
              off * ((std::int64_t{1} << (bits + 1)) + 1) > exact)
            return expect_nearest(x, r, bits);
        }
      }
}

TEST(Mantissa, EveryExponentKeepsTheDerivedBound) {
  std::mt19937 random(17);
  for (int bits = 0; bits <= 22; ++bits)
    for (std::uint32_t exponent = 1; exponent <= 254; ++exponent)
      for (int i = 0; i < 64; ++i) {
        const std::uint32_t x = (random() & 0x807fffffu) | exponent << 23;
        const std::uint32_t r = bits_of(rounded_to(float_of(x), bits));
        if (exponent == 254 && r == x) continue;  // would have become infinity
        expect_nearest(x, r, bits);
        if (HasFailure()) return;
      }
}

TEST(Mantissa, TiesGoToEvenAndNeighboursToTheirSide) {
  const float one = 1, tie = 1 + std::ldexp(1.0f, -10), above = std::nextafter(tie, 2.0f);
  EXPECT_EQ(rounded_to(tie, 9), one);
  EXPECT_EQ(rounded_to(above, 9), one + std::ldexp(1.0f, -9));
  EXPECT_EQ(rounded_to(one + 3 * std::ldexp(1.0f, -10), 9), one + 2 * std::ldexp(1.0f, -9));
  EXPECT_EQ(rounded_to(std::nextafter(2.0f, 1.0f), 9), 2.0f) << "into the next binade";
  EXPECT_EQ(rounded_to(-tie, 9), -one);
}

TEST(Mantissa, WhatHasNoBitsToLoseStays) {
  for (int bits = 0; bits <= 23; ++bits) {
    for (int exponent = -126; exponent <= 127; ++exponent) {
      const float power = std::ldexp(1.0f, exponent);
      EXPECT_EQ(rounded_to(power, bits), power);
      EXPECT_EQ(rounded_to(-power, bits), -power);
    }
    for (const std::uint32_t x : {0u, 0x80000000u, 1u, 0x80000001u, 0x00012345u, 0x007fffffu, 0x807fffffu, 0x7f800000u,
                                  0xff800000u, 0x7f800001u, 0x7fc00000u, 0x7fffffffu, 0xffffffffu, 0xffabcdefu})
      EXPECT_EQ(bits_of(rounded_to(float_of(x), bits)), x) << std::hex << x;
  }
}

TEST(Mantissa, TheLargestFiniteStaysFinite) {
  for (int bits = 0; bits <= 22; ++bits) {
    EXPECT_EQ(rounded_to(largest_float, bits), largest_float);
    EXPECT_EQ(rounded_to(-largest_float, bits), -largest_float);
    // The last that is nearer to a finite value of so many bits than to 2^128.
    const float last = float_of(0x7f7fffff - (1u << (23 - bits - 1)));
    EXPECT_LT(rounded_to(last, bits), infinite_float);
    if (bits < 22) {
      EXPECT_NE(rounded_to(last, bits), last) << "it is rounded";
    }
  }
}

TEST(Mantissa, OneValueIsKept) {
  const float background = 1e10f;
  EXPECT_NE(rounded_to(background, 12), background);
  EXPECT_EQ(rounded_to(background, 12, background), background);
  EXPECT_NE(rounded_to(std::nextafter(background, 0.0f), 12, background), std::nextafter(background, 0.0f));
}

// 1 <= error (2^(bits + 1) + 1) in integers of 128 bits: error is m 2^-s.
bool is_enough(int bits, double error) {
  int exponent = 0;
  const double fraction = std::frexp(error, &exponent);
  const auto m = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  const int s = 53 - exponent;
  if (s > 100) return false;
  using Wide = unsigned __int128;
  return Wide{m} * ((Wide{1} << (bits + 1)) + 1) >= Wide{1} << s;
}

TEST(Mantissa, TheFewestBitsThatKeepTheErrorAreTaken) {
  std::vector<double> errors{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-30, 5e-324, 0.1};
  for (int bits = 3; bits <= 23; ++bits) {  // u and u / (1 + u), with their neighbours: where one bit more is needed
    const double u = std::ldexp(1.0, -(bits + 1)), bound = u / (1 + u);
    for (const double error : {u, bound})
      for (const double near : {std::nextafter(error, 0.0), error, std::nextafter(error, 1.0)}) errors.push_back(near);
  }
  for (const double error : errors) {
    const int bits = mantissa_bits_for(error);
    EXPECT_TRUE(bits == 23 || is_enough(bits, error)) << error << ": " << bits;
    EXPECT_TRUE(bits == 0 || !is_enough(bits - 1, error)) << error << ": " << bits << " are more than needed";
  }
  EXPECT_EQ(mantissa_bits_for(1e-6), 19);
  EXPECT_EQ(mantissa_bits_for(1e-4), 13);
  EXPECT_EQ(mantissa_bits_for(1e-8), 23);
}

TEST(Mantissa, ABoundOutOfRangeIsRefused) {
  for (const double error : {0.0, -0.0, -1e-6, 0.1000001, 1.0, double{infinite_float}, std::nan("")}) {
    try {
      mantissa_bits_for(error);
      ADD_FAILURE() << error;
    } catch (const Error& refusal) {
      EXPECT_EQ(refusal.kind(), ErrorKind::usage);
      EXPECT_NE(refusal.message().find("at most 0.1 is possible"), std::string::npos) << refusal.message();
    }
  }
}

}  // namespace
}  // namespace morphcl
