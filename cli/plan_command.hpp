// morphcl plan: what a frame needs, what is left out, and why.
#pragma once

#include <cstdint>
#include <optional>

#include "cli/scene_options.hpp"

namespace morphcl::cli {

struct PlanOptions {
  SceneOptions scene;
  std::optional<std::int64_t> frame;  // the first of the shot's range when absent
  std::string explain;                // folder for what the hidden-surface method did; "": none
  bool leave_out = true;              // false: nothing is left out
  bool json = false;
};

int plan_command(const PlanOptions& options);

}  // namespace morphcl::cli
