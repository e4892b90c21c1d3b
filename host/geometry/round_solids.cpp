// The solids of revolution: the sphere and the torus.
#include "host/geometry/circle.hpp"
#include "host/geometry/grid_topology.hpp"
#include "morphcl/solids.hpp"

namespace morphcl {

namespace {

constexpr double ring_radius = 0.7, tube_radius = 0.3;

}  // namespace

Mesh make_sphere(Segments segments) {
  Mesh mesh;
  mesh.name = "sphere";
  const std::vector<SinCos> around = circle(segments.u, 360), down = circle(segments.v, 180);
  mesh.positions.reserve(around.size() * down.size());
  for (const SinCos& theta : down)
    for (const SinCos& phi : around) mesh.positions.emplace_back(theta.sin * phi.sin, theta.cos, theta.sin * phi.cos);
  mesh.normals = mesh.positions;
  append_grid_triangles(segments, 0, {.first = true, .last = true}, false, mesh.triangles);
  return mesh;
}

Mesh make_torus(Segments segments) {
  Mesh mesh;
  mesh.name = "torus";
  const std::vector<SinCos> around = circle(segments.u, 360), tube = circle(segments.v, 360);
  mesh.positions.reserve(around.size() * tube.size());
  mesh.normals.reserve(around.size() * tube.size());
  for (const SinCos& psi : tube)  // from the outermost circle downwards
    for (const SinCos& phi : around) {
      const double radius = ring_radius + tube_radius * psi.cos;
      mesh.positions.emplace_back(radius * phi.sin, -tube_radius * psi.sin, radius * phi.cos);
      mesh.normals.emplace_back(psi.cos * phi.sin, -psi.sin, psi.cos * phi.cos);
    }
  append_grid_triangles(segments, 0, {}, false, mesh.triangles);
  return mesh;
}

}  // namespace morphcl
