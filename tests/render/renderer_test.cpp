// Both renderers refuse the frame buffers that do not fit a plan, and the plans of another scene, with the same words,
// and draw nothing then.
#include "morphcl/renderer.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"
#include "tests/support/channel_sets.hpp"

namespace morphcl::test {
namespace {

struct Misfit {
  const char* name;
  ChannelSet plan_channels;
  int width, height;
  ChannelSet channels;
  const char* text;
};

// The plan draws 150 x 100 pixels.
const Misfit misfits[] = {
    {"narrower", default_channels, 149, 100, default_channels,
     "the plan draws 150 x 100 pixels of RGBA and Z, but the frame buffer has 149 x 100 pixels of RGBA and Z"},
    {"lower", default_channels, 150, 30, default_channels,
     "the plan draws 150 x 100 pixels of RGBA and Z, but the frame buffer has 150 x 30 pixels of RGBA and Z"},
    {"much smaller", default_channels, 1, 1, default_channels,
     "the plan draws 150 x 100 pixels of RGBA and Z, but the frame buffer has 1 x 1 pixels of RGBA and Z"},
    {"wider", default_channels, 151, 100, default_channels,
     "the plan draws 150 x 100 pixels of RGBA and Z, but the frame buffer has 151 x 100 pixels of RGBA and Z"},
    {"higher", default_channels, 150, 200, default_channels,
     "the plan draws 150 x 100 pixels of RGBA and Z, but the frame buffer has 150 x 200 pixels of RGBA and Z"},
    {"without colour", default_channels, 150, 100, depth_alone,
     "the plan draws 150 x 100 pixels of RGBA and Z, but the frame buffer has 150 x 100 pixels of Z alone"},
    {"without depth", default_channels, 150, 100, color_alone,
     "the plan draws 150 x 100 pixels of RGBA and Z, but the frame buffer has 150 x 100 pixels of RGBA alone"},
    {"without channels",
     default_channels,
     150,
     100,
     {},
     "the plan draws 150 x 100 pixels of RGBA and Z, but the frame buffer has 150 x 100 pixels of no channels"},
    {"colour too many", depth_alone, 150, 100, default_channels,
     "the plan draws 150 x 100 pixels of Z alone, but the frame buffer has 150 x 100 pixels of RGBA and Z"},
    {"depth too many", color_alone, 150, 100, default_channels,
     "the plan draws 150 x 100 pixels of RGBA alone, but the frame buffer has 150 x 100 pixels of RGBA and Z"},
    {"the other channels", depth_alone, 150, 100, color_alone,
     "the plan draws 150 x 100 pixels of Z alone, but the frame buffer has 150 x 100 pixels of RGBA alone"},
};

Scene cube_scene(ChannelSet channels) {
  SceneBuilder builder(150, 100);
  builder.look({3, 2, 6});
  builder.add(make_cube(), Shading::flat);
  Scene scene = builder.scene();
  scene.image.channels = channels;
  return scene;
}

void expect_refusals(Renderer& renderer) {
  for (const Misfit& misfit : misfits) {
    SCOPED_TRACE(renderer.name() + ", " + misfit.name);
    const Scene scene = cube_scene(misfit.plan_channels);
    const Plan plan = plan_frame(scene, 0);
    FrameBuffer frame(misfit.width, misfit.height, misfit.channels);
    std::fill_n(frame.data(), frame.bytes(), std::byte{0x5a});
    try {
      renderer.render(plan, frame);
      ADD_FAILURE() << "was drawn";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_STREQ(error.what(), misfit.text);
    }
    EXPECT_TRUE(
        std::all_of(frame.data(), frame.data() + frame.bytes(), [](std::byte b) { return b == std::byte{0x5a}; }));
  }
}

TEST(Renderer, ReferenceRendererRefusesWhatDoesNotFit) { expect_refusals(*make_reference_renderer()); }

TEST(Renderer, DeviceRendererRefusesWhatDoesNotFit) { expect_refusals(*make_device_renderer(shared_session())); }

// Two triangles, no normals, a point light: as light falls on a plane, without a seam along the diagonal.
TEST(Renderer, AFlatQuadWithoutNormalsIsLitLikeOneWithThem) {
  Mesh quad;
  quad.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  quad.triangles = {{0, 1, 2}, {0, 2, 3}};
  Mesh with_normals = quad;
  with_normals.normals.assign(4, {0, 0, 1});
  const auto draw = [](const Mesh& mesh) {
    SceneBuilder builder(48, 48);
    builder.add(mesh, Shading::smooth, glm::dmat4(1.0), {1, 1, 1, 1});
    const Scene scene = builder.no_lights().look({0.3, 0.2, 3}).point_light({0.4, 0.7, 0.5}, {1, 1, 1}, true).scene();
    const Plan plan = Planner(scene).plan(0);
    auto frame = std::make_unique<FrameBuffer>(plan->width, plan->height, default_channels);
    make_reference_renderer()->render(plan, *frame);
    return frame;
  };
  const auto by_faces = draw(quad), by_normals = draw(with_normals);
  std::size_t covered = 0;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x) {
      // Both are rounded to half once: they may fall on neighbouring values.
      const int a = by_faces->color_row(0, y)[x], b = by_normals->color_row(0, y)[x];
      EXPECT_LE(std::abs(a - b), 1) << x << ", " << y;
      covered += a > 0;
    }
  EXPECT_GT(covered, 500u);
}

TEST(Renderer, EveryChoiceOfChannelsThatFitsIsDrawn) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  for (const ChannelSet channels : choices_of_two) {
    const Scene scene = cube_scene(channels);
    const Plan plan = plan_frame(scene, 0);
    FrameBuffer expected(150, 100, channels), actual(150, 100, channels);
    reference->render(plan, expected);
    device->render(plan, actual);
    EXPECT_TRUE(same_pixels(expected, actual)) << names_of(channels);
    if (actual.has_color()) {
      EXPECT_GT(covered_pixels(actual), 100u);
    }
    if (actual.has_depth()) {
      EXPECT_LT(std::ranges::min(actual.depth_row(50)), 100.0f);
    }
  }
}

void expect_another_planner_is_refused(Renderer& renderer) {
  const Scene cube = cube_scene(default_channels);
  Scene turned = cube;
  turned.timeline.camera.eye = {6, 2, 3};
  const Planner first(cube), second(turned);
  FrameBuffer frame = first.plan(0).make_frame(), other = second.plan(0).make_frame();
  renderer.render(first.plan(0), frame);
  std::fill_n(other.data(), other.bytes(), std::byte{0x5a});
  try {
    renderer.render(second.plan(0), other);
    ADD_FAILURE() << renderer.name() << " has drawn it";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_STREQ(error.what(),
                 "the plan is of another planner than those drawn before it; call forget() before another scene comes");
  }
  EXPECT_TRUE(
      std::all_of(other.data(), other.data() + other.bytes(), [](std::byte b) { return b == std::byte{0x5a}; }));
  renderer.render(first.plan(0), frame);  // nothing has changed for those that fit

  renderer.forget();
  renderer.render(second.plan(0), other);
  FrameBuffer expected = second.plan(0).make_frame();
  make_reference_renderer()->render(second.plan(0), expected);
  EXPECT_TRUE(same_pixels(expected, other)) << renderer.name();
  EXPECT_THROW(renderer.render(first.plan(0), frame), Error) << "the second scene is drawn now";
}

TEST(Renderer, RefusesPlansOfAnotherSceneUntilItForgets) {
  expect_another_planner_is_refused(*make_reference_renderer());
  expect_another_planner_is_refused(*make_device_renderer(shared_session()));
}

TEST(Renderer, APlanThatStandsAloneIsDrawnBetweenOthers) {
  const Scene cube = cube_scene(default_channels);
  Scene turned = cube;
  turned.timeline.camera.eye = {6, 2, 3};
  const Planner planner(cube);
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  FrameBuffer expected = planner.plan(0).make_frame(), actual = planner.plan(0).make_frame();
  for (const Plan& plan : {planner.plan(0), plan_frame(turned, 0), plan_frame(turned, 0), planner.plan(0)}) {
    reference->render(plan, expected);
    device->render(plan, actual);
    EXPECT_TRUE(same_pixels(expected, actual));
  }
}

TEST(Renderer, ADeviceRendererNeedsASession) {
  try {
    make_device_renderer(nullptr);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
  }
}

}  // namespace
}  // namespace morphcl::test
