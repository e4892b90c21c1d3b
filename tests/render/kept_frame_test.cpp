// What a renderer keeps from the frame before (vertices, face colours, the blank blocks of the picture) is never seen:
// every frame of a sequence has the bits of the reference's, in whatever order, into whatever buffer.
#include <algorithm>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"

namespace morphcl::test {
namespace {

constexpr int kept_width = 300, kept_height = 200;

Track steps(const Timeline& timeline, int components, const std::vector<double>& values) {
  std::vector<std::int64_t> ticks;
  for (std::size_t frame = 0; frame * components < values.size(); ++frame)
    ticks.push_back(timeline.time.frame_ticks(static_cast<std::int64_t>(frame)));
  return Track({Interpolation::step, components, false, timeline.time.ticks_per_second(), ticks, values});
}

// Something stands still, something moves, something comes and goes (its vertices change their place among the others),
// something morphs, and for two frames nothing at all changes; at the end only the camera and the light move.
Scene lively_scene(Shading shading) {
  SceneBuilder builder(kept_width, kept_height);
  builder.look({3, 2, 6});
  builder.add(make_cube(), shading, place({-1.5, 0, 0}));
  builder.add(make_sphere({24, 16}), shading, place({0.0, 0.0, -1.0}), {0.2, 0.6, 0.9, 1});
  builder.add(make_cube(), shading, place({1.5, 0.5, 0}), {0.9, 0.3, 0.3, 1});
  builder.add(make_pyramid_to_cube(), shading, glm::dmat4(1.0), {0.4, 0.8, 0.2, 1}, true);
  Scene scene = builder.scene();
  Timeline& timeline = scene.timeline;
  timeline.nodes[1].translation_track =
      steps(timeline, 3, {0, 0, 0, 0.5, 0, 0, 1, 0.5, 0, 1, 0.5, 0, 1, 0.5, 0, -1, -2, 0, -1, -2, 0});
  timeline.nodes[2].visible_track = steps(timeline, 1, {1, 0, 1, 1, 1, 0, 0});
  timeline.nodes[3].static_transform = place({0, -1, 1}, 0.01) * place({-100, -100, -65});
  scene.objects[3].morph.tracks.push_back({0, steps(timeline, 1, {0, 0, 0.5, 0.5, 0.5, 1, 1})});
  timeline.camera.eye_track = steps(timeline, 3, {3, 2, 6, 3, 2, 6, 3, 2, 6, 3, 2, 6, 3, 2, 6, 3, 2, 6, -4, 3, 5});
  timeline.lights[0].vector_track =
      steps(timeline, 3, {.4, .7, .9, .4, .7, .9, .4, .7, .9, .4, .7, .9, -.4, .7, .9, -.4, .7, .9, -.4, .7, .9});
  validate(timeline);
  return scene;
}

class KeptFrame : public ::testing::TestWithParam<Shading> {
 protected:
  void SetUp() override { scene_ = lively_scene(GetParam()); }

  void expect_parity(const Planner& planner, std::int64_t frame, FrameBuffer& buffer, bool anything_in_view = true) {
    const Plan plan = planner.plan(frame);
    FrameBuffer expected(kept_width, kept_height, {Channel::color, Channel::depth});
    reference_->render(plan, expected);
    device_->render(plan, buffer);
    EXPECT_TRUE(same_pixels(expected, buffer)) << "frame " << frame;
    EXPECT_EQ(covered_pixels(expected) > 0, anything_in_view) << "frame " << frame;
  }

  Scene scene_;
  std::unique_ptr<Renderer> device_ = make_device_renderer(shared_session());
  std::unique_ptr<Renderer> reference_ = make_reference_renderer();
};

TEST_P(KeptFrame, OneBufferForwardsAndBackwards) {
  const Planner planner(scene_);
  FrameBuffer buffer(kept_width, kept_height, {Channel::color, Channel::depth});
  for (const std::int64_t frame : {0, 1, 2, 3, 4, 5, 6, 5, 4, 3, 2, 1, 0, 6, 0, 3, 3})
    expect_parity(planner, frame, buffer);
}

TEST_P(KeptFrame, TwoBuffersInTurn) {
  const Planner planner(scene_);
  FrameBuffer first(kept_width, kept_height, {Channel::color, Channel::depth}),
      second(kept_width, kept_height, {Channel::color, Channel::depth});
  for (const std::int64_t frame : {0, 6, 1, 5, 5, 2, 4}) {
    expect_parity(planner, frame, first);
    expect_parity(planner, (frame + 1) % 7, second);
  }
}

TEST_P(KeptFrame, WhatOthersWroteIntoTheBufferIsDrawnOver) {
  const Planner planner(scene_);
  FrameBuffer buffer(kept_width, kept_height, {Channel::color, Channel::depth});
  expect_parity(planner, 0, buffer);
  for (int y = 0; y < kept_height; ++y) {
    for (int channel = 0; channel < 4; ++channel)
      std::ranges::fill(buffer.color_row(channel, y), std::uint16_t{0x3c00});
    std::ranges::fill(buffer.depth_row(y), 1.0f);
  }
  EXPECT_FALSE(buffer.blank(0, 0));
  expect_parity(planner, 0, buffer);
}

TEST_P(KeptFrame, AnotherPlannersMeshesAreNotTakenForThese) {
  FrameBuffer buffer(kept_width, kept_height, {Channel::color, Channel::depth});
  {
    const Planner planner(scene_);
    expect_parity(planner, 3, buffer);
  }
  // The same draws over meshes of the same addresses and sizes, with other vertices in them.
  for (Mesh& mesh : scene_.meshes)
    for (glm::vec3& position : mesh.positions) position *= 0.9f;
  const Planner planner(scene_);
  reference_->forget();
  device_->forget();
  expect_parity(planner, 3, buffer);
}

// The list of draws stays, and the renderer leaves its tables as they are but for the targets.
TEST_P(KeptFrame, TargetsComeAndGoWhereNothingElseChanges) {
  SceneBuilder builder(kept_width, kept_height);
  builder.look({3, 2, 6});
  for (int i = 0; i < 3; ++i) {
    builder.add(make_pyramid_to_cube(), GetParam(), place({i - 2.0, -0.5, 0}, 0.01) * place({-100, -100, -65}));
    scene_ = builder.scene();
  }
  Timeline& timeline = scene_.timeline;
  scene_.objects[0].morph.tracks.push_back({0, steps(timeline, 1, {0, 0, 0.5, 1, 1, 0, 0.25})});
  scene_.objects[2].morph.tracks.push_back({0, steps(timeline, 1, {0.5, 1, 0, 1, 1, 0, 0})});
  const Planner planner(scene_);
  FrameBuffer buffer(kept_width, kept_height, {Channel::color, Channel::depth});
  for (const std::int64_t frame : {0, 1, 2, 3, 4, 5, 6, 5, 4, 3, 2, 1, 0, 6, 0, 3, 3})
    expect_parity(planner, frame, buffer);
}

// Colours that change where nothing else does, fade and are gone.
TEST_P(KeptFrame, ColorsChangeOfWhatStandsStill) {
  SceneBuilder builder(kept_width, kept_height);
  builder.look({3, 2, 6});
  for (int i = 0; i < 3; ++i) builder.add(make_cube(), GetParam(), place({1.5 * i - 1.5, 0, 0}));
  scene_ = builder.scene();
  const Timeline& timeline = scene_.timeline;
  scene_.objects[0].material.base_color_track =
      steps(timeline, 3, {1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 0.5, 0, 0});
  scene_.objects[2].material.base_color_track =
      steps(timeline, 4, {1, 0, 0, 1, 1, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 1, 1, 1, 0.25});
  const Planner planner(scene_);
  FrameBuffer buffer(kept_width, kept_height, {Channel::color, Channel::depth});
  for (const std::int64_t frame : {0, 1, 2, 3, 4, 5, 6, 5, 4, 3, 2, 1, 0, 6, 0, 3, 3}) {
    expect_parity(planner, frame, buffer);
    EXPECT_EQ((*planner.plan(frame)).draws.size(), frame == 2 || frame == 3 ? 2u : 3u) << "frame " << frame;
  }
}

// First among the draws, so that the others change their place.
TEST_P(KeptFrame, WhatMovesLeavesAndOnlyStillObjectsRemain) {
  SceneBuilder builder(kept_width, kept_height);
  builder.look({3, 2, 6});
  for (int i = 0; i < 3; ++i) builder.add(make_cube(), GetParam(), place({1.5 * i - 1.5, 0, 0}));
  scene_ = builder.scene();
  Timeline& timeline = scene_.timeline;
  timeline.nodes[0].translation_track = steps(timeline, 3, {0, 0, 0, 0, 0.5, 0, 0, 1, 0, 0, 1, 0, 0, 99, 0, 0, 99, 0});
  timeline.nodes[0].visible_track = steps(timeline, 1, {1, 1, 0, 0, 1, 1, 1});
  const Planner planner(scene_);
  FrameBuffer buffer(kept_width, kept_height, {Channel::color, Channel::depth});
  for (const std::int64_t frame : {0, 1, 2, 3, 1, 4, 5, 0, 2, 0, 5, 5}) expect_parity(planner, frame, buffer);
}

TEST_P(KeptFrame, TheCameraTurnsAwayFromEverythingAndBack) {
  SceneBuilder builder(kept_width, kept_height);
  builder.look({3, 2, 6});
  builder.add(make_pyramid_to_cube(), GetParam(), place({0, 0, 0}, 0.01) * place({-100, -100, -65}));
  scene_ = builder.scene();
  Timeline& timeline = scene_.timeline;
  scene_.objects[0].morph.weights[0] = 0.5;
  timeline.camera.target_track = steps(timeline, 3, {0, 0, 0, 0, 0, 0, 9, 2, 9, 9, 2, 9, 0, 0, 0});
  const Planner planner(scene_);
  FrameBuffer buffer(kept_width, kept_height, {Channel::color, Channel::depth});
  for (const std::int64_t frame : {0, 1, 2, 3, 4, 2, 2, 0})
    expect_parity(planner, frame, buffer, frame != 2 && frame != 3);
}

INSTANTIATE_TEST_SUITE_P(Shadings, KeptFrame, ::testing::Values(Shading::flat, Shading::smooth, Shading::wireframe));

TEST(BlankTiles, AreThoseThatHoldTheBackground) {
  SceneBuilder builder(256, 128);
  builder.add(make_cube(), Shading::flat, place({-1.6, 0, 0}, 0.5));
  FrameBuffer buffer(256, 128, {Channel::color, Channel::depth});
  const auto device = make_device_renderer(shared_session());
  device->render(plan_frame(builder.scene(), 0), buffer);
  const FrameBuffer& drawn = buffer;
  int blank = 0;
  for (int tile_y = 0; tile_y < drawn.tiles_y(); ++tile_y)
    for (int tile_x = 0; tile_x < drawn.tiles_x(); ++tile_x) {
      if (!drawn.blank(tile_x, tile_y)) continue;
      ++blank;
      for (int row = 0; row < 64; ++row)
        for (int column = 0; column < 64; ++column) {
          const int x = tile_x * 64 + column, y = tile_y * 64 + row;
          ASSERT_EQ(drawn.depth_row(y)[x], background_depth) << tile_x << " " << tile_y;
          for (int channel = 0; channel < 4; ++channel) ASSERT_EQ(drawn.color_row(channel, y)[x], 0u) << channel;
        }
    }
  EXPECT_GE(blank, 4);  // the right half at least
  EXPECT_LT(blank, drawn.tiles_x() * drawn.tiles_y());
}

}  // namespace
}  // namespace morphcl::test
