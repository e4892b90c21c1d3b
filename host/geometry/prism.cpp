// The right prism over a regular polygon.
#include <cstddef>

#include "host/geometry/circle.hpp"
#include "host/geometry/grid_topology.hpp"
#include "morphcl/solids.hpp"

namespace morphcl {

namespace {

// The face at `y`: its centre, then its corners.
void append_face(const std::vector<SinCos>& corners, double y, Mesh& mesh) {
  const auto center = static_cast<glm::uint>(mesh.positions.size());
  const auto count = static_cast<glm::uint>(corners.size() - 1);
  mesh.positions.emplace_back(0, y, 0);
  for (glm::uint i = 0; i < count; ++i) mesh.positions.emplace_back(corners[i].sin, y, corners[i].cos);
  mesh.normals.resize(mesh.positions.size(), glm::vec3(0, y, 0));
  for (glm::uint i = 0; i < count; ++i) {
    const glm::uint a = center + 1 + i, b = center + 1 + (i + 1) % count;
    mesh.triangles.push_back(y > 0 ? glm::uvec3(center, a, b) : glm::uvec3(center, b, a));
    mesh.edges.emplace_back(a, b);
  }
}

}  // namespace

Mesh make_prism(Segments segments) {
  Mesh mesh;
  mesh.name = "prism";
  const std::vector<SinCos> corners = circle(segments.u, 360), middles = circle(2 * segments.u, 360);
  for (int side = 0; side < segments.u; ++side) {
    const auto first = static_cast<glm::uint>(mesh.positions.size());
    const SinCos& middle = middles[static_cast<std::size_t>(2 * side + 1)];
    for (int j = 0; j <= segments.v; ++j) {
      const double y = 1 - 2.0 * j / segments.v;
      for (const int corner : {side, side + 1}) {
        const SinCos& phi = corners[static_cast<std::size_t>(corner)];
        mesh.positions.emplace_back(phi.sin, y, phi.cos);
        mesh.normals.emplace_back(middle.sin, 0, middle.cos);
      }
      if (j > 0) mesh.edges.emplace_back(first + 2 * (j - 1), first + 2 * j);
    }
    append_grid_triangles({1, segments.v}, first, {}, false, mesh.triangles);
  }
  append_face(corners, 1, mesh);
  append_face(corners, -1, mesh);
  return mesh;
}

}  // namespace morphcl
