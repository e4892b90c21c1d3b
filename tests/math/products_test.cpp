// Kahan products, lerp, and rounding to fp32.
#include <limits>

#include "host/math/kahan.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/transform.hpp"
#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

// Jeannerod, Louvet and Muller 2013.
constexpr double kahan_bound = 2 * u64;

TEST(DifferenceOfProducts, KeepsWhatTheNaiveFormLoses) {
  const float a = 33962.035f, b = -30438.8f, c = 41563.4f, d = -24871.969f;
  EXPECT_EQ(difference_of_products(a, b, c, d), -75.1656036376953125f);
}

TEST(DifferenceOfProducts, NearlyCancellingWithinTwoUnits) {
  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    const double a = random.in(1, 2), b = random.in(1, 2), c = random.in(1, 2);
    const double part = random.in(-1, 1);
    const double d = a * b / c * (1 + std::ldexp(part, -static_cast<int>(random.in(0, 52))));
    EXPECT_TRUE(
        within_relative(difference_of_products(a, b, c, d), reference::difference_of_products(a, b, c, d), kahan_bound))
        << a << " * " << b << " - " << c << " * " << d;
  }
}

TEST(KahanCross, NearlyParallelVectors) {
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 a = random.vector(1), b = 3.0 * a + 1e-14 * random.vector(1);
    const glm::dvec3 computed = kahan_cross(a, b);
    for (int k = 0; k < 3; ++k) {
      const int m = (k + 1) % 3, n = (k + 2) % 3;
      EXPECT_TRUE(within_relative(computed[k], reference::difference_of_products(a[m], b[n], a[n], b[m]), kahan_bound))
          << "component " << k << " of case " << i;
    }
  }
}

TEST(Lerp, ExactAtBothEndsAndWhereTheyAreEqual) {
  Random random(7);
  for (int i = 0; i < 10000; ++i) {
    const auto a = static_cast<float>(random.in(-1e3, 1e3)), b = static_cast<float>(random.in(-1, 1));
    const auto t = static_cast<float>(random.in(0, 1));
    EXPECT_EQ(lerp(a, b, 0.0f), a);
    EXPECT_EQ(lerp(a, b, 1.0f), b);
    EXPECT_EQ(lerp(a, a, t), a) << "t = " << t;
  }
  EXPECT_EQ(lerp(123.456f, 123.456f, 0.3f), 123.456f);
}

TEST(Lerp, NeitherOverflowsNorFlushes) {
  EXPECT_EQ(lerp(-3e38f, 3e38f, 0.5f), 0.0f);
  EXPECT_NEAR(lerp(1e-40f, 2e-40f, 0.5f), 1.5e-40, 0x1p-149);
  EXPECT_NE(lerp(1e-40f, 2e-40f, 0.5f), 0.0f);
}

// The pyramid's apex opens into the box's top: every position at step i of 100 is a multiple of 1/2.
const glm::dvec3 apex(100, 100, 100);
const glm::dvec3 top[] = {{50, 50, 100}, {150, 50, 100}, {150, 150, 100}, {50, 150, 100}};

TEST(Lerp, MorphFromPyramidToBoxIsExactInFp32AtKnownSteps) {
  for (const int step : {0, 1, 37, 50, 99, 100})
    for (const glm::dvec3& corner : top)
      for (int k = 0; k < 3; ++k) {
        const double expected = 100 + (corner[k] - 100) * step / 100;
        const auto t = static_cast<float>(step / 100.0);
        EXPECT_EQ(lerp(100.0f, static_cast<float>(corner[k]), t), expected) << "step " << step << ", component " << k;
      }
  EXPECT_EQ(lerp(100.0f, 50.0f, 0.37f), 81.5f);
  EXPECT_EQ(lerp(100.0f, 150.0f, 0.37f), 118.5f);
}

TEST(Lerp, MorphFromPyramidToBoxAtEveryStep) {
  // The last rounding (half an ulp below 256), the inner one (u |a|) and that of the step's fraction (u |b - a|).
  constexpr double fp32_bound = 0x1p-17 + 100 * reference::u32 + 50 * reference::u32;
  for (int step = 0; step <= 100; ++step)
    for (const glm::dvec3& corner : top)
      for (int k = 0; k < 3; ++k) {
        const double expected = 100 + (corner[k] - 100) * step / 100, t = step / 100.0;
        EXPECT_EQ(static_cast<float>(lerp(apex[k], corner[k], t)), expected) << "step " << step << ", component " << k;
        const float in_fp32 = lerp(100.0f, static_cast<float>(corner[k]), static_cast<float>(t));
        EXPECT_TRUE(within(in_fp32, expected, fp32_bound)) << "step " << step << ", component " << k;
      }
}

TEST(ToFp32, RoundsOnceToNearestEven) {
  EXPECT_EQ(to_fp32(1 + 0x1p-24), 1.0f);
  EXPECT_EQ(to_fp32(1 + 0x1p-24 + 0x1p-52), 1 + 0x1p-23f);
  EXPECT_EQ(to_fp32(1 + 0x3p-24), 1 + 0x1p-22f);
  EXPECT_EQ(to_fp32(1e-45), 0x1p-149f);
  EXPECT_EQ(to_fp32(1e-60), 0.0f);
  glm::dmat4 m(0.0);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) m[c][r] = c + 10 * r + 0.1;
  const glm::mat4 rounded = to_fp32(m);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) EXPECT_EQ(rounded[c][r], static_cast<float>(c + 10 * r + 0.1)) << c << ", " << r;
}

TEST(ToFp32, RefusesWhatDoesNotFit) {
  const double largest = std::numeric_limits<float>::max();
  EXPECT_EQ(to_fp32(largest), std::numeric_limits<float>::max());
  EXPECT_EQ(to_fp32(std::nextafter(0x1.ffffffp+127, 0.0)), std::numeric_limits<float>::max());
  for (const double bad :
       {0x1.ffffffp+127, -1e39, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    expect_error([&] { to_fp32(bad); }, ErrorKind::usage, "does not fit");
}

}  // namespace
}  // namespace morphcl
