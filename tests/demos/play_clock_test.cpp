#include "demos/viewer/play_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace morphcl::viewer {
namespace {

TEST(PlayClock, TicksAPeriodAfterTheStartAndThenEveryPeriod) {
  PlayClock clock(4.0);
  EXPECT_TRUE(std::isinf(clock.next_due()));
  EXPECT_FALSE(clock.take_due(true, 10.0));
  EXPECT_EQ(clock.next_due(), 10.25);
  EXPECT_FALSE(clock.take_due(true, 10.24));
  EXPECT_TRUE(clock.take_due(true, 10.26));
  EXPECT_EQ(clock.next_due(), 10.5) << "the lateness of one frame does not add up";
}

TEST(PlayClock, SlowFramesComeOneByOne) {
  PlayClock clock(4.0);
  clock.take_due(true, 0.0);
  EXPECT_TRUE(clock.take_due(true, 3.0));
  EXPECT_EQ(clock.next_due(), 3.0);
}

TEST(PlayClock, PausingForgetsTheFrameThatWasDue) {
  PlayClock clock(4.0);
  clock.take_due(true, 0.0);
  EXPECT_FALSE(clock.take_due(false, 1.0));
  EXPECT_TRUE(std::isinf(clock.next_due()));
  EXPECT_FALSE(clock.take_due(true, 2.0));
  EXPECT_EQ(clock.next_due(), 2.25);
}

}  // namespace
}  // namespace morphcl::viewer
