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
  bool operator==(const View&) const = default;
};

constexpr int kMaxEyeSteps = 1000;
constexpr int kOrbitSteps = 72;  // of a full turn
constexpr double kOrbitStepDegrees = 360.0 / kOrbitSteps;

struct DemoState {
  View view;
  bool playing = false;
  bool help = false;  // the keys are drawn over the picture
  bool operator==(const DemoState&) const = default;
};

struct DemoLimits {
  int last_step = 0;  // >= 0
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

}  // namespace morphcl::viewer
