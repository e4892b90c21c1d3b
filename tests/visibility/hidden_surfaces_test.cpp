// Catalogue of extreme cases: hidden surfaces. The oracle is a z-buffer in rational numbers that shares no code with
// what it judges: coverage by counting crossings, depth by the plane through three corners.
#include "morphcl/hidden_surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <set>

#include "host/visibility/bsp_tree.hpp"
#include "morphcl/error.hpp"

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
    const glm::ivec3 a{any(), any(), any()}, b{any(), any(), any()}, c{any(), any(), any()};
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

// The part in front of the plane, with corners rounded to integers where edges cross it: whether one lies behind it.
bool naive_part_reaches_behind(const FlatPolygon& polygon, const IntegerPlane& plane) {
  const auto side = [&](const glm::ivec3& p) { return plane.x * p.x + plane.y * p.y + plane.z * p.z - plane.d; };
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const glm::ivec3 &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.corners.size()];
    const double at_a = static_cast<double>(side(a)), at_b = static_cast<double>(side(b));
    if (at_a * at_b >= 0) continue;
    if (side(glm::ivec3(glm::round(glm::dvec3(a) + at_a / (at_a - at_b) * glm::dvec3(b - a)))) < 0) return true;
  }
  return false;
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

  int on_both_sides = 0;
  for (const FlatPolygon& polygon : polygons)
    for (const FlatPolygon& by : polygons) on_both_sides += naive_part_reaches_behind(polygon, by.plane);
  EXPECT_GT(on_both_sides, 0) << "the naive form meets the demand";
}

// Windows of the picture's own size, halved in integers, down to a pixel that is looked up.
void look_into_naive_windows(const PolygonPicture& truth, int x, int y, int width, int height, PolygonPicture& out) {
  if (width <= 1 && height <= 1) {
    out.at(x, y) = truth.at(x, y);
    return;
  }
  const int half_width = std::max(width / 2, 1), half_height = std::max(height / 2, 1);
  for (int top = y; top < y + std::min(height, 2); ++top)
    for (int left = x; left < x + std::min(width, 2); ++left)
      look_into_naive_windows(truth, x + (left - x) * half_width, y + (top - y) * half_height, half_width, half_height,
                              out);
}

TEST(ExtremeCase, BspTree) { expect_the_z_buffers_picture(bsp_picture); }

TEST(ExtremeCase, Warnock) {
  expect_the_z_buffers_picture(warnock_picture);
  // 250 pixels halve to 62.5; a slanted polygon in front of another makes windows of all sizes.
  const int width = 250, height = 250;
  const Polygons polygons = {make_flat_polygon({{0, 0, 0}, {512, 0, 0}, {512, 512, 0}, {0, 512, 0}}),
                             make_flat_polygon({{3, 5, 9}, {400, 77, 9}, {100, 444, 9}})};
  const PolygonPicture picture = warnock_picture(polygons, width, height);
  EXPECT_EQ(std::count(picture.polygon.begin(), picture.polygon.end(), -1), 0) << "pixels in no window";
  PolygonPicture naive(width, height);
  look_into_naive_windows(picture, 0, 0, width, height, naive);
  EXPECT_NE(naive.polygon, picture.polygon) << "the naive form meets the demand";
}

// x += dx from line to line and z += dz from pixel to pixel, in fp32.
PolygonPicture naively_scanned(const Polygons& polygons, int width, int height) {
  PolygonPicture picture(width, height);
  std::vector<float> nearest(picture.polygon.size(), -std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const FlatPolygon& polygon = polygons[i];
    if (polygon.plane.z == 0) continue;
    std::vector<std::vector<float>> crossings(static_cast<std::size_t>(height));
    for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
      glm::ivec3 a = polygon.corners[k], b = polygon.corners[(k + 1) % polygon.corners.size()];
      if (a.y > b.y) std::swap(a, b);
      if (a.y == b.y) continue;
      const float slope = static_cast<float>(b.x - a.x) / static_cast<float>(b.y - a.y);
      int row = 0;
      while (2 * row + 1 < a.y) ++row;
      float x = static_cast<float>(a.x) + static_cast<float>(2 * row + 1 - a.y) * slope;
      for (; row < height && 2 * row + 1 < b.y; ++row) {
        crossings[static_cast<std::size_t>(row)].push_back(x);
        x += 2 * slope;
      }
    }
    const auto plane_x = static_cast<float>(polygon.plane.x), plane_y = static_cast<float>(polygon.plane.y),
               plane_z = static_cast<float>(polygon.plane.z), plane_d = static_cast<float>(polygon.plane.d);
    for (int row = 0; row < height; ++row) {
      std::vector<float>& across = crossings[static_cast<std::size_t>(row)];
      if (across.size() < 2) continue;
      std::sort(across.begin(), across.end());
      int column = 0;
      while (static_cast<float>(2 * column + 1) < across.front()) ++column;
      float z = (plane_d - plane_x * static_cast<float>(2 * column + 1) - plane_y * static_cast<float>(2 * row + 1)) /
                plane_z;
      for (; column < width && static_cast<float>(2 * column + 1) < across.back(); ++column) {
        float& held =
            nearest[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
        if (z > held) {
          held = z;
          picture.at(column, row) = static_cast<int>(i);
        }
        z -= 2 * plane_x / plane_z;
      }
    }
  }
  return picture;
}

TEST(ExtremeCase, Watkins) {
  expect_the_z_buffers_picture(watkins_picture);
  int wrong = 0;
  for (unsigned seed = 0; seed < 2; ++seed) {
    const Polygons polygons = random_polygons(seed, 6, 500);
    const PolygonPicture truth = z_buffer(polygons, 200, 200), naive = naively_scanned(polygons, 200, 200);
    int of_picture = 0;
    for (std::size_t i = 0; i < truth.polygon.size(); ++i) of_picture += truth.polygon[i] != naive.polygon[i];
    EXPECT_LT(of_picture, 40'000 / 50) << "the naive form is another algorithm";
    EXPECT_EQ(watkins_picture(polygons, 200, 200).polygon, truth.polygon) << seed;
    wrong += of_picture;
    std::printf("pixels of 40,000 that adding up gets wrong: %d\n", of_picture);
  }
  EXPECT_GT(wrong, 0) << "the naive form meets the demand";
}

// Every pixel's polygon by integers alone.
PolygonPicture exact_picture(const Polygons& polygons, int width, int height) {
  PolygonPicture picture(width, height);
  for (int i = 0; i < static_cast<int>(polygons.size()); ++i)
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        int& held = picture.at(column, row);
        if (covers(polygons[static_cast<std::size_t>(i)], column, row) &&
            is_seen_before(polygons, i, held, column, row))
          held = i;
      }
  return picture;
}

TEST(HiddenSurfaces, RandomScenesOf256Pixels) {
  const bool all = std::getenv("MORPHCL_LONG_TESTS") != nullptr;
  const int scenes = all ? 1000 : 20;
  for (int seed = 0; seed < scenes; ++seed) {
    // From a few polygons over most of the picture to many that are small; some lie in one plane, many cut each other.
    const Polygons polygons =
        random_polygons(1000 + static_cast<unsigned>(seed), 5 + seed % 40, seed % 3 == 0 ? 120 : 512);
    const PolygonPicture expected = exact_picture(polygons, 256, 256);
    for (const Algorithm algorithm : {painted_picture, bsp_picture, warnock_picture, watkins_picture})
      ASSERT_EQ(algorithm(polygons, 256, 256).polygon, expected.polygon) << "scene " << seed;
  }
  std::printf("%d scenes of 256 x 256 pixels by 4 methods: no pixel differs\n", scenes);
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
