// Small pictures whose coverage can be counted, for tests of several samples a pixel.
#pragma once

#include <vector>

#include "morphcl/numerics.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/support/random.hpp"

namespace morphcl::test {

inline FrameBuffer drawn(Renderer& renderer, const Scene& scene, std::int64_t frame = 0) {
  const Plan plan = plan_frame(scene, frame);
  FrameBuffer pixels = plan.make_frame();
  renderer.forget();
  renderer.render(plan, pixels);
  return pixels;
}

inline Scene with_samples(Scene scene, int samples) {
  scene.image.samples = samples;
  return scene;
}

// With each coordinate from `low` to below `high`.
inline glm::dvec2 random_point(test_support::Random& random, const glm::dvec2& low, const glm::dvec2& high) {
  const double x = random.in(low.x, high.x);
  const double y = random.in(low.y, high.y);
  return {x, y};
}

// Pixel (x, y) of the picture is [x, x + 1) x [y, y + 1) of the xy plane, y down.
inline SceneBuilder flat_picture(int width, int height) {
  SceneBuilder b(width, height);
  b.look({0, 0, 5}).project(Orthographic{-0.5 * width, 0.5 * width, -0.5 * height, 0.5 * height, 1, 10});
  b.no_lights();
  b.scene().timeline.ambient = glm::dvec3(1);
  return b;
}

// In pixels, whole 1/256 of which are exact.
inline Mesh polygon(const std::vector<glm::dvec2>& corners, int width, int height) {
  Mesh mesh;
  for (const glm::dvec2& c : corners) mesh.positions.emplace_back(c.x - 0.5 * width, 0.5 * height - c.y, 0.0);
  for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) mesh.triangles.push_back({0, i, i + 1});
  return mesh;
}

inline double alpha(const FrameBuffer& frame, int x, int y) { return from_half(frame.color_row(3, y)[x]); }

}  // namespace morphcl::test
