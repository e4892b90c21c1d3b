#include "host/image/srgb.hpp"

#include <gtest/gtest.h>
#include <half.h>

#include <cmath>
#include <limits>

namespace morphcl {
namespace {

half half_of(int bits) {
  half value;
  value.setBits(static_cast<std::uint16_t>(bits));
  return value;
}

// The encoding as IEC 61966-2-1 writes it, in long double: the library goes the other way, from code to value.
long double encoded(long double linear) {
  return linear <= 0.0031308L ? 12.92L * linear : 1.055L * std::pow(linear, 1 / 2.4L) - 0.055L;
}

TEST(Srgb, EveryHalfInTheUnitIntervalIsCorrectlyRounded) {
  const auto& table = srgb8_from_half();
  long double closest_to_boundary = 1;
  for (int bits = 0; bits <= half(1.0f).bits(); ++bits) {
    const long double code = 255 * encoded(static_cast<float>(half_of(bits)));
    EXPECT_EQ(table[static_cast<std::size_t>(bits)], std::lround(code)) << "half " << bits;
    closest_to_boundary = std::min(closest_to_boundary, std::abs(code - std::floor(code) - 0.5L));
  }
  // No half comes so near to a rounding boundary that a last bit of the power could decide.
  EXPECT_GT(closest_to_boundary, 1e-9L);
}

TEST(Srgb, WhatIsOutsideIsClampedAndNanIsBlack) {
  const auto& table = srgb8_from_half();
  for (int bits = half(1.0f).bits(); bits <= 0x7c00; ++bits) EXPECT_EQ(table[static_cast<std::size_t>(bits)], 255);
  for (int bits = 0x7c01; bits <= 0xffff; ++bits) EXPECT_EQ(table[static_cast<std::size_t>(bits)], 0) << bits;
}

TEST(Srgb, DisplayableValuesAreFiniteAndNotNegative) {
  const auto& table = displayable_from_half();
  for (int bits = 0; bits <= 0xffff; ++bits) {
    const float value = half_of(bits);
    const float expected = !(value > 0) ? 0.0f : value > 65504 ? 65504.0f : value;
    ASSERT_EQ(table[static_cast<std::size_t>(bits)], expected) << bits;
  }
}

TEST(Srgb, ValuesOfCodesAreCorrectlyRounded) {
  for (int code = 0; code <= 255; ++code) {
    const long double coded = code / 255.0L;
    const long double linear = coded <= 0.04045L ? coded / 12.92L : std::pow((coded + 0.055L) / 1.055L, 2.4L);
    EXPECT_EQ(linear_from_srgb8(static_cast<std::uint8_t>(code)), static_cast<float>(linear)) << "code " << code;
  }
}

TEST(Srgb, FloatsGoThroughTheNearestHalf) {
  EXPECT_EQ(srgb8(0.0f), 0);
  EXPECT_EQ(srgb8(1.0f), 255);
  EXPECT_EQ(srgb8(1e30f), 255);
  EXPECT_EQ(srgb8(-1.0f), 0);
  EXPECT_EQ(srgb8(0.18f), 118);  // middle grey
}

}  // namespace
}  // namespace morphcl
