// The steps that bring a node's points to the world: its own, then those of all nodes above it.
#pragma once

#include <cstdint>
#include <vector>

#include "morphcl/timeline.hpp"
#include "morphcl/transform.hpp"

namespace morphcl {

// Of each node the steps of its static transform, then scale, rotation and translation of its tracks, where they do
// anything. `nodes` are valid.
std::vector<TransformStep> model_steps(const std::vector<Node>& nodes, int node, std::int64_t tick);

}  // namespace morphcl
