// Boxes, spheres and lines: every decision against rationals, on random and on degenerate input.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "morphcl/error.hpp"
#include "morphcl/geometry.hpp"
#include "morphcl/solids.hpp"
#include "tests/support/exact_rational.hpp"

namespace morphcl {
namespace {

using test_support::cases;
using test_support::coordinate;
using test_support::cross;
using test_support::dot;
using test_support::double_infinity;
using test_support::double_nan;
using test_support::families;
using test_support::Family;
using test_support::point2;
using test_support::point3;
using test_support::Random;
using test_support::Rational;
using test_support::rational;
using test_support::sign_of;

Contact by_sign(int sign) { return sign > 0 ? Contact::crossing : sign == 0 ? Contact::touching : Contact::apart; }

TEST(BoxContact, IsThatOfItsIntervals) {
  Random random(3);
  std::array<int, 3> seen{};
  for (const Family family : families)
    for (int i = 0; i < cases(family); ++i) {
      const glm::dvec3 p = point3(random, family), q = point3(random, family);
      const glm::dvec3 r = point3(random, family), s = point3(random, family);
      const Box a = box_of(std::vector{p, q}), b = box_of(std::vector{r, s});
      int sign = 1;  // of the smallest overlap
      for (int k = 0; k < 3; ++k)
        sign = std::min({sign, sign_of(rational(a.upper[k]) - rational(b.lower[k])),
                         sign_of(rational(b.upper[k]) - rational(a.lower[k]))});
      ASSERT_EQ(contact(a, b), by_sign(sign));
      ASSERT_EQ(contact(b, a), by_sign(sign));
      ++seen[static_cast<std::size_t>(contact(a, b))];
      const PointPlace place = place_in_box(a, r);
      int within = 1;
      for (int k = 0; k < 3; ++k)
        within = std::min(
            {within, sign_of(rational(r[k]) - rational(a.lower[k])), sign_of(rational(a.upper[k]) - rational(r[k]))});
      ASSERT_EQ(place, within > 0 ? PointPlace::inside : within < 0 ? PointPlace::outside : PointPlace::boundary);
    }
  for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(BoxContact, OfEmptyFlatAndEndlessBoxes) {
  const Box cube{glm::dvec3(0.0), glm::dvec3(2.0)}, sheet{{1, 0, 0}, {1, 2, 2}}, wall{{2, 0, 0}, {2, 2, 2}};
  const Box all{glm::dvec3(-double_infinity), glm::dvec3(double_infinity)}, unknown{{0, 0, double_nan}, {1, 1, 1}};
  EXPECT_EQ(contact(cube, Box{}), Contact::apart);
  EXPECT_EQ(contact(cube, sheet), Contact::crossing);
  EXPECT_EQ(contact(cube, wall), Contact::touching);
  EXPECT_EQ(contact(sheet, sheet), Contact::touching);
  EXPECT_EQ(contact(cube, all), Contact::crossing);
  EXPECT_EQ(contact(cube, unknown), Contact::apart);
  EXPECT_EQ(place_in_box(Box{}, {0, 0, 0}), PointPlace::outside);
  EXPECT_EQ(place_in_box(cube, {0, 0, double_nan}), PointPlace::outside);
  EXPECT_TRUE(box_of(std::vector<glm::dvec3>{}).empty());
  EXPECT_THROW(box_of(std::vector{glm::dvec3(0, double_nan, 0)}), Error);
}

TEST(MinMaxTest, OfPolygonsAndOfEdges) {
  const std::vector<glm::dvec2> a = {{0, 0}, {4, 0}, {0, 4}}, b = {{3, 3}, {5, 3}, {5, 5}},
                                c = {{4, 1}, {6, 1}, {6, 2}};
  EXPECT_EQ(min_max_test(a, b), Contact::crossing) << "the boxes overlap though the polygons do not";
  EXPECT_EQ(min_max_test(a, c), Contact::touching);
  EXPECT_EQ(min_max_test(std::vector<glm::dvec2>{{0, 0}, {1, 1}}, std::vector<glm::dvec2>{{2, 0}, {3, 1}}),
            Contact::apart);
  EXPECT_EQ(min_max_test(a, {}), Contact::apart);
  EXPECT_THROW(min_max_test(a, std::vector{glm::dvec2(0, double_infinity)}), Error);
  Random random(4);
  for (const Family family : families)
    for (int i = 0; i < cases(family); ++i) {
      std::vector<glm::dvec2> p, q;
      for (int k = 0; k < 3; ++k) p.push_back(point2(random, family));
      for (int k = 0; k < 2; ++k) q.push_back(point2(random, family));
      int sign = 1;
      for (int k = 0; k < 2; ++k) {
        const auto less = [k](const glm::dvec2& v, const glm::dvec2& w) { return v[k] < w[k]; };
        const auto [p_min, p_max] = std::minmax_element(p.begin(), p.end(), less);
        const auto [q_min, q_max] = std::minmax_element(q.begin(), q.end(), less);
        sign = std::min({sign, sign_of(rational((*p_max)[k]) - rational((*q_min)[k])),
                         sign_of(rational((*q_max)[k]) - rational((*p_min)[k]))});
      }
      ASSERT_EQ(min_max_test(p, q), by_sign(sign));
    }
}

TEST(SphereContact, ByDistanceAndRadii) {
  Random random(5);
  std::array<int, 3> seen{}, places{};
  for (const Family family : families)
    for (int i = 0; i < cases(family); ++i) {
      Sphere a{point3(random, family), std::abs(coordinate(random, family))};
      Sphere b{point3(random, family), std::abs(coordinate(random, family))};
      if (i % 4 == 0) {  // along a Pythagorean direction: distance 3 x 2^n or 7 x 2^n
        const double size = std::ldexp(1.0, static_cast<int>(random.integer_in(-400, 400)));
        a = {{0, 0, 0}, size};
        b = {size * (i % 8 == 0 ? glm::dvec3(2, -1, 2) : glm::dvec3(6, 2, -3)), (i % 8 == 0 ? 2 : 6) * size};
        if (i % 3 == 0) b.radius = std::nextafter(b.radius, i % 2 == 0 ? 0 : double_infinity);
      }
      const auto apart = rational(b.center) - rational(a.center);
      const Rational sum = rational(a.radius) + rational(b.radius);
      ASSERT_EQ(contact(a, b), by_sign(sign_of(sum * sum - dot(apart, apart))));
      ASSERT_EQ(contact(b, a), contact(a, b));
      ++seen[static_cast<std::size_t>(contact(a, b))];
      const int side = sign_of(rational(a.radius) * rational(a.radius) - dot(apart, apart));
      const PointPlace place = side > 0 ? PointPlace::inside : side < 0 ? PointPlace::outside : PointPlace::boundary;
      ASSERT_EQ(place_in_sphere(a, b.center), place);
      ++places[static_cast<std::size_t>(place)];
    }
  for (const int count : seen) EXPECT_GT(count, 100);
  for (const int count : places) EXPECT_GT(count, 30);
  EXPECT_THROW(contact(Sphere{{0, 0, 0}, -1}, Sphere{}), Error);
  EXPECT_THROW(contact(Sphere{}, Sphere{{0, 0, 0}, double_nan}), Error);
  EXPECT_THROW(contact(Sphere{}, Sphere{{0, double_nan, 0}, 1}), Error);
  EXPECT_EQ(contact(Sphere{}, Sphere{}), Contact::touching) << "two equal points";
}

// Entry and exit against the roots in 200 digits: t lies between values whose rational squares enclose the root.
TEST(LineSphere, DecisionsAndRoots) {
  Random random(6);
  std::array<int, 3> seen{};
  double max_error = 0;
  for (const Family family : families)
    for (int i = 0; i < cases(family); ++i) {
      const Segment3 line{point3(random, family), point3(random, family)};
      const Sphere sphere{point3(random, family), std::abs(coordinate(random, family))};
      if (line.from == line.to) {
        ASSERT_THROW(intersect_line(line, sphere), Error);
        continue;
      }
      const auto direction = rational(line.to) - rational(line.from),
                 to = rational(sphere.center) - rational(line.from);
      const auto across = cross(direction, to);
      const Rational squared = dot(direction, direction);
      const Rational spare = rational(sphere.radius) * rational(sphere.radius) * squared - dot(across, across);
      const LineSphere result = intersect_line(line, sphere);
      ASSERT_EQ(result.contact, by_sign(sign_of(spare)));
      ++seen[static_cast<std::size_t>(result.contact)];
      if (result.contact == Contact::apart || family == Family::any_size) continue;
      ASSERT_LE(result.enter, result.leave);
      for (const double t : {result.enter, result.leave}) {
        if (std::abs(t) < 1e-290 || result.leave - result.enter <= 1e-12 * std::abs(t)) continue;
        // f(t (1 +- e)) has different signs, or the root is double: f(t) = |from + t d - c|^2 - r^2.
        const auto value = [&](const Rational& at) {
          const auto off = at * direction - to;
          return sign_of(dot(off, off) - rational(sphere.radius) * rational(sphere.radius));
        };
        if (result.contact == Contact::touching) continue;
        double bound = 0x1p-53;
        while (bound < 1e-3 && value(rational(t) * (1 + rational(bound))) == value(rational(t) * (1 - rational(bound))))
          bound *= 2;
        max_error = std::max(max_error, bound);
      }
    }
  EXPECT_LE(max_error, 8 * 0x1p-53);
  RecordProperty("max error in u", std::to_string(max_error * 0x1p53));
  for (const int count : seen) EXPECT_GT(count, 15);
  const LineSphere tangent = intersect_line({{-1, 5, 0}, {1, 5, 0}}, {{0, 2, 4}, 5});
  EXPECT_EQ(tangent.contact, Contact::touching);
  EXPECT_EQ(tangent.enter, 0.5);
  EXPECT_THROW(intersect_line({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, -1}), Error);
}

bool holds(const EnclosingSphere& sphere, const std::vector<glm::dvec3>& points) {
  const Rational squared = rational(sphere.sphere.radius) * rational(sphere.sphere.radius);
  return std::all_of(points.begin(), points.end(), [&](const glm::dvec3& point) {
    const auto off = rational(point) - rational(sphere.sphere.center);
    return dot(off, off) <= squared;
  });
}

TEST(EnclosingSphere, HoldsEveryPointAndIsTheSmallest) {
  Random random(7);
  double max_gap = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<glm::dvec3> points;
    const long long count = random.integer_in(1, 40);
    const double size = std::ldexp(1.0, static_cast<int>(random.integer_in(-900, 900)));
    for (long long k = 0; k < count; ++k) {
      glm::dvec3 point = i % 3 == 0 ? point3(random, Family::whole) : random.vector(1);
      if (i % 4 == 1) point.z = 0.25;                                         // in one plane
      if (i % 4 == 2) point = glm::dvec3(point.x) + 10.0;                     // on one line
      if (i % 4 == 3) point = point / glm::length(point + glm::dvec3(1e-9));  // on a sphere, or nearly
      points.push_back(size * point);
    }
    if (points.size() > 1 && i % 5 == 0) points.push_back(points[0]);
    const EnclosingSphere result = enclosing_sphere(points);
    ASSERT_TRUE(holds(result, points)) << i;
    ASSERT_LE(result.min_radius, result.sphere.radius);
    if (result.sphere.radius > 0) max_gap = std::max(max_gap, 1 - result.min_radius / result.sphere.radius);
  }
  EXPECT_LE(max_gap, 1e-9);
  RecordProperty("largest gap", std::to_string(max_gap * 0x1p53) + " u");
}

TEST(EnclosingSphere, OfKnownFigures) {
  const auto radius = [](const std::vector<glm::dvec3>& points) {
    const EnclosingSphere result = enclosing_sphere(points);
    EXPECT_TRUE(holds(result, points));
    return result;
  };
  EXPECT_EQ(radius({{3, 4, 5}}).sphere.radius, 0);
  EXPECT_EQ(radius({{3, 4, 5}, {3, 4, 5}, {3, 4, 5}}).sphere.center, glm::dvec3(3, 4, 5));
  EXPECT_NEAR(radius({{-3, 0, 0}, {3, 0, 0}, {0, 1, 0}}).sphere.radius, 3, 1e-14);
  EXPECT_NEAR(radius({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}).sphere.radius, std::sqrt(3.0), 1e-14);
  EXPECT_LT(radius({{1e300, 0, 0}, {1e300, 1e-300, 0}}).sphere.radius, 1e-299);
  EXPECT_NEAR(radius({{1e300, 0, 0}, {-1e300, 1e-300, 0}}).sphere.radius, 1e300, 4e285);
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(Box{glm::dvec3(0.0), glm::dvec3(2.0)}.corner(i));
  EXPECT_NEAR(radius(corners).sphere.radius, std::sqrt(3.0), 1e-14);
  EXPECT_THROW(enclosing_sphere(std::vector<glm::dvec3>{}), Error);
  EXPECT_THROW(enclosing_sphere(std::vector{glm::dvec3(0, 0, double_nan)}), Error);
  EXPECT_THROW(enclosing_sphere(std::vector{glm::dvec3(0, 0, 1e301)}), Error);
}

TEST(EnclosingSphere, OfTheSolids) {
  for (const char* name : {"cube", "sphere", "teapot", "pyramid_to_cube"}) {
    const Mesh mesh = make_solid(name);
    const EnclosingSphere result = enclosing_sphere(mesh.positions);
    EXPECT_TRUE(holds(result, {mesh.positions.begin(), mesh.positions.end()})) << name;
    EXPECT_LE(result.sphere.radius - result.min_radius, 0x1p-40 * result.sphere.radius) << name;
  }
}

}  // namespace
}  // namespace morphcl
