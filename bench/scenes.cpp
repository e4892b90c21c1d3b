#include "bench/scenes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "host/error.hpp"
#include "host/geometry/solids.hpp"

namespace morphcl::bench {

namespace {

// The corner of the cube of half-edge 1 whose coordinates are positive where bits 0, 1, 2 of `i` are set.
glm::vec3 cube_corner(int i) { return {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1}; }

// The pyramid on the same base: the four upper corners meet in the apex.
glm::vec3 pyramid_corner(int i) { return i & 2 ? glm::vec3(0, 1, 0) : cube_corner(i); }

// Six faces of four corners of their own. State 1 is the cube.
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

Shape sphere_shape() {
  Mesh mesh = make_solid("sphere_to_cube", Segments{1024, 512});
  Shape shape;
  shape.positions[0] = std::move(mesh.positions);
  shape.normals[0] = std::move(mesh.normals);
  shape.positions[1] = std::move(mesh.targets[0].positions);
  shape.normals[1] = std::move(mesh.targets[0].normals);
  shape.triangles = std::move(mesh.triangles);
  return shape;
}

// 64 quads that just cover the picture, each behind the next or in front of it, with normals that vary across each.
Shape layers_shape(double aspect, bool back_to_front) {
  constexpr int layers = 64;
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

// splitmix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
class Random {
 public:
  double uniform() { return static_cast<double>(next() >> 40) / (1 << 24); }  // [0, 1)

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_ = 12345;
};

// In a box of half-edge 20 around the eye, turned by uniform random rotations (Shoemake, Graphics Gems III, 1992).
std::vector<Placement> scattered(int count) {
  std::vector<Placement> placements(static_cast<std::size_t>(count));
  Random random;
  for (Placement& placement : placements) {
    const double u = random.uniform();
    const double first = 2.0 * std::numbers::pi * random.uniform(), second = 2.0 * std::numbers::pi * random.uniform();
    const double r = std::sqrt(1.0 - u), s = std::sqrt(u);
    placement.rotation =
        glm::dquat(s * std::cos(second), r * std::sin(first), r * std::cos(first), s * std::sin(second));
    placement.scale = 0.1 + 0.3 * random.uniform();
    for (const int axis : {2, 1, 0}) placement.translation[axis] = 40.0 * (random.uniform() - 0.5);
  }
  return placements;
}

// Looks at the origin from (1, 0.8, 1.7), from as far as both states together span 70 % of the picture's height.
void fit_camera(BenchScene& scene) {
  const glm::dvec3 towards_eye = glm::normalize(glm::dvec3(1.0, 0.8, 1.7));
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), towards_eye));
  const glm::dvec3 up = glm::cross(towards_eye, right);
  std::vector<glm::dvec2> points;  // along up and towards_eye
  for (const auto& positions : scene.shape.positions)
    for (const glm::dvec3 position : positions)
      points.emplace_back(glm::dot(position, up), glm::dot(position, towards_eye));

  const double half_height = std::tan(fovy_degrees * std::numbers::pi / 360.0);
  const auto span_at = [&](double distance) {
    double lowest = 1.0, highest = -1.0;
    for (const glm::dvec2& point : points) {
      const double y = point.x / ((distance - point.y) * half_height);
      lowest = std::min(lowest, y), highest = std::max(highest, y);
    }
    return (highest - lowest) / 2.0;
  };
  // The shapes reach 1.74 from the origin, so everything is in front of the eye.
  double near = 2.0, far = 60.0;
  for (int step = 0; step < 40; ++step) {
    const double middle = (near + far) / 2.0;
    (span_at(middle) > 0.7 ? near : far) = middle;
  }
  scene.eye = far * towards_eye;
  scene.target = glm::dvec3(0.0);
}

}  // namespace

const std::vector<std::string>& scene_names() {
  static const std::vector<std::string> names = {"morph", "heavy", "overdraw_btf", "overdraw_ftb", "many", "wire"};
  return names;
}

BenchScene make_bench_scene(const std::string& name, int width, int height) {
  BenchScene scene;
  scene.name = name;
  if (name == "wire") scene.width = scene.height = 600;
  if (width > 0) scene.width = width;
  if (height > 0) scene.height = height;

  if (name == "morph") {
    scene.frames = 100;
    scene.shape = cube_shape(true, 1.0f);
    fit_camera(scene);
  } else if (name == "heavy") {
    scene.surface = Surface::smooth;
    scene.shape = sphere_shape();
    fit_camera(scene);
  } else if (name == "overdraw_btf" || name == "overdraw_ftb") {
    scene.frames = 10;
    scene.surface = Surface::smooth;
    scene.shape = layers_shape(static_cast<double>(scene.width) / scene.height, name == "overdraw_btf");
  } else if (name == "many") {
    scene.shape = cube_shape(false, 0.75f);
    scene.placements = scattered(20000);
  } else if (name == "wire") {
    scene.frames = 100;
    scene.surface = Surface::lines;
    scene.shape = lines_shape();
    fit_camera(scene);
  } else {
    throw Error(ErrorKind::usage, "",
                fmt::format("there is no scene \"{}\"; scenes: {}", name, fmt::join(scene_names(), ", ")));
  }
  return scene;
}

}  // namespace morphcl::bench
