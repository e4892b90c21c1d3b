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

void circle(int& orbit, int steps) { orbit = ((orbit + steps) % kOrbitSteps + kOrbitSteps) % kOrbitSteps; }

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
      circle(view.orbit_right, -kOrbitStepsOfKey);
      break;
    case Key::orbit_right:
      circle(view.orbit_right, kOrbitStepsOfKey);
      break;
    case Key::orbit_up:
      circle(view.orbit_up, kOrbitStepsOfKey);
      break;
    case Key::orbit_down:
      circle(view.orbit_up, -kOrbitStepsOfKey);
      break;
    case Key::turn:
      state.turning = limits.turn_ticks > 0 && !state.turning;
      break;
    case Key::tick:
      return {turn_on(state, limits)};
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

DemoState turn_on(const DemoState& before, const DemoLimits& limits) {
  DemoState state = before;
  if (limits.turn_ticks > 0) state.view.turn = (state.view.turn + 1) % limits.turn_ticks;
  return state;
}

DemoState drag(const DemoState& before, int right, int down) {
  DemoState state = before;
  circle(state.view.orbit_right, -right % kOrbitSteps);
  circle(state.view.orbit_up, down % kOrbitSteps);
  return state;
}

DemoState zoom(const DemoState& before, int notches) {
  DemoState state = before;
  state.view.zoom = std::clamp(state.view.zoom + std::clamp(notches, -kMaxZoom, kMaxZoom), -kMaxZoom, kMaxZoom);
  return state;
}

}  // namespace morphcl::viewer
