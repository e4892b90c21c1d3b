// Where an object is at all times: one box in world space that holds it at every frame, so that most objects out of
// view are found without looking at their motion.
#pragma once

#include <optional>
#include <vector>

#include "anim/node_sampler.hpp"
#include "host/geometry/bounds.hpp"
#include "host/render/plan/half_spaces.hpp"

namespace morphcl {

// Intervals that each morph weight stays in, one a target; not finite where a track may overflow.
void weight_ranges(const MorphWeights& morph, std::vector<Interval>& ranges);

// Contains the image of `box`, given in the node's space, at every tick. A node that is still: the box's own bounds.
// One that moves: a sphere around the box is carried up to the first node that is still, widened in each step by what
// the tracks' values reach. Nothing when that is not finite, where
// a moving step has no bound (shear, scaling of the axes), or after more than 64 moving nodes: the object may be
// anywhere.
std::optional<BoundedBox> bounds_over_time(const std::vector<Node>& nodes, const NodeSampler& sampler, int node,
                                           const Box& box);

}  // namespace morphcl
