#include "anim/hierarchy.hpp"

#include <fmt/core.h>

#include <cstddef>
#include <string>

#include "morphcl/error.hpp"
#include "morphcl/timeline.hpp"

namespace morphcl {

namespace {

[[noreturn]] void refuse_cycle(const std::vector<int>& parents, int node) {
  constexpr int max_named = 8;
  std::string names = fmt::format("{}", node);
  int length = 1;
  for (int next = parents[node]; next != node; next = parents[next]) {
    if (length < max_named) names += fmt::format(" under {}", next);
    ++length;
  }
  if (length > max_named) names += " ...";
  throw Error(ErrorKind::bad_input, fmt::format("nodes[{}]", node),
              fmt::format("{} nodes are each other's parents ({}); a hierarchy has no cycle", length, names));
}

}  // namespace

std::vector<int> parents_first(const std::vector<int>& parents) {
  const int count = static_cast<int>(parents.size());
  for (int node = 0; node < count; ++node)
    if (parents[node] < -1 || parents[node] >= count)
      throw Error(ErrorKind::bad_input, fmt::format("nodes[{}]", node),
                  fmt::format("parent {} does not exist; there are {} nodes", parents[node], count));

  enum class Mark : char { unseen, on_path, ordered };
  std::vector<Mark> marks(parents.size(), Mark::unseen);
  std::vector<int> order, path;
  order.reserve(parents.size());
  for (int start = 0; start < count; ++start) {
    path.clear();
    int node = start;
    for (; node >= 0 && marks[node] == Mark::unseen; node = parents[node]) {
      marks[node] = Mark::on_path;
      path.push_back(node);
    }
    if (node >= 0 && marks[node] == Mark::on_path) refuse_cycle(parents, node);
    for (std::size_t i = path.size(); i-- > 0;) {
      marks[path[i]] = Mark::ordered;
      order.push_back(path[i]);
    }
  }
  return order;
}

std::vector<int> parents_first(const std::vector<Node>& nodes) {
  std::vector<int> parents;
  parents.reserve(nodes.size());
  for (const Node& node : nodes) parents.push_back(node.parent);
  return parents_first(parents);
}

}  // namespace morphcl
