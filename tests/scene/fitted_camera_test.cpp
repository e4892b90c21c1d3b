#include "host/scene/model/fitted_camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::ShotFolder;

struct Seen {
  double width = 0, height = 0;             // largest |x| and |y| in NDC, over all vertices and frames
  double nearest = INFINITY, farthest = 0;  // distance along the view axis
};

// What the camera of a scene sees of every vertex at every frame, by projecting each.
Seen seen(const Scene& scene) {
  Seen result;
  const auto& perspective = std::get<Perspective>(scene.timeline.camera.projection);
  const double slope = std::tan(perspective.fovy_degrees * M_PI / 360);
  const double aspect = static_cast<double>(scene.image.width) / scene.image.height;
  for (const std::int64_t frame : frame_numbers(scene.frames)) {
    const FrameState state = evaluate(scene.timeline, frame);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const Mesh& mesh = scene.meshes[scene.objects[i].mesh];
      const std::vector<double> weights = weights_at(scene.objects[i].morph, scene.timeline.time, frame);
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        glm::dvec3 p(mesh.positions[v]);
        if (!mesh.targets.empty()) p = glm::mix(p, glm::dvec3(mesh.targets[0].positions[v]), weights[0]);
        const glm::dvec4 eye =
            state.camera.world_to_eye * state.node_to_world[scene.objects[i].node] * glm::dvec4(p, 1);
        const double distance = -eye.z;
        result.width = std::max(result.width, std::abs(eye.x) / distance / slope / aspect);
        result.height = std::max(result.height, std::abs(eye.y) / distance / slope);
        result.nearest = std::min(result.nearest, distance);
        result.farthest = std::max(result.farthest, distance);
      }
    }
  }
  return result;
}

void expect_fits(const Scene& scene, double min_part) {
  const Seen view = seen(scene);
  const auto& perspective = std::get<Perspective>(scene.timeline.camera.projection);
  constexpr double rounding = 1e-12;
  EXPECT_LE(std::max(view.width, view.height), 0.7 + rounding);
  EXPECT_GE(std::max(view.width, view.height), min_part);
  EXPECT_GT(view.nearest, perspective.near);
  EXPECT_LT(view.farthest, perspective.far);
}

TEST(FittedCamera, FillsSeventyPercentWithABox) {
  // The bounds of a cube are the cube: its outermost corner is at 70 %.
  expect_fits(ShotFolder().load(test::cube_object), 0.7 - 1e-6);
}

TEST(FittedCamera, FitsTheWidthOfATallImage) {
  expect_fits(ShotFolder().load("[image]\nsize = [200, 1000]\n" + std::string(test::cube_object)), 0.7 - 1e-6);
}

TEST(FittedCamera, SeesEveryFrameOfWhatMoves) {
  expect_fits(
      ShotFolder().load("[[object]]\nmesh = \"pyramid_to_cube\"\n"
                        "[[object.track]]\ntarget = \"translation\"\nkeys = [[0, [0, 0, 0]], [100, [900, 20, -300]]]\n"
                        "[[object.track]]\ntarget = \"morph.cube\"\nkeys = [[0, 0], [100, 1]]\n"),
      0.6);
}

TEST(FittedCamera, LooksFromTheSameSideWhateverTheSizeAndPlace) {
  for (const char* scale : {"1e-6", "1", "1e6"})
    for (const char* place : {"0", "-1000", "1e8"}) {
      const Scene scene =
          ShotFolder().load(std::string(test::cube_object) + "[[object.transform]]\nscale = [" + scale + ", " + scale +
                            ", " + scale + "]\n[[object.transform]]\ntranslate = [" + place + ", 0, 0]\n");
      const Camera& camera = scene.timeline.camera;
      const glm::dvec3 from = glm::normalize(camera.eye - camera.target),
                       expected = glm::normalize(glm::dvec3(1, 0.8, 1.7));
      EXPECT_GT(glm::dot(from, expected), 1 - 1e-4) << "scale " << scale << ", place " << place;
    }
}

TEST(FittedCamera, LooksAtAPointFromADistance) {
  const ShotFolder folder;
  for (const int at : {0, 5}) {
    const std::string vertex = "v " + std::to_string(at) + " " + std::to_string(at) + " " + std::to_string(at) + "\n";
    folder.write("point.obj", vertex + vertex + vertex + "f 1 2 3\n");
    const Scene scene = load_scene(folder.path("point.obj"));
    const FrameState state = evaluate(scene.timeline, 0);
    const glm::dvec4 point = state.camera.world_to_eye * glm::dvec4(at, at, at, 1);
    const auto& perspective = std::get<Perspective>(state.camera.projection);
    // The bounds of one vertex are widened by two ulp of it; 16 u of the distance, which is about 2, for the camera.
    const double widening = 2 * std::ldexp(1.0, -23) * at * std::sqrt(3.0) + 32 * std::ldexp(1.0, -53);
    EXPECT_NEAR(point.x, 0, widening) << "point at " << at;
    EXPECT_NEAR(point.y, 0, widening) << "point at " << at;
    EXPECT_GT(-point.z, perspective.near) << "point at " << at;
    EXPECT_LT(-point.z, perspective.far) << "point at " << at;
  }
}

TEST(FittedCamera, LeavesOutWhatIsHidden) {
  const std::string shot = std::string(test::cube_object) +
                           "[[object]]\nmesh = \"sphere\"\n[[object.transform]]\ntranslate = [1000, 0, 0]\n"
                           "[[object.track]]\ntarget = \"visible\"\nkeys = [[0, false]]\n";
  EXPECT_EQ(ShotFolder().load(shot).timeline.camera.eye, ShotFolder().load(test::cube_object).timeline.camera.eye);
}

TEST(FittedCamera, OfAnEmptySceneLooksAtTheOrigin) {
  Scene scene;
  scene.frames = {{}};
  complete_scene(scene, {.camera = false, .lights = false, .frames = true});
  EXPECT_NEAR(glm::length(glm::normalize(scene.timeline.camera.eye) - glm::normalize(glm::dvec3(1, 0.8, 1.7))), 0, 0.1);
}

TEST(AnimationRange, EndsAtTheLastWholeFrameAndIsBounded) {
  std::vector<std::string> warnings;
  Scene scene;
  Timeline& timeline = scene.timeline;
  timeline.nodes.emplace_back();
  const auto with_last_key = [&](double frame) {
    const TimeBase& time = timeline.time;
    timeline.nodes[0].visible_track =
        Track({Interpolation::step, 1, false, time.ticks_per_second(), {time.frames_to_ticks(frame)}, {1}});
    return animation_range(scene, warnings).last;
  };
  EXPECT_EQ(animation_range(scene, warnings).last, 0);
  EXPECT_EQ(with_last_key(10), 10);
  EXPECT_EQ(with_last_key(10.5), 10);
  EXPECT_EQ(with_last_key(-3), 0);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(with_last_key(5'000'000), 999'999);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0], "the animation has 5000001 frames; the first 1000000 are drawn");
}

}  // namespace
}  // namespace morphcl
