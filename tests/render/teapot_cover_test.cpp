// Nothing shows through the teapot: what is drawn of its front faces covers every pixel that the pot covers.
//
// The truth is the pot with all its faces drawn from both sides, so that wherever a line of sight meets any part of the
// true surface, be it the inner wall behind a gap, a pixel is covered. Where it meets none, through the handle and
// beside the pot, both show the background. Both are drawn by the reference renderer, which the device equals bit for
// bit.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "host/render/frame/frame_plan.hpp"
#include "host/scene/model/fitted_camera.hpp"
#include "morphcl/mesh.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/scene.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/scene_builder.hpp"

namespace morphcl::test {
namespace {

struct Cover {
  int pixels = 0;   // that the pots cover
  int through = 0;  // of them, those that show the background where only front faces are drawn
};

FrameBuffer drawn_for_cover(const Scene& scene, std::int64_t frame) {
  const Plan plan = plan_frame(scene, frame);
  FrameBuffer pixels(plan->width, plan->height, plan->channels);
  make_reference_renderer()->render(plan, pixels);
  return pixels;
}

// Every pot of the scene by itself, so that none hides the gaps of another.
Cover cover_of(const Scene& scene, std::int64_t frame) {
  Cover cover;
  for (const Object& pot : scene.objects) {
    Scene front = scene;
    front.objects = {pot};
    front.objects[0].material.double_sided = false;
    Scene whole = front;
    whole.objects[0].material.double_sided = true;
    const FrameBuffer seen = drawn_for_cover(front, frame), truth = drawn_for_cover(whole, frame);
    for (int y = 0; y < truth.height(); ++y)
      for (int x = 0; x < truth.width(); ++x) {
        const bool covered = truth.depth_row(y)[x] < background_depth;
        cover.pixels += covered;
        cover.through += covered && seen.depth_row(y)[x] >= background_depth;
      }
  }
  return cover;
}

Scene one_pot(Mesh mesh) {
  SceneBuilder builder(320, 240);
  builder.add(std::move(mesh), Shading::flat);
  return builder.scene();
}

// Directions that go evenly round the sphere, and three that look at the lid's gap, into the spout and at the handle.
std::vector<glm::dvec3> directions_of_view() {
  constexpr int count = 60;
  std::vector<glm::dvec3> directions = {{0.1, 0.5, 1}, {1, 0.9, 0.1}, {-1, 0.1, 0.05}};
  for (int i = 0; i < count; ++i) {
    const double height = 1 - (2.0 * i + 1) / count, radius = std::sqrt(1 - height * height), angle = 2.399963 * i;
    directions.emplace_back(radius * std::cos(angle), height, radius * std::sin(angle));
  }
  return directions;
}

// As near as the fitted camera goes.
Cover cover_from_all_sides(Scene scene) {
  Cover sum;
  fit_camera(scene);
  const double distance = glm::length(scene.timeline.camera.eye - scene.timeline.camera.target);
  const glm::dvec3 target = scene.timeline.camera.target;
  for (const glm::dvec3& direction : directions_of_view()) {
    scene.timeline.camera.eye = target + distance * glm::normalize(direction);
    const Cover cover = cover_of(scene, 0);
    sum.pixels += cover.pixels;
    sum.through += cover.through;
  }
  return sum;
}

TEST(TeapotCover, NothingShowsThroughThePotsOfTheDemos) {
  for (const char* name : {"teapots.toml", "crowd.toml"}) {
    const Scene shot = load_scene(std::string(MORPHCL_DEMOS) + "/" + name);
    Scene scene = shot;
    scene.image.width = shot.image.width / 2;
    scene.image.height = shot.image.height / 2;
    const std::vector<std::int64_t> frames = frame_numbers(scene.frames);
    for (std::size_t i = 0; i < frames.size(); i += 24) {
      const Cover cover = cover_of(scene, frames[i]);
      EXPECT_GT(cover.pixels, 5000) << name << ", frame " << frames[i];
      EXPECT_EQ(cover.through, 0) << name << ", frame " << frames[i] << ", of " << cover.pixels;
    }
  }
}

TEST(TeapotCover, NothingShowsThroughTheFittedView) {
  Scene scene = one_pot(make_teapot({10, 10}));
  scene.image.width = 1280;
  scene.image.height = 960;
  fit_camera(scene);
  const Cover cover = cover_of(scene, 0);
  EXPECT_GT(cover.pixels, 100'000);
  EXPECT_EQ(cover.through, 0);
}

TEST(TeapotCover, NothingShowsThroughFromAnySide) {
  for (const int segments : {2, 3, 5, 10, 24}) {
    const Cover cover = cover_from_all_sides(one_pot(make_teapot({segments, segments})));
    EXPECT_GT(cover.pixels, 500'000) << "segments " << segments;
    EXPECT_EQ(cover.through, 0) << "segments " << segments << ", of " << cover.pixels;
  }
}

// Without what closes them the background does show: the test would see it.
TEST(TeapotCover, ThePatchesAloneHaveHoles) {
  Mesh mesh = make_teapot({10, 10});
  mesh.triangles.resize(32 * 2 * 10 * 10 - 8 * 10);
  EXPECT_GT(cover_from_all_sides(one_pot(mesh)).through, 100);
}

}  // namespace
}  // namespace morphcl::test
