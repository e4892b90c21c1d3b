// Transparent surfaces: blended in depth order in each sample, against exact sums in 113 bits; whatever the order of
// objects; what distances are of; and the device's bits against the reference's.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "host/render/frame/frame_plan.hpp"
#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/channel_scenes.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/sample_pictures.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/render/shared_session.hpp"
#include "tests/render/test_scenes.hpp"
#include "tests/support/random.hpp"

namespace morphcl::test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;  // 113 bits
using test_support::Random;

// A soup whose triangles are objects of their own, so that each has its own alpha.
Scene transparent_soup(unsigned seed, int objects, int width, int height) {
  Random random(seed);
  SceneBuilder b(width, height);
  for (int i = 0; i < objects; ++i) {
    Scene soup = triangle_soup(seed + static_cast<unsigned>(i), 25, width, height);
    const auto shading = static_cast<Shading>(i % 4);
    const int object = b.add(std::move(soup.meshes[0]), shading, glm::dmat4(1),
                             {random.in(0, 1), random.in(0, 1), random.in(0, 1), random.in(0.05, 1)}, i % 3 != 0);
    if (i % 5 == 0) b.scene().objects[static_cast<std::size_t>(object)].material.base_color.a = 1;
    b.scene().timeline.camera = soup.timeline.camera;
  }
  return transparent(b.scene(), seed + 1000);
}

// Alpha in each of the pixel's corners is the same; the quad covers the whole of a flat_picture() at this height.
Mesh pane(int width, int height) {
  return polygon({{0, 0}, {0, 1.0 * height}, {1.0 * width, 1.0 * height}, {1.0 * width, 0}}, width, height);
}

bool blends(const Scene& scene, std::int64_t frame = 0) {
  const Plan plan = plan_frame(scene, frame);
  return plan->blends;
}
std::size_t draw_count(const Scene& scene) {
  const Plan plan = plan_frame(scene, 0);
  return plan->draws.size();
}

TEST(BlendingParity, EveryTestScene) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer(2);
  unsigned seed = 1;
  std::size_t blended = 0;
  for (const TestScene& test : test_scenes(110, 70, 300)) {
    SCOPED_TRACE(test.name);
    for (const int samples : {1, 4}) {
      SCOPED_TRACE(samples);
      const Scene scene = with_samples(transparent(test.scene, seed++), samples);
      blended += blends(scene, test.frames.back());
      EXPECT_TRUE(same_pixels(drawn(*reference, scene, test.frames.back()), drawn(*device, scene, test.frames.back())));
    }
  }
  EXPECT_GT(blended, 20u);
}

TEST(BlendingParity, EverySampleCountAndChannel) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer(2);
  unsigned seed = 50;
  for (const int samples : sample_counts)
    for (const ChannelSet channels : {default_channels, ChannelSet{Channel::color}, ChannelSet{Channel::depth}})
      for (const bool background : {false, true}) {
        Scene soup = with_samples(transparent_soup(seed++, 14, 90, 70), samples);
        soup.image.channels = channels;
        if (background) soup.image.background = Background{{0.1, 0.3, 0.9}, {0.7, 0.6, 0.5}};
        EXPECT_TRUE(same_pixels(drawn(*reference, soup), drawn(*device, soup))) << samples << " " << channels.bits();
      }
}

// Each with another number of samples: a device compiles its kernels for every pair of them.
TEST(BlendingParity, EveryDepthBuffer) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer(2);
  for (std::size_t i = 0; i < depth_formats.size(); ++i)
    for (unsigned seed = 0; seed < 3; ++seed) {
      Scene soup = with_samples(transparent_soup(80 + seed, 14, 90, 70), sample_counts[i]);
      soup.image.depth_format = depth_formats[i];
      soup.image.channels = i == 0 ? default_channels : ChannelSet{Channel::color};
      EXPECT_TRUE(same_pixels(drawn(*reference, soup), drawn(*device, soup))) << name_of(depth_formats[i]);
    }
}

// Other channels beside colour and distance, alone and together with them.
TEST(BlendingParity, EveryChannel) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer(2);
  unsigned seed = 120;
  for (const int samples : {1, 4})
    for (const ChannelSet channels : {every_channel, every_channel - default_channels, ChannelSet{Channel::object_id},
                                      ChannelSet{Channel::coverage}}) {
      Scene soup = with_samples(transparent_soup(seed++, 14, 90, 70), samples);
      soup.image.channels = channels;
      EXPECT_TRUE(same_pixels(drawn(*reference, soup), drawn(*device, soup))) << samples << " " << channels.bits();
    }
}

// More layers than one pass sorts, in large and in small triangles.
TEST(BlendingParity, DeepStacks) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer(2);
  for (const int samples : sample_counts)
    for (const double size : {1.0, 0.06}) {
      Random random(7);
      SceneBuilder b = flat_picture(70, 70);
      for (int i = 0; i < 100; ++i) {
        const double depth = random.in(-4, 3), x = size < 1 ? random.in(-30, 30) / 5 : 0;
        glm::dmat4 placed = place({x, x, depth});
        placed[0][0] = placed[1][1] = size;
        b.add(pane(70, 70), Shading::unlit, placed,
              {random.in(0, 1), random.in(0, 1), random.in(0, 1), random.in(0.01, 0.3)});
      }
      const Scene scene = with_samples(b.scene(), samples);
      EXPECT_TRUE(same_pixels(drawn(*reference, scene), drawn(*device, scene))) << samples << " " << size;
    }
}

TEST(BlendingParity, InABufferThatHeldOtherPictures) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  SceneBuilder b(200, 150);
  b.add(make_cube(), Shading::flat, place({-1.5, 0, 0}, 0.4), {1, 0.5, 0, 0.5});
  const Scene left = b.look({0, 0, 6}).scene();
  Scene right = left, opaque = left;
  right.timeline.nodes[0].static_transform = place({1.5, 0, 0}, 0.4);
  opaque.objects[0].material.base_color.a = 1;
  for (const int samples : {1, 4}) {
    FrameBuffer buffer(200, 150, default_channels);
    for (const Scene* scene : std::vector<const Scene*>{&left, &left, &right, &opaque, &right, &left, &opaque}) {
      const Scene sampled = with_samples(*scene, samples);
      const Plan plan = plan_frame(sampled, 0);
      device->render(plan, buffer);
      EXPECT_TRUE(same_pixels(drawn(*reference, sampled), buffer));
    }
  }
}

// ---- the exact sum --------------------------------------------------------------------------------------------------

struct Surface {
  double depth;  // along the view axis
  glm::vec4 color;
};

// Blends in the order of the list, from the back, in 113 bits.
std::array<Quad, 4> exact_sum(const std::vector<Surface>& back_to_front, const std::array<Quad, 4>& behind) {
  std::array<Quad, 4> sum = behind;
  for (const Surface& surface : back_to_front) {
    const Quad alpha = surface.color.a;
    for (std::size_t c = 0; c < 3; ++c) sum[c] = alpha * surface.color[static_cast<int>(c)] + (1 - alpha) * sum[c];
    sum[3] = alpha + (1 - alpha) * sum[3];
  }
  return sum;
}

// n layers and what lies behind. u = 2^-24. The transmittance T behind k layers has k roundings, each of a fused
// multiply and add whose exact result is T (1 - alpha): it is within k u of its own. So is each share T alpha but for
// one more, and the sum of the shares' colours, all of which are at least 0, has n more. What lies behind is multiplied
// once and added once; the mean over S samples, all alike, adds S terms and divides by a power of two. Alpha is 1 - T:
// u of 1, and n u of T, so of at most 1.
double error_bound(std::size_t layers, int samples) {
  return (2.0 * static_cast<double>(layers) + 4 + samples) * 0x1p-24;
}

// A half is right when it is what some number within the bound rounds to.
void expect_half(std::uint16_t half, const Quad& exact, double relative, double absolute) {
  const Quad slack = exact * relative + absolute;
  EXPECT_GE(from_half(half), from_half(to_half(static_cast<double>(Quad(exact - slack))))) << exact;
  EXPECT_LE(from_half(half), from_half(to_half(static_cast<double>(Quad(exact + slack))))) << exact;
}

void expect_exact_sum(const FrameBuffer& frame, const std::vector<Surface>& back_to_front,
                      const std::array<Quad, 4>& behind, int samples) {
  const std::array<Quad, 4> exact = exact_sum(back_to_front, behind);
  const double bound = error_bound(back_to_front.size(), samples);
  for (int y = 0; y < frame.height(); ++y)
    for (int c = 0; c < 4; ++c)
      expect_half(frame.color_row(c, y)[static_cast<std::size_t>(frame.width() / 2)],
                  exact[static_cast<std::size_t>(c)], c == 3 ? 0 : bound, c == 3 ? bound : 0);
}

Scene stack(const std::vector<Surface>& surfaces, int samples, bool background) {
  constexpr int size = 4;
  SceneBuilder b = flat_picture(size, size);
  for (const Surface& surface : surfaces)
    b.add(pane(size, size), Shading::unlit, place({0, 0, -surface.depth}), glm::dvec4(surface.color));
  if (background) b.scene().image.background = Background{{0.25, 0.5, 1}, {0.25, 0.5, 1}};
  b.scene().image.samples = samples;
  return b.scene();
}

std::array<Quad, 4> behind_of(bool background) {
  if (background) return {0.25, 0.5, 1, 1};
  return {0, 0, 0, 0};
}

TEST(BlendingAccuracy, ThousandRandomStacks) {
  const auto device = make_device_renderer(shared_session());
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const auto count = random.integer_in(1, 40);
    std::vector<Surface> surfaces;
    for (long long k = 0; k < count; ++k) {
      const auto part = [&random] { return static_cast<float>(random.in(0, 1)); };
      const float red = part(), green = part(), blue = part();
      const float root = part();
      const float alpha = random.in(0, 1) < 0.1 ? 1.0f : root * root;
      surfaces.push_back({random.in(-3.5, 3.5), {red, green, blue, alpha}});
    }
    const int samples = sample_counts[static_cast<std::size_t>(i) % sample_counts.size()];
    const bool background = i % 2 == 0;
    const FrameBuffer frame = drawn(*device, stack(surfaces, samples, background));
    std::stable_sort(surfaces.begin(), surfaces.end(),
                     [](const Surface& a, const Surface& b) { return a.depth > b.depth; });
    expect_exact_sum(frame, surfaces, behind_of(background), samples);
  }
}

// Of equal depths what is drawn later lies over what was drawn before.
TEST(BlendingAccuracy, SixtyFourCoplanarLayersInDrawingOrder) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  Random random(4);
  std::vector<Surface> surfaces;
  for (int i = 0; i < 64; ++i)
    surfaces.push_back({0.5, {random.in(0, 1), random.in(0, 1), random.in(0, 1), random.in(0.01, 0.4)}});
  for (const int samples : sample_counts) {
    const Scene scene = stack(surfaces, samples, true);
    expect_exact_sum(drawn(*device, scene), surfaces, behind_of(true), samples);
    EXPECT_TRUE(same_pixels(drawn(*reference, scene), drawn(*device, scene)));
  }
}

// An opaque surface hides what was drawn before it at its depth, and lies under what comes later.
TEST(BlendingAccuracy, OpaqueSurfacesTakePartInTheDrawingOrder) {
  const auto device = make_device_renderer(shared_session()), reference = make_reference_renderer();
  const Surface glass{0, {1, 0, 0, 0.5}}, wall{0, {0, 1, 0, 1}};
  for (const int samples : {1, 4}) {
    const Scene over = stack({wall, glass}, samples, false), under = stack({glass, wall}, samples, false);
    expect_exact_sum(drawn(*device, over), {wall, glass}, behind_of(false), samples);
    expect_exact_sum(drawn(*device, under), {glass, wall}, behind_of(false), samples);
    EXPECT_TRUE(same_pixels(drawn(*reference, over), drawn(*device, over)));
    EXPECT_TRUE(same_pixels(drawn(*reference, under), drawn(*device, under)));
  }
}

TEST(Blending, DoesNotDependOnTheOrderOfObjects) {
  const auto device = make_device_renderer(shared_session());
  for (const int samples : {1, 4, 16}) {
    Random random(11);
    SceneBuilder b(120, 90);
    for (int i = 0; i < 12; ++i)
      b.add(make_sphere({9, 6}), static_cast<Shading>(i % 3),
            place({random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)}, random.in(0.2, 0.7)),
            {random.in(0, 1), random.in(0, 1), random.in(0, 1), random.in(0.1, 1)}, i % 2 == 0);
    b.look({0.3, 0.5, 4});
    const Scene scene = with_samples(b.scene(), samples);
    const FrameBuffer expected = drawn(*device, scene);
    for (int turn = 1; turn < 12; turn += 3) {
      Scene turned = scene;
      std::rotate(turned.objects.begin(), turned.objects.begin() + turn, turned.objects.end());
      EXPECT_TRUE(same_pixels(expected, drawn(*device, turned)));
    }
  }
}

// ---- what is blended ------------------------------------------------------------------------------------------------

TEST(Blending, AlphaOfOneIsOpaqueAndOfZeroIsNothing) {
  Scene scene = stack({{0, {1, 0, 0, 1}}, {1, {0, 1, 0, 0}}}, 1, false);
  EXPECT_FALSE(blends(scene));
  EXPECT_EQ(draw_count(scene), 1u);
  scene.objects[0].material.base_color.a = 0.999;
  EXPECT_TRUE(blends(scene));
  scene.objects[0].material.alpha_mode = AlphaMode::opaque;
  scene.objects[1].material.alpha_mode = AlphaMode::opaque;
  EXPECT_FALSE(blends(scene));
  EXPECT_EQ(draw_count(scene), 2u);
}

TEST(Blending, MasksAreThereOrNot) {
  const auto device = make_device_renderer(shared_session());
  constexpr int size = 16;
  SceneBuilder b = flat_picture(size, size);
  Mesh mesh = pane(size, size);
  mesh.colors = {{1, 1, 1, 0}, {1, 1, 1, 0}, {1, 1, 1, 1}, {1, 1, 1, 1}};  // from left to right
  b.add(mesh, Shading::unlit, glm::dmat4(1), {0.5, 0.25, 1, 1});
  Material& material = b.scene().objects[0].material;
  material.alpha_mode = AlphaMode::mask;
  material.alpha_cutoff = 4.5 / size;  // alpha in the middle of pixel 4
  const FrameBuffer frame = drawn(*device, b.scene());
  for (int x = 0; x < size; ++x) {
    const bool there = x >= 4;
    EXPECT_EQ(alpha(frame, x, 3), there) << x;
    EXPECT_EQ(from_half(frame.color_row(0, 3)[static_cast<std::size_t>(x)]), there ? 0.5 : 0) << x;
    EXPECT_EQ(frame.depth_row(3)[static_cast<std::size_t>(x)], there ? 5.0f : background_depth) << x;
  }
  mesh.colors.clear();
  b.scene().meshes[0] = mesh;
  material.base_color.a = 4.4 / size;
  EXPECT_EQ(draw_count(b.scene()), 0u);
  material.base_color.a = 4.5 / size;
  EXPECT_EQ(draw_count(b.scene()), 1u);
  EXPECT_FALSE(blends(b.scene()));
}

// Distances are those of the nearest surface whose alpha is at least one half.
TEST(Blending, DistancesAreOfSurfacesThatShowHalfAndMore) {
  const auto device = make_device_renderer(shared_session());
  for (const int samples : {1, 4})
    for (const bool color : {true, false}) {
      Scene scene = stack({{2, {0, 0, 1, 1}}, {1, {1, 0, 0, 0.5f}}, {0, {0, 1, 0, 0.4999f}}}, samples, false);
      scene.image.channels.set(Channel::color, color);
      EXPECT_EQ(drawn(*device, scene).depth_row(2)[1], 6.0f);
      scene.objects[1].material.base_color.a = 0.25;
      EXPECT_EQ(drawn(*device, scene).depth_row(2)[1], 7.0f);
      scene.objects[0].material.base_color.a = 0.25;
      EXPECT_EQ(drawn(*device, scene).depth_row(2)[1], background_depth);
    }
}

TEST(Blending, IdsAreOfSurfacesThatShowHalfAndMore) {
  const auto device = make_device_renderer(shared_session());
  for (const int samples : {1, 4}) {
    Scene scene = stack({{2, {0, 0, 1, 1}}, {1, {1, 0, 0, 0.5f}}, {0, {0, 1, 0, 0.4999f}}}, samples, false);
    scene.image.channels = {Channel::color, Channel::object_id, Channel::crypto_object};
    const auto id = [&] { return drawn(*device, scene).uint_row(Channel::object_id, 0, 2)[1]; };
    EXPECT_EQ(id(), 2u);
    const FrameBuffer frame = drawn(*device, scene);
    EXPECT_EQ(frame.float_row(Channel::crypto_object, 1, 2)[1], 1.0f) << "the share of the first rank";
    scene.objects[1].material.base_color.a = 0.25;
    EXPECT_EQ(id(), 1u);
    scene.objects[0].material.base_color.a = 0.25;
    EXPECT_EQ(id(), 0u);
  }
}

// Without a background coverage is what alpha is, but for its rounding to a half.
TEST(Blending, CoverageIsAlpha) {
  const auto device = make_device_renderer(shared_session());
  for (const int samples : sample_counts) {
    Scene soup = with_samples(transparent_soup(33, 14, 90, 70), samples);
    soup.image.channels = {Channel::color, Channel::coverage};
    const FrameBuffer frame = drawn(*device, soup);
    std::size_t shares = 0;
    for (int y = 0; y < frame.height(); ++y)
      for (int x = 0; x < frame.width(); ++x) {
        const float coverage = frame.float_row(Channel::coverage, 0, y)[static_cast<std::size_t>(x)];
        EXPECT_EQ(to_half(coverage), frame.color_row(3, y)[static_cast<std::size_t>(x)]);
        shares += coverage > 0 && coverage < 1;
      }
    EXPECT_GT(shares, 100u);
  }
}

TEST(Blending, AlphaOutsideItsRangeIsRefused) {
  for (const double wrong : {-0.001, 1.001}) {
    const Scene scene = stack({{0, {1, 1, 1, wrong}}}, 1, false);
    try {
      plan_frame(scene, 0);
      FAIL() << wrong;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("alpha"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace morphcl::test
