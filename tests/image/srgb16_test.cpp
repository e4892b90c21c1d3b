// Codes of 16 bits are correctly rounded for every ratio of two halves: the boundaries between codes are those of an
// arithmetic of 113 bits but for some units, and no ratio is so near to one that these units could decide.
#include <gtest/gtest.h>
#include <half.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>

#include "host/image/srgb.hpp"
#include "lab/accuracy/random.hpp"

namespace morphcl {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;  // 113 bits

constexpr int boundary_count = 65535;
constexpr int last_straight =
    2650;  // the last boundary on the straight piece: 5301 / 131070 <= 0.04045 < 5303 / 131070
constexpr double boundary_error = 0x1p-49;  // relative, of the boundaries above, as srgb.hpp states it

// What sRGB takes to the power 2.4, for the code twice / 2.
Quad base_of(int twice) { return (Quad(twice) / 131070 + Quad(55) / 1000) / (Quad(1055) / 1000); }

// x^5 == base^12 is x == base^2.4, without a power that is not whole.
Quad fifth(const Quad& x) { return x * x * (x * x) * x; }
Quad twelfth(const Quad& x) {
  const Quad third = x * x * x;
  return third * third * (third * third);
}

TEST(Srgb16, StraightBoundariesAreTheNearestDoubles) {
  const std::vector<double>& boundaries = srgb16_boundaries();
  ASSERT_EQ(boundaries.size(), static_cast<std::size_t>(boundary_count));
  constexpr double divisor = 646.0 * 65535;  // (2k + 1) / 131070 / 12.92 = 25 (2k + 1) / divisor
  for (int k = 0; k <= last_straight; ++k) {
    const double found = boundaries[static_cast<std::size_t>(k)];
    const double rest = std::fma(found, divisor, -25.0 * (2 * k + 1));  // exact
    ASSERT_LE(std::abs(rest), (std::nextafter(found, 1.0) - found) / 2 * divisor) << k;
  }
}

// (1 + e)^5 is 1 + 5 e but for 10 e^2; the products of 113 bits add 2^-108.
TEST(Srgb16, OtherBoundariesKeepTheirBound) {
  const std::vector<double>& boundaries = srgb16_boundaries();
  double largest = 0;
  for (int k = last_straight + 1; k < boundary_count; ++k) {
    const Quad ratio = fifth(Quad(boundaries[static_cast<std::size_t>(k)])) / twelfth(base_of(2 * k + 1));
    largest = std::max(largest, std::abs(static_cast<double>(Quad(ratio - 1))) / 5);
  }
  EXPECT_LT(largest, boundary_error * (1 - 1e-6));
}

// Euclid's algorithm: the two fractions of denominators up to `most` that enclose m / d most closely. `check` gets
// both.
template <class Check>
void with_neighbours(std::uint64_t m, std::uint64_t d, std::uint64_t most, const Check& check) {
  std::uint64_t h0 = 0, k0 = 1, h1 = 1, k1 = 0;  // the convergents so far
  for (std::uint64_t a = m, b = d; b != 0;) {
    const std::uint64_t term = a / b, room = k1 == 0 ? term : std::min(term, (most - k0) / k1);
    const std::uint64_t h = h0 + room * h1, k = k0 + room * k1;
    if (room < term) {  // the next convergent is beyond: this one between the two stands on its side
      check(h, k);
      check(h1, k1);
      return;
    }
    h0 = h1;
    k0 = k1;
    h1 = h;
    k1 = k;
    const std::uint64_t rest = a % b;
    a = b;
    b = rest;
  }
  check(h1, k1);  // exact
}

// Halves are n 2^e with n up to 2047, so their ratios are those of two n of 1024 to 2047, times a power of two. A
// boundary that is scaled to 1..2 or to 1/2..1 is compared with the nearest of these, exactly, in units of its last
// bit.
TEST(Srgb16, NoRatioOfHalvesIsNearACurvedBoundary) {
  constexpr std::uint64_t largest_significand = 2047;
  // The boundary's error, in units of a double's last bit at most 2^53 of them, and the rounding of the ratio.
  constexpr double units = boundary_error * 0x1p53 + 1;
  double smallest = 1e300;
  for (int k = last_straight + 1; k < boundary_count; ++k) {
    int exponent = 0;
    const auto m = static_cast<std::uint64_t>(
        std::ldexp(std::frexp(srgb16_boundaries()[static_cast<std::size_t>(k)], &exponent), 53));
    for (const std::uint64_t d : {std::uint64_t{1} << 52, std::uint64_t{1} << 53})
      with_neighbours(m, d, largest_significand, [&](std::uint64_t h, std::uint64_t q) {
        const auto distance = static_cast<std::int64_t>(m * q - h * d);  // far below 2^63, whatever overflows
        smallest = std::min(smallest, std::abs(static_cast<double>(distance)) / static_cast<double>(q));
      });
  }
  EXPECT_GT(smallest, units);
}

// On the straight piece a ratio may lie on a boundary, and else is no nearer to one than 2^-37 of it: two fractions
// with denominators of 11 and 26 bits. There, then, everything is compared with whole numbers.
TEST(Srgb16, StraightCodesAreExactAndHalvesGoUp) {
  accuracy::Random random(3);
  int ties = 0;
  const auto check = [&ties](std::uint64_t n_color, std::uint64_t n_alpha, int shift) {
    const float alpha = std::ldexp(static_cast<float>(n_alpha), -11);
    const float color = std::ldexp(static_cast<float>(n_color), -11 - shift);
    if (color / alpha > 0.0031f) return;
    // floor(323 65535 color / (25 alpha) + 1/2)
    const std::uint64_t numerator = 2 * 323 * std::uint64_t{65535} * n_color, denominator = (50 * n_alpha) << shift;
    const std::uint64_t expected = (numerator + denominator / 2) / denominator;
    ties += (numerator + denominator / 2) % denominator == 0;
    ASSERT_EQ(srgb16_of_ratio(color, alpha), expected) << n_color << " / " << n_alpha << " >> " << shift;
  };
  for (int i = 0; i < 20000; ++i)
    check(1024 + random.bits() % 1024, 1024 + random.bits() % 1024, 8 + static_cast<int>(random.bits() % 6));
  // (2k + 1) 25 / (646 65535) with 2k + 1 up to 5301 has a denominator below 2048 where 2k + 1 is 4369 = 17 257 (then
  // it is 2 969) or 4883 = 19 257 (2 867).
  for (const std::uint64_t alpha : {969u, 1938u, 867u, 1734u})
    for (std::uint64_t color = 1; color < 2048; ++color)
      for (int shift = 1; shift < 12; ++shift) check(color, alpha, shift);
  EXPECT_GE(ties, 20);
}

TEST(Srgb16, CodesOfRandomRatiosLieBetweenTheirBoundaries) {
  accuracy::Random random(4);
  for (int i = 0; i < 3000; ++i) {
    const auto n_alpha = static_cast<float>(1024 + random.bits() % 1024),
               n_color = static_cast<float>(random.bits() % 2048);
    const float color = std::ldexp(n_color, -static_cast<int>(random.bits() % 8));
    if (color / n_alpha < 0.0032f) continue;
    const int code = srgb16_of_ratio(std::ldexp(color, -11), std::ldexp(n_alpha, -11));
    const Quad value = fifth(Quad(color) / Quad(n_alpha));
    if (color < n_alpha) {
      EXPECT_LE(twelfth(base_of(2 * code - 1)), value);
    }
    if (code < 65535) {
      EXPECT_GT(twelfth(base_of(2 * code + 1)), value);
    }
  }
}

TEST(Srgb16, OpaqueHalvesHaveTheCodesOfTheirRatioToOne) {
  for (std::size_t bits = 0; bits <= 0xffff; ++bits) {
    const float value = displayable_from_half()[bits];
    const std::uint16_t expected = value > 0 ? srgb16_of_ratio(value, 1) : std::uint16_t{0};
    ASSERT_EQ(srgb16_from_half()[bits], expected) << bits;
  }
  EXPECT_EQ(srgb16_from_half()[half(1.0f).bits()], 65535);
  EXPECT_EQ(srgb16_from_half()[half(0.0f).bits()], 0);
}

// round(255 v) out of round(65535 v): at every boundary between codes of 8 bits, and one code beside it.
TEST(Srgb16, CodesOf8BitsAreRoundedOnce) {
  for (int code = 0; code < 65536; ++code) {
    const int expected = (2 * code * 255 + 65535) / (2 * 65535);  // the nearest; 65535 is odd: no ties
    ASSERT_EQ(srgb8_from_srgb16(static_cast<std::uint16_t>(code)), expected) << code;
  }
}

TEST(Srgb16, CodesDecodeToWhatEncodesToThem) {
  double before = -1;
  for (int code = 0; code < 65536; ++code) {
    const double value = linear_from_srgb16(static_cast<std::uint16_t>(code));
    ASSERT_GT(value, before);
    if (code > 0) {
      ASSERT_GT(value, srgb16_boundaries()[static_cast<std::size_t>(code - 1)]);
    }
    if (code < 65535) {
      ASSERT_LT(value, srgb16_boundaries()[static_cast<std::size_t>(code)]);
    }
    before = value;
  }
  EXPECT_EQ(linear_from_srgb16(0), 0);
  EXPECT_EQ(linear_from_srgb16(65535), 1);
}

}  // namespace
}  // namespace morphcl
