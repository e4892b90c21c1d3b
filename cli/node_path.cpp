#include "cli/node_path.hpp"

namespace morphcl::cli {

std::string node_path(const std::vector<Node>& nodes, int node, std::string_view own_name) {
  constexpr int max_named = 16;
  std::string path;
  int named = 0;
  for (; node >= 0 && named < max_named; node = nodes[node].parent) {
    const std::string& name = nodes[node].name;
    if (name.empty() || (named == 0 && name == own_name)) continue;
    path = named == 0 ? name : name + " / " + path;
    ++named;
  }
  return node >= 0 ? "... / " + path : path;
}

}  // namespace morphcl::cli
