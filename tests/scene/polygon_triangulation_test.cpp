// Polygons cut into triangles: the triangles cover the polygon once and wind like it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "host/scene/obj/polygon_triangulation.hpp"

namespace morphcl::test {
namespace {

using Triangulation = std::vector<std::array<std::uint32_t, 3>>;

double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

// Cuts a polygon of whole-number corners (so that areas are exact): n - 2 triangles, none wound the other way, of the
// polygon's area in all. For a simple polygon that means that they cover it once.
void expect_cover(const std::vector<glm::ivec2>& outline) {
  std::vector<glm::vec3> corners;
  double expected = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    corners.emplace_back(outline[i].x, outline[i].y, 0);
    expected += area({0, 0}, outline[i], outline[(i + 1) % outline.size()]);
  }
  Triangulation triangles;
  ASSERT_TRUE(triangulate_polygon(corners, triangles));
  EXPECT_EQ(triangles.size(), outline.size() - 2);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const double part = area(outline[a], outline[b], outline[c]);
    EXPECT_GE(part * expected, 0) << "triangle " << a << " " << b << " " << c << " winds the other way";
    sum += part;
  }
  EXPECT_EQ(sum, expected);
}

TEST(PolygonTriangulation, ConvexQuadIsTheFanOfItsFirstCorner) {
  Triangulation triangles;
  ASSERT_TRUE(triangulate_polygon(std::vector<glm::vec3>{{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}, triangles));
  EXPECT_EQ(triangles, (Triangulation{{0, 1, 2}, {0, 2, 3}}));
}

TEST(PolygonTriangulation, ConcaveQuadIsCutThroughItsDent) {
  for (int turn = 0; turn < 4; ++turn) {
    std::vector<glm::ivec2> dart = {{0, 0}, {8, 0}, {2, 2}, {0, 8}};
    std::rotate(dart.begin(), dart.begin() + turn, dart.end());
    expect_cover(dart);
    std::reverse(dart.begin(), dart.end());
    expect_cover(dart);
  }
}

TEST(PolygonTriangulation, CombAndSpiral) {
  std::vector<glm::ivec2> comb = {{0, 0}, {200, 0}};
  for (int tooth = 19; tooth >= 0; --tooth) {
    comb.emplace_back(10 * tooth + 9, 100);
    comb.emplace_back(10 * tooth, 5);
  }
  comb.back() = {0, 100};
  expect_cover(comb);
  expect_cover({{0, 0}, {10, 0}, {10, 10}, {2, 10}, {2, 4}, {6, 4}, {6, 6}, {4, 6}, {4, 8}, {8, 8}, {8, 2}, {0, 2}});
}

TEST(PolygonTriangulation, CollinearCornersAndRepeatedOnes) {
  expect_cover({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {0, 3}});
  expect_cover({{0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 4}});
  // A square with a square hole, reached by a slit.
  expect_cover({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}});
}

TEST(PolygonTriangulation, AnyPlaneAndFarAway) {
  const double s = std::sqrt(0.5);
  for (const glm::dvec3& u : {glm::dvec3{0, 1, 0}, glm::dvec3{-s, 0, s}, glm::dvec3{s, s, 0}}) {
    const glm::dvec3 v = glm::normalize(glm::cross(u, glm::dvec3(0.3, -0.5, 0.8)));
    std::vector<glm::vec3> corners;
    for (const glm::dvec2& p : {glm::dvec2{0, 0}, {8, 0}, {8, 8}, {4, 2}, {0, 8}})
      corners.emplace_back(glm::dvec3(1e4, -2e4, 3e4) + p.x * u + p.y * v);
    Triangulation triangles;
    ASSERT_TRUE(triangulate_polygon(corners, triangles));
    const glm::dvec3 normal = glm::cross(u, v);
    double sum = 0;
    for (const auto& [a, b, c] : triangles) {
      const glm::dvec3 p(corners[a]), q(corners[b]), r(corners[c]);
      const double part = glm::dot(glm::cross(q - p, r - p), normal) / 2;
      EXPECT_GT(part, 0);
      sum += part;
    }
    // Corners are rounded to 2^-10 at 3e4; sides are up to 10 long, and there are five.
    EXPECT_NEAR(sum, 40, 5 * 10 * std::ldexp(1, -10));
  }
}

TEST(PolygonTriangulation, CrossingAndFlatPolygonsEnd) {
  for (const std::vector<glm::vec3>& corners :
       {std::vector<glm::vec3>{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}, std::vector<glm::vec3>(6, {1, 2, 3}),
        std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}}}) {
    Triangulation triangles;
    ASSERT_TRUE(triangulate_polygon(corners, triangles));
    EXPECT_EQ(triangles.size(), corners.size() - 2);
  }
}

std::vector<glm::vec3> star(std::size_t points) {
  std::vector<glm::vec3> corners;
  for (std::size_t i = 0; i < 2 * points; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    corners.emplace_back(glm::dvec3(std::cos(angle), std::sin(angle), 0) * (i % 2 ? 0.5 : 1.0));
  }
  return corners;
}

TEST(PolygonTriangulation, LargeConvexIsAFanAndLargeConcaveIsRefused) {
  std::vector<glm::vec3> circle;
  for (int i = 0; i < 100'000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 100'000;
    circle.emplace_back(1000 * std::cos(angle), 1000 * std::sin(angle), 0);
  }
  Triangulation triangles;
  EXPECT_TRUE(triangulate_polygon(star(max_ear_clipping_corners / 2), triangles));
  EXPECT_EQ(triangles.size(), max_ear_clipping_corners - 2);
  triangles.clear();
  EXPECT_FALSE(triangulate_polygon(star(max_ear_clipping_corners), triangles));
  EXPECT_TRUE(triangles.empty());
  EXPECT_TRUE(triangulate_polygon(std::vector<glm::vec3>(100'000, {0, 0, 0}), triangles));
}

}  // namespace
}  // namespace morphcl::test
