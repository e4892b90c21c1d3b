#include "demos/viewer/demo_state.hpp"

#include <algorithm>

namespace morphcl::viewer {
namespace {

void step_by(DemoState& state, int steps, const DemoLimits& limits) {
  state.view.step = std::clamp(state.view.step + steps, 0, limits.last_step);
  state.playing = false;
}

void move_eye(View& view, int steps) {
  view.eye_steps = std::clamp(view.eye_steps + steps, -kMaxEyeSteps, kMaxEyeSteps);
}

void turn(int& orbit, int steps) { orbit = (orbit + steps + kOrbitSteps) % kOrbitSteps; }

void toggle_playing(DemoState& state, const DemoLimits& limits) {
  if (limits.last_step == 0) return;
  state.playing = !state.playing;
  const bool at_end = state.view.step == limits.last_step;
  if (state.playing && at_end) state.view.step = 0;
}

}  // namespace

Transition apply(const DemoState& before, Key key, const DemoLimits& limits) {
  DemoState state = before;
  View& view = state.view;
  switch (key) {
    case Key::step_forward:
      step_by(state, 1, limits);
      break;
    case Key::step_back:
      step_by(state, -1, limits);
      break;
    case Key::play:
      toggle_playing(state, limits);
      break;
    case Key::orthographic:
      view.projection = ProjectionKind::orthographic;
      break;
    case Key::frustum:
      view.projection = ProjectionKind::frustum;
      break;
    case Key::eye_up:
      move_eye(view, 1);
      break;
    case Key::eye_down:
      move_eye(view, -1);
      break;
    case Key::orbit_left:
      turn(view.orbit_right, -1);
      break;
    case Key::orbit_right:
      turn(view.orbit_right, 1);
      break;
    case Key::orbit_up:
      turn(view.orbit_up, 1);
      break;
    case Key::orbit_down:
      turn(view.orbit_up, -1);
      break;
    case Key::help:
      state.help = !state.help;
      break;
    case Key::export_frame:
      return {state, Action::export_frame};
    case Key::leave:
      return {state, Action::leave};
  }
  return {state, Action::none};
}

DemoState advance(const DemoState& before, const DemoLimits& limits) {
  if (!before.playing) return before;
  DemoState state = before;
  state.view.step = std::min(state.view.step + 1, limits.last_step);
  state.playing = state.view.step < limits.last_step;
  return state;
}

}  // namespace morphcl::viewer
