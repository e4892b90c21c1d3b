// What a demo shows, and how each key changes it: a pure state machine, without window, clock or device.
//
// Everything is counted in whole steps, so that k and p, w and s, or a full orbit come back to exactly the same
// picture.
#pragma once

#include "demos/viewer/key.hpp"

namespace morphcl::viewer {

enum class ProjectionKind { orthographic, frustum };

// What decides the picture.
struct View {
  int step = 0;  // 0 to DemoLimits::last_step
  ProjectionKind projection = ProjectionKind::frustum;
  int eye_steps = 0;    // upwards, within +-kMaxEyeSteps
  int orbit_right = 0;  // 0 to kOrbitSteps - 1: the eye circles to the right about the up axis ...
  int orbit_up = 0;     // ... after it circled upwards about the picture's horizontal axis
  int zoom = 0;         // nearer, within +-kMaxZoom
  int turn = 0;         // ticks of a scene that turns, 0 to DemoLimits::turn_ticks - 1
  bool operator==(const View&) const = default;
};

constexpr int kMaxEyeSteps = 1000;
constexpr int kOrbitSteps = 720;  // of a full turn; the mouse moves one a pixel
constexpr double kOrbitStepDegrees = 360.0 / kOrbitSteps;
constexpr int kOrbitStepsOfKey = 10;
constexpr int kMaxZoom = 40;
constexpr double kZoomSteps = 8.0;  // that make things twice as large

struct DemoState {
  View view;
  bool playing = false;
  bool turning = false;  // by the clock
  bool help = false;     // the keys are drawn over the picture
  bool operator==(const DemoState&) const = default;
};

struct DemoLimits {
  int last_step = 0;   // >= 0
  int turn_ticks = 0;  // of a full turn; 0: the scene does not turn
};

enum class Action { none, export_frame, leave };

struct Transition {
  DemoState state;
  Action action = Action::none;  // what is left for the caller to do, once the state is shown
};

// One press of a key.
Transition apply(const DemoState& state, Key key, const DemoLimits& limits);

// One tick of playing: a step forward; the last step ends it. Without effect unless `playing`.
DemoState advance(const DemoState& state, const DemoLimits& limits);

// One tick of a scene that turns; without effect on others.
DemoState turn_on(const DemoState& state, const DemoLimits& limits);

// The mouse: the scene is dragged by pixels to the right and downwards, and the wheel brings the eye nearer by notches.
DemoState drag(const DemoState& state, int right, int down);
DemoState zoom(const DemoState& state, int notches);

}  // namespace morphcl::viewer
