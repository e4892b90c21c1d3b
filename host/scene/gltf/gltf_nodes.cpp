#include "host/scene/gltf/gltf_nodes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <span>

#include "anim/hierarchy.hpp"
#include "host/scene/gltf/gltf_quaternion.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

glm::dvec3 vec3(const GltfValue& json) {
  const std::vector<double> v = json.numbers(3);
  return {v[0], v[1], v[2]};
}

// The specification asks for a unit quaternion, which fp32 text misses by some 1e-7.
glm::dquat unit_quaternion(const GltfValue& json, GltfWarnings& warnings) {
  constexpr double noticeable = 0.01;  // more than the step of 8-bit components
  std::vector<double> v = json.numbers(4);
  const std::optional<double> length = normalize_quaternion(std::span<double, 4>(v));
  if (!length) json.fail("has no direction: a unit quaternion x y z w is needed");
  if (std::abs(*length - 1) > noticeable)
    warnings.say(fmt::format("{}: of length {:.6g}; scaled to unit length", json.place(), *length));
  return {v[3], v[0], v[1], v[2]};
}

Node read_node(const GltfValue& json, std::size_t index, GltfWarnings& warnings) {
  Node node;
  node.name = warnings.read_name(json, fmt::format("node{}", index));
  const auto translation = json.find("translation"), rotation = json.find("rotation"), scale = json.find("scale");
  if (translation) node.translation = vec3(*translation);
  if (rotation) node.rotation = unit_quaternion(*rotation, warnings);
  if (scale) node.scale = vec3(*scale);
  if (const auto matrix = json.find("matrix")) {
    if (translation || rotation || scale) json.fail("has a matrix and also translation, rotation or scale");
    const std::vector<double> m = matrix->numbers(16);  // column by column
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row)
        node.static_transform[column][row] = m[static_cast<std::size_t>(4 * column + row)];
    constexpr double noise = 1e-5;  // of exporters that multiply in fp32
    for (int column = 0; column < 4; ++column) {
      const double exact = column == 3 ? 1.0 : 0.0;
      if (!(std::abs(node.static_transform[column][3] - exact) <= noise)) matrix->fail("the last row must be 0 0 0 1");
      node.static_transform[column][3] = exact;
    }
  }
  return node;
}

void read_children(const GltfValue& json, int parent, std::vector<Node>& nodes) {
  const auto children = json.find("children");
  if (!children) return;
  for (std::size_t i = 0; i < children->size(); ++i) {
    const int child = (*children)[i].index(nodes.size(), "nodes");
    Node& node = nodes[static_cast<std::size_t>(child)];
    if (node.parent >= 0)
      (*children)[i].fail(fmt::format("nodes[{}] is already a child of nodes[{}]", child, node.parent));
    node.parent = parent;
  }
}

std::vector<int> order_nodes(const GltfDocument& document, const std::vector<Node>& nodes) {
  std::vector<int> parents;
  parents.reserve(nodes.size());
  for (const Node& node : nodes) parents.push_back(node.parent);
  try {
    return parents_first(parents);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", document.path(), error.place()), error.message());
  }
}

std::vector<int> drawn_roots(const GltfDocument& document, const std::vector<Node>& nodes, int scene,
                             GltfWarnings& warnings) {
  std::vector<int> roots;
  if (scene < 0) {
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i)
      if (nodes[static_cast<std::size_t>(i)].parent < 0) roots.push_back(i);
    return roots;
  }
  const auto members = document.element("scenes", static_cast<std::size_t>(scene)).find("nodes");
  for (std::size_t i = 0; members && i < members->size(); ++i) {
    const int root = (*members)[i].index(nodes.size(), "nodes");
    if (nodes[static_cast<std::size_t>(root)].parent >= 0)
      warnings.say(fmt::format("{}: nodes[{}] is a child of nodes[{}]; it is drawn with what is below it",
                               (*members)[i].place(), root, nodes[static_cast<std::size_t>(root)].parent));
    roots.push_back(root);
  }
  return roots;
}

}  // namespace

GltfNodes read_nodes(const GltfDocument& document, int scene, GltfWarnings& warnings) {
  GltfNodes result;
  const std::size_t count = document.count("nodes");
  document.budget().charge(count, sizeof(Node), document.path());
  for (std::size_t i = 0; i < count; ++i) {
    const GltfValue json = document.element("nodes", i);
    result.nodes.push_back(read_node(json, i, warnings));
    result.has_matrix.push_back(json.find("matrix").has_value());
  }
  for (std::size_t i = 0; i < count; ++i)
    read_children(document.element("nodes", i), static_cast<int>(i), result.nodes);
  result.parents_first = order_nodes(document, result.nodes);
  result.drawn.resize(count);
  for (const int root : drawn_roots(document, result.nodes, scene, warnings))
    result.drawn[static_cast<std::size_t>(root)] = true;
  for (const int node : result.parents_first)
    if (const int parent = result.nodes[static_cast<std::size_t>(node)].parent; parent >= 0)
      if (result.drawn[static_cast<std::size_t>(parent)]) result.drawn[static_cast<std::size_t>(node)] = true;
  return result;
}

std::vector<glm::dmat4> rest_to_world(const GltfNodes& nodes) {
  std::vector<glm::dmat4> to_world(nodes.nodes.size());
  for (const int index : nodes.parents_first) {
    const Node& node = nodes.nodes[static_cast<std::size_t>(index)];
    glm::dmat4 local = glm::mat4_cast(node.rotation);
    for (int axis = 0; axis < 3; ++axis) local[axis] *= node.scale[axis];
    local[3] = glm::dvec4(node.translation, 1.0);
    local *= node.static_transform;
    to_world[static_cast<std::size_t>(index)] =
        node.parent < 0 ? local : to_world[static_cast<std::size_t>(node.parent)] * local;
  }
  return to_world;
}

std::vector<bool> moving_nodes(const GltfNodes& nodes) {
  std::vector<bool> moving(nodes.nodes.size());
  for (const int index : nodes.parents_first) {
    const Node& node = nodes.nodes[static_cast<std::size_t>(index)];
    const bool driven = !node.translation_track.empty() || !node.rotation_track.empty() || !node.scale_track.empty();
    moving[static_cast<std::size_t>(index)] =
        driven || (node.parent >= 0 && moving[static_cast<std::size_t>(node.parent)]);
  }
  return moving;
}

}  // namespace morphcl
