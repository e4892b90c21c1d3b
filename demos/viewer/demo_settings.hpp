// What makes one demo different from another.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "demos/viewer/demo_state.hpp"
#include "morphcl/projection.hpp"

namespace morphcl::viewer {

// A scene that turns by the clock, about an axis through the origin, counter-clockwise seen from the axis' tip.
struct Turning {
  glm::dvec3 axis{0, 1, 0};
  double degrees_a_tick = 0.5;  // a full turn is a whole number of ticks
  double ticks_per_second = 100;
};

struct DemoSettings {
  std::string name;               // of the program, and of the files it exports
  std::string description;        // for --help
  std::string shot;               // file name of the shot shown by default, below demos/
  int width = 640, height = 480;  // of the window, pixels, where --size says nothing

  // What the keys o and f choose, widened to the window's aspect. Where there is none, the shot's own projection is one
  // of the two, and the other one is made to show the camera's target at the same size.
  std::optional<Orthographic> orthographic = std::nullopt;
  std::optional<Frustum> frustum = std::nullopt;

  std::optional<ProjectionKind> first_projection = std::nullopt;  // where it is not the shot's
  std::optional<glm::dvec3> background = std::nullopt;            // scene-linear; where it is not the shot's
  bool lights_follow_eye = false;                                 // they stay where the eye sees them at first
  std::optional<Turning> turning = std::nullopt;
};

}  // namespace morphcl::viewer
