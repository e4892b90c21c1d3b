// Several samples a pixel: the patterns against the specifications of Direct3D 11 and Vulkan, coverage against counts
// in whole numbers, sums of coverage, what the centre decides, and the device's bits against the reference's.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/sample_pattern.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/sample_pictures.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"
#include "tests/render/test_scenes.hpp"
#include "tests/support/random.hpp"

namespace morphcl::test {
namespace {

constexpr std::array<int, 4> several = {2, 4, 8, 16};

// D3D11_STANDARD_MULTISAMPLE_QUALITY_LEVELS: 1/16 pixel from the centre, y down. (Vulkan's standard sample locations
// are the same, from the upper left in pixels.)
using Offset = std::pair<int, int>;
std::vector<Offset> standard_pattern(int samples) {
  switch (samples) {
    case 1:
      return {{0, 0}};
    case 2:
      return {{4, 4}, {-4, -4}};
    case 4:
      return {{-2, -6}, {6, -2}, {-6, 2}, {2, 6}};
    case 8:
      return {{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}};
    default:
      return {{1, 1},  {-1, -3}, {-3, 2},  {4, -1}, {-5, -2}, {2, 5},  {5, 3}, {3, -5},
              {-2, 6}, {0, -7},  {-4, -6}, {-6, 4}, {-8, 0},  {7, -4}, {6, 7}, {-7, -8}};
  }
}

TEST(SamplePattern, IsTheStandardOne) {
  for (const int samples : sample_counts) {
    const auto pattern = sample_pattern(samples);
    const std::vector<Offset> standard = standard_pattern(samples);
    ASSERT_EQ(pattern.size(), standard.size());
    for (std::size_t i = 0; i < standard.size(); ++i) EXPECT_EQ(Offset(pattern[i].x, pattern[i].y), standard[i]) << i;
  }
}

TEST(SamplePattern, LiesAroundTheCentreButThatOf16) {
  for (const int samples : sample_counts) {
    int x = 0, y = 0;
    for (const SampleOffset& sample : sample_pattern(samples)) {
      x += sample.x;
      y += sample.y;
    }
    // Of 16 the mean is half of 1/16 pixel to the left and above.
    EXPECT_EQ(x, samples == 16 ? -8 : 0);
    EXPECT_EQ(y, samples == 16 ? -8 : 0);
  }
}

TEST(SampleParity, EveryTestScene) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer(2);
  for (const TestScene& test : test_scenes(150, 85)) {
    SCOPED_TRACE(test.name);
    for (const int samples : several) {
      SCOPED_TRACE(samples);
      const Scene scene = with_samples(test.scene, samples);
      EXPECT_TRUE(same_pixels(drawn(*reference, scene, test.frames.back()), drawn(*device, scene, test.frames.back())));
    }
  }
}

TEST(SampleParity, EveryDepthBuffer) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer(2);
  for (const DepthFormat format : depth_formats)
    for (const Shading shading : {Shading::smooth, Shading::wireframe}) {
      SCOPED_TRACE(name_of(format));
      Scene soup = with_samples(triangle_soup(31, 400, 100, 70), 4);
      soup.image.depth_format = format;
      for (Object& object : soup.objects) object.material.shading = shading;
      EXPECT_TRUE(same_pixels(drawn(*reference, soup), drawn(*device, soup)));
    }
}

TEST(SampleParity, ChannelsBackgroundAndSizes) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  for (const auto& [width, height] : {std::pair{1, 1}, {17, 3}, {64, 64}, {65, 129}, {130, 2}})
    for (const bool depth : {false, true})
      for (const bool background : {false, true}) {
        Scene soup = with_samples(triangle_soup(5, 1000, width, height), 4);
        soup.image.channels.set(Channel::depth, depth);
        if (background) soup.image.background = Background{{0.1, 0.3, 0.9}, {0.7, 0.6, 0.5}};
        EXPECT_TRUE(same_pixels(drawn(*reference, soup), drawn(*device, soup))) << width << "x" << height;
      }
}

// Blank blocks stay from frame to frame; colour and distance find theirs in passes of their own.
TEST(SampleParity, InABufferThatHeldOtherPictures) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  SceneBuilder b(200, 150);
  b.add(make_cube(), Shading::flat, place({-1.5, 0, 0}, 0.4));
  const Scene left = b.look({0, 0, 6}).scene();
  Scene right = left;
  right.timeline.nodes[0].static_transform = place({1.5, 0, 0}, 0.4);
  Scene lines = left;
  lines.objects[0].material.shading = Shading::wireframe;
  lines.objects[0].material.line_width = 9;
  FrameBuffer buffer(200, 150, {Channel::color, Channel::depth});
  for (const auto& [scene, samples] : {std::pair{&left, 4},
                                       {&left, 4},
                                       {&right, 4},
                                       {&right, 1},
                                       {&left, 1},
                                       {&left, 8},
                                       {&lines, 4},
                                       {&lines, 4},
                                       {&right, 2},
                                       {&right, 2},
                                       {&left, 1}}) {
    const Scene drawn_scene = with_samples(*scene, samples);
    device->forget();
    device->render(plan_frame(drawn_scene, 0), buffer);
    EXPECT_TRUE(same_pixels(drawn(*reference, drawn_scene), buffer)) << samples;
    EXPECT_TRUE(buffer.blank(1, 2));
  }
}

TEST(SampleParity, PoolsGrowInBothPasses) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer(2);
  const Scene soup = with_samples(triangle_soup(10, 30000, 200, 150), 4);
  EXPECT_TRUE(same_pixels(drawn(*reference, soup), drawn(*device, soup)));
}

// What lies on both sides of an edge on whole 1/256 pixels: samples are counted here, by the fill rule.
TEST(SampleCoverage, IsTheNumberOfSamplesInside) {
  const auto reference = make_reference_renderer();
  constexpr int size = 3;
  test_support::Random random(77);
  for (const int samples : several)
    for (int i = 0; i < 300; ++i) {
      // A triangle over the middle pixel with corners on 1/16 pixel, so that samples lie on edges as well.
      glm::ivec2 c[3];
      for (glm::ivec2& corner : c) corner = glm::ivec2(random_point(random, {0, 0}, {3 * 16, 3 * 16}));
      const auto cross = [](glm::ivec2 u, glm::ivec2 v) { return u.x * v.y - u.y * v.x; };
      if (cross(c[1] - c[0], c[2] - c[0]) == 0) continue;
      if (cross(c[1] - c[0], c[2] - c[0]) < 0) std::swap(c[1], c[2]);  // clockwise on the screen, y down
      SceneBuilder b = flat_picture(size, size);
      std::vector<glm::dvec2> corners;
      for (const int k : {0, 2, 1}) corners.emplace_back(c[k].x / 16.0, c[k].y / 16.0);
      b.add(polygon(corners, size, size), Shading::unlit, place({0, 0, 0}), {1, 1, 1, 1});
      b.scene().image.samples = samples;
      const FrameBuffer frame = drawn(*reference, b.scene());
      for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
          int inside = 0;
          for (const auto& [sx, sy] : standard_pattern(samples)) {
            const glm::ivec2 p(x * 16 + 8 + sx, y * 16 + 8 + sy);
            bool in = true;
            for (int e = 0; e < 3; ++e) {
              const glm::ivec2 d = c[(e + 1) % 3] - c[e];
              const int side = cross(d, p - c[e]);
              in = in && (side > 0 || (side == 0 && (d.y < 0 || (d.y == 0 && d.x > 0))));
            }
            inside += in;
          }
          EXPECT_EQ(alpha(frame, x, y), static_cast<double>(inside) / samples) << samples << " at " << x << ", " << y;
        }
    }
}

// A partition of the picture: what its parts cover adds up to 1 exactly, and together they leave no gap.
TEST(SampleCoverage, OfPartsOfThePictureAddsUpToOne) {
  constexpr int width = 40, height = 30, cells = 6;
  test_support::Random random(78);
  std::vector<glm::dvec2> points;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const bool inner = i > 0 && i < cells && j > 0 && j < cells;
      const double dx = inner ? random.in(-0.4, 0.4) : 0, dy = inner ? random.in(-0.4, 0.4) : 0;
      points.emplace_back((i + dx) / cells * (width + 4) - 2, (j + dy) / cells * (height + 4) - 2);
    }
  SceneBuilder all = flat_picture(width, height);
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int at = j * (cells + 1) + i;
      const std::vector<glm::dvec2> corners = {points[at], points[at + cells + 1], points[at + cells + 2],
                                               points[at + 1]};
      all.add(polygon(corners, width, height), Shading::unlit, place({0, 0, 0}), {1, 1, 1, 1}, true);
    }
  const auto reference = make_reference_renderer();
  for (const int samples : sample_counts) {
    const Scene scene = with_samples(all.scene(), samples);
    std::vector<double> sums(width * height, 0.0);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      Scene alone = scene;
      alone.objects = {scene.objects[i]};
      const FrameBuffer frame = drawn(*reference, alone);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) sums[y * width + x] += alpha(frame, x, y);
    }
    const FrameBuffer together = drawn(*reference, scene);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        EXPECT_EQ(sums[y * width + x], 1.0) << samples;
        for (int c = 0; c < 4; ++c) EXPECT_EQ(from_half(together.color_row(c, y)[x]), 1.0) << samples;
      }
  }
}

// Colour and alpha are the mean over the samples: shares of two surfaces and the background.
TEST(SampleResolve, IsTheMeanOfWhatTheSamplesShow) {
  constexpr int size = 4;
  const auto reference = make_reference_renderer();
  for (const int samples : several)
    for (const bool background : {false, true}) {
      SceneBuilder b = flat_picture(size, size);
      // Upright edges at 1/16 pixel: red to the left of `red`, green from there to the left of `green`.
      const double red = 1 + 5 / 16.0, green = 1 + 12 / 16.0;
      b.add(polygon({{0, 0}, {0, 4}, {red, 4}, {red, 0}}, size, size), Shading::unlit, place({0, 0, 0}), {1, 0, 0, 1});
      b.add(polygon({{red, 0}, {red, 4}, {green, 4}, {green, 0}}, size, size), Shading::unlit, place({0, 0, 0}),
            {0, 0.5, 0, 1});
      if (background) b.scene().image.background = Background{{0, 0, 0.25}, {0, 0, 0.25}};
      b.scene().image.samples = samples;
      const FrameBuffer frame = drawn(*reference, b.scene());
      int of_red = 0, of_green = 0;
      for (const auto& [sx, sy] : standard_pattern(samples)) {
        of_red += 16 + 8 + sx < 16 * red;
        of_green += 16 + 8 + sx >= 16 * red && 16 + 8 + sx < 16 * green;
      }
      const double all = samples, empty = samples - of_red - of_green;
      const double expected[4] = {of_red / all, 0.5 * of_green / all, background ? 0.25 * empty / all : 0,
                                  background ? 1 : 1 - empty / all};
      for (int c = 0; c < 4; ++c) EXPECT_EQ(from_half(frame.color_row(c, 2)[1]), expected[c]) << samples << " " << c;
    }
}

// Three strips whose first samples are 2, 0 and 1 of four. In red the two that come first are so dark that either is
// lost beside the third, and both together are not; in green the first is bright, and either of the others is lost. The
// bright one lies half way between two halves, so what is left of the dark ones decides which it becomes.
TEST(SampleResolve, AddsInTheOrderOfTheFirstSamples) {
  constexpr int size = 4;
  constexpr double tie = 1 + 0x1p-11, in_red = 0.75 * 0x1p-24, in_green = 0.75 * 0x1p-23;
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  for (const bool smooth_elsewhere : {false, true}) {
    SceneBuilder b = flat_picture(size, size);
    const auto strip = [&b](double left, double right, const glm::dvec4& color) {
      b.add(polygon({{left, 0}, {left, 2}, {right, 2}, {right, 0}}, size, size), Shading::unlit, place({0, 0, 0}),
            color);
    };
    strip(1.0, 1.25, {tie, in_green, 0, 1});
    strip(1.25, 1.75, {0.5 * in_red, tie, 0, 1});
    strip(1.75, 2.0, {in_red, in_green, 0, 1});
    if (smooth_elsewhere) {
      Mesh mesh = polygon({{0, 3}, {1, 4}, {2, 3}}, size, size);
      mesh.normals.assign(3, {0, 0, 1});
      b.add(mesh, Shading::smooth);
    }
    const Scene scene = with_samples(b.scene(), 4);
    const FrameBuffer frame = drawn(*reference, scene);
    EXPECT_EQ(alpha(frame, 1, 1), 1);
    EXPECT_EQ(from_half(frame.color_row(0, 1)[1]), 0.25 + 0x1p-12);
    EXPECT_EQ(from_half(frame.color_row(1, 1)[1]), 0.5);
    EXPECT_TRUE(same_pixels(frame, drawn(*device, scene)));
  }
}

// Where a pixel shows one primitive alone, its colour is that of a single sample; Z is in every pixel.
TEST(SampleResolve, LeavesWholePixelsAndDistancesAsTheyAre) {
  const auto reference = make_reference_renderer(2);
  std::size_t whole = 0, edges = 0;
  for (const bool smooth : {false, true}) {
    SceneBuilder b(160, 120);
    b.add(make_sphere({12, 8}), smooth ? Shading::smooth : Shading::flat, place({-0.7, 0, 0}));
    b.add(make_cube(), smooth ? Shading::smooth : Shading::flat, place({0.9, 0.3, -0.5}, 0.8), {0.2, 0.6, 0.9, 1});
    b.look({1, 1, 4});
    const FrameBuffer one = drawn(*reference, b.scene());
    for (const int samples : several) {
      const FrameBuffer more = drawn(*reference, with_samples(b.scene(), samples));
      for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x) {
          EXPECT_EQ(more.depth_row(y)[x], one.depth_row(y)[x]);
          bool same = true;
          for (int c = 0; c < 4; ++c) same = same && more.color_row(c, y)[x] == one.color_row(c, y)[x];
          ++(same ? whole : edges);
        }
    }
  }
  EXPECT_GT(whole, 20 * edges);  // outlines and the edges of faces alone differ
  EXPECT_GT(edges, 1000u);
}

// Vertex colours from 0 to 1 stay between these, and normals between those of the corners, however thin a triangle is.
TEST(SampleShading, ExtrapolatesNothing) {
  constexpr int width = 64, height = 48;
  const auto reference = make_reference_renderer();
  test_support::Random random(79);
  for (const int samples : several) {
    SceneBuilder b = flat_picture(width, height);
    for (int i = 0; i < 200; ++i) {
      const glm::dvec2 from = random_point(random, {0, 0}, {width, height});
      const glm::dvec2 to = random_point(random, {0, 0}, {width, height});
      const glm::dvec2 aside = random_point(random, {-1, -1}, {1, 1});
      Mesh needle = polygon({from, to, from + aside}, width, height);
      // Steep: between 0.25 and 0.75 over less than a pixel.
      needle.colors = {glm::vec4(0.25f), glm::vec4(0.25f), glm::vec4(0.75f)};
      b.add(needle, Shading::unlit, place({0, 0, 0}), {1, 1, 1, 1}, true);
    }
    const FrameBuffer frame = drawn(*reference, with_samples(b.scene(), samples));
    std::size_t seen = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const double share = alpha(frame, x, y);
        if (share == 0) continue;
        ++seen;
        const double color = from_half(frame.color_row(0, y)[x]) / share;
        EXPECT_GE(color, 0.25 * (1 - 0x1p-10));
        EXPECT_LE(color, 0.75 * (1 + 0x1p-10));
      }
    EXPECT_GT(seen, 1000u);
  }
}

// A needle whose lower edge runs through three samples of a pixel: their mean, rounded to a sub-pixel, lies outside, as
// far from that edge as the needle is high. Of the areas at it, one is the negative of the two others. It is lit from
// its front.
TEST(SampleShading, TurnsNoNormalOfANeedle) {
  constexpr int size = 3;
  constexpr double subpixel = 1.0 / 256;
  SceneBuilder b = flat_picture(size, size);
  b.scene().timeline.ambient = glm::dvec3(0);
  Light light;
  light.vector = {0, 0, 1};
  b.scene().timeline.lights = {light};
  // The samples (-5, -2), (1, 1) and (5, 3) of sixteen lie along (2, 1).
  const glm::dvec2 centre(1.5, 1.5), middle = centre + subpixel * glm::dvec2(16, 16),
                                     along = subpixel * glm::dvec2(2, 1);
  const glm::dvec2 from = middle - 60.0 * along, to = middle + 50.0 * along;
  const glm::dvec2 centroid = centre + subpixel * glm::dvec2(5, 11);  // of (5 1/3, 10 2/3)
  Mesh needle = polygon({from, to, from + to - centroid}, size, size);
  needle.normals.assign(3, {0, 0, 1});
  b.add(needle, Shading::smooth, place({0, 0, 0}), {1, 1, 1, 1}, true);
  const auto reference = make_reference_renderer();
  const FrameBuffer frame = drawn(*reference, with_samples(b.scene(), 16));
  EXPECT_EQ(alpha(frame, 1, 1), 3 / 16.0);
  EXPECT_EQ(from_half(frame.color_row(0, 1)[1]), 3 / 16.0);
  EXPECT_TRUE(same_pixels(frame, drawn(*make_device_renderer(shared_session()), with_samples(b.scene(), 16))));
}

TEST(SamplePlan, IsOfOneSampleWithoutColour) {
  Scene scene = with_samples(triangle_soup(3, 10, 8, 8), 8);
  EXPECT_EQ((*plan_frame(scene, 0)).samples, 8);
  scene.image.channels.erase(Channel::color);
  EXPECT_EQ((*plan_frame(scene, 0)).samples, 1);
}

TEST(SamplePlan, LeavingOutChangesNoPixel) {
  const auto device = make_device_renderer(shared_session());
  for (const TestScene& test : test_scenes(96, 64, 300))
    for (const int samples : {4, 16}) {
      const Scene scene = with_samples(test.scene, samples);
      FrameBuffer pixels[2] = {{96, 64, default_channels}, {96, 64, default_channels}};
      for (const bool leave_out : {true, false}) {
        device->forget();
        device->render(plan_frame(scene, test.frames.back(), {.leave_out = leave_out}), pixels[leave_out]);
      }
      EXPECT_TRUE(same_pixels(pixels[0], pixels[1])) << test.name << " " << samples;
    }
}

}  // namespace
}  // namespace morphcl::test
