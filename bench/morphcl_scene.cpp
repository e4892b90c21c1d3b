#include "bench/morphcl_scene.hpp"

#include <fmt/format.h>

namespace morphcl::bench {

namespace {

std::vector<glm::vec3> unit_length(std::vector<glm::vec3> directions) {
  for (glm::vec3& direction : directions) direction = glm::normalize(direction);
  return directions;
}

Mesh take_mesh(BenchScene& bench) {
  Mesh mesh;
  mesh.name = bench.name;
  mesh.positions = std::move(bench.shape.positions[0]);
  mesh.triangles = std::move(bench.shape.triangles);
  mesh.edges = std::move(bench.shape.edges);
  MorphTarget target;
  target.name = "end";
  target.form = TargetForm::absolute;
  target.positions = std::move(bench.shape.positions[1]);
  if (bench.surface == Surface::smooth) {
    mesh.normals = unit_length(std::move(bench.shape.normals[0]));
    target.normals = unit_length(std::move(bench.shape.normals[1]));
  }
  mesh.targets.push_back(std::move(target));
  return mesh;
}

// Lit surfaces have base_color * (ambient + sum of lights), so the ambient light that adds the same to every channel
// is coloured.
void set_light(Timeline& timeline) {
  Light light;
  light.vector = light_direction;
  timeline.lights.push_back(light);
  timeline.ambient = ambient / base_color;
}

MorphWeights mixing_weights(const TimeBase& time, int frames) {
  MorphWeights weights;
  weights.weights = {0.0};
  if (frames > 1)
    weights.tracks.push_back({0, Track({Interpolation::linear,
                                        1,
                                        false,
                                        time.ticks_per_second(),
                                        {time.frame_ticks(0), time.frame_ticks(frames - 1)},
                                        {0.0, 1.0}})});
  return weights;
}

Material make_material(Surface surface, double alpha) {
  Material material;
  if (surface == Surface::lines) {
    material.base_color = glm::dvec4(1.0);
    material.shading = Shading::wireframe;
  } else {
    material.base_color = glm::dvec4(base_color, alpha);
    material.shading = surface == Surface::flat ? Shading::flat : Shading::smooth;
  }
  return material;
}

}  // namespace

Scene morphcl_scene(BenchScene& bench, int frames) {
  Scene scene;
  scene.name = bench.name;
  scene.meshes.push_back(take_mesh(bench));
  scene.image.width = bench.width;
  scene.image.height = bench.height;
  scene.frames = {{0, frames - 1, 1}};

  Timeline& timeline = scene.timeline;
  set_light(timeline);
  timeline.camera.projection = Perspective{fovy_degrees, near_plane, far_plane};
  timeline.camera.eye = bench.eye;
  timeline.camera.target = bench.target;
  const Material material = make_material(bench.surface, bench.alpha);
  const MorphWeights weights = mixing_weights(timeline.time, frames);
  for (const Placement& placement : bench.placements) {
    Node node;
    node.translation = placement.translation;
    node.rotation = placement.rotation;
    node.scale = glm::dvec3(placement.scale);
    const auto index = static_cast<int>(timeline.nodes.size());
    node.name = fmt::format("{} {}", bench.name, index);
    scene.objects.push_back({node.name, 0, index, material, weights});
    timeline.nodes.push_back(std::move(node));
  }
  validate(scene);
  return scene;
}

}  // namespace morphcl::bench
