// The background: the reference's bits on the device, in whatever buffer, and the colours that were asked for.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"

namespace morphcl::test {
namespace {

constexpr int background_width = 200, background_height = 150;  // tiles that are cut off, and some that nothing reaches
constexpr std::uint16_t half_one = 0x3c00;

Scene scene_before(const std::optional<Background>& background, Shading shading = Shading::smooth) {
  SceneBuilder builder(background_width, background_height);
  builder.look({3, 2, 12});
  builder.add(make_sphere({24, 16}), shading, place({-1, 0, 0}));
  builder.add(make_cube(), shading, place({1.2, 0.4, -1}, 0.8), {0.2, 0.6, 0.9, 1});
  builder.scene().image.background = background;
  return builder.scene();
}

const Background sky{{0.1, 0.3, 0.9}, {0.7, 0.6, 0.5}};

FrameBuffer drawn_alone(Renderer& renderer, const Scene& scene) {
  FrameBuffer frame(background_width, background_height, scene.image.channels);
  renderer.forget();
  renderer.render(plan_frame(scene, 0), frame);
  return frame;
}

TEST(BackgroundPixels, AreTheSameOnTheDevice) {
  const auto device = make_device_renderer(shared_session());
  const auto reference = make_reference_renderer();
  for (const Shading shading : {Shading::flat, Shading::smooth, Shading::unlit, Shading::wireframe})
    for (const bool depth : {true, false}) {
      Scene scene = scene_before(sky, shading);
      scene.image.channels.set(Channel::depth, depth);
      EXPECT_TRUE(same_pixels(drawn_alone(*reference, scene), drawn_alone(*device, scene)))
          << "shading " << static_cast<int>(shading);
    }
}

TEST(BackgroundPixels, AreWhereNothingIsDrawnAndNowhereElse) {
  const auto reference = make_reference_renderer();
  const FrameBuffer with = drawn_alone(*reference, scene_before(sky)),
                    without = drawn_alone(*reference, scene_before(std::nullopt));
  std::size_t behind = 0, before = 0;
  for (int y = 0; y < background_height; ++y)
    for (int x = 0; x < background_width; ++x) {
      const bool is_drawn = without.color_row(3, y)[x] != 0;
      ++(is_drawn ? before : behind);
      EXPECT_EQ(with.color_row(3, y)[x], half_one);
      EXPECT_EQ(with.depth_row(y)[x], without.depth_row(y)[x]);
      for (int c = 0; c < 3; ++c) {
        // Half has 11 bits.
        const double exact = sky.top[c] + (y + 0.5) / background_height * (sky.bottom[c] - sky.top[c]);
        if (is_drawn)
          EXPECT_EQ(with.color_row(c, y)[x], without.color_row(c, y)[x]);
        else
          EXPECT_NEAR(from_half(with.color_row(c, y)[x]), exact, std::ldexp(exact, -11) * 1.001);
      }
    }
  EXPECT_GT(behind, 1000u);
  EXPECT_GT(before, 1000u);
}

TEST(BackgroundPixels, OfOneColourAreItsHalves) {
  const auto reference = make_reference_renderer();
  const Background plain{{0.1, 0, max_background}, {0.1, 0, max_background}};
  const FrameBuffer frame = drawn_alone(*reference, scene_before(plain));
  for (const int y : {0, 77, background_height - 1})
    for (const auto& [channel, bits] : {std::pair(0, 0x2e66), std::pair(1, 0), std::pair(2, 0x7bff)})
      EXPECT_EQ(frame.color_row(channel, y)[0], bits) << "channel " << channel;
}

// Blank blocks are left alone from frame to frame; those of a scene without a background must not be taken for its own,
// nor the other way round.
TEST(BackgroundPixels, InABufferThatHeldOtherPictures) {
  const auto device = make_device_renderer(shared_session());
  const auto reference = make_reference_renderer();
  Scene dim = scene_before(Background{{0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}});
  Scene plain = scene_before(std::nullopt), bright = scene_before(sky);
  FrameBuffer buffer(background_width, background_height, {Channel::color, Channel::depth});
  for (const Scene* scene : {&plain, &plain, &bright, &bright, &dim, &plain, &plain, &bright}) {
    device->forget();
    device->render(plan_frame(*scene, 0), buffer);
    EXPECT_TRUE(same_pixels(drawn_alone(*reference, *scene), buffer));
    EXPECT_EQ(buffer.blank(0, 0), !scene->image.background);
  }
}

TEST(BackgroundPixels, FollowWhatMoves) {
  Scene scene = scene_before(sky);
  const TimeBase& time = scene.timeline.time;
  scene.timeline.nodes[0].translation_track = Track({Interpolation::step,
                                                     3,
                                                     false,
                                                     time.ticks_per_second(),
                                                     {0, time.frame_ticks(1), time.frame_ticks(2)},
                                                     {0, 0, 0, 2, 1, 0, -2, -1, 0}});
  const Planner planner(scene);
  const auto device = make_device_renderer(shared_session());
  const auto reference = make_reference_renderer();
  FrameBuffer expected(background_width, background_height, {Channel::color, Channel::depth}),
      buffer(background_width, background_height, {Channel::color, Channel::depth});
  for (const std::int64_t frame : {0, 1, 2, 2, 0, 1}) {
    reference->render(planner.plan(frame), expected);
    device->render(planner.plan(frame), buffer);
    EXPECT_TRUE(same_pixels(expected, buffer)) << "frame " << frame;
  }
}

TEST(BackgroundPlan, HoldsNoneWithoutColour) {
  Scene scene = scene_before(sky);
  const Plan with = plan_frame(scene, 0);
  EXPECT_TRUE(with->background);
  scene.image.channels.erase(Channel::color);
  const Plan without_color = plan_frame(scene, 0);
  EXPECT_FALSE(without_color->background);
  const Scene plain = scene_before(std::nullopt);
  const Plan without = plan_frame(plain, 0);
  EXPECT_FALSE(without->background);
}

TEST(BackgroundPlan, IsRefusedOutOfRange) {
  for (const double wrong : {-0.1, 65505.0, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    Scene scene = scene_before(sky);
    scene.image.background->bottom.y = wrong;
    EXPECT_THROW(validate(scene), Error) << wrong;
  }
}

}  // namespace
}  // namespace morphcl::test
