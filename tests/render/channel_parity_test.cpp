// The channels beside colour and distance: the device's bits against the reference's, each alone and with others, and
// that none changes another one.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <utility>
#include <vector>

#include "host/render/device/device_renderer.hpp"
#include "host/render/frame/channel_passes.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/channel_scenes.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/shared_session.hpp"

namespace morphcl::test {
namespace {

constexpr ChannelSet all = every_channel;

// Of the test scenes those that are drawn in ways of their own.
std::vector<TestScene> scenes_of_all_ways(int width, int height) {
  const std::set<std::string> names = {"across the near plane",
                                       "mirrored and two-sided",
                                       "faces under point lights",
                                       "lines",
                                       "orthographic",
                                       "oblique",
                                       "without lights",
                                       "soup 7"};
  std::vector<TestScene> scenes = test_scenes(width, height, 600);
  std::erase_if(scenes, [&](const TestScene& scene) { return !names.contains(scene.name); });
  return scenes;
}

// A small picture in which lines are wide, on and behind bodies, and cut by the near plane.
Scene wide_lines(int width, int height) {
  Scene scene;
  for (TestScene& test : test_scenes(width, height, 1))
    if (test.name == "lines") scene = std::move(test.scene);
  for (Object& object : scene.objects) object.material.line_width = 4.5;
  return scene;
}

class ChannelParity : public ::testing::Test {
 protected:
  FrameBuffer by_device(const Scene& scene, std::int64_t frame = 0) const { return drawn(*device_, scene, frame); }
  FrameBuffer by_reference(const Scene& scene, std::int64_t frame = 0) const {
    return drawn(*reference_, scene, frame);
  }
  void expect_same(const Scene& scene, std::int64_t frame = 0) const {
    EXPECT_TRUE(same_pixels(by_reference(scene, frame), by_device(scene, frame)));
  }

  const std::unique_ptr<Renderer> device_ = make_device_renderer(shared_session()),
                                  reference_ = make_reference_renderer(2);
};

TEST_F(ChannelParity, AllTogetherInEveryTestScene) {
  for (const TestScene& test : test_scenes(150, 85, 600)) {
    SCOPED_TRACE(test.name);
    for (const int samples : {1, 4}) {
      SCOPED_TRACE(samples);
      expect_same(with_channels(test.scene, all, samples), test.frames.back());
    }
  }
}

TEST_F(ChannelParity, EachAlone) {
  for (const TestScene& test : scenes_of_all_ways(90, 70)) {
    SCOPED_TRACE(test.name);
    for (const int samples : {1, 4})
      for (const Channel channel : all) {
        SCOPED_TRACE(std::string(name_of(channel)) + ", samples " + std::to_string(samples));
        expect_same(with_channels(test.scene, {channel}, samples));
      }
  }
}

// Whatever else is asked for, each channel has the bits that it has beside all others.
TEST_F(ChannelParity, InPairsAsAllTogether) {
  for (const int samples : {1, 4}) {
    Scene soup = with_channels(triangle_soup(7, 300, 70, 40), all, samples);
    soup.timeline.lights.clear();  // then light alone would need no normals
    const FrameBuffer together = by_reference(soup);
    for (const Channel one : all)
      for (const Channel other : all) {
        if (other < one) continue;
        soup.image.channels = {one, other};
        SCOPED_TRACE(names_of(soup.image.channels) + ", samples " + std::to_string(samples));
        EXPECT_TRUE(same_pixels(together, by_device(soup), soup.image.channels));
        EXPECT_TRUE(same_pixels(together, by_reference(soup), soup.image.channels));
      }
  }
}

TEST_F(ChannelParity, ColorAndDistanceStayAsTheyAre) {
  for (const TestScene& test : scenes_of_all_ways(120, 80)) {
    SCOPED_TRACE(test.name);
    for (const int samples : {1, 4}) {
      const FrameBuffer few = by_device(with_channels(test.scene, default_channels, samples));
      EXPECT_TRUE(same_pixels(few, by_device(with_channels(test.scene, all, samples)), default_channels));
      for (const Channel channel : all - default_channels) {
        const ChannelSet with_one = default_channels | ChannelSet{channel};
        EXPECT_TRUE(same_pixels(few, by_device(with_channels(test.scene, with_one, samples)), default_channels))
            << name_of(channel);
      }
    }
  }
}

TEST_F(ChannelParity, EverySampleCountAndDepthBuffer) {
  for (const int samples : sample_counts)
    for (const DepthFormat format : depth_formats) {
      // All of either with one of the other: kernels are compiled for each pair.
      if (samples != 1 && samples != 4 && format != DepthFormat::reversed_float) continue;
      SCOPED_TRACE(std::string(name_of(format)) + ", samples " + std::to_string(samples));
      for (const unsigned seed : {11u, 22u}) {  // the first one parallel
        Scene soup = with_channels(triangle_soup(seed, 400, 60, 40), all, samples);
        soup.image.depth_format = format;
        expect_same(soup);
        for (Object& object : soup.objects) object.material.shading = Shading::wireframe;
        expect_same(soup);
      }
    }
}

TEST_F(ChannelParity, WideLines) {
  for (const int samples : {1, 4, 16}) expect_same(with_channels(wide_lines(110, 90), all, samples));
}

TEST_F(ChannelParity, SizesThatDoNotFillTiles) {
  for (const auto& [width, height] : {std::pair{1, 1}, {17, 3}, {64, 64}, {65, 129}, {130, 2}})
    for (const int samples : {1, 2, 8}) {
      SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
      expect_same(with_channels(triangle_soup(5, 600, width, height), all, samples));
    }
}

// Vertices relative to a pivot, and in two floats.
TEST_F(ChannelParity, VerticesOfEveryForm) {
  Scene scene = with_channels(pyramid_to_cube(120, 80), all);
  for (const double pixels : {1e-2, 1e-3, 1e-9}) {
    scene.accuracy_pixels = pixels;
    for (const std::int64_t frame : {0, 50, 99}) expect_same(scene, frame);
  }
}

TEST_F(ChannelParity, ElasticObjects) {
  for (const Shading shading : {Shading::smooth, Shading::flat, Shading::wireframe}) {
    SceneBuilder b(120, 80);
    b.add(make_sphere_to_cube({12, 8}), shading, place({0, 0, 0}, 0.8));
    b.look({0.5, 1.5, 4});
    Scene& scene = b.scene();
    const TimeBase& time = scene.timeline.time;
    scene.objects[0].morph.tracks.push_back({0, Track({Interpolation::linear,
                                                       1,
                                                       false,
                                                       time.ticks_per_second(),
                                                       {time.frame_ticks(2), time.frame_ticks(8)},
                                                       {0, 1}})});
    scene.objects[0].morph.elastic = Elastic{};
    scene.image.channels = all;
    const Planner planner(scene);
    const auto device = make_device_renderer(shared_session());
    for (const std::int64_t frame : {0, 5, 6, 7, 7, 30, 12}) {
      const Plan plan = planner.plan(frame);
      FrameBuffer expected = plan.make_frame(), actual = plan.make_frame();
      reference_->forget();
      reference_->render(plan, expected);
      device->render(plan, actual);
      EXPECT_TRUE(same_pixels(expected, actual)) << "frame " << frame;
    }
  }
}

TEST_F(ChannelParity, OfFramesOneAfterTheOther) {
  const Scene scene = with_channels(pyramid_to_cube(130, 90), all, 2);
  const Planner planner(scene);
  const auto device = make_device_renderer(shared_session());
  FrameBuffer actual = planner.plan(0).make_frame();
  for (std::int64_t frame = 0; frame < 12; ++frame) {
    const Plan plan = planner.plan(frame);
    FrameBuffer expected = plan.make_frame();
    reference_->forget();
    reference_->render(plan, expected);
    device->render(plan, actual);
    EXPECT_TRUE(same_pixels(expected, actual)) << "frame " << frame;
  }
}

// Blank blocks stay from frame to frame, in each pass for itself.
TEST_F(ChannelParity, InABufferThatHeldOtherPictures) {
  SceneBuilder b(200, 150);
  b.add(make_cube(), Shading::flat, place({-1.5, 0, 0}, 0.4));
  const Scene left = with_channels(b.look({0, 0, 6}).scene(), all);
  Scene right = left;
  right.timeline.nodes[0].static_transform = place({1.5, 0, 0}, 0.4);
  Scene lines = left;
  lines.objects[0].material.shading = Shading::wireframe;
  lines.objects[0].material.line_width = 9;
  FrameBuffer buffer(200, 150, all);
  for (const auto& [scene, samples] : {std::pair{&left, 4},
                                       {&left, 4},
                                       {&right, 4},
                                       {&right, 1},
                                       {&left, 1},
                                       {&lines, 4},
                                       {&lines, 4},
                                       {&right, 2},
                                       {&left, 1}}) {
    const Scene drawn_scene = with_samples(*scene, samples);
    device_->forget();
    device_->render(plan_frame(drawn_scene, 0), buffer);
    EXPECT_TRUE(same_pixels(by_reference(drawn_scene), buffer)) << samples;
    EXPECT_TRUE(buffer.blank(1, 2));
  }
}

TEST_F(ChannelParity, InManyBands) {
  const auto banded = make_device_renderer(shared_session(), 1);  // a row of tiles each
  for (const int samples : {1, 4}) {
    const Scene soup = with_channels(triangle_soup(9, 2000, 150, 300), all, samples);
    EXPECT_TRUE(same_pixels(by_reference(soup), drawn(*banded, soup)));
  }
}

TEST_F(ChannelParity, PoolsGrowInBothPasses) { expect_same(with_channels(triangle_soup(10, 30000, 200, 150), all, 4)); }

}  // namespace
}  // namespace morphcl::test
