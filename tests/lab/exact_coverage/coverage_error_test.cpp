// What samples miss: known errors, bias apart from spread, and the same for any number of threads.
#include <gtest/gtest.h>

#include "lab/exact_coverage/coverage_error.hpp"
#include "morphcl/error.hpp"
#include "morphcl/planner.hpp"
#include "morphcl/solids.hpp"
#include "tests/render/sample_pictures.hpp"
#include "tests/render/test_scenes.hpp"

namespace morphcl::accuracy {
namespace {

using test::flat_picture;
using test::polygon;
using test::SceneBuilder;

CoverageError error_of(const Scene& scene, std::int64_t frame = 0, int threads = 1) {
  const Scene measured = scene_for_coverage(scene);
  const Plan plan = plan_frame(measured, frame);
  return coverage_error(*plan, {.threads = threads, .progress = {}, .stop = nullptr});
}

// An upright edge a quarter into each pixel of a column: known samples lie to the left of it.
TEST(CoverageError, OfAnUprightEdgeIsThatOfThePattern) {
  SceneBuilder b = flat_picture(8, 4);
  b.add(polygon({{-9, -9}, {3.25, -9}, {3.25, 9}, {-9, 9}}, 8, 4), Shading::unlit, glm::dmat4(1), {1, 1, 1, 1}, true);
  const CoverageError error = error_of(b.scene());
  EXPECT_EQ(error.pixels, 4u * 4);
  // Offsets below -4 / 16: none of one; of two -4 lies on the edge and is not covered; -6 of four; -5 and -7 of eight;
  // -5, -6, -8 and -7 of sixteen, while -4 lies on the edge.
  const double expected[] = {0, 0, 1 / 4.0, 2 / 8.0, 4 / 16.0};
  for (const Surfaces surfaces : {Surfaces::all, Surfaces::objects})
    for (std::size_t i = 0; i < 5; ++i) {
      const CoverageTally& tally = error.tally(surfaces, i);
      const double missed = std::abs(expected[i] - 0.25);
      EXPECT_EQ(tally.edge_pixels(), 4u);
      EXPECT_NEAR(tally.largest(), missed, 0x1p-40) << sample_counts[i];
      EXPECT_NEAR(tally.rms(), missed, 0x1p-40) << sample_counts[i];
      EXPECT_EQ(tally.beyond(), missed > 0 ? 1 : 0);
      EXPECT_NEAR(tally.shift()[0], expected[i] - 0.25, 0x1p-40) << "as if the edge lay so much more to the right";
      EXPECT_NEAR(tally.shift()[1], 0, 0x1p-40);
      EXPECT_NEAR(tally.spread(), 0, 1e-7);
      EXPECT_NEAR(tally.bias(), surfaces == Surfaces::all ? expected[i] - 0.25 : 0, 0x1p-40);
    }
}

// The mean of the sixteen samples lies 1/32 pixel to the upper left, so the picture seems 1/32 pixel to the lower
// right; that of the others is the centre.
TEST(CoverageError, TellsBiasFromSpread) {
  SceneBuilder b = flat_picture(64, 64);
  test_support::Random random(5);
  for (int i = 0; i < 40; ++i) {
    const glm::dvec2 p = test::random_point(random, {2, 2}, {62, 62});
    const glm::dvec2 q = test::random_point(random, {2, 2}, {62, 62});
    const glm::dvec2 r = test::random_point(random, {2, 2}, {62, 62});
    b.add(polygon({p, q, r}, 64, 64), Shading::unlit, test::place({0, 0, 0.1 * i}), {1, 1, 1, 1}, true);
  }
  const CoverageError error = error_of(b.scene());
  double spread_before = 1;
  for (std::size_t i = 0; i < sample_counts.size(); ++i) {
    const CoverageTally& tally = error.tally(Surfaces::objects, i);
    const auto [x, y] = tally.shift();
    const double expected = sample_counts[i] == 16 ? 1 / 32.0 : 0;
    // Four standard deviations of what independent errors of n edges in all directions, half of whose squared
    // derivatives are along x, leave in the mean.
    const double noise = 4 * tally.spread() / std::sqrt(0.5 * static_cast<double>(tally.edge_pixels()));
    EXPECT_NEAR(x, expected, noise) << sample_counts[i];
    EXPECT_NEAR(y, expected, noise) << sample_counts[i];
    EXPECT_LT(noise, sample_counts[i] == 16 ? 1 / 64.0 : 0.1) << "so that 1/32 is seen";
    EXPECT_LE(tally.spread(), tally.rms());
    EXPECT_LT(tally.spread(), 0.8 * spread_before) << sample_counts[i];
    spread_before = tally.spread();
  }
}

TEST(CoverageError, OfWholePixelsIsNothing) {
  SceneBuilder b = flat_picture(8, 8);
  b.add(polygon({{2, 3}, {6, 3}, {6, 7}, {2, 7}}, 8, 8), Shading::unlit, glm::dmat4(1), {1, 1, 1, 1}, true);
  const CoverageError error = error_of(b.scene());
  EXPECT_EQ(error.pixels, 16u);
  for (std::size_t i = 0; i < sample_counts.size(); ++i) {
    EXPECT_EQ(error.tally(Surfaces::all, i).edge_pixels(), 0u);
    EXPECT_EQ(error.tally(Surfaces::triangles, i).edge_pixels(), 4u) << "along the diagonal of the square";
    EXPECT_EQ(error.strays[i], 0u);
  }
}

// Sixteen samples are near the truth wherever there is anything; where they are not, the method or the samples are
// wrong. A sample has 1/16 of the pixel, and an edge passes no more than three or four of them wrongly.
TEST(CoverageError, OfTestScenesIsWhatSixteenSamplesCanMiss) {
  for (const auto& [name, scene, frames] : test::test_scenes(64, 40)) {
    const CoverageError error = error_of(scene, frames.back());
    const CoverageTally& all = error.tally(Surfaces::all, 4);
    EXPECT_LE(all.largest(), 0.3) << name;
    EXPECT_LE(all.rms(), 0.06) << name;
    EXPECT_LE(error.tally(Surfaces::triangles, 4).largest(), 0.5) << name;
    EXPECT_LE(error.strays[4], 64u * 40 * 16 / 200) << name;
    EXPECT_LT(error.error_bound, 1e-5) << name << ": far below the limit of 1/255";
  }
}

TEST(CoverageError, IsTheSameForAnyNumberOfThreads) {
  SceneBuilder b(900, 120);
  b.look({1.1, 1.9, 2.7});
  b.add(make_solid("teapot"), Shading::flat);
  const std::string one = coverage_csv_lines(error_of(b.scene()));
  EXPECT_EQ(one, coverage_csv_lines(error_of(b.scene(), 0, 2)));
  EXPECT_EQ(one, coverage_csv_lines(error_of(b.scene(), 0, 7)));
}

TEST(CoverageError, OfFramesTogetherIsThatOfAllTheirPixels) {
  SceneBuilder b = flat_picture(8, 4);
  b.add(polygon({{-9, -9}, {3.25, -9}, {3.25, 9}, {-9, 9}}, 8, 4), Shading::unlit, glm::dmat4(1), {1, 1, 1, 1}, true);
  CoverageError two = error_of(b.scene());
  const CoverageError one = two;
  two += one;
  EXPECT_EQ(two.pixels, 2 * one.pixels);
  EXPECT_EQ(two.tally(Surfaces::all, 0).edge_pixels(), 2 * one.tally(Surfaces::all, 0).edge_pixels());
  EXPECT_EQ(two.tally(Surfaces::all, 0).rms(), one.tally(Surfaces::all, 0).rms());
  EXPECT_EQ(two.tally(Surfaces::all, 0).bias(), one.tally(Surfaces::all, 0).bias());
}

TEST(CoverageError, OfAnEmptyFrameIsNothing) {
  SceneBuilder b(1, 1);
  b.look({0, 0, 5});
  const CoverageError error = error_of(b.scene());
  EXPECT_EQ(error.pixels, 0u);
  EXPECT_EQ(error.tally(Surfaces::triangles, 0).edge_pixels(), 0u);
  EXPECT_EQ(error.tally(Surfaces::triangles, 0).rms(), 0);
  EXPECT_EQ(error.tally(Surfaces::triangles, 0).spread(), 0);
}

TEST(CoverageError, StopsWhenItIsAskedTo) {
  SceneBuilder b(64, 64);
  b.look({0, 0, 5});
  const Scene scene = scene_for_coverage(b.scene());
  const Plan plan = plan_frame(scene, 0);
  const std::atomic<bool> stop{true};
  try {
    coverage_error(*plan, {.threads = 2, .progress = {}, .stop = &stop});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
}

TEST(CoverageError, TellsHowFarItIs) {
  SceneBuilder b(2000, 200);
  b.look({0, 0, 5});
  const Scene scene = scene_for_coverage(b.scene());
  const Plan plan = plan_frame(scene, 0);
  std::vector<int> told;
  int parts = 0;
  const auto tell = [&](int done, int all) {
    told.push_back(done);
    parts = all;
  };
  coverage_error(*plan, {.threads = 2, .progress = tell, .stop = nullptr});
  EXPECT_GT(parts, 2);
  EXPECT_EQ(told.size(), static_cast<std::size_t>(parts));
  EXPECT_EQ(told.back(), parts);
}

}  // namespace
}  // namespace morphcl::accuracy
