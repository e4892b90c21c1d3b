#include "demos/viewer/hold_repeat.hpp"

#include <gtest/gtest.h>

namespace morphcl::viewer {
namespace {

// Repeats of a key held from 0 to `until` seconds, asked for every millisecond.
int repeats_in(HoldRepeat& hold, double until) {
  int count = 0;
  for (int millisecond = 0; millisecond * 1e-3 < until; ++millisecond)
    count += hold.take_due(millisecond * 1e-3) ? 1 : 0;
  return count;
}

TEST(HoldRepeat, WaitsForTheDelayThenRepeatsAtItsRate) {
  HoldRepeat hold;
  hold.press(Key::step_forward, 0.0);
  EXPECT_EQ(hold.next_due(), kHoldDelaySeconds);
  EXPECT_EQ(repeats_in(hold, kHoldDelaySeconds), 0);
  // 30 repeats a second: one at the end of the delay and 30 in the second after it; 2 ms for the clock of repeats_in().
  EXPECT_EQ(repeats_in(hold, kHoldDelaySeconds + 1.002), 31);
}

TEST(HoldRepeat, EndsWithTheRelease) {
  HoldRepeat hold;
  hold.press(Key::step_forward, 0.0);
  EXPECT_EQ(hold.take_due(1.0), Key::step_forward);
  hold.release(Key::step_forward);
  EXPECT_EQ(hold.take_due(2.0), std::nullopt);
  EXPECT_EQ(hold.next_due(), std::nullopt);
}

TEST(HoldRepeat, ASlowFrameIsNotMadeUpFor) {
  HoldRepeat hold;
  hold.press(Key::step_back, 0.0);
  EXPECT_EQ(hold.take_due(10.0), Key::step_back);
  EXPECT_EQ(hold.take_due(10.0), std::nullopt);
  EXPECT_EQ(hold.next_due(), 10.0 + kHoldPeriodSeconds);
}

TEST(HoldRepeat, TheLastKeyPressedRepeats) {
  HoldRepeat hold;
  hold.press(Key::step_forward, 0.0);
  hold.press(Key::eye_up, 0.1);
  EXPECT_EQ(hold.take_due(1.0), Key::eye_up);
  hold.release(Key::step_forward);
  EXPECT_EQ(hold.take_due(2.0), Key::eye_up);
}

TEST(HoldRepeat, KeysThatDoNotRepeatAreNotHeld) {
  HoldRepeat hold;
  hold.press(Key::export_frame, 0.0);
  EXPECT_EQ(hold.next_due(), std::nullopt);
}

}  // namespace
}  // namespace morphcl::viewer
