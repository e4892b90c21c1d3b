#pragma once

#include <optional>

#include "anim/time_base.hpp"

namespace morphcl {

// What the caller decides instead of the file.
struct LoadOptions {
  bool allow_outside = false;        // files may lie outside the folder of the file that names them
  std::optional<TimeBase> fps;       // frames per second
  std::optional<int> width, height;  // pixels; the fitted camera frames for this size
};

}  // namespace morphcl
