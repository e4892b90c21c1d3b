#include "bench/shapes.hpp"

#include <cmath>
#include <numbers>

#include "morphcl/solids.hpp"

namespace morphcl::bench {

namespace {

// The corner of the cube of half-edge 1 whose coordinates are positive where bits 0, 1, 2 of `i` are set.
glm::vec3 cube_corner(int i) { return {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1}; }

// The pyramid on the same base: the four upper corners meet in the apex.
glm::vec3 pyramid_corner(int i) { return i & 2 ? glm::vec3(0, 1, 0) : cube_corner(i); }

}  // namespace

Shape cube_shape(bool pyramid_first, float first_scale) {
  Shape shape;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1}) {
      glm::vec3 normal(0.0f);
      normal[axis] = static_cast<float>(side);
      const int fixed = side > 0 ? 1 << axis : 0, right = 1 << (axis + 1) % 3, up = 1 << (axis + 2) % 3;
      const auto first_vertex = static_cast<glm::uint>(shape.positions[0].size());
      for (const int corner : {fixed, fixed | right, fixed | right | up, fixed | up}) {
        shape.positions[0].push_back(pyramid_first ? pyramid_corner(corner) : cube_corner(corner) * first_scale);
        shape.positions[1].push_back(cube_corner(corner));
        // A pyramid's side leans back by 1 : 2 and straightens linearly; of normals 2 long, state 0 rises by 1.
        const bool leans = pyramid_first && axis != 1;
        shape.normals[0].push_back(2.0f * normal + glm::vec3(0.0f, leans ? 1.0f : 0.0f, 0.0f));
        shape.normals[1].push_back(2.0f * normal);
      }
      const glm::uint second = side > 0 ? 1 : 3, fourth = side > 0 ? 3 : 1;
      for (const glm::uvec3 triangle : {glm::uvec3(0, second, 2), glm::uvec3(0, 2, fourth)})
        shape.triangles.push_back(first_vertex + triangle);
    }
  return shape;
}

Shape sphere_shape(int cells) {
  Mesh mesh = make_solid("sphere_to_cube", Segments{4 * cells, 2 * cells});
  Shape shape;
  shape.positions[0] = std::move(mesh.positions);
  shape.normals[0] = std::move(mesh.normals);
  shape.positions[1] = std::move(mesh.targets[0].positions);
  shape.normals[1] = std::move(mesh.targets[0].normals);
  shape.triangles = std::move(mesh.triangles);
  return shape;
}

Shape layers_shape(int layers, double aspect, bool back_to_front) {
  const double reach_y = std::tan(fovy_degrees * std::numbers::pi / 360.0) * 1.0005, reach_x = reach_y * aspect;
  Shape shape;
  for (int drawn = 0; drawn < layers; ++drawn) {
    const int layer = back_to_front ? layers - 1 - drawn : drawn;
    const double distance = 2.0 + 0.5 * layer, slope = 0.2 + 0.01 * layer;
    const auto first_vertex = static_cast<glm::uint>(shape.positions[0].size());
    for (const double y : {-1.0, 1.0})
      for (const double x : {-1.0, 1.0}) {
        const glm::vec3 corner(x * reach_x * distance, y * reach_y * distance, -distance);
        for (auto& positions : shape.positions) positions.push_back(corner);
        shape.normals[0].push_back(glm::normalize(glm::vec3(x * slope, y * slope, 1.0)));
        shape.normals[1].push_back(glm::normalize(glm::vec3(-x * slope, y * 0.5, 1.0)));
      }
    for (const glm::uvec3 triangle : {glm::uvec3(0, 1, 2), glm::uvec3(2, 1, 3)})
      shape.triangles.push_back(first_vertex + triangle);
  }
  return shape;
}

Shape lines_shape() {
  Shape shape;
  for (int i = 0; i < 8; ++i) {
    shape.positions[0].push_back(pyramid_corner(i));
    shape.positions[1].push_back(cube_corner(i));
    for (const int bit : {1, 2, 4})
      if (!(i & bit)) shape.edges.emplace_back(i, i | bit);
  }
  return shape;
}

}  // namespace morphcl::bench
