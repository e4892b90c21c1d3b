#include "host/geometry/welded_mesh.hpp"

#include <algorithm>
#include <numeric>

namespace morphcl {

namespace {

// The order of the vertices' positions in the base, then in the targets; -0 equals 0.
class PositionOrder {
 public:
  explicit PositionOrder(const Mesh& mesh) : lists_{&mesh.positions} {
    for (const MorphTarget& target : mesh.targets)
      if (!target.positions.empty()) lists_.push_back(&target.positions);
  }
  int compare(std::uint32_t a, std::uint32_t b) const {
    for (const std::vector<glm::vec3>* list : lists_)
      for (int c = 0; c < 3; ++c) {
        const float p = (*list)[a][c], q = (*list)[b][c];
        if (p != q) return p < q ? -1 : 1;
      }
    return 0;
  }

 private:
  std::vector<const std::vector<glm::vec3>*> lists_;
};

}  // namespace

WeldedMesh weld(const Mesh& mesh) {
  const PositionOrder order(mesh);
  std::vector<std::uint32_t> sorted(mesh.positions.size());
  std::iota(sorted.begin(), sorted.end(), 0u);
  std::sort(sorted.begin(), sorted.end(), [&order](std::uint32_t a, std::uint32_t b) {
    const int compared = order.compare(a, b);
    return compared != 0 ? compared < 0 : a < b;
  });
  std::vector<std::uint32_t> first(sorted.size());  // of each vertex, the first of those that are the same point
  for (std::size_t i = 0; i < sorted.size(); ++i)
    first[sorted[i]] = i > 0 && order.compare(sorted[i - 1], sorted[i]) == 0 ? first[sorted[i - 1]] : sorted[i];

  WeldedMesh welded;
  welded.point_of_vertex.resize(first.size());
  for (std::uint32_t vertex = 0; vertex < first.size(); ++vertex) {
    if (first[vertex] == vertex) {
      welded.point_of_vertex[vertex] = static_cast<std::uint32_t>(welded.vertex_of_point.size());
      welded.vertex_of_point.push_back(vertex);
    } else {
      welded.point_of_vertex[vertex] = welded.point_of_vertex[first[vertex]];
    }
  }
  std::vector<glm::uvec3> lines;  // as triangles without area
  for (const glm::uvec3& t : mesh.triangles)
    lines.emplace_back(welded.point_of_vertex[t.x], welded.point_of_vertex[t.y], welded.point_of_vertex[t.z]);
  if (mesh.triangles.empty())
    for (const glm::uvec2& e : mesh.edges)
      lines.emplace_back(welded.point_of_vertex[e.x], welded.point_of_vertex[e.y], welded.point_of_vertex[e.y]);
  welded.edges = distinct_edges(lines);
  return welded;
}

}  // namespace morphcl
