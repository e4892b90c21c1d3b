#include "host/scene/shot/parent_links.hpp"

#include <fmt/format.h>

#include <string_view>

#include "host/scene/shot/nearest_name.hpp"

namespace morphcl {

namespace {

std::string cycle_text(const std::vector<Node>& nodes, int node) {
  constexpr int max_named = 8;
  std::string text = fmt::format("\"{}\"", nodes[node].name);
  int named = 1, next = nodes[node].parent;
  for (; next != node && named < max_named; next = nodes[next].parent, ++named)
    text += fmt::format(" below \"{}\"", nodes[next].name);
  return text + (next == node ? fmt::format(" below \"{}\"", nodes[node].name) : " and so on");
}

}  // namespace

int ParentLinks::named(const ShotValue& parent) const {
  const auto found = nodes_.find(parent.text());
  if (found != nodes_.end()) return found->second;
  if (nodes_.empty())
    parent.fail(fmt::format("no object has the name \"{}\"; give the parent its name", parent.text()));
  std::vector<std::string_view> known;
  for (const auto& [name, node] : nodes_) known.push_back(name);
  parent.fail(fmt::format("no object has the name \"{}\"{}", parent.text(), suggestion(parent.text(), known)));
}

// A walk up from each object that has a parent, no node twice: linear in the nodes.
void ParentLinks::refuse_cycles(const std::vector<Node>& nodes) const {
  std::vector<std::size_t> walks(nodes.size(), 0);  // the walk that came by, counted from 1
  for (std::size_t walk = 1; walk <= links_.size(); ++walk) {
    const Link& link = links_[walk - 1];
    if (link.child != Child::node) continue;
    int node = link.index;
    for (; node >= 0 && walks[node] == 0; node = nodes[node].parent) walks[node] = walk;
    if (node >= 0 && walks[node] == walk)
      link.parent.fail(
          fmt::format("{}: an object cannot hang below itself; leave one parent out", cycle_text(nodes, node)));
  }
}

void ParentLinks::resolve(Timeline& timeline) const {
  for (const Link& link : links_) {
    const int node = named(link.parent);
    if (link.child == Child::node) timeline.nodes[link.index].parent = node;
    if (link.child == Child::light) timeline.lights[link.index].node = node;
    if (link.child == Child::camera) timeline.camera.parent = node;
  }
  refuse_cycles(timeline.nodes);
}

}  // namespace morphcl
