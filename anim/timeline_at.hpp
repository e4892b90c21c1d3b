// The pieces of a timeline's state at a tick, for those who need only some of them; evaluate() is all of them at a
// frame. Each is a pure function of its arguments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "morphcl/timeline.hpp"

namespace morphcl {

// Error(usage) when |frame| > 1,000,000.
std::int64_t tick_of(const TimeBase& time, std::int64_t frame);

// node -> parent. Not finite where the motion overflows. Error(bad_input) naming the node where a step degenerates.
glm::dmat4 node_to_parent(const Node& node, std::int64_t tick);
// Whether a track moves the node; what is above it may move it all the same.
bool moves_itself(const Node& node);
// Calls visit(const Track&) for each track that the node has.
template <typename Visit>
void for_each_track(const Node& node, Visit&& visit) {
  for (const Track* track : {&node.translation_track, &node.rotation_track, &node.scale_track, &node.visible_track})
    if (!track->empty()) visit(*track);
  for (const AnimatedStep& step : node.steps.steps())
    for (const DrivenParameters& driven : step.tracks) visit(driven.track);
}
// By the node's own track; what is above it may hide it all the same.
bool shows_itself(const Node& node, std::int64_t tick);
// Error(bad_input) naming the node when its matrix to world space is not finite.
void require_finite(const glm::dmat4& node_to_world, const Node& node, std::size_t index);

// One weight a target into `weights`, whose room is used again. Error(bad_input) when one overflows.
void evaluate_weights(const MorphWeights& morph, std::int64_t tick, std::vector<double>& weights);

// The node that the camera sits in or that carries it, or -1.
int node_of(const Camera& camera);

// `node_to_world` belongs to node_of(camera), or to the light's node, and is read only if there is one. Errors as
// evaluate() has them.
CameraState evaluate_camera(const Camera& camera, const glm::dmat4& node_to_world, std::int64_t tick);
LightState evaluate_light(const Light& light, std::size_t index, const glm::dmat4& node_to_world, std::int64_t tick);

}  // namespace morphcl
