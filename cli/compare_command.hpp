// morphcl compare: frames against an fp64 render of the same shot, samples against exact coverage.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/open_renderer.hpp"
#include "cli/scene_options.hpp"

namespace morphcl::cli {

struct CompareOptions {
  SceneOptions scene;
  DeviceOptions device{.device = auto_name, .threads = 0};
  std::optional<std::int64_t> frame;  // one frame, or
  std::optional<std::string> frames;  // a range; the first of the shot's range when both are absent
  std::string truth = "both";         // grid, true or both; coverage
  std::string out;                    // folder for EXR, PNG and CSV; "": none
  bool json = false;
};

int compare_command(const CompareOptions& options);

}  // namespace morphcl::cli
