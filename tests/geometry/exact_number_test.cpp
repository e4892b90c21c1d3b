// Sums, products and quotients against rationals; orientations of coordinates of any size.
#include "host/math/exact_number.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "host/math/exact_sign.hpp"
#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"
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
using test_support::is_nearest;
using test_support::point2;
using test_support::point3;
using test_support::Random;
using test_support::Rational;
using test_support::rational;
using test_support::sign_of;

TEST(ExactNumber, SignsAndQuotientsOfSumsOfProducts) {
  Random random(1);
  int zeros = 0;
  for (const auto family : families)
    for (int i = 0; i < cases(family); ++i) {
      const double a = coordinate(random, family), b = coordinate(random, family), c = coordinate(random, family);
      const double d = coordinate(random, family), e = coordinate(random, family);
      const ExactNumber number = ExactNumber(a) * ExactNumber(b) - ExactNumber(c) * ExactNumber(d) + ExactNumber(e);
      const Rational exact = rational(a) * rational(b) - rational(c) * rational(d) + rational(e);
      ASSERT_EQ(number.sign(), sign_of(exact)) << a << ' ' << b << ' ' << c << ' ' << d << ' ' << e;
      ASSERT_EQ(exact_sign([&](auto n) { return n(a) * n(b) - n(c) * n(d) + n(e); }), sign_of(exact));
      zeros += exact == 0;
      const double divisor = coordinate(random, family);
      if (divisor == 0 || exact == 0) continue;
      const Rational ratio = exact / rational(divisor);
      const double rounded = quotient(number, ExactNumber(divisor));
      if (std::abs(rounded) < 1e-300 || std::isinf(rounded)) continue;
      ASSERT_TRUE(is_nearest(rounded, ratio)) << rounded << " of " << a << ' ' << b << ' ' << c << ' ' << d;
    }
  EXPECT_GT(zeros, 100);
}

TEST(ExactNumber, QuotientsAtTheEndsOfTheRange) {
  const ExactNumber one(1), three(3), large(std::numeric_limits<double>::max()), small(0x1p-1074);
  EXPECT_EQ(quotient(one, three), 1.0 / 3);
  EXPECT_EQ(quotient(-one, three), -1.0 / 3);
  EXPECT_EQ(quotient(ExactNumber(), three), 0);
  EXPECT_EQ(quotient(large * three, three), std::numeric_limits<double>::max());
  EXPECT_EQ(quotient(large * three, one), double_infinity);
  EXPECT_EQ(quotient(small * three, three), 0x1p-1074);
  EXPECT_EQ(quotient(small, three), 0);
  EXPECT_EQ(quotient(small, ExactNumber(2)), 0) << "a tie, to even";
  EXPECT_EQ(quotient(small * three, ExactNumber(2)), 0x1p-1073) << "a tie, to even";
  EXPECT_EQ(quotient(ExactNumber(0x1p+53) + one, one), 0x1p+53) << "a tie, to even";
  EXPECT_EQ(quotient(ExactNumber(0x1p+53) + one + small, one), 0x1p+53 + 2) << "a little beyond the tie";
  EXPECT_EQ(square_root_of_quotient(large * large * ExactNumber(4), ExactNumber(16)),
            std::numeric_limits<double>::max() / 2);
}

TEST(ExactNumber, WhatIsNotFiniteIsRefused) {
  EXPECT_THROW(ExactNumber{double_infinity}, Error);
  EXPECT_THROW(orientation(glm::dvec2(0, double_nan), {1, 0}, {0, 1}), Error);
  EXPECT_THROW(orientation(glm::dvec2(0, 0), {double_infinity, 0}, {0, 1}), Error);
  EXPECT_THROW(orientation(glm::dvec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, -double_infinity}), Error);
}

TEST(Orientation, OfCoordinatesOfAnySize) {
  Random random(2);
  int zeros = 0;
  for (const auto family : families)
    for (int i = 0; i < cases(family); ++i) {
      const glm::dvec2 p = point2(random, family), q = point2(random, family), r = point2(random, family);
      const Rational area = (rational(q.x) - rational(p.x)) * (rational(r.y) - rational(p.y)) -
                            (rational(q.y) - rational(p.y)) * (rational(r.x) - rational(p.x));
      ASSERT_EQ(orientation(p, q, r), sign_of(area));
      const glm::dvec3 a = point3(random, family), b = point3(random, family), c = point3(random, family);
      const glm::dvec3 d = point3(random, family);
      const auto from = rational(a);
      const Rational volume = dot(cross(rational(b) - from, rational(c) - from), rational(d) - from);
      ASSERT_EQ(orientation(a, b, c, d), sign_of(volume));
      zeros += volume == 0;
    }
  EXPECT_GT(zeros, 100);
}

}  // namespace
}  // namespace morphcl
