// The shots of demos/ load, and show what they promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "morphcl/scene.hpp"

namespace morphcl {
namespace {

Scene demo(const std::string& name) { return load_scene(std::string(MORPHCL_DEMOS) + "/" + name); }

TEST(DemoShots, AllLoadWithoutWarningsAndSoDoThoseOfTheFirstShot) {
  int shots = 0;
  for (const char* folder : {MORPHCL_DEMOS, MORPHCL_DEMOS "/../docs/first-shot"})
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().extension() == ".toml") {
        EXPECT_TRUE(load_scene(entry.path().string()).warnings.empty()) << entry.path();
        ++shots;
      }
  EXPECT_GE(shots, 15);
}

TEST(DemoShots, PyramidToCubeMorphsInAHundredSteps) {
  const Scene scene = demo("pyramid_to_cube.toml");
  const std::vector<std::int64_t> frames = frame_numbers(scene.frames);
  ASSERT_EQ(frames.size(), 101u);
  EXPECT_EQ(scene.image.width, 1920);
  EXPECT_EQ(scene.image.height, 1080);
  for (const std::int64_t frame : frames)
    EXPECT_EQ(weights_at(scene.objects[0].morph, scene.timeline.time, frame)[0], static_cast<double>(frame) / 100)
        << "frame " << frame;
}

TEST(DemoShots, WireframeTurnsHalfADegreeAFrame) {
  const Scene scene = demo("wireframe.toml");
  EXPECT_EQ(scene.image.width, 600);
  EXPECT_EQ(scene.image.height, 600);
  EXPECT_EQ(wireframe_edges(scene.meshes[0]).size(), 12u);
  const int node = scene.objects[0].node;
  const auto turned = [&](std::int64_t frame) {
    return glm::dmat3(evaluate(scene.timeline, frame).node_to_world[node]);
  };
  // The trace of a rotation by a is 1 + 2 cos a; the scale is 0.02.
  for (const std::int64_t frame : {0, 1, 300, 719}) {
    const glm::dmat3 now = turned(frame), next = turned(frame + 1), step = next * glm::transpose(now) / (0.02 * 0.02);
    EXPECT_NEAR(step[0][0] + step[1][1] + step[2][2], 1 + 2 * std::cos(0.5 * M_PI / 180), 1e-12) << "frame " << frame;
  }
}

// From the outside inwards: none at first, no target before the one outside of it, and all in the end.
TEST(DemoShots, WaterLilyOpensRowByRow) {
  const Scene scene = demo("water_lily.toml");
  const std::vector<MorphTarget>& targets = scene.meshes[0].targets;
  ASSERT_EQ(targets.size(), 25u);
  const auto weights = [&](std::int64_t frame) {
    return weights_at(scene.objects[0].morph, scene.timeline.time, frame);
  };
  ASSERT_EQ(frame_numbers(scene.frames).size(), 101u);
  EXPECT_EQ(weights(0), std::vector<double>(25, 0.0));
  EXPECT_EQ(weights(100), std::vector<double>(25, 1.0));
  for (std::int64_t frame = 1; frame < 100; ++frame) {
    const std::vector<double> now = weights(frame), before = weights(frame - 1);
    for (std::size_t target = 0; target < 25; ++target) {
      EXPECT_GE(now[target], before[target]) << targets[target].name << ", frame " << frame;
      EXPECT_LE(now[target], 1) << targets[target].name << ", frame " << frame;
    }
    for (std::size_t target = 2; target < 24; ++target)  // lift and open take turns, row by row
      EXPECT_LE(now[target], now[target - 2]) << targets[target].name << ", frame " << frame;
  }
  const std::vector<double> halfway = weights(50);
  EXPECT_GE(std::count(halfway.begin(), halfway.end(), 0.0), 5) << "targets that are not read";
}

TEST(DemoShots, TeapotsStandAtTheirFiveDepths) {
  const Scene scene = demo("teapots.toml");
  ASSERT_EQ(scene.objects.size(), 5u);
  EXPECT_EQ(scene.meshes.size(), 1u);
  const FrameState state = evaluate(scene.timeline, 0);
  const glm::dmat4 to_clip = projection_matrix(state.camera.projection, 1) * state.camera.world_to_eye;
  const std::vector<double> depths = {1. / 7, 3. / 7, 31. / 49, 11. / 14, 19. / 21};  // NDC, frustum from 3 to 10
  for (std::size_t i = 0; i < 5; ++i) {
    const glm::dvec4 clip = to_clip * state.node_to_world[scene.objects[i].node] * glm::dvec4(0, 0, 0, 1);
    EXPECT_NEAR(clip.z / clip.w, depths[i], 1e-14) << "teapot " << i;
  }
}

}  // namespace
}  // namespace morphcl
