// Painter, BSP tree, Warnock and Watkins against the z-buffer: the same bits in every channel of every pixel; the bound
// of depth that they lean on, against 113 bits; and what splits and what is refused.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/reference/surface_visibility.hpp"
#include "host/visibility/paint.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/channel_scenes.hpp"
#include "tests/render/parity.hpp"
#include "tests/render/sample_pictures.hpp"
#include "tests/render/shared_session.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;  // 113 bits
using test_support::Random;
using visibility::ScreenSurfaces;
using visibility::SurfaceId;

constexpr std::array<VisibilityMethod, 4> other_methods = {VisibilityMethod::painter, VisibilityMethod::bsp,
                                                           VisibilityMethod::warnock, VisibilityMethod::watkins};

Scene with_method(Scene scene, VisibilityMethod method) {
  scene.image.visibility = method;
  return scene;
}

// Whether all methods draw what the z-buffer draws.
void expect_same_pixels(const Scene& scene, std::int64_t frame = 0) {
  const auto renderer = make_reference_renderer(2);
  const FrameBuffer expected = drawn(*renderer, scene, frame);
  for (const VisibilityMethod method : other_methods)
    EXPECT_TRUE(same_pixels(expected, drawn(*renderer, with_method(scene, method), frame))) << name_of(method);
}

// Large triangles that cut each other, seen from both sides, in parallel or in perspective.
Scene cutting_soup(unsigned seed, int triangles, bool parallel, int width = 90, int height = 70) {
  Random random(seed);
  SceneBuilder b = flat_picture(width, height);
  for (int part = 0; part < 4; ++part) {
    Mesh mesh;
    for (int i = 0; i < triangles / 4 * 3; ++i) {
      const double x = random.in(-0.6, 0.6) * width, y = random.in(-0.6, 0.6) * height, z = random.in(-3.5, 3.5);
      mesh.positions.emplace_back(x, y, z);
      if (i % 3 == 2) mesh.triangles.push_back(glm::uvec3(i - 2, i - 1, i));
    }
    b.add(mesh, Shading::unlit, glm::dmat4(1), {random.in(0, 1), random.in(0, 1), random.in(0, 1), 1}, true);
  }
  if (!parallel) {
    b.look({0.3 * width, 0.2 * height, 0.7 * width}, {0, 0, 0});
    b.project(Perspective{.fovy_degrees = 60, .near = 0.5, .far = 1000});
  }
  return b.scene();
}

TEST(VisibilityMethods, SurfacesThatCutEachOther) {
  for (unsigned seed = 0; seed < 6; ++seed)
    for (const bool parallel : {true, false}) {
      SCOPED_TRACE(fmt::format("{} {}", seed, parallel));
      const Scene soup = cutting_soup(seed, 60, parallel);
      expect_same_pixels(soup);
      expect_same_pixels(transparent(soup, seed));
    }
}

TEST(VisibilityMethods, EveryTestScene) {
  unsigned seed = 1;
  for (const TestScene& test : test_scenes(110, 70, 300)) {
    SCOPED_TRACE(test.name);
    for (const std::int64_t frame : test.frames) expect_same_pixels(test.scene, frame);
    expect_same_pixels(transparent(test.scene, seed++), test.frames.back());
  }
}

TEST(VisibilityMethods, EveryDepthBuffer) {
  for (const DepthFormat format : depth_formats)
    for (unsigned seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(fmt::format("{} {}", name_of(format), seed));
      Scene soup = triangle_soup(seed, 300, 150, 90);
      soup.image.depth_format = format;
      expect_same_pixels(soup);
      expect_same_pixels(transparent(soup, seed));
    }
}

TEST(VisibilityMethods, EveryChannel) {
  for (const TestScene& test : test_scenes(60, 50, 100)) {
    SCOPED_TRACE(test.name);
    expect_same_pixels(with_channels(test.scene, every_channel), test.frames.front());
    expect_same_pixels(with_channels(transparent(test.scene, 9), every_channel), test.frames.front());
  }
}

TEST(VisibilityMethods, DemoShots) {
  int shots = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MORPHCL_DEMOS)) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path());
    LoadOptions options;
    options.width = 320;
    options.height = 180;
    Scene scene = load_scene(entry.path().string(), options);
    scene.image.samples = 1;  // more are refused
    const std::vector<std::int64_t> frames = frame_numbers(scene.frames);
    for (const std::int64_t frame : {frames.front(), frames[frames.size() * 3 / 4]}) expect_same_pixels(scene, frame);
    ++shots;
  }
  EXPECT_GE(shots, 10);
}

// Meshes that lie in one plane, or in planes that differ by roundings alone: stored depths decide every pixel.
TEST(VisibilityMethods, SurfacesInOnePlane) {
  for (const double offset : {0.0, 1e-7, -1e-7, 1e-6, 1e-3}) {
    SCOPED_TRACE(offset);
    SceneBuilder b(120, 90);
    b.add(make_grid({7, 7}), Shading::unlit, place({0, 0, 0}), {1, 0, 0, 1}, true);
    b.add(make_grid({5, 5}), Shading::unlit, place({0.13, offset, 0.07}, 0.8), {0, 1, 0, 1}, true);
    b.add(make_grid({5, 5}), Shading::unlit, place({-0.13, 0, -0.07}, 0.9), {0, 0, 1, 0.5}, true);
    b.look({1, 2, 1.4});
    expect_same_pixels(b.scene());
  }
}

// ---- the bound of depth ---------------------------------------------------------------------------------------------

struct Surfaces {
  Scene scene;  // the plan refers to it
  Plan plan;
  RasterGrid grid;
  std::vector<std::vector<reference::Vertex>> vertices;

  explicit Surfaces(Scene of) : scene(std::move(of)), plan(plan_frame(scene, 0)), grid(plan->width, plan->height) {
    for (const Draw& draw : plan->draws) vertices.push_back(reference::project_vertices(draw, *plan, grid));
  }
};

// What a number in a depth buffer stands for, linear on the screen.
Quad level_of(const FramePlan& plan, const reference::Sample& sample) {
  if (!is_forward(plan.depth_format)) return sample.depth;
  if (plan.depth_format == DepthFormat::forward_float) return 1 - Quad(std::bit_cast<float>(0x3f800000u - sample.key));
  return Quad(sample.key) / steps_of(plan.depth_format);
}

TEST(SurfaceDepth, StoredDepthIsWithinItsBound) {
  for (const DepthFormat format : depth_formats) {
    Quad largest_part = 0;
    std::size_t pixels = 0, level = 0;
    for (unsigned seed = 0; seed < 2; ++seed)
      for (const bool thin : {false, true}) {
        Scene scene = triangle_soup(seed, 120, 150, 90);
        if (thin) scene.meshes[0] = needles(250);
        scene.image.depth_format = format;
        const Surfaces of(scene);
        const reference::FrameSurfaces frame(*of.plan, of.grid, of.vertices);
        const ScreenSurfaces& surfaces = frame.surfaces();
        for (SurfaceId id = 0; id < surfaces.count(); ++id) {
          const visibility::Surface& surface = surfaces[id];
          level += surface.depth.dx == 0 && surface.depth.dy == 0;
          for (int y = surface.box.first_y; y <= surface.box.last_y; ++y) {
            const visibility::Span span = visibility::covered_columns(surface, y);
            for (int x = span.first; x < span.end; ++x) {
              if (!surfaces.stored->shows(id, x, y)) continue;
              const Quad stored = level_of(*of.plan, frame.sample(id, x, y));
              const Quad exact = Quad(surface.depth.dx) * x + Quad(surface.depth.dy) * y + surface.depth.at_origin;
              const Quad error = abs(stored - exact);
              ASSERT_LE(error, surface.error) << name_of(format) << " surface " << id << " at " << x << ", " << y;
              ASSERT_GE(stored, surface.min);
              ASSERT_LE(stored, surface.max);
              if (surface.error > 0) largest_part = std::max<Quad>(largest_part, error / surface.error);
              ++pixels;
            }
          }
        }
      }
    std::printf("%s: %zu pixels, at most %.3f of the bound, %zu level planes\n", std::string(name_of(format)).c_str(),
                pixels, static_cast<double>(largest_part), level);
    EXPECT_GT(pixels, 10'000u);
    EXPECT_GT(largest_part, 0.01) << "a bound so wide says nothing";
  }
}

// ---- splits
// ---------------------------------------------------------------------------------------------------------------

// Four bars, each of which hides a part of the next.
Scene bars_in_a_circle() {
  SceneBuilder b = flat_picture(100, 100);
  const std::vector<std::vector<glm::vec3>> bars = {{{0, 0, 0}, {100, 0, 1}, {100, 10, 1}, {0, 10, 0}},
                                                    {{90, 0, 0}, {100, 0, 0}, {100, 100, 1}, {90, 100, 1}},
                                                    {{0, 90, 1}, {100, 90, 0}, {100, 100, 0}, {0, 100, 1}},
                                                    {{0, 0, 1}, {10, 0, 1}, {10, 100, 0}, {0, 100, 0}}};
  for (const auto& bar : bars) {
    Mesh mesh;
    for (const glm::vec3& corner : bar) mesh.positions.emplace_back(corner.x - 50, 50 - corner.y, corner.z);
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    b.add(mesh, Shading::unlit, glm::dmat4(1), {1, 0.5, 0.25, 1}, true);
  }
  return b.scene();
}

TEST(VisibilityMethods, BarsInACircleAreSplit) {
  const Scene scene = bars_in_a_circle();
  expect_same_pixels(scene);
  expect_same_pixels(transparent(scene, 3));
  const Surfaces of(scene);
  const reference::FrameSurfaces frame(*of.plan, of.grid, of.vertices);
  visibility::Pieces pieces(frame.surfaces());
  const visibility::DepthSort sorted = visibility::sort_by_depth(pieces, 1000);
  EXPECT_GT(sorted.counts.circles, 0u);
  EXPECT_GT(sorted.counts.splits, 0u);
  EXPECT_EQ(sorted.counts.cuts, 0u);
  EXPECT_EQ(sorted.back_to_front.size(), frame.surfaces().count() + sorted.counts.splits);
}

// Every pixel of a surface is in one of its pieces and in one alone.
void expect_partition(const visibility::Pieces& pieces, const std::vector<visibility::Piece>& parts) {
  const ScreenSurfaces& surfaces = pieces.surfaces();
  const auto width = static_cast<std::size_t>(surfaces.width);
  std::vector<std::vector<int>> counts(surfaces.count(),
                                       std::vector<int>(width * static_cast<std::size_t>(surfaces.height)));
  for (const visibility::Piece& piece : parts) {
    const visibility::Pieces::Bounds bounds = pieces.bounds_of(piece);
    for (int y = piece.box.first_y; y <= piece.box.last_y; ++y) {
      const visibility::Span span = pieces.columns_of(piece, bounds, y);
      for (int x = span.first; x < span.end; ++x)
        ++counts[piece.surface][static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
    }
  }
  for (SurfaceId id = 0; id < surfaces.count(); ++id)
    for (int y = 0; y < surfaces.height; ++y) {
      const visibility::Span span = visibility::covered_columns(surfaces[id], y);
      const bool in_box = y >= surfaces[id].box.first_y && y <= surfaces[id].box.last_y;
      for (int x = 0; x < surfaces.width; ++x)
        ASSERT_EQ(counts[id][static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)],
                  in_box && x >= span.first && x < span.end)
            << "surface " << id << " at " << x << ", " << y;
    }
}

TEST(VisibilityMethods, PiecesLeaveNoPixelAndDoubleNone) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    const Surfaces of(cutting_soup(seed, 60, seed % 2 == 0));
    const reference::FrameSurfaces frame(*of.plan, of.grid, of.vertices);
    visibility::Pieces sorted(frame.surfaces()), parted(frame.surfaces());
    const visibility::DepthSort order = visibility::sort_by_depth(sorted, 100'000);
    EXPECT_GT(order.counts.splits, 20u);
    expect_partition(sorted, order.back_to_front);
    const visibility::Bsp tree = visibility::build_bsp(parted, 100'000);
    EXPECT_GT(tree.counts.splits, 20u);
    expect_partition(parted, tree.pieces);
    EXPECT_EQ(tree.back_to_front().size(), tree.pieces.size());
  }
}

// ---- refusals
// -------------------------------------------------------------------------------------------------------------

template <class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(VisibilityMethods, TooManyPiecesAreRefusedWithTheirCount) {
  const Surfaces of(cutting_soup(1, 60, true));
  const reference::FrameSurfaces frame(*of.plan, of.grid, of.vertices);
  const std::size_t limit = frame.surfaces().count() + 10;
  visibility::Pieces pieces(frame.surfaces());
  for (const std::string& message : {message_of([&] { visibility::sort_by_depth(pieces, limit); }),
                                     message_of([&] { visibility::build_bsp(pieces, limit); })}) {
    EXPECT_NE(message.find(std::to_string(limit)), std::string::npos) << message;
    EXPECT_NE(message.find("warnock"), std::string::npos) << message;
  }
}

TEST(VisibilityMethods, SeveralSamplesAreRefused) {
  for (const VisibilityMethod method : other_methods) {
    const Scene scene = with_method(with_samples(triangle_soup(1, 3, 20, 20), 4), method);
    const std::string message = message_of([&] { plan_frame(scene, 0); });
    EXPECT_NE(message.find(fmt::format("visibility {} takes one sample a pixel, not 4", name_of(method))),
              std::string::npos)
        << message;
  }
}

TEST(VisibilityMethods, DevicesRefuseWhatTheReferenceDraws) {
  const auto device = make_device_renderer(shared_session());
  const Scene scene = with_method(triangle_soup(1, 3, 20, 20), VisibilityMethod::bsp);
  EXPECT_NE(message_of([&] { drawn(*device, scene); }).find("visibility bsp is the reference renderer's"),
            std::string::npos);
  const auto by_turns = make_auto_renderer({});
  EXPECT_TRUE(same_pixels(drawn(*make_reference_renderer(), scene), drawn(*by_turns, scene)));
  EXPECT_EQ(by_turns->drawn_by(), "reference");
}

TEST(VisibilityMethods, NamesAreKnown) {
  for (const VisibilityMethod method : visibility_methods) EXPECT_EQ(visibility_method_named(name_of(method)), method);
  EXPECT_EQ(visibility_method_named("zbuffer"), std::nullopt);
}

}  // namespace
}  // namespace morphcl::test
