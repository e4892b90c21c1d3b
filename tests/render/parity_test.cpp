// The device draws the reference's bits: every test scene, at sizes that do and do not fill whole tiles.
#include "tests/render/parity.hpp"
#include "host/render/frame/frame_plan.hpp"
#include "morphcl/planner.hpp"

#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"
#include "tests/render/test_scenes.hpp"
#include "tests/support/channel_sets.hpp"

namespace morphcl::test {
namespace {

void expect_parity(Renderer& device, Renderer& reference, const Scene& scene, std::int64_t frame,
                   bool may_be_blank = false) {
  const Plan plan = plan_frame(scene, frame);
  FrameBuffer expected(plan->width, plan->height, plan->channels), actual(plan->width, plan->height, plan->channels);
  reference.render(plan, expected);
  device.render(plan, actual);
  EXPECT_TRUE(same_pixels(expected, actual)) << "frame " << frame;
  if (plan->has_color() && !may_be_blank) {
    EXPECT_GT(covered_pixels(expected), 0u);
  }
}

TEST(Parity, EveryTestScene) {
  const auto reference = make_reference_renderer();
  for (const TestScene& test : test_scenes(333, 211)) {
    SCOPED_TRACE(test.name);
    const auto device = make_device_renderer(shared_session());
    for (const std::int64_t frame : test.frames)
      expect_parity(*device, *reference, test.scene, frame, test.name == "nothing" || test.name == "degenerate");
  }
}

TEST(Parity, EveryFrameOfThePyramidThatBecomesACube) {
  const Scene scene = pyramid_to_cube(192, 108);
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  for (std::int64_t frame = 0; frame <= 100; ++frame) expect_parity(*device, *reference, scene, frame);
}

TEST(Parity, SizesThatDoNotFillTiles) {
  const auto reference = make_reference_renderer();
  for (const auto& [width, height] : {std::pair{1, 1}, {17, 3}, {64, 64}, {65, 129}, {300, 2}, {2, 300}}) {
    SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
    const auto device = make_device_renderer(shared_session());
    for (const unsigned seed : {5u, 6u}) {
      SCOPED_TRACE(seed);
      const Scene soup = triangle_soup(seed, 2000, width, height);
      expect_parity(*device, *reference, soup, 0);
    }
  }
}

// Where coverage's grid has what is outside the corners: needles, and sheets seen nearly edge-on, in every form that
// depth has.
TEST(Parity, TrianglesThinnerThanASubPixel) {
  const auto reference = make_reference_renderer();
  for (const DepthFormat format : {DepthFormat::reversed_float, DepthFormat::forward_float, DepthFormat::fixed24})
    for (const double height : {0.003, 0.05, 0.6}) {
      SCOPED_TRACE(std::string(name_of(format)) + ", " + std::to_string(height));
      SceneBuilder b(320, 180);
      b.add(needles(3000), Shading::unlit, glm::dmat4(1.0), {1, 1, 1, 1}, true);
      b.add(make_sphere({64, 32}), Shading::smooth, place({1.5, 0, -1}), {1, 0.5, 0, 1}, true);
      b.add(make_grid({40, 40}), Shading::flat, place({0, -0.2, 0}, 3), {0, 0.5, 1, 1}, true);
      b.add(make_grid({2, 2}), Shading::flat, place({0, -0.4, 0}, 6), {0, 0.5, 0.2, 1}, true);
      Scene scene = b.look({0.3, height, 2.5}).scene();
      scene.image.depth_format = format;
      const auto device = make_device_renderer(shared_session());
      expect_parity(*device, *reference, scene, 0);
      scene.objects[0].material.base_color.a = 0.4;  // the same among layers
      scene.objects[2].material.base_color.a = 0.7;
      expect_parity(*make_device_renderer(shared_session()), *reference, scene, 0);
    }
}

TEST(Parity, ChannelsThatWereNotAskedFor) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  for (const ChannelSet channels : {color_alone, depth_alone}) {
    Scene soup = triangle_soup(8, 500, 100, 80);
    soup.image.channels = channels;
    expect_parity(*device, *reference, soup, 0);
  }
}

// A frame depends on its plan only, not on what the renderer drew before: small pools that grew, other scenes' tables.
TEST(Parity, AFrameDoesNotDependOnTheFramesBefore) {
  const std::vector<TestScene> scenes = test_scenes(160, 90);
  const auto device = make_device_renderer(shared_session());
  std::vector<FrameBuffer> first;
  for (const TestScene& test : scenes) {
    const Plan plan = plan_frame(test.scene, test.frames.back());
    first.emplace_back(plan->width, plan->height, default_channels);
    make_device_renderer(shared_session())->render(plan, first.back());
  }
  for (std::size_t i = scenes.size(); i-- > 0;) {
    SCOPED_TRACE(scenes[i].name);
    FrameBuffer frame(160, 90, {Channel::color, Channel::depth});
    device->render(plan_frame(scenes[i].scene, scenes[i].frames.back()), frame);
    EXPECT_TRUE(same_pixels(first[i], frame));
  }
}

// A mesh at the address of one that is gone, as scenes that come and go may have it.
TEST(Parity, AnotherMeshAtTheSameAddress) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  Scene scene = triangle_soup(20, 300, 90, 70);
  expect_parity(*device, *reference, scene, 0);
  const Mesh* const address = &scene.meshes[0];
  scene.meshes[0] = triangle_soup(21, 300, 90, 70).meshes[0];
  ASSERT_EQ(&scene.meshes[0], address);
  expect_parity(*device, *reference, scene, 0);
}

// More fragments, large triangles and clipped triangles than any first guess has room for.
TEST(Parity, PoolsGrowAndLoseNothing) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  Scene soup = triangle_soup(10, 40000, 200, 150);
  expect_parity(*device, *reference, soup, 0);
}

}  // namespace
}  // namespace morphcl::test
