#include "host/scene/model/fitted_camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "morphcl/projection.hpp"
#include "tests/scene/outline.hpp"
#include "tests/scene/shot_folder.hpp"

namespace morphcl {
namespace {

using test::expect_fills;
using test::ShotFolder;

TEST(FittedCamera, FillsThePictureWithSolids) {
  for (const char* mesh : {"cube", "sphere", "teapot", "torus", "grid", "pyramid_to_cube"}) {
    SCOPED_TRACE(mesh);
    expect_fills(ShotFolder().load(std::string("[[object]]\nmesh = \"") + mesh + "\"\n"));
  }
}

TEST(FittedCamera, FitsTheWidthOfATallImage) {
  const auto outline =
      expect_fills(ShotFolder().load("[image]\nsize = [200, 1000]\n" + std::string(test::cube_object)));
  EXPECT_GT(outline.upper.x - outline.lower.x, outline.upper.y - outline.lower.y);
}

TEST(FittedCamera, SeesEveryFrameOfWhatMoves) {
  expect_fills(
      ShotFolder().load("[[object]]\nmesh = \"pyramid_to_cube\"\n"
                        "[[object.track]]\ntarget = \"translation\"\nkeys = [[0, [0, 0, 0]], [100, [900, 20, -300]]]\n"
                        "[[object.track]]\ntarget = \"morph.cube\"\nkeys = [[0, 0], [100, 1]]\n"));
}

// At one frame of 3,000 it is far outside of where it is at all others.
TEST(FittedCamera, SeesASingleFrame) {
  expect_fills(ShotFolder().load(std::string(test::cube_object) +
                                 "[[object.track]]\ntarget = \"translation\"\ninterpolation = \"step\"\n"
                                 "keys = [[0, [0, 0, 0]], [1777, [9, 2, 3]], [1778, [0, 0, 0]], [2999, [0, 0, 0]]]\n"));
}

TEST(FittedCamera, SeesTurningBelowAMovingParent) {
  expect_fills(
      ShotFolder().load("[[object]]\nmesh = \"teapot\"\n[[object.transform]]\ntranslate = [3, 0, 0]\n"
                        "[[object.track]]\ntarget = \"rotation\"\nkeys = [[0, { axis = [0.2, 1, 0.1], degrees = 0 }],"
                        " [100, { axis = [0.2, 1, 0.1], degrees = 300 }]]\n"
                        "[[object.track]]\ntarget = \"scale\"\nkeys = [[0, [1, 1, 1]], [60, [1, 2, 0.5]]]\n"));
}

// The springs of the weights carry it over its target, so weights go below 0 and above 1.
TEST(FittedCamera, SeesSpringsOvershoot) {
  const Scene scene = ShotFolder().load(
      "[[object]]\nmesh = \"sphere_to_cube\"\n[[object.track]]\ntarget = \"morph.cube\"\n"
      "interpolation = \"spring\"\nfrequency = 2\ndamping_ratio = 0.05\nkeys = [[0, 0], [1, 3]]\n");
  double heaviest = 0;
  for (const std::int64_t frame : frame_numbers(scene.frames))
    heaviest = std::max(heaviest, weights_at(scene.objects[0].morph, scene.timeline.time, frame)[0]);
  EXPECT_GT(heaviest, 4);
  expect_fills(scene);
}

TEST(FittedCamera, SeesElasticVertices) {
  const Scene scene = ShotFolder().load(
      "[[object]]\nmesh = \"pyramid_to_cube\"\n[object.elastic]\nanchor = 300\nstiffness = 500\ndamping = 1\n"
      "[[object.track]]\ntarget = \"morph.cube\"\ninterpolation = \"step\"\nkeys = [[0, 0], [2, 1]]\n");
  expect_fills(scene);
}

TEST(FittedCamera, LeavesOutVerticesThatNoTriangleNames) {
  const ShotFolder folder;
  folder.write("stray.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 900 0 0\nf 1 2 3\n");
  const Scene scene = load_scene(folder.path("stray.obj"));
  expect_fills(scene);
  EXPECT_LT(scene.timeline.camera.eye.x, 10);
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
