// The raster stage against exact and high-precision references that share no code with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <random>

#include "host/render/frame/frame_plan.hpp"
#include "host/render/frame/raster_grid.hpp"
#include "host/render/reference/clip_polygon.hpp"
#include "host/render/reference/visibility.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/renderer.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/scene_builder.hpp"

namespace morphcl::test {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_quad;  // 113 bits

std::array<std::uint32_t, 4> bits_of(const reference::ClipPoint& p) {
  return std::bit_cast<std::array<std::uint32_t, 4>>(p);
}

Exact round_half_even(const Exact& v) {
  const Exact low = floor(v), part = v - low;
  if (part < 0.5) return low;
  if (part > 0.5) return low + 1;
  return fmod(low, Exact(2)) == 0 ? low : low + 1;
}

// Viewport row of the catalogue of extreme cases: 16384 pixels wide, every snapped coordinate is the exact one.
TEST(RasterAccuracy, SnappedCoordinatesAreExactAt16384Pixels) {
  const RasterGrid grid(16384, 16384);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<float> unit(-1, 1), exponent(-10, 10);
  int wrong = 0;
  constexpr int tries = 1'000'000;
  for (int i = 0; i < tries; ++i) {
    const float w = std::exp2(exponent(random)), x = unit(random) * w;
    const reference::ScreenVertex v = reference::to_screen({x, -x, 1, w}, grid);
    const Exact ndc = Exact(x) / Exact(w);
    const Exact exact_x = round_half_even(ndc * Exact(grid.scale_x) + Exact(grid.offset_x));
    const Exact exact_y = round_half_even(-ndc * Exact(grid.scale_y) + Exact(grid.offset_y));
    wrong += exact_x != v.x || exact_y != v.y;
  }
  EXPECT_EQ(wrong, 0) << "of " << tries;
}

// The naive form must fail the same demand, or the test above shows nothing.
TEST(RasterAccuracy, NaiveSnappingMissesTheExactCoordinates) {
  const RasterGrid grid(16384, 16384);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<float> unit(-1, 1), exponent(-10, 10);
  int wrong = 0;
  for (int i = 0; i < 10000; ++i) {
    const float w = std::exp2(exponent(random)), x = unit(random) * w;
    const float naive = std::nearbyint(x / w * grid.scale_x + grid.offset_x);
    wrong += round_half_even(Exact(x) / Exact(w) * Exact(grid.scale_x) + Exact(grid.offset_x)) != Exact(naive);
  }
  EXPECT_GT(wrong, 100);
}

// A mesh without gaps over the whole image: every pixel is covered by exactly one of its triangles, whichever way they
// are cut, clipped or not.
TEST(RasterAccuracy, EveryPixelBelongsToExactlyOneTriangleOfAClosedSheet) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> jitter(-0.2f, 0.2f), depth(0.5f, 2.0f);
  for (const float reach : {1.7f, 90.0f}) {  // the second sheet reaches far beyond the guard band
    constexpr int cells = 12;
    Mesh sheet;
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i) {
        const bool inner = i > 0 && j > 0 && i < cells && j < cells;
        const float u = 2.0f * (static_cast<float>(i) + (inner ? jitter(random) : 0)) / cells - 1.0f;
        const float v = 2.0f * (static_cast<float>(j) + (inner ? jitter(random) : 0)) / cells - 1.0f;
        const float z = depth(random);  // the sheet is not flat, but projects to itself from the origin
        sheet.positions.push_back({u * reach * z, v * reach * z, -z});
      }
    for (unsigned j = 0; j < cells; ++j)
      for (unsigned i = 0; i < cells; ++i) {
        const unsigned a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
        sheet.triangles.push_back({a, b, c});
        sheet.triangles.push_back({b, d, c});
      }
    SceneBuilder builder(97, 61);
    builder.add(sheet, Shading::unlit, glm::dmat4(1.0), {1, 1, 1, 1}, true);
    const Scene& scene = builder.look({0, 0, 0}, {0, 0, -1}).project(Perspective{90, 0.1, 100}).scene();
    FramePlan plan = *plan_frame(scene, 0);
    const RasterGrid grid(plan.width, plan.height);
    const auto vertices = reference::project_vertices(plan.draws.at(0), plan, grid);
    std::vector<int> hits(static_cast<std::size_t>(plan.width) * plan.height, 0);
    Mesh one = sheet;
    for (const glm::uvec3& triangle : sheet.triangles) {
      one.triangles = {triangle};
      plan.draws[0].mesh = &one;
      const reference::Visibility visible = reference::find_visible(plan, grid, {vertices});
      for (std::size_t i = 0; i < hits.size(); ++i) hits[i] += visible.samples[i].order != reference::no_order;
    }
    for (std::size_t i = 0; i < hits.size(); ++i)
      ASSERT_EQ(hits[i], 1) << "pixel (" << i % 97 << ", " << i / 97 << "), reach " << reach;
  }
}

TEST(RasterAccuracy, SharedEdgesAreCutToTheSameBits) {
  SceneBuilder builder(1920, 1080);
  builder.add(make_cube(), Shading::unlit);
  const Plan plan = plan_frame(builder.look({0, 0, 5}).scene(), 0);
  const RasterGrid grid(1920, 1080);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(-1, 1);
  const auto point = [&](float sign) {
    reference::Corner corner{
        {30 * unit(random), 30 * unit(random), plan->camera.near, sign * std::abs(unit(random)) + 0.1f}, {0, 0, 0}};
    return corner;
  };
  int cut = 0;
  for (int i = 0; i < 20000; ++i) {
    const reference::Corner a = point(1), b = point(-1), c = point(1), d = point(i % 2 ? 1.0f : -1.0f);
    const auto left = reference::clip_polygon({a, b, c}, *plan, grid),
               right = reference::clip_polygon({b, a, d}, *plan, grid);
    // The near plane's cut of edge ab is in both polygons, unless the guard band took it away.
    const auto on_edge = [&](const reference::Corner& corner) { return corner.clip.w == plan->camera.near_w; };
    for (const reference::Corner& corner : left) {
      if (!(corner.clip.w >= plan->camera.near_w)) ADD_FAILURE() << "w = " << corner.clip.w << " is in front of near";
      if (on_edge(corner)) {
        EXPECT_EQ(corner.clip.z, plan->camera.near_depth * plan->camera.near_w);
      }
    }
    const auto forward = reference::clip_polygon({a, b}, *plan, grid),
               backward = reference::clip_polygon({b, a}, *plan, grid);
    ASSERT_EQ(forward.size(), backward.size());
    if (forward.size() != 2) continue;
    ++cut;
    EXPECT_EQ(bits_of(forward[0].clip), bits_of(backward[1].clip));
    EXPECT_EQ(bits_of(forward[1].clip), bits_of(backward[0].clip));
    const auto holds = [](const std::vector<reference::Corner>& polygon, const reference::ClipPoint& p) {
      return std::any_of(polygon.begin(), polygon.end(),
                         [&](const reference::Corner& corner) { return bits_of(corner.clip) == bits_of(p); });
    };
    EXPECT_TRUE(holds(left, forward[1].clip) && holds(right, forward[1].clip)) << "edge " << i;
  }
  EXPECT_GT(cut, 1000);
}

// Distance of a plane seen at a slant, from 0.2 to 1000: against the exact intersection of each pixel's ray.
//
// Bound, relative: a vertex is rounded to a corner unit, which moves the plane; that part is exact geometry and is
// taken out by intersecting the plane through the rounded vertices. What is left is fp32: depth = near / w is rounded
// at the vertices (1/w, product), interpolated with 2 fma and an inverse area (4 roundings) from the farthest vertex,
// stepped inside a tile (2 fma) and inverted: 12 roundings of terms that do not exceed twice the depth: 24 u.
TEST(RasterAccuracy, DistanceOfASlantedPlane) {
  constexpr int width = 640, height = 360;
  Mesh plane;
  plane.positions = {{-50, 0, 1}, {50, 0, 1}, {0, 0, -1000}};
  plane.triangles = {{0, 1, 2}};
  SceneBuilder builder(width, height);
  builder.add(plane, Shading::unlit, glm::dmat4(1.0), {1, 1, 1, 1}, true);
  const Scene& scene = builder.look({0, 1, 5}, {0, 0.8, 0}).project(Perspective{40, 0.1, 5000}).scene();
  const Plan plan = plan_frame(scene, 0);
  const RasterGrid grid(width, height);
  const auto vertices = reference::project_vertices(plan->draws.at(0), *plan, grid);
  FrameBuffer frame(width, height, {Channel::color, Channel::depth});
  make_reference_renderer()->render(plan, frame);
  // Depth is affine on the screen: solve it exactly through the three vertices.
  Exact x[3], y[3], depth[3];
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(vertices[i].outcode, 0);
    x[i] = Exact(vertices[i].screen.corner_x()) / layout::corner_units;
    y[i] = Exact(vertices[i].screen.corner_y()) / layout::corner_units;
    depth[i] = Exact(plan->camera.near) / Exact(vertices[i].clip.w);
  }
  const Exact area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  const double bound = 24 * std::ldexp(1.0, -24);
  double worst = 0;
  int covered = 0;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const float actual = frame.depth_row(row)[column];
      if (actual == background_depth) continue;
      ++covered;
      const Exact px = pixel_centre(column), py = pixel_centre(row);
      const Exact w1 = ((px - x[0]) * (y[2] - y[0]) - (py - y[0]) * (x[2] - x[0])) / area;
      const Exact w2 = ((py - y[0]) * (x[1] - x[0]) - (px - x[0]) * (y[1] - y[0])) / area;
      const Exact exact =
          Exact(plan->camera.near) / (depth[0] + w1 * (depth[1] - depth[0]) + w2 * (depth[2] - depth[0]));
      const double error = std::abs(static_cast<double>((Exact(actual) - exact) / exact));
      worst = std::max(worst, error);
      ASSERT_LE(error, bound) << "pixel (" << column << ", " << row << "): expected " << static_cast<double>(exact)
                              << ", got " << actual;
    }
  EXPECT_GT(covered, width * height / 10);
  RecordProperty("worst_relative_error", std::to_string(worst));
}

}  // namespace
}  // namespace morphcl::test
