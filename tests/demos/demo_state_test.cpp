#include "demos/viewer/demo_state.hpp"

#include <gtest/gtest.h>

namespace morphcl::viewer {
namespace {

constexpr DemoLimits kHundredSteps{.last_step = 100};
constexpr DemoLimits kTurning{.last_step = 100, .turn_ticks = 720};
constexpr int kPressesOfOrbit = kOrbitSteps / kOrbitStepsOfKey;

DemoState pressed(DemoState state, Key key, int times, const DemoLimits& limits = kHundredSteps) {
  for (int i = 0; i < times; ++i) state = apply(state, key, limits).state;
  return state;
}

TEST(DemoState, ForwardStopsExactlyAtTheLastStep) {
  EXPECT_EQ(pressed({}, Key::step_forward, 37).view.step, 37);
  EXPECT_EQ(pressed({}, Key::step_forward, 100).view.step, 100);
  EXPECT_EQ(pressed({}, Key::step_forward, 137).view.step, 100);
}

TEST(DemoState, BackStopsExactlyAtZero) {
  const DemoState end = pressed({}, Key::step_forward, 137);
  EXPECT_EQ(pressed(end, Key::step_back, 1).view.step, 99);
  EXPECT_EQ(pressed(end, Key::step_back, 100), DemoState{});
  EXPECT_EQ(pressed(end, Key::step_back, 1000), DemoState{});
}

TEST(DemoState, ASceneOfOneFrameHasNoSteps) {
  const DemoLimits one_frame{.last_step = 0};
  for (const Key key : {Key::step_forward, Key::step_back, Key::play}) {
    EXPECT_EQ(pressed({}, key, 3, one_frame), DemoState{}) << info(key).name;
  }
}

TEST(DemoState, ProjectionKeysChoose) {
  const DemoState orthographic = pressed({}, Key::orthographic, 2);
  EXPECT_EQ(orthographic.view.projection, ProjectionKind::orthographic);
  EXPECT_EQ(pressed(orthographic, Key::frustum, 1), DemoState{});
}

TEST(DemoState, EyeMovesUpAndDownAndStopsFarOut) {
  EXPECT_EQ(pressed({}, Key::eye_up, 3).view.eye_steps, 3);
  EXPECT_EQ(pressed({}, Key::eye_down, 3).view.eye_steps, -3);
  EXPECT_EQ(pressed(pressed({}, Key::eye_up, 7), Key::eye_down, 7), DemoState{});
  EXPECT_EQ(pressed({}, Key::eye_up, kMaxEyeSteps + 5).view.eye_steps, kMaxEyeSteps);
  EXPECT_EQ(pressed({}, Key::eye_down, kMaxEyeSteps + 5).view.eye_steps, -kMaxEyeSteps);
}

TEST(DemoState, AFullOrbitEndsWhereItBegan) {
  for (const Key key : {Key::orbit_left, Key::orbit_right, Key::orbit_up, Key::orbit_down}) {
    EXPECT_NE(pressed({}, key, 1), DemoState{}) << info(key).name;
    EXPECT_NE(pressed({}, key, kPressesOfOrbit - 1), DemoState{}) << info(key).name;
    EXPECT_EQ(pressed({}, key, kPressesOfOrbit), DemoState{}) << info(key).name;
  }
  EXPECT_EQ(pressed(pressed({}, Key::orbit_left, 5), Key::orbit_right, 5), DemoState{});
  EXPECT_EQ(pressed(pressed({}, Key::orbit_down, 5), Key::orbit_up, 5), DemoState{});
}

TEST(DemoState, ATurnComesBackToItsBeginning) {
  EXPECT_EQ(pressed({}, Key::tick, 120, kTurning).view.turn, 120);
  EXPECT_EQ(pressed({}, Key::tick, 719, kTurning).view.turn, 719);
  EXPECT_EQ(pressed({}, Key::tick, 720, kTurning), DemoState{});
  EXPECT_EQ(turn_on({}, kTurning), pressed({}, Key::tick, 1, kTurning));
}

TEST(DemoState, TurningIsStoppedAndGoesOn) {
  const DemoState turning = pressed({}, Key::turn, 1, kTurning);
  EXPECT_TRUE(turning.turning);
  EXPECT_EQ(pressed(turning, Key::turn, 1, kTurning), DemoState{});
  EXPECT_TRUE(pressed(turning, Key::step_forward, 3, kTurning).turning) << "k and p go on turning";
}

TEST(DemoState, AStillSceneDoesNotTurn) {
  EXPECT_EQ(pressed({}, Key::tick, 5), DemoState{});
  EXPECT_EQ(pressed({}, Key::turn, 1), DemoState{});
  EXPECT_EQ(turn_on({}, kHundredSteps), DemoState{});
}

TEST(DemoState, DraggingIsAnOrbitOfAStepAPixel) {
  EXPECT_EQ(drag({}, -kOrbitStepsOfKey, 0), pressed({}, Key::orbit_right, 1));
  EXPECT_EQ(drag({}, 0, kOrbitStepsOfKey), pressed({}, Key::orbit_up, 1));
  EXPECT_EQ(drag(drag({}, 1234, -99), -1234, 99), DemoState{});
  EXPECT_EQ(drag({}, kOrbitSteps, -kOrbitSteps), DemoState{});
  EXPECT_EQ(drag({}, 1'000'000, -1'000'000), drag({}, 1'000'000 % kOrbitSteps, -1'000'000 % kOrbitSteps));
}

TEST(DemoState, TheWheelStopsFarOutAndNear) {
  EXPECT_EQ(zoom(zoom({}, 3), -3), DemoState{});
  EXPECT_EQ(zoom({}, 1'000'000).view.zoom, kMaxZoom);
  EXPECT_EQ(zoom({}, -1'000'000).view.zoom, -kMaxZoom);
}

TEST(DemoState, PlayingEndsAtTheLastStep) {
  DemoState state = pressed({}, Key::play, 1);
  int ticks = 0;
  for (; state.playing && ticks < 1000; ++ticks) {
    EXPECT_EQ(state.view.step, ticks);
    state = advance(state, kHundredSteps);
  }
  EXPECT_EQ(ticks, 100);
  EXPECT_EQ(state.view.step, 100);
  EXPECT_EQ(advance(state, kHundredSteps), state);
}

TEST(DemoState, PlayingAtTheEndBeginsAgain) {
  const DemoState state = pressed(pressed({}, Key::step_forward, 100), Key::play, 1);
  EXPECT_TRUE(state.playing);
  EXPECT_EQ(state.view.step, 0);
}

TEST(DemoState, PlayingPausesWhereItIs) {
  DemoState state = advance(advance(pressed({}, Key::play, 1), kHundredSteps), kHundredSteps);
  state = pressed(state, Key::play, 1);
  EXPECT_FALSE(state.playing);
  EXPECT_EQ(state.view.step, 2);
  EXPECT_EQ(advance(state, kHundredSteps), state);
}

TEST(DemoState, SteppingByHandEndsPlaying) {
  const DemoState playing = advance(pressed({}, Key::play, 1), kHundredSteps);
  EXPECT_EQ(pressed(playing, Key::step_forward, 1), pressed({}, Key::step_forward, 2));
  EXPECT_EQ(pressed(playing, Key::step_back, 1), DemoState{});
}

TEST(DemoState, MovingTheEyeGoesOnPlaying) { EXPECT_TRUE(pressed(pressed({}, Key::play, 1), Key::eye_up, 1).playing); }

TEST(DemoState, HelpTogglesAndLeavesTheViewAlone) {
  const DemoState shown = pressed({}, Key::help, 1);
  EXPECT_TRUE(shown.help);
  EXPECT_EQ(shown.view, View{});
  EXPECT_EQ(pressed(shown, Key::help, 1), DemoState{});
}

TEST(DemoState, ExportAndLeaveAreActionsThatKeepTheState) {
  const DemoState state = pressed({}, Key::step_forward, 37);
  const Transition exported = apply(state, Key::export_frame, kHundredSteps);
  EXPECT_EQ(exported.action, Action::export_frame);
  EXPECT_EQ(exported.state, state);
  const Transition left = apply(state, Key::leave, kHundredSteps);
  EXPECT_EQ(left.action, Action::leave);
  EXPECT_EQ(left.state, state);
}

TEST(DemoState, EveryOtherKeyIsNoAction) {
  for (const KeyInfo& entry : key_table()) {
    if (entry.key == Key::export_frame || entry.key == Key::leave) continue;
    EXPECT_EQ(apply({}, entry.key, kHundredSteps).action, Action::none) << entry.name;
  }
}

}  // namespace
}  // namespace morphcl::viewer
