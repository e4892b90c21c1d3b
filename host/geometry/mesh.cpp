#include "morphcl/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr std::size_t max_triangles = std::size_t{1} << 29;
constexpr std::size_t max_vertices = std::size_t{1} << 31;

[[noreturn]] void fail(const Mesh& mesh, const std::string& message) {
  throw Error(ErrorKind::bad_input, "", fmt::format("mesh \"{}\": {}", mesh.name, message));
}

template <typename Vector>
void check_vertex_array(const Mesh& mesh, const std::string& array, const std::vector<Vector>& values) {
  if (values.size() != mesh.positions.size())
    fail(mesh, fmt::format("{} has {} elements; one for each of the {} vertices is needed", array, values.size(),
                           mesh.positions.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int c = 0; c < Vector::length(); ++c)
      if (!std::isfinite(values[i][c]))
        fail(mesh, fmt::format("{}[{}] holds {}; every component must be finite", array, i, values[i][c]));
}

template <typename Indices>
void check_indices(const Mesh& mesh, const std::string& array, const std::vector<Indices>& values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int c = 0; c < Indices::length(); ++c)
      if (values[i][c] >= mesh.positions.size())
        fail(mesh, fmt::format("{}[{}] names vertex {}; there are {} vertices, counted from 0", array, i, values[i][c],
                               mesh.positions.size()));
}

}  // namespace

void validate(const Mesh& mesh) {
  if (mesh.positions.empty()) fail(mesh, "positions is empty; a mesh needs at least one vertex");
  if (mesh.positions.size() > max_vertices)
    fail(mesh, fmt::format("positions has {} elements; at most 2^31 vertices are drawn", mesh.positions.size()));
  if (mesh.triangles.size() > max_triangles)
    fail(mesh, fmt::format("triangles has {} elements; at most 2^29 triangles are drawn", mesh.triangles.size()));
  check_vertex_array(mesh, "positions", mesh.positions);
  if (!mesh.normals.empty()) check_vertex_array(mesh, "normals", mesh.normals);
  if (!mesh.colors.empty()) check_vertex_array(mesh, "colors", mesh.colors);
  if (!mesh.uvs.empty()) check_vertex_array(mesh, "uvs", mesh.uvs);
  for (std::size_t t = 0; t < mesh.targets.size(); ++t) {
    const MorphTarget& target = mesh.targets[t];
    const std::string prefix = fmt::format("targets[{}].", t);
    if (!target.positions.empty()) check_vertex_array(mesh, prefix + "positions", target.positions);
    if (!target.normals.empty()) check_vertex_array(mesh, prefix + "normals", target.normals);
    if (!target.colors.empty()) check_vertex_array(mesh, prefix + "colors", target.colors);
  }
  check_indices(mesh, "triangles", mesh.triangles);
  check_indices(mesh, "edges", mesh.edges);
}

std::vector<glm::uvec2> distinct_edges(const std::vector<glm::uvec3>& triangles) {
  std::vector<glm::uvec2> edges;
  edges.reserve(3 * triangles.size());
  for (const glm::uvec3& triangle : triangles)
    for (int corner = 0; corner < 3; ++corner) {
      const glm::uint a = triangle[corner], b = triangle[(corner + 1) % 3];
      if (a != b) edges.emplace_back(std::min(a, b), std::max(a, b));
    }
  std::sort(edges.begin(), edges.end(),
            [](const glm::uvec2& a, const glm::uvec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  edges.shrink_to_fit();
  return edges;
}

std::vector<glm::uvec2> wireframe_edges(const Mesh& mesh) {
  return mesh.edges.empty() ? distinct_edges(mesh.triangles) : mesh.edges;
}

}  // namespace morphcl
