// Areas in one pixel that are known beforehand.
#include <gtest/gtest.h>

#include "tests/lab/exact_coverage/polygons.hpp"

namespace morphcl::accuracy {
namespace {

using testing::Share;
using testing::shares_of;
using testing::triangle;

constexpr int far_off = 1 << 22;

// Everything to the left of the line through (x, 0) and (x + 256 slope, 256), of constant depth.
RasterPolygon left_of(int x, int slope, double depth, std::uint32_t primitive) {
  const int up = 1 << 12;
  return triangle({{{x - up * slope, -256 * up}, {x + up * slope, 256 * up}, {-far_off, 0}}}, {depth, depth, depth},
                  primitive);
}

TEST(PixelCoverage, NothingIsAllNothing) {
  const std::vector<Share> shares = shares_of({});
  EXPECT_EQ(shares[0].area, 1);
}

TEST(PixelCoverage, AHalfPlaneUprightThroughThePixel) {
  for (const int x : {1, 64, 128, 255}) {
    const std::vector<Share> shares = shares_of({left_of(x, 0, 0.5, 0)});
    EXPECT_EQ(shares[0].area, x / 256.0);
    EXPECT_EQ(shares[1].area, 1 - x / 256.0);
    // Moved to the right, it grows by its edge of one pixel.
    EXPECT_EQ(shares[0].with_x, 1);
    EXPECT_EQ(shares[1].with_x, -1);
    EXPECT_EQ(shares[0].with_y, 0);
  }
  EXPECT_EQ(shares_of({left_of(256, 0, 0.5, 0)})[0].area, 1) << "an edge along the pixel's side cuts nothing off";
  EXPECT_EQ(shares_of({left_of(0, 0, 0.5, 0)})[0].area, 0);
}

TEST(PixelCoverage, AHalfPlaneAslantThroughThePixel) {
  // From (64, 0) to (64 + 128, 256), in sub-pixels: a trapezoid of (1/4 + 3/4) / 2.
  double bound = 0;
  const std::vector<Share> shares = shares_of({left_of(64, 128, 0.5, 0)}, 0, 0, 0, &bound);
  EXPECT_NEAR(shares[0].area, 0.5, bound);
  EXPECT_LT(bound, 0x1p-44);
  EXPECT_NEAR(shares[0].with_x, 1, 0x1p-50) << "its height";
  EXPECT_NEAR(shares[0].with_y, -0.5, 0x1p-50) << "less its width, as the surface lies below the edge";
}

TEST(PixelCoverage, ASmallTriangleInsideIsItsOwnArea) {
  const RasterPolygon small = triangle({{{100, 100}, {103, 100}, {100, 107}}}, {0.5, 0.5, 0.5}, 0);
  double bound = 0;
  const std::vector<Share> shares = shares_of({small}, 0, 0, 0, &bound);
  EXPECT_NEAR(shares[0].area, 21 / 2.0 / 65536, bound);
  EXPECT_NEAR(shares[0].with_x, 0, 0) << "moved, it stays as large";
}

TEST(PixelCoverage, ThinSliversHaveTheirExactArea) {
  // A sub-pixel wide at its base and 2^14 pixels long: in pixel (k, 0) its height falls from (1 - k / n) / 256 pixels.
  const int n = 1 << 14;
  const RasterPolygon sliver = triangle({{{0, 100}, {0, 101}, {256 * n, 100}}}, {0.5, 0.5, 0.5}, 0);
  for (const int k : {0, 1, 1000, n - 1}) {
    double bound = 0;
    const double middle = (1 - (k + 0.5) / n) / 256;
    EXPECT_NEAR(shares_of({sliver}, k, 0, 0, &bound)[0].area, middle, bound + 0x1p-53 * middle) << k;
  }
}

TEST(PixelCoverage, TrianglesAtASharedEdgeLeaveNoGap) {
  const SubPixelPoint a{-300, -517}, b{401, 733};
  const RasterPolygon left = triangle({{a, b, {-far_off, 11}}}, {0.5, 0.5, 0.5}, 0);
  const RasterPolygon right = triangle({{a, b, {far_off, -7}}}, {0.25, 0.25, 0.25}, 1);
  double bound = 0;
  const std::vector<Share> shares = shares_of({left, right}, 0, 0, 0, &bound);
  EXPECT_GT(shares[0].area, 0.1);
  EXPECT_GT(shares[1].area, 0.1);
  EXPECT_LE(shares[2].area, bound);
}

TEST(PixelCoverage, ACornerOnAnEdgeLeavesNoGap) {
  // Left of the upright edge one triangle, to its right two that meet at (128, 77) on it.
  const RasterPolygon left = left_of(128, 0, 0.5, 0);
  const RasterPolygon upper = triangle({{{128, -far_off}, {128, 77}, {far_off, 77}}}, {0.5, 0.5, 0.5}, 1);
  const RasterPolygon lower = triangle({{{128, 77}, {128, far_off}, {far_off, 77}}}, {0.5, 0.5, 0.5}, 2);
  double bound = 0;
  const std::vector<Share> shares = shares_of({left, upper, lower}, 0, 0, 0, &bound);
  EXPECT_NEAR(shares[0].area, 0.5, bound);
  EXPECT_NEAR(shares[1].area, 0.5 * 77 / 256, bound + 0x1p-12) << "cut by its third side far away";
  EXPECT_NEAR(shares[0].area + shares[1].area + shares[2].area, 1, 0x1p-12);
}

TEST(PixelCoverage, TheNearerOneHidesTheOther) {
  const RasterPolygon front = left_of(64, 0, 0.75, 0), back = left_of(192, 0, 0.5, 1);
  for (const auto& polygons : {std::vector{front, back}, std::vector{back, front}}) {
    const std::vector<Share> shares = shares_of(polygons);
    EXPECT_EQ(shares[0].area, 0.25);
    EXPECT_EQ(shares[1].area, 0.5);
    EXPECT_EQ(shares[2].area, 0.25);
  }
}

TEST(PixelCoverage, PlanesThatPassThroughEachOtherMeetInALine) {
  // Depth rises from 0 at x = -256 to 1 at x = 512 in the one and falls so in the other: they meet in the middle.
  const auto ramp = [](double at_left, double at_right, std::uint32_t primitive) {
    return triangle({{{-256, -4096}, {-256, 4096}, {512, 0}}}, {at_left, at_left, at_right}, primitive);
  };
  double bound = 0;
  std::vector<Share> shares = shares_of({ramp(0, 1, 0), ramp(1, 0, 1)}, 0, 0, -1, &bound);
  EXPECT_NEAR(shares[0].area, 0.5, bound);
  EXPECT_NEAR(shares[1].area, 0.5, bound);
  // The second one is farther by an eighth of 768 sub-pixels: they meet half as much to the left, at x = 80.
  shares = shares_of({ramp(0, 1, 0), ramp(0.875, -0.125, 1)}, 0, 0, -1, &bound);
  EXPECT_NEAR(shares[0].area, (256 - 80) / 256.0, bound);
}

TEST(PixelCoverage, OfEqualPlanesTheFirstIsSeen) {
  const std::vector<RasterPolygon> same = {left_of(128, 0, 0.5, 0), left_of(192, 0, 0.5, 1)};
  std::vector<Share> shares = shares_of(same);
  EXPECT_EQ(shares[0].area, 0.5);
  EXPECT_EQ(shares[1].area, 0.25);
  // The same tilted plane by other corners: whatever they are, every difference is exactly 0.
  const auto tilted = [](std::array<SubPixelPoint, 3> corners, std::uint32_t primitive) {
    std::array<double, 3> depth;
    for (std::size_t k = 0; k < 3; ++k) depth[k] = (3.0 * corners[k].x - 5.0 * corners[k].y) * 0x1p-20;
    return triangle(corners, depth, primitive);
  };
  const RasterPolygon one = tilted({{{-999, -777}, {4321, 123}, {-55, 6543}}}, 0);
  const RasterPolygon other = tilted({{{-3210, -1234}, {7000, -77}, {33, 9871}}}, 1);
  shares = shares_of({one, other}, 0, 0, -1);
  EXPECT_EQ(shares[0].area, 1);
  EXPECT_EQ(shares[1].area, 0);
}

TEST(PixelCoverage, WhatLiesBeyondTheFarPlaneIsNotSeen) {
  // Depth falls from 1 at x = -256 to -1 at x = 512: 0 at x = 128.
  const RasterPolygon ramp = triangle({{{-256, -4096}, {-256, 4096}, {512, 0}}}, {1, 1, -1}, 0);
  double bound = 0;
  const std::vector<Share> shares = shares_of({ramp}, 0, 0, 0, &bound);
  EXPECT_NEAR(shares[0].area, 0.5, bound);
  EXPECT_NEAR(shares[1].area, 0.5, bound);
  EXPECT_EQ(shares_of({left_of(256, 0, 0, 0)}, 0, 0, 0)[0].area, 1) << "exactly on it is seen";
}

TEST(PixelCoverage, PlanesAtTheFlattestAngleMeetWhereTheyShould) {
  // Depths of neighbouring floats: both planes are 1 but at one corner of each, 2^-24 less, 2^21 sub-pixels away.
  const int reach = 1 << 21;
  const double less = 1 - 0x1p-24;
  const RasterPolygon to_left = triangle({{{-reach, 0}, {reach, -reach}, {reach, reach}}}, {less, 1, 1}, 0);
  const RasterPolygon to_right = triangle({{{reach, 0}, {-reach, -reach}, {-reach, reach}}}, {less, 1, 1}, 1);
  double bound = 0;
  // They meet at x = 0, the left side of pixel 0; and in pixel -1 the other one is in front.
  EXPECT_NEAR(shares_of({to_left, to_right}, 0, 0, 0, &bound)[0].area, 1, bound);
  EXPECT_LT(bound, 0x1p-40);
  const RasterPolygon moved =
      triangle({{{reach + 128, 0}, {-reach + 128, -reach}, {-reach + 128, reach}}}, {less, 1, 1}, 1);
  EXPECT_NEAR(shares_of({to_left, moved}, 0, 0, 0, &bound)[0].area, 0.75, bound) << "they meet at x = 64";
}

TEST(PixelCoverage, GivesUpWhereAPixelTakesTooLong) {
  // n narrow triangles of equal depth, none over another: more than n n / 2 visits.
  std::vector<RasterPolygon> many;
  std::vector<const RasterPolygon*> pointers;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const int x = static_cast<int>(i % 250), y = static_cast<int>(i / 250) * 9;
    many.push_back(triangle({{{x, y}, {x + 1, y}, {x, y + 5}}}, {0.5, 0.5, 0.5}, i));
  }
  for (const RasterPolygon& p : many) pointers.push_back(&p);
  PixelCoverage<double> coverage(0, 500000);
  EXPECT_FALSE(coverage.find(pointers, 0, 0));
  EXPECT_TRUE(coverage.find(std::span(pointers).first(100), 0, 0)) << "the next pixel is found again";
}

}  // namespace
}  // namespace morphcl::accuracy
