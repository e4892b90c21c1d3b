// The cost model of the auto renderer: numbers in, a choice out.
#include "host/render/auto/choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "host/device/kernel_source.hpp"
#include "host/render/auto/first_situation.hpp"
#include "morphcl/planner.hpp"
#include "tests/render/test_scenes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace morphcl::test {
namespace {

// A frame by the reference takes 40 ms, by the device 2; two seconds to compile, after the first frame.
Situation cold(std::int64_t frames_left, int threads) {
  Situation now;
  now.frames_drawn = 1;
  now.frames_left = frames_left;
  now.threads = threads;
  now.reference_frame = 0.04;
  now.device_frame = 0.002;
  now.preparing = 2;
  now.storing = 1;
  now.compiles = true;
  return now;
}

Situation warm(std::int64_t frames_left, int threads) {
  Situation now = cold(frames_left, threads);
  now.frames_drawn = 0;
  now.preparing = 0.07;
  now.storing = 0;
  now.compiles = false;
  return now;
}

TEST(AutoChoice, AFewFramesCompileNothing) {
  for (const int threads : {1, 2, 16})
    for (const std::int64_t frames : {1, 20, 40}) EXPECT_EQ(choose(cold(frames, threads)), Choice::reference) << frames;
}

TEST(AutoChoice, ManyFramesArePreparedForBesideThem) {
  for (const int threads : {4, 16}) EXPECT_EQ(choose(cold(1000, threads)), Choice::prepare);
  EXPECT_EQ(choose(cold(1000, 2)), Choice::wait) << "the compiler is done sooner alone";
}

TEST(AutoChoice, TheFirstFrameHasAllProcessorsWhereKernelsHaveToBeCompiled) {
  Situation now = cold(1000, 2);
  now.frames_drawn = 0;
  EXPECT_EQ(choose(now), Choice::reference);
  now.reference_frame = 2;  // it would be late in any case
  EXPECT_NE(choose(now), Choice::reference);
}

// On one processor nothing is won by turns: the compiler has it alone, or does not start.
TEST(AutoChoice, OneThreadCompilesBetweenFramesOrNotAtAll) {
  EXPECT_EQ(choose(cold(40, 1)), Choice::reference);
  EXPECT_EQ(choose(cold(1000, 1)), Choice::wait);
  for (std::int64_t frames = 1; frames < 3000; frames += 7)
    EXPECT_NE(choose(cold(frames, 1)), Choice::prepare) << frames;
}

TEST(AutoChoice, NoFramesLeftIsNoReasonToStart) { EXPECT_EQ(choose(cold(0, 2)), Choice::reference); }

TEST(AutoChoice, WithAWarmCacheTheDeviceDrawsFromTheFirstFrameWhereThatEndsSooner) {
  EXPECT_EQ(choose(warm(1, 1)), Choice::reference);
  EXPECT_EQ(choose(warm(100, 1)), Choice::wait);
  EXPECT_NE(choose(warm(100, 2)), Choice::reference);
  Situation slow = warm(1, 2);
  slow.reference_frame = 3;
  EXPECT_EQ(choose(slow), Choice::wait);
}

TEST(AutoChoice, ADeviceThatIsOutTakesNoPart) {
  for (const std::int64_t frames : {1, 1000, 1'000'000}) {
    Situation now = cold(frames, 2);
    now.device = DeviceState::out;
    EXPECT_EQ(choose(now), Choice::reference);
  }
}

TEST(AutoChoice, WhatIsBeingPreparedIsNotWaitedFor) {
  Situation now = cold(1000, 2);
  now.device = DeviceState::preparing;
  EXPECT_EQ(choose(now), Choice::reference);
}

TEST(AutoChoice, AReadyDeviceDrawsWhatItDrawsFaster) {
  Situation now = cold(5, 2);
  now.device = DeviceState::ready;
  EXPECT_EQ(choose(now), Choice::device);
  now.device_frame = 0.05;
  EXPECT_EQ(choose(now), Choice::reference);
  now.both_measured = false;
  EXPECT_EQ(choose(now), Choice::device) << "the estimate may be wrong";
  now.device_frame = 1;
  EXPECT_EQ(choose(now), Choice::reference);
}

// What the model takes for the end is the same for all frames by one renderer, however it is put.
TEST(AutoChoice, TheTimesAgreeWhereTheyMean) {
  Situation now = warm(10, 2);
  EXPECT_DOUBLE_EQ(seconds_by_reference(now), 0.4);
  EXPECT_DOUBLE_EQ(seconds_by_device(now), 0.09);
  // 70 ms to open, 119 beside frames that take 80: two of them, the other eight are the device's.
  EXPECT_DOUBLE_EQ(seconds_by_turns(now), 2 * 0.08 + 8 * 0.002);
  now.frames_left = 1;
  EXPECT_DOUBLE_EQ(seconds_by_turns(now), 0.08);
  now.threads = 1;  // each has half of the processor
  EXPECT_DOUBLE_EQ(seconds_by_turns(now), 0.08);
  now.frames_left = 10;
  EXPECT_DOUBLE_EQ(seconds_by_turns(now), 2 * 0.08 + 8 * 0.002);
  now = cold(1000, 2);
  // 3.4 s are 43 frames of 80 ms; storing takes half of the processors for a second.
  EXPECT_DOUBLE_EQ(seconds_by_turns(now), 43 * 0.08 + 957 * 0.002 + 0.5);
}

// Choosing by the model never ends later, by its own times, than the better of drawing all in one way, but for margins.
TEST(AutoChoice, IsNeverMuchWorseThanTheBestOfTheThree) {
  for (const int threads : {1, 2, 8})
    for (const double reference : {0.0005, 0.01, 0.3, 4.0})
      for (const double preparing : {0.05, 0.5, 3.0})
        for (std::int64_t frames = 1; frames < 5000; frames *= 3) {
          Situation now = cold(frames, threads);
          now.reference_frame = reference;
          now.device_frame = 0.0003 + reference / 12;
          now.preparing = preparing;
          now.storing = preparing / 2;
          const double by[] = {seconds_by_reference(now), seconds_by_turns(now), seconds_by_device(now)};
          const Choice choice = choose(now);
          const double chosen = choice == Choice::reference ? by[0] : choice == Choice::prepare ? by[1] : by[2];
          EXPECT_LE(chosen, 1.15 * 1.1 * std::min({by[0], by[1], by[2]}) + 1e-12)
              << threads << " threads, " << reference << " s, " << preparing << " s, " << frames << " frames";
        }
}

TEST(AutoChoice, AnEmptyCacheIsSeenWithoutADevice) {
  const test_support::TemporaryFolder folder;
  const Scene scene = pyramid_to_cube(64, 48);
  const Plan plan = plan_frame(scene, 0);
  const AutoOptions options{.threads = 2, .cache_dir = folder.path().string()};
  const Situation empty = first_situation(*plan, 100, options);
  EXPECT_TRUE(empty.compiles);
  EXPECT_EQ(empty.threads, 2);
  EXPECT_EQ(empty.frames_left, 100);
  EXPECT_GT(empty.preparing, 1);
  const KnownKernels known(folder.path());
  for (const FrameKernel& kernel : frame_kernels(*plan))
    known.add(kernel_source(kernel.stage).text, kernel.options, kernel.name);
  EXPECT_TRUE(first_situation(*plan, 100, options).compiles) << "the device is not tested";
  known.add(kernel_source("self_test").text, "", self_test_note);
  const Situation full = first_situation(*plan, 100, options);
  EXPECT_FALSE(full.compiles);
  EXPECT_LT(full.preparing, 0.5);
  EXPECT_EQ(full.storing, 0);
}

}  // namespace
}  // namespace morphcl::test
