#include "bench/scenes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <numbers>

#include "bench/placements.hpp"
#include "bench/shapes.hpp"
#include "morphcl/error.hpp"

namespace morphcl::bench {

namespace {

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
      lowest = std::min(lowest, y);
      highest = std::max(highest, y);
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

struct AmountRange {
  int lowest, highest, standard;
};

// Error(usage) when it is out of range; 0 is the standard one.
int checked_amount(const std::string& scene, int amount, AmountRange range) {
  if (amount == 0) return range.standard;
  if (amount < range.lowest || amount > range.highest)
    throw Error(ErrorKind::usage, "",
                fmt::format("--amount {} of scene {}: from {} to {}", amount, scene, range.lowest, range.highest));
  return amount;
}

void refuse_amount(const std::string& scene, int amount) {
  if (amount != 0)
    throw Error(ErrorKind::usage, "", fmt::format("--amount {}: there is nothing to count in {}", amount, scene));
}

void make_sphere(BenchScene& scene, int amount) {
  const int triangles = checked_amount(scene.name, amount, {16, 100'000'000, 12 * 296 * 296});
  scene.surface = Surface::smooth;
  scene.shape = sphere_shape(static_cast<int>(std::lround(std::sqrt(triangles / 12.0))));
  fit_camera(scene);
}

void make_layers(BenchScene& scene, int amount, bool back_to_front) {
  // The last of 190 layers is at 96.5, before the far plane.
  const int layers = checked_amount(scene.name, amount, {1, 190, scene.alpha < 1 ? 8 : 64});
  scene.frames = 10;
  scene.surface = Surface::smooth;
  scene.shape = layers_shape(layers, static_cast<double>(scene.width) / scene.height, back_to_front);
}

void make_cubes(BenchScene& scene, int amount) {
  const int count = checked_amount(scene.name, amount, {1, 1'000'000, 20'000});
  const double aspect = static_cast<double>(scene.width) / scene.height;
  scene.shape = cube_shape(false, 0.75f);
  scene.placements = scene.name == "many" ? scattered(count) : crowd(count, aspect, scene.name == "crowd_in_view");
}

void make_morph(BenchScene& scene, int amount) {
  refuse_amount(scene.name, amount);
  scene.frames = 100;
  const bool lines = scene.name == "wire";
  scene.surface = lines ? Surface::lines : Surface::flat;
  scene.shape = lines ? lines_shape() : cube_shape(true, 1.0f);
  fit_camera(scene);
}

}  // namespace

bool is_placed(const BenchScene& scene) {
  const Placement& first = scene.placements.front();
  return scene.placements.size() > 1 || first.translation != glm::dvec3(0.0) || first.scale != 1.0 ||
         first.rotation != glm::dquat(1.0, 0.0, 0.0, 0.0);
}

const std::vector<std::string>& scene_names() {
  static const std::vector<std::string> names = {"morph", "heavy",   "overdraw_btf", "overdraw_ftb", "many",
                                                 "wire",  "blended", "crowd",        "crowd_in_view"};
  return names;
}

BenchScene make_bench_scene(const std::string& name, int width, int height, int amount) {
  BenchScene scene;
  scene.name = name;
  if (name == "wire") scene.width = scene.height = 600;
  if (width > 0) scene.width = width;
  if (height > 0) scene.height = height;

  if (name == "morph" || name == "wire") {
    make_morph(scene, amount);
  } else if (name == "heavy") {
    make_sphere(scene, amount);
  } else if (name == "overdraw_btf" || name == "overdraw_ftb") {
    make_layers(scene, amount, name == "overdraw_btf");
  } else if (name == "blended") {
    scene.alpha = 0.5;
    make_layers(scene, amount, true);
  } else if (name == "many" || name == "crowd" || name == "crowd_in_view") {
    make_cubes(scene, amount);
  } else {
    throw Error(ErrorKind::usage, "",
                fmt::format("there is no scene \"{}\"; scenes: {}", printable(name), fmt::join(scene_names(), ", ")));
  }
  return scene;
}

}  // namespace morphcl::bench
