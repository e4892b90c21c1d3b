// morphcl trace: each step of a point from object to pixel, and back from a pixel.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/scene_options.hpp"

namespace morphcl::cli {

struct TraceOptions {
  SceneOptions scene;
  std::string object;                       // "": the first
  std::optional<std::int64_t> vertex;       // 0 when absent
  std::optional<std::string> point, pixel;  // "x,y,z" in object space; "x,y"
  std::optional<std::int64_t> frame;        // the first of the shot's range when absent
  std::string vectors = "column", handedness = "right", depth = "minus_one_to_one";
  bool json = false, latex = false;
};

int trace_command(const TraceOptions& options);

}  // namespace morphcl::cli
