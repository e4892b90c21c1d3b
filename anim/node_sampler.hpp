// Where the nodes of a hierarchy are, one by one: what never moves is computed once for all ticks, and of what moves
// only the nodes that are asked for and those above them.
//
// Gives the numbers of evaluate(), bit by bit. Holds the tick it stands at: one thread uses it at a time. Work: linear
// in the nodes to build; per tick linear in the nodes that are reached. No recursion.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "morphcl/timeline.hpp"

namespace morphcl {

class NodeSampler {
 public:
  explicit NodeSampler(const std::vector<Node>& nodes);  // of a timeline that has passed validate(); they outlive this

  // Neither the node nor one above it has a track that moves it, and its matrix is finite.
  bool is_still(int node) const { return still_[node] != 0; }
  const glm::dmat4& still_to_world(int node) const { return to_world_[node]; }  // of a node that is still

  void go_to(std::int64_t tick);
  // At the tick. Error(bad_input) naming the node whose transform overflows.
  const glm::dmat4& to_world(int node);
  bool is_visible(int node);

 private:
  const std::vector<Node>& nodes_;
  std::vector<glm::dmat4> to_world_;
  std::vector<char> still_, always_visible_, visible_;
  std::vector<std::uint64_t> matrix_visit_, visible_visit_;  // the visit in which a moving node was computed
  std::vector<int> path_;
  std::uint64_t visit_ = 0;
  std::int64_t tick_ = 0;
};

}  // namespace morphcl
