#include "morphcl/numerics.hpp"

#include <limits>

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using test_support::Random;

// Correctly rounded; the reference itself is within 2^-50 ulp.
constexpr double sin_cos_ulp = 0.5 + 0x1p-50;

void expect_sin_cos(double degrees) {
  const SinCos computed = sin_cos_degrees(degrees);
  const reference::ExactSinCos exact = reference::sin_cos_degrees(degrees);
  const double sin_error = reference::error_in_ulp(computed.sin, exact.sin);
  const double cos_error = reference::error_in_ulp(computed.cos, exact.cos);
  EXPECT_LE(std::abs(sin_error), sin_cos_ulp) << "ulp: sine of " << degrees << " degrees is " << computed.sin;
  EXPECT_LE(std::abs(cos_error), sin_cos_ulp) << "ulp: cosine of " << degrees << " degrees is " << computed.cos;
}

TEST(Angle, RightAnglesAreExact) {
  for (int quarter = -4000; quarter <= 4000; ++quarter) {
    const SinCos a = sin_cos_degrees(90.0 * quarter);
    const int turn = ((quarter % 4) + 4) % 4;
    const double sines[] = {0, 1, 0, -1}, cosines[] = {1, 0, -1, 0};
    EXPECT_EQ(a.sin, sines[turn]) << "quarter " << quarter;
    EXPECT_EQ(a.cos, cosines[turn]) << "quarter " << quarter;
    EXPECT_FALSE(std::signbit(a.sin) && a.sin == 0) << "-0 at quarter " << quarter;
    EXPECT_FALSE(std::signbit(a.cos) && a.cos == 0) << "-0 at quarter " << quarter;
  }
}

TEST(Angle, RationalAndDiagonalValuesAreExact) {
  EXPECT_EQ(sin_cos_degrees(30).sin, 0.5);
  EXPECT_EQ(sin_cos_degrees(60).cos, 0.5);
  EXPECT_EQ(sin_cos_degrees(-150).sin, -0.5);
  EXPECT_EQ(sin_cos_degrees(240).cos, -0.5);
  for (const double degrees : {45.0, 135.0, 225.0, 315.0, -45.0, 765.0}) {
    const SinCos a = sin_cos_degrees(degrees);
    EXPECT_EQ(std::abs(a.sin), std::sqrt(0.5)) << degrees;
    EXPECT_EQ(std::abs(a.cos), std::sqrt(0.5)) << degrees;
  }
}

TEST(Angle, RandomAnglesWithinHalfAnUlp) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) expect_sin_cos(random.in(-1000, 1000));
}

TEST(Angle, HugeTinyAndAlmostRightAngles) {
  for (const double degrees :
       {1e-300, -1e-30, 1e-8, 1e6, 1e15 + 30, 1e15 + 0.125, 123456789012345678.0, -1e22, 1e100, 1e300, 1.7e308})
    expect_sin_cos(degrees);
  for (int quarter = -3; quarter <= 3; ++quarter)
    for (const double offset : {1e-13, -1e-13, 1e-7, -1e-7, 44.99999999999999, -29.999999999999996})
      expect_sin_cos(90.0 * quarter + offset);
}

TEST(Angle, ReductionIsExact) {
  const SinCos small = sin_cos_degrees(30.25), huge = sin_cos_degrees(30.25 + 360.0 * 1e12);
  EXPECT_EQ(small.sin, huge.sin);
  EXPECT_EQ(small.cos, huge.cos);
}

TEST(Angle, NotFiniteIsAnError) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    expect_error([&] { sin_cos_degrees(bad); }, ErrorKind::usage, "not a finite number");
}

TEST(Angle, ConversionsWithinOneUlp) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.in(-400, 400);
    EXPECT_LT(std::abs(reference::error_in_ulp(radians(angle), reference::radians(angle))), 1) << angle;
    EXPECT_LT(std::abs(reference::error_in_ulp(degrees(angle), reference::degrees(angle))), 1) << angle;
  }
  EXPECT_EQ(degrees(radians(45)), 45);
  EXPECT_EQ(radians(180), 3.141592653589793);
}

}  // namespace
}  // namespace morphcl
