#include "anim/node_sampler.hpp"

#include <cstddef>

#include "anim/hierarchy.hpp"
#include "anim/timeline_at.hpp"
#include "host/math/finite.hpp"

namespace morphcl {

NodeSampler::NodeSampler(const std::vector<Node>& nodes)
    : nodes_(nodes),
      to_world_(nodes.size()),
      still_(nodes.size()),
      always_visible_(nodes.size()),
      visible_(nodes.size(), 1),
      matrix_visit_(nodes.size()),
      visible_visit_(nodes.size()) {
  for (const int index : parents_first(nodes)) {
    const Node& node = nodes[index];
    const bool root = node.parent < 0;
    always_visible_[index] = node.visible_track.empty() && (root || always_visible_[node.parent]);
    if (moves_itself(node) || !(root || still_[node.parent])) continue;
    const glm::dmat4 local = node_to_parent(node, 0);
    to_world_[index] = root ? local : to_world_[node.parent] * local;
    still_[index] = is_finite(to_world_[index]);  // what overflows is an error of the frame that needs it
  }
}

void NodeSampler::go_to(std::int64_t tick) {
  tick_ = tick;
  ++visit_;
}

const glm::dmat4& NodeSampler::to_world(int node) {
  path_.clear();
  for (int at = node; at >= 0 && !still_[at] && matrix_visit_[at] != visit_; at = nodes_[at].parent)
    path_.push_back(at);
  for (std::size_t i = path_.size(); i-- > 0;) {
    const int at = path_[i], parent = nodes_[at].parent;
    const glm::dmat4 local = node_to_parent(nodes_[at], tick_);
    to_world_[at] = parent < 0 ? local : to_world_[parent] * local;
    require_finite(to_world_[at], nodes_[at], static_cast<std::size_t>(at));
    matrix_visit_[at] = visit_;
  }
  return to_world_[node];
}

bool NodeSampler::is_visible(int node) {
  path_.clear();
  for (int at = node; at >= 0 && !always_visible_[at] && visible_visit_[at] != visit_; at = nodes_[at].parent)
    path_.push_back(at);
  for (std::size_t i = path_.size(); i-- > 0;) {
    const int at = path_[i], parent = nodes_[at].parent;
    visible_[at] = shows_itself(nodes_[at], tick_) && (parent < 0 || visible_[parent]);
    visible_visit_[at] = visit_;
  }
  return visible_[node] != 0;
}

}  // namespace morphcl
