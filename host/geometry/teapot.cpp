#include <cstddef>

#include "host/geometry/grid_topology.hpp"
#include "host/geometry/teapot_patches.hpp"
#include "morphcl/solids.hpp"

namespace morphcl {

namespace {

constexpr double classic_centre_height = 1.5, scale = 0.5;

// z up to y up: a quarter turn about x.
glm::dvec3 y_up(const glm::dvec3& p) { return {p.x, p.z, -p.y}; }

bool is_point(const std::array<glm::dvec3, 4>& row) { return row[0] == row[1] && row[0] == row[2] && row[0] == row[3]; }

}  // namespace

Mesh make_teapot(Segments segments) {
  Mesh mesh;
  mesh.name = "teapot";
  const auto& patches = teapot_patches();
  const std::size_t patch_vertices = (segments.u + std::size_t{1}) * (segments.v + std::size_t{1});
  mesh.positions.reserve(patches.size() * patch_vertices);
  mesh.normals.reserve(patches.size() * patch_vertices);
  for (const BezierPatch& patch : patches) {
    const auto first = static_cast<glm::uint>(mesh.positions.size());
    for (int j = 0; j <= segments.v; ++j)
      for (int i = 0; i <= segments.u; ++i) {
        const SurfacePoint point =
            evaluate_patch(patch, static_cast<double>(i) / segments.u, static_cast<double>(j) / segments.v);
        mesh.positions.emplace_back(scale * y_up(point.position - glm::dvec3(0, 0, classic_centre_height)));
        mesh.normals.emplace_back(y_up(point.normal));
      }
    const CollapsedRows collapsed = {.first = is_point(patch.points.front()), .last = is_point(patch.points.back())};
    append_grid_triangles(segments, first, collapsed, patch.flipped, mesh.triangles);
  }
  return mesh;
}

}  // namespace morphcl
