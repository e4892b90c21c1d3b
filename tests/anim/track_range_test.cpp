// Track::range() contains every value that evaluate() gives, and is reached where its bound says so.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "morphcl/track.hpp"

namespace morphcl {
namespace {

TEST(TrackRange, OfKeysIsThatOfTheirValues) {
  const Track track({Interpolation::linear, 2, false, 1000, {0, 500, 900}, {1, -5, 3, 2, -2, 0}});
  EXPECT_EQ(track.range(0).lower, -2);
  EXPECT_EQ(track.range(0).upper, 3);
  EXPECT_EQ(track.range(1).lower, -5);
  EXPECT_EQ(track.range(1).upper, 2);
}

TEST(TrackRange, ContainsWhatACubicOvershoots) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-10, 10);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<std::int64_t> ticks = {0};
    std::vector<double> values;
    for (int key = 0; key < 4; ++key) {
      if (key > 0) ticks.push_back(ticks.back() + 1 + static_cast<std::int64_t>(random() % 3000));
      for (int i = 0; i < 6; ++i) values.push_back(number(random));
    }
    const Track track({Interpolation::cubic, 2, false, 1000, ticks, values});
    for (int component = 0; component < 2; ++component) {
      const ValueRange range = track.range(component);
      for (std::int64_t tick = -5; tick <= ticks.back() + 5; ++tick) {
        double value[2];
        track.evaluate(tick, value);
        ASSERT_GE(value[component], range.lower - 1e-12);
        ASSERT_LE(value[component], range.upper + 1e-12);
      }
    }
  }
}

// The bound is reached: both tangents of a key distance point outwards, u = 1/3 and 2/3.
TEST(TrackRange, OfOneTangentIsTight) {
  const Track track({Interpolation::cubic, 1, false, 3000, {0, 3000}, {0, 0, 27, 0, 0, 0}});
  double peak;
  track.evaluate(1000, &peak);
  EXPECT_DOUBLE_EQ(peak, 4);
  EXPECT_DOUBLE_EQ(track.range(0).upper, 4);
}

TEST(TrackRange, IsNotFiniteWhereACubicMayOverflow) {
  const Track track({Interpolation::cubic, 1, false, 1, {0, 1000}, {0, 0, 1e308, 0, 0, 0}});
  EXPECT_FALSE(std::isfinite(track.range(0).upper));
}

}  // namespace
}  // namespace morphcl
