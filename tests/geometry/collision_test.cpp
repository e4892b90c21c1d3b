// Triangles and meshes against one another: every decision, and every point where they meet, against rationals.
#include "morphcl/collision.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <set>
#include <vector>

#include "morphcl/error.hpp"
#include "morphcl/solids.hpp"
#include "tests/support/exact_rational.hpp"

namespace morphcl {
namespace {

using test_support::cases;
using test_support::cross;
using test_support::dot;
using test_support::double_infinity;
using test_support::double_nan;
using test_support::families;
using test_support::Family;
using test_support::is_nearest;
using test_support::point3;
using test_support::Random;
using test_support::Rational;
using test_support::rational;
using test_support::RationalVector;
using test_support::sign_of;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

bool same(const RationalVector& a, const RationalVector& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

// The part of a convex polygon where normal . (x - origin) >= 0.
std::vector<RationalVector> kept_part(const std::vector<RationalVector>& polygon, const RationalVector& normal,
                                      const RationalVector& origin) {
  std::vector<RationalVector> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalVector &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Rational of_p = dot(normal, p - origin), of_q = dot(normal, q - origin);
    if (of_p >= 0) kept.push_back(p);
    if (sign_of(of_p) * sign_of(of_q) < 0) kept.push_back(p + Rational(of_p / (of_p - of_q)) * (q - p));
  }
  return kept;
}

std::array<RationalVector, 3> exact(const Triangle& triangle) {
  return {rational(triangle[0]), rational(triangle[1]), rational(triangle[2])};
}

RationalVector normal_of(const Triangle& triangle) {
  const auto [a, b, c] = exact(triangle);
  return cross(b - a, c - a);
}

bool has_area(const Triangle& triangle) {
  const RationalVector normal = normal_of(triangle);
  return dot(normal, normal) != 0;
}

// The corners of what the triangles have in common, each once; `b` has an area.
std::vector<RationalVector> exact_common(const Triangle& a, const Triangle& b) {
  const auto of_a = exact(a), of_b = exact(b);
  const RationalVector normal = normal_of(b);
  std::vector<RationalVector> polygon(of_a.begin(), of_a.end());
  polygon = kept_part(kept_part(polygon, normal, of_b[0]), Rational(-1) * normal, of_b[0]);
  for (std::size_t i = 0; i < 3; ++i) polygon = kept_part(polygon, cross(normal, of_b[(i + 1) % 3] - of_b[i]), of_b[i]);
  std::vector<RationalVector> distinct;
  for (const RationalVector& point : polygon)
    if (std::none_of(distinct.begin(), distinct.end(), [&](const auto& other) { return same(point, other); }))
      distinct.push_back(point);
  return distinct;
}

// Whether the point, which is in the triangle, is off its edges.
bool is_within(const RationalVector& point, const Triangle& triangle) {
  const auto corners = exact(triangle);
  const RationalVector normal = normal_of(triangle);
  for (std::size_t i = 0; i < 3; ++i)
    if (dot(cross(normal, corners[(i + 1) % 3] - corners[i]), point - corners[i]) <= 0) return false;
  return true;
}

// The mean of all common corners is within both triangles if any common point is.
Contact exact_contact(const std::vector<RationalVector>& common, const Triangle& a, const Triangle& b) {
  if (common.empty()) return Contact::apart;
  RationalVector sum{};
  for (const RationalVector& point : common) sum = sum + point;
  const RationalVector mean = Rational(1, static_cast<int>(common.size())) * sum;
  return has_area(a) && has_area(b) && is_within(mean, a) && is_within(mean, b) ? Contact::crossing : Contact::touching;
}

bool is_nearest_point(const glm::dvec3& point, const RationalVector& at) {
  return is_nearest(point.x, at.x) && is_nearest(point.y, at.y) && is_nearest(point.z, at.z);
}

Triangle any_triangle(Random& random, Family family) {
  const glm::dvec3 a = point3(random, family), b = point3(random, family), c = point3(random, family);
  return {a, b, c};
}

TEST(TriangleContact, DecisionsAndCommonPoints) {
  Random random(11);
  std::array<int, 3> seen{};
  for (const Family family : families)
    for (int i = 0; i < cases(family) / 2; ++i) {
      Triangle a = any_triangle(random, family), b = any_triangle(random, family);
      if (i % 5 == 1) b[0] = a[1];                                          // a shared corner
      if (i % 5 == 2) b[0] = a[1], b[2] = a[0];                             // a shared edge
      if (i % 5 == 3) b[0].x = b[1].x = b[2].x = a[0].x = a[1].x = a[2].x;  // one plane
      if (i % 25 == 4) a[2] = a[1];                                         // no area
      if (!has_area(b)) continue;
      const std::vector<RationalVector> common = exact_common(a, b);
      const Contact expected = exact_contact(common, a, b);
      ASSERT_EQ(contact(a, b), expected) << static_cast<int>(family) << ' ' << i;
      ASSERT_EQ(contact(b, a), expected);
      ASSERT_EQ(contact({a[2], a[1], a[0]}, {b[1], b[2], b[0]}), expected);
      ++seen[static_cast<std::size_t>(expected)];
      if (family == Family::any_size) continue;
      const std::vector<glm::dvec3> points = common_points(a, b);
      ASSERT_EQ(points.empty(), common.empty());
      if (common.size() < 3) {
        ASSERT_LE(points.size(), common.size()) << "two may be rounded to one";
        if (family == Family::whole) {
          ASSERT_EQ(points.size(), common.size());
        }
      }
      for (const glm::dvec3& point : points)
        ASSERT_TRUE(
            std::any_of(common.begin(), common.end(), [&](const auto& at) { return is_nearest_point(point, at); }));
    }
  for (const int count : seen) EXPECT_GT(count, 200);
}

TEST(TriangleContact, OfTrianglesWithoutArea) {
  const Triangle flat = {glm::dvec3(0, 0, 0), {4, 0, 0}, {0, 4, 0}};
  const auto segment = [](const glm::dvec3& a, const glm::dvec3& b) { return Triangle{a, b, 0.5 * a + 0.5 * b}; };
  EXPECT_EQ(contact(flat, segment({1, 1, -1}, {1, 1, 1})), Contact::touching);
  EXPECT_EQ(contact(flat, segment({3, 3, -1}, {3, 3, 1})), Contact::apart);
  EXPECT_EQ(contact(flat, segment({1, 1, 0}, {9, 9, 0})), Contact::touching);
  EXPECT_EQ(contact(flat, {glm::dvec3(1, 1, 0), {1, 1, 0}, {1, 1, 0}}), Contact::touching);
  EXPECT_EQ(contact(flat, {glm::dvec3(1, 1, 1), {1, 1, 1}, {1, 1, 1}}), Contact::apart);
  EXPECT_EQ(contact(segment({0, 0, 0}, {4, 4, 4}), segment({0, 4, 4}, {4, 0, 0})), Contact::touching);
  EXPECT_EQ(contact(segment({0, 0, 0}, {4, 4, 4}), segment({0, 4, 5}, {4, 0, 0})), Contact::apart);
  EXPECT_EQ(contact(segment({0, 0, 0}, {2, 2, 2}), segment({1, 1, 1}, {4, 4, 4})), Contact::touching);
  EXPECT_EQ(contact(segment({0, 0, 0}, {1, 1, 1}), segment({2, 2, 2}, {4, 4, 4})), Contact::apart);
  EXPECT_THAT(common_points(segment({0, 0, 0}, {4, 4, 4}), segment({0, 4, 4}, {4, 0, 0})),
              UnorderedElementsAre(glm::dvec3(2, 2, 2)));
  const Triangle along = {glm::dvec3(0, 0, 0), {4, 0, 0}, {2, 0, 0}},
                 further = {glm::dvec3(1, 0, 0), {3, 0, 0}, {9, 0, 0}};
  EXPECT_THAT(common_points(along, further), UnorderedElementsAre(glm::dvec3(1, 0, 0), glm::dvec3(4, 0, 0)));
  EXPECT_THROW(contact(flat, {glm::dvec3(0, 0, double_nan), {1, 0, 0}, {0, 1, 0}}), Error);
}

TEST(CommonPoints, OfTwoTrianglesThatMakeAStar) {
  const Triangle up = {glm::dvec3(0, 0, 1), {6, 0, 1}, {3, 6, 1}}, down = {glm::dvec3(0, 4, 1), {3, -2, 1}, {6, 4, 1}};
  EXPECT_EQ(contact(up, down), Contact::crossing);
  EXPECT_THAT(common_points(up, down),
              UnorderedElementsAre(glm::dvec3(2, 0, 1), glm::dvec3(4, 0, 1), glm::dvec3(5, 2, 1), glm::dvec3(4, 4, 1),
                                   glm::dvec3(2, 4, 1), glm::dvec3(1, 2, 1)));
}

std::vector<glm::dvec3> moved(const std::vector<glm::vec3>& positions, double factor, const glm::dvec3& by) {
  std::vector<glm::dvec3> result;
  for (const glm::vec3& position : positions) result.push_back(factor * glm::dvec3(position) + by);
  return result;
}

// The parity of crossings of a ray that meets no edge, in rationals.
PointPlace exact_place(const MeshTree& mesh, const glm::dvec3& point) {
  const RationalVector from = rational(point);
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const auto corners = exact(mesh.triangle(i));
    const RationalVector normal = normal_of(mesh.triangle(i));
    if (!has_area(mesh.triangle(i)) || dot(normal, from - corners[0]) != 0) continue;
    bool within = true;
    for (std::size_t k = 0; k < 3; ++k)
      within &= dot(cross(normal, corners[(k + 1) % 3] - corners[k]), from - corners[k]) >= 0;
    if (within) return PointPlace::boundary;
  }
  // A direction that no edge of these meshes has.
  const RationalVector way = {Rational(1), Rational(1, 1009), Rational(1, 1000003)};
  bool inside = false;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const auto [a, b, c] = exact(mesh.triangle(i));
    const RationalVector normal = normal_of(mesh.triangle(i));
    const Rational speed = dot(normal, way);
    if (speed == 0) continue;
    const Rational t = dot(normal, a - from) / speed;
    if (t < 0) continue;
    const RationalVector hit = from + t * way;
    const int p = sign_of(dot(cross(normal, b - a), hit - a)), q = sign_of(dot(cross(normal, c - b), hit - b)),
              r = sign_of(dot(cross(normal, a - c), hit - c));
    if (p > 0 && q > 0 && r > 0) inside = !inside;
  }
  return inside ? PointPlace::inside : PointPlace::outside;
}

// By clipping, as triangles above: a segment is a triangle without area.
TEST(SegmentInMesh, AgainstRationals) {
  Random random(13);
  std::array<int, 3> seen{};
  for (const Family family : families)
    for (int i = 0; i < cases(family) / 50; ++i) {
      std::vector<glm::dvec3> positions;
      std::vector<glm::uvec3> triangles;
      for (std::uint32_t k = 0; k < 8; ++k) {
        const Triangle triangle = any_triangle(random, family);
        if (!has_area(triangle)) continue;
        const auto first = static_cast<std::uint32_t>(positions.size());
        positions.insert(positions.end(), triangle.begin(), triangle.end());
        triangles.emplace_back(first, first + 1, first + 2);
      }
      const MeshTree mesh(positions, triangles);
      const Segment3 segment{point3(random, family), point3(random, family)};
      const std::vector<MeshHit> hits = intersect(segment, mesh);
      for (std::uint32_t k = 0; k < mesh.size(); ++k) {
        const std::vector<RationalVector> common =
            exact_common({segment.from, segment.to, segment.to}, mesh.triangle(k));
        const RationalVector normal = normal_of(mesh.triangle(k)), corner = rational(mesh.triangle(k)[0]);
        const int sides =
            sign_of(dot(normal, rational(segment.from) - corner)) * sign_of(dot(normal, rational(segment.to) - corner));
        const bool through = sides < 0 && !common.empty() && is_within(common[0], mesh.triangle(k));
        const Contact expected = common.empty() ? Contact::apart : through ? Contact::crossing : Contact::touching;
        ++seen[static_cast<std::size_t>(expected)];
        const auto hit =
            std::find_if(hits.begin(), hits.end(), [k](const MeshHit& each) { return each.triangle == k; });
        ASSERT_EQ(hit == hits.end() ? Contact::apart : hit->at.contact, expected);
        if (hit == hits.end() || family == Family::any_size) continue;
        for (const glm::dvec3& point : {hit->at.from, hit->at.to})
          ASSERT_TRUE(
              std::any_of(common.begin(), common.end(), [&](const auto& at) { return is_nearest_point(point, at); }));
      }
    }
  for (const int count : seen) EXPECT_GT(count, 10);
  const MeshTree cube(make_solid("cube"));
  EXPECT_THROW(intersect(Segment3{{0, 0, double_nan}, {1, 1, 1}}, cube), Error);
  EXPECT_THAT(intersect(Segment3{{1e9, 0, 0}, {1e9, 1, 0}}, cube), IsEmpty());
  EXPECT_THAT(intersect(Segment3{}, MeshTree(std::vector<glm::dvec3>{}, {})), IsEmpty());
}

TEST(PointInMesh, AgainstRationals) {
  Random random(12);
  std::array<int, 3> seen{};
  for (const char* name : {"cube", "sphere", "pyramid_to_cube"}) {
    const Mesh mesh = make_solid(name);
    const Box box = box_of(moved(mesh.positions, 1, {}));
    const MeshTree tree(mesh);
    ASSERT_TRUE(tree.closed()) << name;
    for (int i = 0; i < (mesh.triangles.size() > 100 ? 4 : 150); ++i) {
      glm::dvec3 point;
      for (int k = 0; k < 3; ++k)
        point[k] = box.lower[k] + (box.upper[k] - box.lower[k]) * 0.25 * static_cast<double>(random.integer_in(-1, 5));
      if (i % 3 == 1) point = mesh.positions[static_cast<std::size_t>(i) % mesh.positions.size()];
      if (i % 9 == 4) point.y = std::nextafter(point.y, 1e9);
      const PointPlace place = place_in_mesh(tree, point);
      ASSERT_EQ(place, exact_place(tree, point)) << name << ' ' << point.x << ' ' << point.y << ' ' << point.z;
      ++seen[static_cast<std::size_t>(place)];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 8);
}

TEST(PointInMesh, OfMeshesThatAreOddOrOpen) {
  const MeshTree cube(make_solid("cube"));
  EXPECT_THROW(place_in_mesh(cube, {0, double_infinity, 0}), Error);
  EXPECT_EQ(place_in_mesh(MeshTree(std::vector<glm::dvec3>{}, {}), {0, 0, 0}), PointPlace::outside);
  EXPECT_THROW(MeshTree({glm::dvec3(0.0)}, {glm::uvec3(0, 0, 1)}), Error);
  EXPECT_THROW(MeshTree({glm::dvec3(double_nan)}, {}), Error);
  Mesh open = make_solid("cube");
  open.triangles.pop_back();
  EXPECT_FALSE(MeshTree(open).closed());
  EXPECT_THROW(place_in_mesh(MeshTree(open), {0, 0, 0}), Error);
  Mesh inward = make_solid("cube");
  for (glm::uvec3& triangle : inward.triangles) std::swap(triangle.y, triangle.z);
  EXPECT_EQ(place_in_mesh(MeshTree(inward), glm::dvec3(box_of(moved(inward.positions, 1, {})).center())),
            PointPlace::inside);
}

TEST(Collide, OfCubesSideBySideInsideAndApart) {
  const Mesh cube = make_solid("cube");
  const Box box = box_of(moved(cube.positions, 1, {}));
  const double side = box.upper.x - box.lower.x;
  const MeshTree still(cube);
  const auto beside = [&](double factor, const glm::dvec3& by) {
    return collide(still, MeshTree(moved(cube.positions, factor, by), cube.triangles));
  };
  EXPECT_FALSE(beside(1, {side * 1.5, 0, 0}).collides());
  EXPECT_EQ(beside(1, {side * 0.5, 0.25 * side, 0.25 * side}).contact, Contact::crossing);
  const Collision wall = beside(1, {side, 0, 0});
  EXPECT_EQ(wall.contact, Contact::crossing) << "two faces overlap in one plane";
  EXPECT_EQ(beside(1, {side, side, side}).contact, Contact::touching) << "one corner";
  const Collision corner = beside(1, {side, side, side});
  ASSERT_FALSE(corner.pairs.empty());
  for (const TriangleContact& pair : corner.pairs) EXPECT_THAT(pair.points, UnorderedElementsAre(box.upper));
  const glm::dvec3 into_middle = 0.5 * box.center();
  const Collision inner = beside(0.5, into_middle);
  EXPECT_EQ(inner.contact, Contact::apart);
  EXPECT_TRUE(inner.b_in_a && !inner.a_in_b && inner.collides());
  const Collision outer = beside(2, -box.center());
  EXPECT_TRUE(outer.a_in_b && !outer.b_in_a);
  EXPECT_FALSE(collide(still, MeshTree(std::vector<glm::dvec3>{}, {})).collides());
}

// The tree leaves out no pair: all pairs of two spheres, one by one.
TEST(Collide, FindsWhatAllPairsFind) {
  const Mesh sphere = make_solid("sphere");
  const MeshTree a(sphere), b(moved(sphere.positions, 0.9, {0.4, 0.3, 0.2}), sphere.triangles);
  const std::size_t stride = std::max<std::size_t>(1, a.size() / 60);
  std::set<std::pair<std::uint32_t, std::uint32_t>> expected, found;
  for (std::size_t i = 0; i < a.size(); i += stride)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (contact(a.triangle(i), b.triangle(j)) != Contact::apart) expected.emplace(i, j);
  const Collision collision = collide(a, b, 1'000'000);
  EXPECT_EQ(collision.count, collision.pairs.size());
  for (const TriangleContact& pair : collision.pairs)
    if (pair.a % stride == 0) found.emplace(pair.a, pair.b);
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(found, expected);
  EXPECT_EQ(collide(a, b, 3).pairs.size(), 3u);
  EXPECT_EQ(collide(a, b, 3).count, collision.count);
}

// Two bumpy sheets of 100,000 triangles each through one another, and one on itself: exact answers within seconds.
TEST(Collide, LargeMeshes) {
  constexpr std::uint32_t cells = 223;
  std::vector<glm::dvec3> sheet;
  std::vector<glm::uvec3> triangles;
  for (std::uint32_t y = 0; y <= cells; ++y)
    for (std::uint32_t x = 0; x <= cells; ++x)
      sheet.emplace_back(x / 16.0, y / 16.0, ((x * x + 3 * y * y) % 17) / 64.0);
  for (std::uint32_t y = 0; y < cells; ++y)
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t i = y * (cells + 1) + x;
      triangles.emplace_back(i, i + 1, i + cells + 1);
      triangles.emplace_back(i + 1, i + cells + 2, i + cells + 1);
    }
  std::vector<glm::dvec3> standing;
  for (const glm::dvec3& p : sheet) standing.emplace_back(p.x + 0.01, p.z + 6.9, p.y - 7.0);
  const auto start = std::chrono::steady_clock::now();
  const MeshTree a(sheet, triangles), b(standing, triangles);
  const Collision collision = collide(a, b);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(collision.contact, Contact::crossing);
  EXPECT_GT(collision.count, 100u);
  EXPECT_LT(seconds.count(), 10) << "well under a second on a machine that does nothing else";
  RecordProperty("seconds", std::to_string(seconds.count()));
}

}  // namespace
}  // namespace morphcl
