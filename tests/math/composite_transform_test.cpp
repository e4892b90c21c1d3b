#include "morphcl/transform.hpp"

#include <limits>

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

double row_sum_norm(const glm::dmat4& m) {
  double norm = 0;
  for (int r = 0; r < 4; ++r)
    norm = std::max(norm, std::abs(m[0][r]) + std::abs(m[1][r]) + std::abs(m[2][r]) + std::abs(m[3][r]));
  return norm;
}

// Each step multiplies the condition by |M||M^-1|; a step and its inverse fit within 64u, the two products cost 4u
// each, and so does the final one.
double identity_bound(const CompositeTransform& t) {
  double condition = 1;
  for (const TransformStep& step : t.steps()) condition *= row_sum_norm(step.matrix) * row_sum_norm(step.inverse);
  return static_cast<double>(t.steps().size()) * (64 + 3 * 4) * u64 * condition;
}

void expect_inverse(const CompositeTransform& t) {
  const glm::dmat4 identity = t.matrix() * t.inverse().matrix();
  const double bound = identity_bound(t);
  ASSERT_LT(bound, 1e-3) << "the bound says nothing for\n" << t.to_string();
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      EXPECT_TRUE(within(identity[c][r], r == c ? 1.0 : 0.0, bound)) << r << ", " << c << " of\n" << t.to_string();
}

TEST(CompositeTransform, StepsApplyInTheOrderAdded) {
  const glm::dmat4 m = CompositeTransform().translate({1, 0, 0}).scale({2, 2, 2}).rotate_z_degrees(90).matrix();
  expect_point(transform_point(m, {3, 0, 0}), {0, 8, 0}, 0, "(3 + 1) * 2, turned to y");
}

TEST(CompositeTransform, TranslationOfTheObjectAndOfTheAxes) {
  const CompositeTransform object = CompositeTransform().translate({1, -2, 3.5});
  expect_point(transform_point(object.matrix(), {10, 10, 10}), {11, 8, 13.5}, 0, "object");
  expect_point(transform_point(object.inverse().matrix(), {11, 8, 13.5}), {10, 10, 10}, 0, "axes");
}

TEST(CompositeTransform, RotationOfTheAxesIsTheInverse) {
  for (const double degrees : {12.5, 90.0, -200.0}) {
    EXPECT_EQ(CompositeTransform().rotate_x_degrees(degrees).inverse().matrix(),
              CompositeTransform().rotate_x_degrees(-degrees).matrix());
    EXPECT_EQ(CompositeTransform().rotate_about_axis({1, 2, 3}, {3, 2, 5}, degrees).inverse().matrix(),
              CompositeTransform().rotate_about_axis({1, 2, 3}, {3, 2, 5}, -degrees).matrix());
  }
}

TEST(CompositeTransform, ScaleAboutAPointKeepsThePoint) {
  const glm::dmat4 m = CompositeTransform().scale_about({100, 100, 30}, {0.01, 2, 0.5}).matrix();
  // Two products and a sum of numbers up to 200.
  expect_point(transform_point(m, {100, 100, 30}), {100, 100, 30}, 3 * 200 * u64, "pivot");
  expect_point(transform_point(m, {200, 101, 40}), {101, 102, 35}, 3 * 200 * u64, "another");
}

// Pivot 1e8: the fp32 image is the exact one within half an ulp, which is 4; S x + (1 - S) X in fp32 is off by 64.
TEST(CompositeTransform, ScaleAboutAFarPointWithinHalfAnUlp) {
  constexpr double half_ulp_at_1e8 = 4, fp64_part = 4 * 2e8 * u64;
  Random random(21);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 pivot(1e8, -1e8, 1.3e8);
    const glm::dvec3 factor = random.vector(1.2), x(glm::vec3(pivot + random.vector(100)));
    const glm::dvec3 image = transform_point(CompositeTransform().scale_about(pivot, factor).matrix(), x);
    for (int k = 0; k < 3; ++k) {
      const long double exact = pivot[k] + static_cast<long double>(factor[k]) * (x[k] - pivot[k]);
      EXPECT_TRUE(within(to_fp32(image[k]), static_cast<double>(exact), half_ulp_at_1e8 + fp64_part)) << i << ", " << k;
    }
  }
}

TEST(CompositeTransform, ShearAddsTheNamedMultiples) {
  const glm::dmat4 m = CompositeTransform().shear(2, 3, 5, 7, 11, 13).matrix();
  expect_point(transform_point(m, {1, 10, 100}), {1 + 20 + 300, 5 + 10 + 700, 11 + 130 + 100}, 0, "shear");
}

TEST(CompositeTransform, InverseOfEachStepAndOfChains) {
  Random random(22);
  for (int i = 0; i < 300; ++i) {
    CompositeTransform t;
    const auto factor = [&] {
      const double size = random.in(0.25, 4);
      return std::copysign(size, random.in(-1, 1));
    };
    const auto shear_factor = [&] { return random.in(-0.4, 0.4); };
    t.translate(random.vector(10));
    expect_inverse(t);
    t.scale({factor(), factor(), factor()});
    expect_inverse(t);
    const glm::dvec3 on_axis = random.vector(5), along_axis = random.vector(5);
    t.rotate_about_axis(on_axis, along_axis, random.in(-360, 360));
    expect_inverse(t);
    const glm::dvec3 middle = random.vector(5);
    t.scale_about(middle, {factor(), factor(), factor()});
    expect_inverse(t);
    CompositeTransform sheared;
    const double xy = shear_factor(), xz = shear_factor(), yz = shear_factor(), zy = shear_factor();
    sheared.shear(xy, xz, 0.3, yz, 0, zy);
    sheared.rotate_y_degrees(random.in(-90, 90)).matrix_step(t.matrix());
    expect_inverse(sheared);
  }
}

TEST(CompositeTransform, InverseOfTheInverseIsTheOriginal) {
  CompositeTransform t;
  t.translate({1, 2, 3}).rotate_x_degrees(10).scale({3, 5, 7});
  const CompositeTransform twice = t.inverse().inverse();
  EXPECT_EQ(twice.matrix(), t.matrix());
  EXPECT_EQ(twice.to_string(), t.to_string());
}

TEST(CompositeTransform, StepWithoutInverseIsNamed) {
  CompositeTransform flat;
  flat.translate({1, 2, 3}).scale({1, 0, 1});
  expect_error([&] { flat.inverse(); }, ErrorKind::usage, "step 2, scale by (1, 0, 1), has no inverse");
  EXPECT_EQ(flat.matrix()[3], glm::dvec4(1, 0, 3, 1));
  expect_error([] { CompositeTransform().shear(1, 0, 1, 0, 0, 0).inverse(); }, ErrorKind::usage, "step 1, shear");
  expect_error([] { CompositeTransform().scale({1e-320, 1, 1}).inverse(); }, ErrorKind::usage, "step 1, scale");
  expect_error(
      [] { CompositeTransform().matrix_step(glm::dmat4(1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 0, 0, 0, 1)).inverse(); },
      ErrorKind::usage, "step 1, matrix");
}

TEST(CompositeTransform, PrintsOneLineAStep) {
  CompositeTransform t;
  t.rotate_about_axis({0, 0, 0}, {1, 0, 1}, 30).scale_about({100, 100, 30}, {0.01, 0.01, 0.01});
  EXPECT_EQ(t.to_string(),
            "1. rotate_about_axis from (0, 0, 0) to (1, 0, 1), 30 degrees\n"
            "2. scale_about point (100, 100, 30) by (0.01, 0.01, 0.01)\n");
  EXPECT_EQ(t.inverse().steps()[0].name, "inverse of scale_about");
}

TEST(CompositeTransform, AppendsAlsoToItself) {
  CompositeTransform t;
  t.translate({1, 0, 0}).append(t).append(t);
  EXPECT_EQ(t.steps().size(), 4u);
  EXPECT_EQ(t.matrix()[3], glm::dvec4(4, 0, 0, 1));
}

TEST(CompositeTransform, BadArgumentsAreErrors) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  expect_error([&] { CompositeTransform().translate({nan, 0, 0}); }, ErrorKind::usage, "translate");
  expect_error([&] { CompositeTransform().scale({1, inf, 0}); }, ErrorKind::usage, "scale");
  expect_error([&] { CompositeTransform().scale_about({1, inf, 0}, {1, 1, 1}); }, ErrorKind::usage, "scale_about");
  expect_error([&] { CompositeTransform().shear(0, 0, nan, 0, 0, 0); }, ErrorKind::usage, "shear");
  expect_error([&] { CompositeTransform().matrix_step(glm::dmat4(nan)); }, ErrorKind::usage, "matrix");
  expect_error([&] { CompositeTransform().matrix_step(glm::dmat4(2)); }, ErrorKind::usage, "0 0 0 1");
  expect_error([&] { CompositeTransform().scale_about({1e200, 0, 0}, {1e200, 1, 1}); }, ErrorKind::usage, "overflows");
  CompositeTransform huge;
  huge.scale({1e200, 1, 1}).scale({1e200, 1, 1});
  expect_error([&] { huge.matrix(); }, ErrorKind::usage, "overflows");
}

// The classic pyramid, turned by 45 degrees about x and halved. Sums of two products of numbers up to 150: 4u each.
TEST(CompositeTransform, PyramidTurnedAboutX) {
  const glm::dvec3 corners[] = {{50, 50, 30}, {150, 50, 30}, {150, 150, 30}, {50, 150, 30}, {100, 100, 100}};
  const double r = std::sqrt(2.0), bound = 2 * 4 * 150 * u64;
  const glm::dvec3 object[] = {
      {25, 5 * r, 20 * r}, {75, 5 * r, 20 * r}, {75, 30 * r, 45 * r}, {25, 30 * r, 45 * r}, {50, 0, 50 * r}};
  const glm::dvec3 axes[] = {
      {25, 20 * r, -5 * r}, {75, 20 * r, -5 * r}, {75, 45 * r, -30 * r}, {25, 45 * r, -30 * r}, {50, 50 * r, 0}};
  const glm::dvec3 half(0.5);
  const CompositeTransform turn = CompositeTransform().rotate_x_degrees(45);
  const glm::dmat4 turned = CompositeTransform(turn).scale(half).matrix();
  const glm::dmat4 axes_turned = turn.inverse().scale(half).matrix();
  for (int i = 0; i < 5; ++i) {
    expect_point(transform_point(turned, corners[i]), object[i], bound, "object, corner " + std::to_string(i));
    expect_point(transform_point(axes_turned, corners[i]), axes[i], bound, "axes, corner " + std::to_string(i));
  }
}

}  // namespace
}  // namespace morphcl
