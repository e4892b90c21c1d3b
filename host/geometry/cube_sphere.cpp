// The sphere that becomes a cube: the faces of a cube, cut at equal angles and blown up to a sphere.
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "morphcl/numerics.hpp"
#include "morphcl/solids.hpp"

namespace morphcl {

namespace {

// How many cells an edge of the cube is cut into, by its axis.
std::array<int, 3> cells_of(Segments segments) {
  const int around = (segments.u + 3) / 4, up = (segments.v + 1) / 2;
  return {around, up, around};
}

// Where the lines of a face cross its edge: tangents of equal steps from -45 to 45 degrees, exactly -1 and 1 at the
// ends, and of opposite sign at opposite places.
std::vector<double> equal_angles(int cells) {
  std::vector<double> tangents;
  tangents.reserve(static_cast<std::size_t>(cells) + 1);
  for (int i = 0; i <= cells; ++i) {
    const SinCos angle = sin_cos_degrees(45.0 * (2 * i - cells) / cells);
    tangents.push_back(angle.sin / angle.cos);
  }
  return tangents;
}

// Two triangles a cell, cut by the diagonal that runs towards the middle of the face: on the sphere, where the cells at
// the corners are rhombi of 120 and 60 degrees, it is the shorter one.
void append_face_triangles(int columns, int rows, glm::uint first_vertex, bool flipped,
                           std::vector<glm::uvec3>& triangles) {
  const auto append = [&](glm::uint a, glm::uint b, glm::uint c) {
    triangles.push_back(flipped ? glm::uvec3(a, c, b) : glm::uvec3(a, b, c));
  };
  const auto line = static_cast<glm::uint>(columns) + 1;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const glm::uint a = first_vertex + static_cast<glm::uint>(j) * line + static_cast<glm::uint>(i);
      const glm::uint b = a + 1, c = a + line, d = c + 1;
      const bool left = 2 * i + 1 < columns, low = 2 * j + 1 < rows;
      if (left == low) {
        append(a, b, d);
        append(a, d, c);
      } else {
        append(a, b, c);
        append(b, d, c);
      }
    }
}

}  // namespace

long long sphere_to_cube_vertices(Segments segments) {
  const auto [x, y, z] = cells_of(segments);
  const long long along_x = x + 1LL, along_y = y + 1LL, along_z = z + 1LL;
  return 2 * (along_x * along_y + along_y * along_z + along_z * along_x);
}

Mesh make_sphere_to_cube(Segments segments) {
  Mesh mesh;
  mesh.name = "sphere_to_cube";
  MorphTarget cube{"cube", TargetForm::absolute, {}, {}, {}};
  const auto vertices = static_cast<std::size_t>(sphere_to_cube_vertices(segments));
  mesh.positions.reserve(vertices);
  cube.positions.reserve(vertices);
  cube.normals.reserve(vertices);

  const std::array<int, 3> cells = cells_of(segments);
  for (int axis = 0; axis < 3; ++axis) {
    const int column_axis = (axis + 1) % 3, row_axis = (axis + 2) % 3;
    const std::vector<double> columns = equal_angles(cells[column_axis]), rows = equal_angles(cells[row_axis]);
    for (const double side : {1.0, -1.0}) {
      const auto first = static_cast<glm::uint>(mesh.positions.size());
      glm::dvec3 normal(0);
      normal[axis] = side;
      for (const double row : rows)
        for (const double column : columns) {
          glm::dvec3 p = normal;
          p[column_axis] = column;
          p[row_axis] = row;
          // Summed x, y, z on every face: neighbours find the same point, bit for bit.
          mesh.positions.emplace_back(p / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z));
          cube.positions.emplace_back(p);
          cube.normals.emplace_back(normal);
        }
      append_face_triangles(cells[column_axis], cells[row_axis], first, side < 0, mesh.triangles);
    }
  }
  mesh.normals = mesh.positions;
  mesh.targets.push_back(std::move(cube));
  return mesh;
}

}  // namespace morphcl
