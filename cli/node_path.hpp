// What an object, a light or the camera hangs below, in words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "morphcl/timeline.hpp"

namespace morphcl::cli {

// "base / arm": the names of a node and of those above it, the outermost first; those without a name and, at the end,
// those called `own_name` left out. At most 16 of them. Empty for -1: what stands in the world.
std::string node_path(const std::vector<Node>& nodes, int node, std::string_view own_name = "");

}  // namespace morphcl::cli
