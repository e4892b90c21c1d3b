// What makes one demo different from another.
#pragma once

#include <optional>
#include <string>

#include "morphcl/projection.hpp"

namespace morphcl::viewer {

struct DemoSettings {
  std::string name;               // of the program, and of the files it exports
  std::string description;        // for --help
  std::string shot;               // file name of the shot shown by default, below demos/
  int width = 640, height = 480;  // of the window, pixels, where --size says nothing

  // What the keys o and f choose, widened to the window's aspect. Where there is none, the shot's own projection is one
  // of the two, and the other one is made to show the camera's target at the same size.
  std::optional<Orthographic> orthographic = std::nullopt;
  std::optional<Frustum> frustum = std::nullopt;
};

}  // namespace morphcl::viewer
