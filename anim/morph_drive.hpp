// Where a morph wants the masses of an elastic object.
#pragma once

#include <cstdint>
#include <vector>

#include "anim/spring_net.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

struct MorphDrive {
  MorphWeights weights;                // one a target
  std::vector<Displacements> targets;  // of each target, the displacement of each mass at weight 1

  // The sum of the targets' displacements by their weights at the tick. Error(bad_input) when a weight overflows.
  void displacements_at(std::int64_t tick, Displacements& out) const;
  // From the first of these ticks something moves; at the last all keys are over, and springs settled or swinging for
  // 10 s. Not in that order: nothing ever moves.
  std::int64_t first_tick() const;
  std::int64_t end_tick() const;
  // Some weight swings on a spring: it may go on long after end_tick(), however lightly it is damped.
  bool on_springs() const;
};

}  // namespace morphcl
