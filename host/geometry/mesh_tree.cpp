#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

#include "host/math/finite.hpp"
#include "morphcl/collision.hpp"
#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr std::uint32_t max_leaf = 4;
constexpr std::size_t max_tree_triangles = std::size_t{1} << 31;

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

// For each position the index of the first one that is equal to it.
std::vector<std::uint32_t> first_equal(const std::vector<glm::dvec3>& positions) {
  std::vector<std::uint32_t> order(positions.size()), first(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) { return std::tie(positions[i].x, positions[i].y, positions[i].z); };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b) || (key(a) == key(b) && a < b); });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  return first;
}

}  // namespace

MeshTree::MeshTree(std::vector<glm::dvec3> positions, std::vector<glm::uvec3> triangles)
    : positions_(std::move(positions)), triangles_(std::move(triangles)) {
  if (triangles_.size() > max_tree_triangles)
    throw Error(ErrorKind::usage, "", "a tree of more than 2^31 triangles was asked for; divide the mesh");
  for (const glm::dvec3& position : positions_)
    if (!is_finite(position)) throw Error(ErrorKind::usage, "", "a coordinate is not finite; give numbers");
  std::vector<Box> boxes(triangles_.size());
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      if (triangles_[i][k] >= positions_.size())
        throw Error(ErrorKind::usage, "", "an index of a triangle is out of range; give one of the positions");
      boxes[i].include(positions_[triangles_[i][k]]);
    }
  order_.resize(triangles_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(triangles_.size());
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()), boxes);
  find_parts();
}

MeshTree::MeshTree(const Mesh& mesh)
    : MeshTree(std::vector<glm::dvec3>(mesh.positions.begin(), mesh.positions.end()), mesh.triangles) {}

Triangle MeshTree::triangle(std::size_t i) const {
  const glm::uvec3& corners = triangles_[i];
  return {positions_[corners.x], positions_[corners.y], positions_[corners.z]};
}

// Halves by the middle of the boxes along the longest axis of these middles.
std::uint32_t MeshTree::build(std::uint32_t first, std::uint32_t count, const std::vector<Box>& boxes) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box box, middles;
  for (std::uint32_t i = first; i < first + count; ++i) {
    box.include(boxes[order_[i]]);
    middles.include(boxes[order_[i]].center());
  }
  nodes_[index].box = box;
  nodes_[index].first = first;
  if (count <= max_leaf) {
    nodes_[index].count = count;
    return index;
  }
  const glm::dvec3 size = 0.5 * middles.upper - 0.5 * middles.lower;
  const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    const double p = boxes[a].center()[axis], q = boxes[b].center()[axis];
    return p < q || (p == q && a < b);
  });
  build(first, count / 2, boxes);
  const std::uint32_t right = build(first + count / 2, count - count / 2, boxes);
  nodes_[index].right = right;
  return index;
}

void MeshTree::find_parts() {
  const std::vector<std::uint32_t> first = first_equal(positions_);
  std::vector<std::uint32_t> parent(positions_.size());
  std::iota(parent.begin(), parent.end(), 0u);
  // Each edge with its smaller end first, and which way it runs.
  std::vector<std::tuple<std::uint32_t, std::uint32_t, int>> edges;
  edges.reserve(3 * triangles_.size());
  for (const glm::uvec3& triangle : triangles_)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = first[triangle[k]], b = first[triangle[(k + 1) % 3]];
      parent[root_of(parent, a)] = root_of(parent, b);
      if (a != b) edges.emplace_back(std::min(a, b), std::max(a, b), a < b ? 1 : -1);
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size();) {
    const auto [a, b, way] = edges[i];
    int sum = 0;
    for (; i < edges.size() && std::get<0>(edges[i]) == a && std::get<1>(edges[i]) == b; ++i)
      sum += std::get<2>(edges[i]);
    if (sum != 0) closed_ = false;
  }
  std::vector<bool> seen(positions_.size(), false);
  for (const glm::uvec3& triangle : triangles_) {
    const std::uint32_t root = root_of(parent, first[triangle.x]);
    if (!seen[root]) part_corners_.push_back(positions_[triangle.x]);
    seen[root] = true;
  }
}

}  // namespace morphcl
