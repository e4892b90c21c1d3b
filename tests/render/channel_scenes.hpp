// Scenes in which every channel has something to show.
#pragma once

#include <string>

#include "tests/render/sample_pictures.hpp"
#include "tests/render/test_scenes.hpp"
#include "tests/support/channel_sets.hpp"

namespace morphcl::test {

// From 0 at frame 0 to `way` at frame 100, added to what is there.
inline Track drifting(const TimeBase& time, const glm::dvec3& from, const glm::dvec3& way) {
  const glm::dvec3 to = from + way;
  return Track({Interpolation::linear,
                3,
                false,
                time.ticks_per_second(),
                {time.frame_ticks(0), time.frame_ticks(100)},
                {from.x, from.y, from.z, to.x, to.y, to.z}});
}

// The scene with texture coordinates on every second mesh, four materials, and a camera and every third object that
// drift.
inline Scene with_channels(Scene scene, ChannelSet channels, int samples = 1) {
  scene.image.channels = channels;
  scene.image.samples = samples;
  for (std::size_t i = 0; i < scene.meshes.size(); i += 2) {
    Mesh& mesh = scene.meshes[i];
    mesh.uvs.clear();
    for (const glm::vec3& p : mesh.positions) mesh.uvs.emplace_back(0.25f * p.x - 0.5f * p.z, 0.75f * p.y + 0.125f);
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (i % 5 != 4) scene.objects[i].material.name = "material " + std::to_string(i % 5);
  Timeline& timeline = scene.timeline;
  timeline.camera.eye_track = drifting(timeline.time, timeline.camera.eye, {0.4, -0.3, 0.2});
  for (std::size_t i = 0; i < timeline.nodes.size(); i += 3)
    timeline.nodes[i].translation_track = drifting(timeline.time, timeline.nodes[i].translation, {-0.7, 0.5, 0.9});
  return scene;
}

}  // namespace morphcl::test
