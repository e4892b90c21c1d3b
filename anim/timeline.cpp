#include "morphcl/timeline.hpp"

#include <fmt/core.h>

#include <cstddef>

#include "anim/hierarchy.hpp"
#include "anim/timeline_at.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

void evaluate_nodes(const std::vector<Node>& nodes, std::int64_t tick, FrameState& state) {
  state.node_to_world.resize(nodes.size());
  state.node_visible.resize(nodes.size());
  for (const int index : parents_first(nodes)) {
    const Node& node = nodes[index];
    const glm::dmat4 local = node_to_parent(node, tick);
    const bool root = node.parent < 0;
    state.node_to_world[index] = root ? local : state.node_to_world[node.parent] * local;
    state.node_visible[index] = shows_itself(node, tick) && (root || state.node_visible[node.parent]);
    require_finite(state.node_to_world[index], node, static_cast<std::size_t>(index));
  }
}

}  // namespace

FrameState evaluate(const Timeline& timeline, std::int64_t frame) {
  const std::int64_t tick = tick_of(timeline.time, frame);
  FrameState state;
  state.frame = frame;
  state.ambient = timeline.ambient;
  try {
    evaluate_nodes(timeline.nodes, tick, state);
    const auto to_world = [&state](int node) { return node < 0 ? glm::dmat4(1.0) : state.node_to_world[node]; };
    state.camera = evaluate_camera(timeline.camera, to_world(node_of(timeline.camera)), tick);
    for (std::size_t i = 0; i < timeline.lights.size(); ++i)
      state.lights.push_back(evaluate_light(timeline.lights[i], i, to_world(timeline.lights[i].node), tick));
  } catch (const Error& error) {
    throw Error(error.kind(), error.place(), fmt::format("frame {}: {}", frame, error.message()));
  }
  return state;
}

std::vector<double> weights_at(const MorphWeights& morph, const TimeBase& time, std::int64_t frame) {
  std::vector<double> weights;
  evaluate_weights(morph, tick_of(time, frame), weights);
  return weights;
}

}  // namespace morphcl
