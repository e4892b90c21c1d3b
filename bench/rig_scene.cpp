#include "bench/rig_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/morphcl_scene.hpp"
#include "morphcl/error.hpp"
#include "morphcl/solids.hpp"

namespace morphcl::bench {

namespace {

constexpr int max_targets = 4096;

// A smooth bump around a point of the sphere that is `number`'s own; the normals follow it roughly, as sculpted shapes
// do.
MorphTarget bump(const Mesh& sphere, int number) {
  // Multiples of two irrational numbers spread evenly, however many there are.
  const double height = 2.0 * std::fmod(0.5 + 0.7548776662 * number, 1.0) - 1.0, angle = 2.399963 * number;
  const double radius = std::sqrt(1.0 - height * height);
  const glm::vec3 centre(radius * std::cos(angle), height, radius * std::sin(angle));
  MorphTarget target;
  target.name = fmt::format("bump {}", number);
  for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
    const float near = std::max(0.0f, glm::dot(sphere.positions[i], centre));
    target.positions.push_back(0.2f * near * near * sphere.positions[i]);
    target.normals.push_back(0.4f * near * (sphere.positions[i] - centre));
  }
  return target;
}

}  // namespace

Scene rig_scene(int targets, int width, int height, int frames) {
  if (targets < 1 || targets > max_targets)
    throw Error(ErrorKind::usage, "", fmt::format("--amount {} of scene rig: from 1 to {}", targets, max_targets));
  const int active_targets = std::min(targets, max_active_targets);
  BenchScene ball = make_bench_scene("heavy", width, height, 12 * 46 * 46);
  ball.name = "rig";
  Scene scene = morphcl_scene(ball, frames);

  Mesh& mesh = scene.meshes.front();
  mesh.targets.clear();
  MorphWeights& weights = scene.objects.front().morph;
  const TimeBase& time = scene.timeline.time;
  weights.weights.assign(static_cast<std::size_t>(targets), 0.0);
  weights.tracks.clear();
  for (int active = 0; active < active_targets; ++active) {
    // Ends apart from 0, so that all five are used in every frame.
    const double start = 0.2 + 0.1 * active;
    const int target = active * targets / active_targets;
    weights.tracks.push_back({target, Track({Interpolation::linear,
                                             1,
                                             false,
                                             time.ticks_per_second(),
                                             {time.frame_ticks(0), time.frame_ticks(std::max(1, frames - 1))},
                                             {start, 1.0 - start / 2.0}})});
  }
  for (int target = 0, active = 0; target < targets; ++target) {
    const bool is_active = active < active_targets && target == active * targets / active_targets;
    mesh.targets.push_back(bump(mesh, is_active ? active++ : max_active_targets + target));
  }
  validate(scene);
  return scene;
}

}  // namespace morphcl::bench
