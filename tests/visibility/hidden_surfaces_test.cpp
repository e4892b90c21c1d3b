// Catalogue of extreme cases: hidden surfaces. The oracle is a z-buffer in rational numbers that shares no code with
// what it judges: coverage by counting crossings, depth by the plane through three corners.
#include "host/visibility/hidden_surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <set>

#include "host/error.hpp"
#include "host/visibility/bsp_tree.hpp"

namespace morphcl {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Polygons = std::vector<FlatPolygon>;

bool oracle_covers(const FlatPolygon& polygon, int column, int row) {
  bool inside = false;
  const int x = 2 * column + 1, y = 2 * row + 1;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const glm::ivec3 &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.corners.size()];
    if ((a.y <= y) == (b.y <= y)) continue;
    if (Rational(a.x) + Rational((y - a.y) * (b.x - a.x)) / (b.y - a.y) > x) inside = !inside;
  }
  return inside;
}

// z = a.z + s (b.z - a.z) + t (c.z - a.z) of the first corners that are not in one line.
Rational oracle_depth(const FlatPolygon& polygon, int column, int row) {
  const glm::ivec3& a = polygon.corners[0];
  for (std::size_t i = 1; i + 1 < polygon.corners.size(); ++i) {
    const glm::ivec3 b = polygon.corners[i] - a, c = polygon.corners[i + 1] - a;
    const int area = b.x * c.y - b.y * c.x, x = 2 * column + 1 - a.x, y = 2 * row + 1 - a.y;
    if (area != 0) return a.z + Rational(x * c.y - y * c.x) / area * b.z + Rational(b.x * y - b.y * x) / area * c.z;
  }
  throw std::logic_error("a polygon seen edge-on covers nothing");
}

PolygonPicture z_buffer(const Polygons& polygons, int width, int height) {
  PolygonPicture picture(width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      Rational nearest = 0;
      for (std::size_t i = 0; i < polygons.size(); ++i) {
        if (!oracle_covers(polygons[i], column, row)) continue;
        const Rational depth = oracle_depth(polygons[i], column, row);
        if (picture.at(column, row) >= 0 && depth <= nearest) continue;
        nearest = depth;
        picture.at(column, row) = static_cast<int>(i);
      }
    }
  return picture;
}

// Painted in the order of their mean depths, as if such an order always existed.
PolygonPicture naively_painted(const Polygons& polygons, int width, int height) {
  std::vector<std::size_t> order(polygons.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto mean = [&](std::size_t i) {
    double sum = 0;
    for (const glm::ivec3& corner : polygons[i].corners) sum += corner.z;
    return sum / static_cast<double>(polygons[i].corners.size());
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return mean(a) < mean(b); });
  PolygonPicture picture(width, height);
  for (const std::size_t i : order)
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        if (oracle_covers(polygons[i], column, row)) picture.at(column, row) = static_cast<int>(i);
  return picture;
}

// Four bars, each of which hides a part of the next: larger z is nearer. In half pixels, scaled.
Polygons bars_in_a_circle(int scale) {
  const std::vector<std::vector<glm::ivec3>> bars = {
      {{0, 0, 0}, {10, 0, 10}, {10, 1, 10}, {0, 1, 0}},
      {{9, 0, 0}, {10, 0, 0}, {10, 10, 10}, {9, 10, 10}},
      {{0, 9, 10}, {10, 9, 0}, {10, 10, 0}, {0, 10, 10}},
      {{0, 0, 10}, {1, 0, 10}, {1, 10, 0}, {0, 10, 0}},
  };
  Polygons polygons;
  for (auto bar : bars) {
    for (glm::ivec3& corner : bar) corner *= scale;
    polygons.push_back(make_flat_polygon(bar));
  }
  return polygons;
}

// Triangles that cut each other, touch and coincide, quadrilaterals, some edge-on, some seen from behind.
Polygons random_polygons(unsigned seed, int count, int reach) {
  std::mt19937 random(seed);
  const auto any = [&] { return static_cast<int>(random() % static_cast<unsigned>(reach)) - reach / 8; };
  Polygons polygons;
  while (static_cast<int>(polygons.size()) < count) {
    const glm::ivec3 a(any(), any(), any()), b(any(), any(), any()), c(any(), any(), any());
    std::vector<glm::ivec3> corners = {a, b, c};
    if (random() % 3 == 0) corners = {a, b, b + c - a, c};
    if (random() % 5 == 0)
      for (glm::ivec3& corner : corners) corner.z = 7;
    if (random() % 9 == 0 && !polygons.empty()) corners = polygons.back().corners;
    try {
      polygons.push_back(make_flat_polygon(corners));
    } catch (const Error&) {
      continue;  // of no area, or beyond the range
    }
  }
  return polygons;
}

using Algorithm = PolygonPicture (*)(const Polygons&, int, int);

void expect_the_z_buffers_picture(Algorithm algorithm) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const int width = 40, height = 33;
    const Polygons polygons = random_polygons(seed, 14, seed % 2 == 0 ? 90 : 24);
    const PolygonPicture expected = z_buffer(polygons, width, height), picture = algorithm(polygons, width, height);
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        ASSERT_EQ(picture.at(column, row), expected.at(column, row)) << seed << ": " << column << ", " << row;
  }
  for (const int scale : {2, 3, 8, 40}) {
    const Polygons bars = bars_in_a_circle(scale);
    EXPECT_EQ(algorithm(bars, 5 * scale, 5 * scale).polygon, z_buffer(bars, 5 * scale, 5 * scale).polygon) << scale;
  }
}

TEST(ExtremeCase, PainterOfBarsInACircle) {
  expect_the_z_buffers_picture(painted_picture);
  const Polygons bars = bars_in_a_circle(2);
  const PolygonPicture picture = painted_picture(bars, 10, 10);
  EXPECT_EQ(picture.at(9, 0), 0);
  EXPECT_EQ(picture.at(9, 9), 1);
  EXPECT_EQ(picture.at(0, 9), 2);
  EXPECT_EQ(picture.at(0, 0), 3);
  EXPECT_NE(naively_painted(bars, 10, 10).polygon, picture.polygon) << "the naive form meets the demand";
}

// Whether the polygon's point at the pixel's centre is on all sides that bound the part.
bool oracle_holds(const PolygonPart& part, const FlatPolygon& polygon, int column, int row) {
  const Rational z = oracle_depth(polygon, column, row);
  return std::all_of(part.sides.begin(), part.sides.end(), [&](const PlaneSide& side) {
    const IntegerPlane& plane = side.plane;
    const bool in_front = plane.x * (2 * column + 1) + plane.y * (2 * row + 1) + plane.z * z - plane.d >= 0;
    return in_front == side.front;
  });
}

// No point of a polygon is in two parts or in none, and no order needs more parts than another.
TEST(ExtremeCase, BspSplits) {
  const std::vector<PolygonPart> order = BspTree(bars_in_a_circle(2)).back_to_front({0, 0, 1, 0});
  EXPECT_GT(order.size(), 4u) << "a circle of four bars has no order without a split";
  std::set<int> seen;
  for (const PolygonPart& part : order) seen.insert(part.polygon);
  EXPECT_EQ(seen.size(), 4u);
  const Polygons polygons = random_polygons(3, 10, 90);
  const BspTree tree(polygons);
  const std::vector<PolygonPart> parts = tree.back_to_front({0, 0, 1, 0});
  for (int row = 0; row < 30; ++row)
    for (int column = 0; column < 30; ++column)
      for (std::size_t i = 0; i < polygons.size(); ++i) {
        if (!oracle_covers(polygons[i], column, row)) continue;
        const auto holds = [&](const PolygonPart& part) {
          return part.polygon == static_cast<int>(i) && oracle_holds(part, polygons[i], column, row);
        };
        EXPECT_EQ(std::count_if(parts.begin(), parts.end(), holds), 1) << i << " at " << column << ", " << row;
      }
  EXPECT_EQ(tree.back_to_front({0, 0, 1, 0}).size(), tree.back_to_front({0, 0, -1, 0}).size());
  EXPECT_EQ(tree.back_to_front({5, 7, 400, 1}).size(), tree.back_to_front({0, 0, 1, 0}).size());

  // The naive form: a split corner rounded to integers leaves its plane.
  const glm::ivec3 a(0, 0, 0), b(10, 3, 7);
  const glm::ivec3 middle(glm::round(glm::dvec3(a) + (1.0 / 3.0) * glm::dvec3(b - a)));
  EXPECT_NE(glm::cross(glm::dvec3(b - a), glm::dvec3(middle - a)), glm::dvec3(0)) << "still on the edge";
}

// Windows of the picture's own size, halved in integers: how many pixels are left of them at the end.
int pixels_of_naive_windows(int width, int height) {
  if (width <= 1 && height <= 1) return 1;
  const int left = std::max(width / 2, 1), top = std::max(height / 2, 1);
  return (width > 1 ? 2 : 1) * (height > 1 ? 2 : 1) * pixels_of_naive_windows(left, top);
}

TEST(ExtremeCase, Warnock) {
  expect_the_z_buffers_picture(warnock_picture);
  // 250 pixels halve to 62.5; a slanted polygon in front of another makes windows of all sizes.
  const int width = 250, height = 250;
  const Polygons polygons = {make_flat_polygon({{0, 0, 0}, {512, 0, 0}, {512, 512, 0}, {0, 512, 0}}),
                             make_flat_polygon({{3, 5, 9}, {400, 77, 9}, {100, 444, 9}})};
  const PolygonPicture picture = warnock_picture(polygons, width, height);
  EXPECT_EQ(std::count(picture.polygon.begin(), picture.polygon.end(), -1), 0) << "pixels in no window";
  EXPECT_NE(pixels_of_naive_windows(width, height), width * height) << "the naive form meets the demand";
}

TEST(ExtremeCase, Watkins) {
  expect_the_z_buffers_picture(watkins_picture);
  // The naive form adds the edge's step line by line: over 16384 lines it comes to another pixel than the edge does.
  int wrong = 0;
  for (int run = 1; run <= 20'000; run += 997) {
    const float step = static_cast<float>(run) / 16384.0f * 1.1f;
    float x = 0;
    for (int line = 0; line < 16384; ++line) x += step;
    wrong += static_cast<int>(std::floor(x)) != static_cast<int>(std::floor(16384 * static_cast<double>(step)));
  }
  EXPECT_GT(wrong, 0) << "the naive form meets the demand";
}

TEST(HiddenSurfaces, SheetOfTrianglesLeavesNoPixelOutAndSharesNone) {
  Polygons polygons;
  for (int y = 0; y < 40; y += 10)
    for (int x = 0; x < 40; x += 10) {
      const auto height = [](int u, int v) { return u * v % 37; };
      const glm::ivec3 a(x, y, height(x, y)), b(x + 10, y, height(x + 10, y)), c(x, y + 10, height(x, y + 10)),
          d(x + 10, y + 10, height(x + 10, y + 10));
      polygons.push_back(make_flat_polygon({a, b, c}));
      polygons.push_back(make_flat_polygon({b, d, c}));
    }
  for (int row = 0; row < 20; ++row)
    for (int column = 0; column < 20; ++column)
      EXPECT_EQ(std::count_if(polygons.begin(), polygons.end(),
                              [&](const FlatPolygon& polygon) { return covers(polygon, column, row); }),
                1)
          << column << ", " << row;
}

TEST(FlatPolygon, RefusesWhatIsNoFlatConvexPolygon) {
  EXPECT_THROW(make_flat_polygon({{0, 0, 0}, {1, 0, 0}}), Error);
  EXPECT_THROW(make_flat_polygon({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), Error);
  EXPECT_THROW(make_flat_polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 1}, {0, 4, 0}}), Error);
  EXPECT_THROW(make_flat_polygon({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}), Error);
  EXPECT_THROW(make_flat_polygon({{0, 0, 0}, {513, 0, 0}, {1, 1, 0}}), Error);
  EXPECT_THROW(make_flat_polygon({{0, 10, 0}, {6, -8, 0}, {-9, 3, 0}, {9, 3, 0}, {-6, -8, 0}}), Error);
  EXPECT_NO_THROW(make_flat_polygon({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}}))
      << "a corner in the middle of an edge";
}

}  // namespace
}  // namespace morphcl
