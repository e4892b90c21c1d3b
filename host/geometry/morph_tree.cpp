#include "host/geometry/morph_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "host/geometry/bounds.hpp"

namespace morphcl {

namespace {

// Every third bit of the result is one of the lowest ten of `value`.
std::uint32_t spread_bits(std::uint32_t value) {
  value = (value | value << 16) & 0x030000ff;
  value = (value | value << 8) & 0x0300f00f;
  value = (value | value << 4) & 0x030c30c3;
  return (value | value << 2) & 0x09249249;
}

std::uint32_t morton_code(const glm::dvec3& point, const Box& box) {
  constexpr double cells = 1023;
  std::uint32_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = box.upper[axis] - box.lower[axis];
    const double part = size > 0 ? (point[axis] - box.lower[axis]) / size : 0;
    code |= spread_bits(static_cast<std::uint32_t>(cells * part)) << axis;
  }
  return code;
}

std::vector<std::uint32_t> in_morton_order(const Mesh& mesh, const std::vector<std::uint32_t>& vertices) {
  Box box;
  for (const std::uint32_t vertex : vertices) box.include(glm::dvec3(mesh.positions[vertex]));
  std::vector<std::pair<std::uint32_t, std::uint32_t>> coded;
  coded.reserve(vertices.size());
  for (const std::uint32_t vertex : vertices)
    coded.emplace_back(morton_code(glm::dvec3(mesh.positions[vertex]), box), vertex);
  std::sort(coded.begin(), coded.end());
  std::vector<std::uint32_t> order;
  order.reserve(coded.size());
  for (const auto& [code, vertex] : coded) order.push_back(vertex);
  return order;
}

// What the target adds at weight 1.
glm::dvec3 delta_of(const Mesh& mesh, const MorphTarget& target, std::uint32_t vertex) {
  if (target.positions.empty()) return glm::dvec3(0.0);
  const glm::dvec3 value(target.positions[vertex]);
  return target.form == TargetForm::absolute ? value - glm::dvec3(mesh.positions[vertex]) : value;
}

}  // namespace

std::vector<std::uint32_t> drawn_vertices(const Mesh& mesh, bool wireframe) {
  std::vector<char> drawn(mesh.positions.size(), 0);
  if (wireframe && !mesh.edges.empty()) {
    for (const glm::uvec2& edge : mesh.edges)
      for (int i = 0; i < 2; ++i) drawn[edge[i]] = 1;
  } else {
    for (const glm::uvec3& triangle : mesh.triangles)
      for (int i = 0; i < 3; ++i) drawn[triangle[i]] = 1;
  }
  std::vector<std::uint32_t> vertices;
  for (std::size_t vertex = 0; vertex < drawn.size(); ++vertex)
    if (drawn[vertex]) vertices.push_back(static_cast<std::uint32_t>(vertex));
  return vertices;
}

glm::dvec3 morphed_vertex(const Mesh& mesh, std::span<const double> weights, std::uint32_t vertex) {
  glm::dvec3 point(mesh.positions[vertex]);
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i] != 0) point += weights[i] * delta_of(mesh, mesh.targets[i], vertex);
  return point;
}

MorphTree::MorphTree(const Mesh& mesh, const std::vector<std::uint32_t>& vertices)
    : mesh_(&mesh), order_(in_morton_order(mesh, vertices)), sets_(1 + mesh.targets.size()) {
  if (order_.empty()) return;
  std::vector<Box> boxes((order_.size() + leaf_size - 1) / leaf_size * sets_);
  for (std::size_t i = 0; i < order_.size(); ++i) {
    Box* leaf = &boxes[i / leaf_size * sets_];
    leaf[0].include(glm::dvec3(mesh.positions[order_[i]]));
    for (std::size_t t = 0; t < mesh.targets.size(); ++t)
      leaf[1 + t].include(delta_of(mesh, mesh.targets[t], order_[i]));
  }
  while (true) {
    std::vector<Range>& level = levels_.emplace_back();
    level.reserve(boxes.size());
    for (const Box& box : boxes) level.push_back({box.center(), 0.5 * box.upper - 0.5 * box.lower});
    const std::size_t count = boxes.size() / sets_;
    if (count == 1) return;
    std::vector<Box> above((count + fan_out - 1) / fan_out * sets_);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t set = 0; set < sets_; ++set) above[i / fan_out * sets_ + set].include(boxes[i * sets_ + set]);
    boxes = std::move(above);
  }
}

struct MorphTree::Search {
  std::span<const double> weights;
  glm::dvec3 direction, size_of_direction;
  FarthestVertex best;
  bool found = false;
};

std::optional<FarthestVertex> MorphTree::farthest(std::span<const double> weights, const glm::dvec3& direction,
                                                  double beyond) const {
  if (levels_.empty()) return std::nullopt;
  Search search{weights, direction, glm::abs(direction), {beyond, 0}};
  if (reach(levels_.size() - 1, 0, search) > beyond) search_below(levels_.size() - 1, 0, search);
  return search.found ? std::optional(search.best) : std::nullopt;
}

double MorphTree::reach(std::size_t level, std::size_t index, const Search& search) const {
  const Range* sets = &levels_[level][index * sets_];
  double center = glm::dot(sets[0].center, search.direction), half = glm::dot(sets[0].half, search.size_of_direction);
  for (std::size_t i = 0; i < search.weights.size(); ++i) {
    const double weight = search.weights[i];
    if (weight == 0) continue;
    center += weight * glm::dot(sets[1 + i].center, search.direction);
    half += std::abs(weight) * glm::dot(sets[1 + i].half, search.size_of_direction);
  }
  return center + half;
}

void MorphTree::search_below(std::size_t level, std::size_t index, Search& search) const {
  if (level == 0) {
    for (std::size_t i = index * leaf_size; i < std::min(order_.size(), (index + 1) * leaf_size); ++i) {
      const double distance = glm::dot(morphed_vertex(*mesh_, search.weights, order_[i]), search.direction);
      if (!(distance > search.best.distance && distance < std::numeric_limits<double>::infinity())) continue;
      search.best = {distance, order_[i]};
      search.found = true;
    }
    return;
  }
  // The box that reaches farthest first: what it holds spares the others.
  const std::size_t first = index * fan_out, count = levels_[level - 1].size() / sets_;
  std::array<std::pair<double, std::size_t>, fan_out> below;
  std::size_t boxes = 0;
  for (std::size_t i = first; i < std::min(count, first + fan_out); ++i) {
    const std::pair<double, std::size_t> box = {reach(level - 1, i, search), i};
    std::size_t place = boxes++;
    for (; place > 0 && below[place - 1] < box; --place) below[place] = below[place - 1];
    below[place] = box;
  }
  for (std::size_t i = 0; i < boxes && below[i].first > search.best.distance; ++i)
    search_below(level - 1, below[i].second, search);
}

}  // namespace morphcl
