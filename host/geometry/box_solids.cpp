// The solids with flat faces: the pyramid that becomes a box, the cube, and the grid.
#include <array>

#include "host/geometry/grid_topology.hpp"
#include "morphcl/solids.hpp"

namespace morphcl {

Mesh make_pyramid_to_cube() {
  Mesh mesh;
  mesh.name = "pyramid_to_cube";
  const std::array<glm::vec3, 4> base = {{{50, 50, 30}, {150, 50, 30}, {150, 150, 30}, {50, 150, 30}}};
  const glm::vec3 apex(100, 100, 100);
  const float box_top = 100;

  MorphTarget cube{"cube", TargetForm::absolute, {}, {}, {}};
  mesh.positions.assign(base.begin(), base.end());
  cube.positions.assign(base.begin(), base.end());
  for (const glm::vec3& corner : base) {
    mesh.positions.push_back(apex);
    cube.positions.emplace_back(corner.x, corner.y, box_top);
  }
  mesh.targets.push_back(cube);

  mesh.triangles = {{0, 3, 2}, {0, 2, 1}, {4, 5, 6}, {4, 6, 7}};
  for (glm::uint i = 0; i < 4; ++i) {
    const glm::uint next = (i + 1) % 4;
    mesh.triangles.insert(mesh.triangles.end(), {{i, next, next + 4}, {i, next + 4, i + 4}});
    mesh.edges.insert(mesh.edges.end(), {{i, next}, {i + 4, next + 4}, {i, i + 4}});
  }
  return mesh;
}

Mesh make_cube() {
  Mesh mesh;
  mesh.name = "cube";
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {1.0f, -1.0f}) {
      glm::vec3 normal(0), right(0);
      normal[axis] = side;
      right[(axis + 1) % 3] = 1;
      const glm::vec3 up = glm::cross(normal, right);
      const auto first = static_cast<glm::uint>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(),
                            {normal - right - up, normal + right - up, normal + right + up, normal - right + up});
      mesh.normals.insert(mesh.normals.end(), 4, normal);
      mesh.triangles.insert(mesh.triangles.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
    }
  // Two corners of a face that differ along one axis only bound an edge; each edge is kept from one of its two faces.
  for (glm::uint face = 0; face < 6; ++face)
    for (glm::uint corner = 0; corner < 4; ++corner) {
      const glm::uint a = 4 * face + corner, b = 4 * face + (corner + 1) % 4;
      const auto direction = mesh.positions[b] - mesh.positions[a];
      const int along = direction.x != 0 ? 0 : direction.y != 0 ? 1 : 2;
      const glm::uint face_axis = face / 2;
      if (static_cast<int>(face_axis) == (along + 1) % 3) mesh.edges.emplace_back(a, b);
    }
  return mesh;
}

Mesh make_grid(Segments segments) {
  Mesh mesh;
  mesh.name = "grid";
  for (int j = 0; j <= segments.v; ++j)
    for (int i = 0; i <= segments.u; ++i)
      mesh.positions.emplace_back(static_cast<float>(2.0 * i / segments.u - 1), 0,
                                  static_cast<float>(2.0 * j / segments.v - 1));
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 1, 0));
  append_grid_triangles(segments, 0, {}, false, mesh.triangles);
  return mesh;
}

}  // namespace morphcl
