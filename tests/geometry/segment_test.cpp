// Segments against planes and boxes: every decision and point against rationals, on random and on degenerate input.
#include <gtest/gtest.h>

#include <algorithm>

#include "morphcl/error.hpp"
#include "morphcl/geometry.hpp"
#include "tests/support/exact_rational.hpp"

namespace morphcl {
namespace {

using test_support::cases;
using test_support::coordinate;
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

void expect_nearest(const glm::dvec3& point, const RationalVector& at, Family family) {
  if (family == Family::any_size) return;  // may be subnormal
  ASSERT_TRUE(is_nearest(point.x, at.x) && is_nearest(point.y, at.y) && is_nearest(point.z, at.z));
}

TEST(SegmentContact, WithPlanes) {
  Random random(21);
  std::array<int, 3> seen{};
  for (const Family family : families)
    for (int i = 0; i < cases(family); ++i) {
      const Plane plane{point3(random, family), coordinate(random, family)};
      const Segment3 segment{point3(random, family), point3(random, family)};
      if (plane.normal == glm::dvec3(0.0)) {
        ASSERT_THROW(side_of_plane(plane, segment.from), Error);
        continue;
      }
      const auto side = [&](const glm::dvec3& point) {
        return Rational(dot(rational(plane.normal), rational(point)) - rational(plane.offset));
      };
      const Rational from = side(segment.from), to = side(segment.to);
      ASSERT_EQ(side_of_plane(plane, segment.from), sign_of(from));
      const int product = sign_of(from) * sign_of(to);
      const Contact expected = product > 0 ? Contact::apart : product < 0 ? Contact::crossing : Contact::touching;
      const Intersection3 result = intersect(segment, plane);
      ASSERT_EQ(result.contact, expected);
      ++seen[static_cast<std::size_t>(expected)];
      if (expected == Contact::crossing) {
        const Rational t = from / (from - to);
        expect_nearest(result.from, rational(segment.from) + t * (rational(segment.to) - rational(segment.from)),
                       family);
        ASSERT_EQ(result.from, result.to);
      }
      if (expected == Contact::touching) {
        ASSERT_EQ(result.from, from == 0 ? segment.from : segment.to);
        ASSERT_EQ(result.to, to == 0 ? segment.to : segment.from);
      }
    }
  for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(SegmentContact, WithBoxes) {
  Random random(22);
  std::array<int, 3> seen{};
  for (const Family family : families)
    for (int i = 0; i < cases(family); ++i) {
      Box box;
      box.include(point3(random, family));
      box.include(point3(random, family));
      const Segment3 segment{point3(random, family), point3(random, family)};
      const RationalVector start = rational(segment.from), way = rational(segment.to) - start;
      const RationalVector low = rational(box.lower), high = rational(box.upper);
      Rational enter = 0, leave = 1;
      bool apart = false;
      const auto clip = [&](const Rational& at, const Rational& step, const Rational& lower, const Rational& upper) {
        if (step == 0) {
          apart |= at < lower || at > upper;
          return;
        }
        const Rational p = (lower - at) / step, q = (upper - at) / step;
        enter = std::max(enter, std::min(p, q));
        leave = std::min(leave, std::max(p, q));
      };
      clip(start.x, way.x, low.x, high.x);
      clip(start.y, way.y, low.y, high.y);
      clip(start.z, way.z, low.z, high.z);
      const Rational half = (enter + leave) / 2;
      const RationalVector middle = start + half * way;
      const auto within = [](const Rational& at, const Rational& lower, const Rational& upper) {
        return at > lower && at < upper;
      };
      const bool inside = segment.from != segment.to && within(middle.x, low.x, high.x) &&
                          within(middle.y, low.y, high.y) && within(middle.z, low.z, high.z);
      const Contact expected = apart || enter > leave ? Contact::apart : inside ? Contact::crossing : Contact::touching;
      const Intersection3 result = intersect(segment, box);
      ASSERT_EQ(result.contact, expected) << static_cast<int>(family) << ' ' << i;
      ASSERT_EQ(intersect({segment.to, segment.from}, box).contact, expected);
      ++seen[static_cast<std::size_t>(expected)];
      if (expected == Contact::apart) continue;
      expect_nearest(result.from, start + enter * way, family);
      expect_nearest(result.to, start + leave * way, family);
    }
  for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(SegmentContact, BadInput) {
  const Box box{glm::dvec3(0.0), glm::dvec3(1.0)};
  EXPECT_EQ(intersect(Segment3{{0, 0, 0}, {1, 1, 1}}, Box{}).contact, Contact::apart);
  EXPECT_THROW(intersect(Segment3{{0, 0, double_nan}, {1, 1, 1}}, box), Error);
  EXPECT_THROW(intersect(Segment3{{0, 0, 0}, {1, double_infinity, 1}}, box), Error);
  EXPECT_THROW(intersect(Segment3{{0, 0, 0}, {1, 1, 1}}, Plane{{0, 0, 0}, 1}), Error);
  EXPECT_THROW(intersect(Segment3{{0, 0, 0}, {1, 1, 1}}, Plane{{0, 0, 1}, double_nan}), Error);
  EXPECT_EQ(intersect(Segment3{{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, box).contact, Contact::touching) << "a point";
}

}  // namespace
}  // namespace morphcl
