#include "lab/frame_error/stored_number.hpp"

#include <Imath/half.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace morphcl::accuracy {
namespace {

// Every finite half, and what lies between two of them: a quarter, a half (the tie) and three quarters of the way.
TEST(StoredNumber, NearestHalfOfEveryHalfAndBetween) {
  for (unsigned bits = 0; bits < 0x7bff; ++bits) {
    const double low = imath_half_to_float(static_cast<std::uint16_t>(bits));
    const double high = imath_half_to_float(static_cast<std::uint16_t>(bits + 1));
    const double step = high - low;
    ASSERT_EQ(nearest_half(low), low);
    ASSERT_EQ(nearest_half(low + 0.25 * step), low);
    ASSERT_EQ(nearest_half(low + 0.5 * step), bits % 2 == 0 ? low : high) << "tie above " << low;
    ASSERT_EQ(nearest_half(low + 0.75 * step), high);
    ASSERT_EQ(nearest_half(-(low + 0.75 * step)), -high);
    ASSERT_EQ(half_spacing(low), step) << "at " << low;
  }
}

TEST(StoredNumber, HalvesEndAt65504) {
  EXPECT_EQ(nearest_half(65519.99), 65504);
  EXPECT_EQ(nearest_half(65520), std::numeric_limits<double>::infinity());
  EXPECT_EQ(nearest_half(-1e300), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(nearest_half(std::nan(""))));
}

// Rounding to float first and to half then is another function: the tie is not seen.
TEST(StoredNumber, RoundsOnce) {
  const double above_a_tie = 1 + 0x1p-11 + 0x1p-40;
  EXPECT_EQ(nearest_half(above_a_tie), 1 + 0x1p-10);
  EXPECT_EQ(imath_half_to_float(imath_float_to_half(static_cast<float>(above_a_tie))), 1);
}

TEST(StoredNumber, FloatSpacing) {
  std::mt19937 random(5);
  for (int i = 0; i < 100000; ++i) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()) & 0x7effffffu);
    if (!std::isfinite(value)) continue;
    const double next = std::nextafter(value, std::numeric_limits<float>::infinity());
    ASSERT_EQ(float_spacing(value), next - value) << "at " << value;
  }
}

}  // namespace
}  // namespace morphcl::accuracy
