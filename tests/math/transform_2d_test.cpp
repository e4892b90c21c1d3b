#include "morphcl/transform_2d.hpp"

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::infinity;
using reference::u64;
using test_support::Random;

glm::dvec2 apply(const glm::dmat3& m, const glm::dvec2& p) { return glm::dvec2(m * glm::dvec3(p, 1)); }

void expect_near(const glm::dvec2& actual, const glm::dvec2& expected, double bound, const char* what) {
  EXPECT_TRUE(within(actual.x, expected.x, bound)) << what << ": x";
  EXPECT_TRUE(within(actual.y, expected.y, bound)) << what << ": y";
}

TEST(Transform2d, QuarterTurnsAreExact) {
  const glm::dvec2 p(0.1, 1e300);
  EXPECT_EQ(apply(CompositeTransform2d().rotate_degrees(90).matrix(), p), glm::dvec2(-1e300, 0.1));
  EXPECT_EQ(apply(CompositeTransform2d().rotate_degrees(-180).matrix(), p), glm::dvec2(-0.1, -1e300));
  EXPECT_EQ(apply(CompositeTransform2d().rotate_degrees(1e12 * 360 + 270).matrix(), {1, 2}), glm::dvec2(2, -1));
  EXPECT_EQ(apply(CompositeTransform2d().rotate_about_degrees({3, 5}, 90).matrix(), {4, 5}), glm::dvec2(3, 6));
}

TEST(Transform2d, StepsApplyInTheOrderWritten) {
  CompositeTransform2d t;
  t.translate({1, 2}).scale({2, 3}).shear(0.5, 0).rotate_degrees(90);
  EXPECT_EQ(apply(t.matrix(), {0, 0}), glm::dvec2(-6, 5));
  EXPECT_EQ(t.steps().size(), 4u);
  EXPECT_EQ(t.to_string(),
            "1. translate by (1, 2)\n2. scale by (2, 3)\n3. shear xy 0.5, yx 0\n4. rotate_degrees 90 degrees\n");
}

TEST(Transform2d, PointsStayThatAreScaledOrTurnedAbout) {
  const glm::dvec2 far(1e8 + 8, -1e8);
  EXPECT_EQ(apply(CompositeTransform2d().scale_about(far, {0.5, 4}).matrix(), far), far);
  Random random(181);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec2 point{random.in(-9, 9), random.in(-9, 9)};
    const double degrees = random.in(-720, 720);
    const glm::dmat3 m = CompositeTransform2d().rotate_about_degrees(point, degrees).matrix();
    // Entries within 16u64, three products of numbers up to 9.
    expect_near(apply(m, point), point, 3 * 9 * 17 * u64, "centre");
  }
}

TEST(Transform2d, InverseUndoes) {
  Random random(182);
  for (int i = 0; i < 500; ++i) {
    const glm::dmat3 m{random.in(-5, 5), random.in(-5, 5), 0, random.in(-5, 5), random.in(-5, 5), 0,
                       random.in(-9, 9), random.in(-9, 9), 1};
    const double determinant = m[0][0] * m[1][1] - m[1][0] * m[0][1];
    const glm::dmat3 product = affine_inverse(m) * m;
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r)
        // Entries of the inverse within 4u64 of numbers up to 5 / determinant, times numbers up to 9, three of them.
        EXPECT_TRUE(
            within(product[c][r], c == r ? 1.0 : 0.0, 3 * 4 * 5 * 9 * 2 * u64 * (1 + 1 / std::abs(determinant))))
            << i;
  }
  expect_error([] { affine_inverse(glm::dmat3(1, 2, 0, 2, 4, 0, 0, 0, 1)); }, ErrorKind::usage, "no inverse");
}

// The view stands at (2, 1), turned by 90 degrees: what is to its right is up in the world.
TEST(Pipeline2d, WorldToView) {
  EXPECT_EQ(apply(world_to_view({2, 1}, 90), {2, 4}), glm::dvec2(3, 0));
  EXPECT_EQ(apply(world_to_view({2, 1}, 0), {2, 1}), glm::dvec2(0, 0));
}

TEST(Pipeline2d, WindowToNdc) {
  EXPECT_EQ(apply(view_to_ndc({-1, 3, -2, 0}), {-1, -2}), glm::dvec2(-1, -1));
  EXPECT_EQ(apply(view_to_ndc({-1, 3, -2, 0}), {3, 0}), glm::dvec2(1, 1));
  EXPECT_EQ(apply(view_to_ndc({-1, 3, -2, 0}), {1, -1}), glm::dvec2(0, 0));
}

TEST(Pipeline2d, NdcToPixelsIsTheViewports) {
  const Viewport viewport{10, 20, 640, 360};
  Random random(183);
  for (int i = 0; i < 300; ++i) {
    const glm::dvec2 ndc{random.in(-1, 1), random.in(-1, 1)};
    expect_near(apply(ndc_to_pixels(viewport), ndc), viewport.to_pixels(ndc), 4 * 650 * u64, "pixel");
  }
  EXPECT_EQ(apply(ndc_to_pixels(viewport), {-1, 1}), glm::dvec2(10, 20));
  EXPECT_FALSE(viewport.pixel_of({1, 0}));  // half-open
}

// A window of 4 x 2 on 400 x 100 pixels is widened in x: 1 unit is 50 pixels either way.
TEST(Pipeline2d, WorldToPixelsKeepsProportions) {
  const glm::dmat3 m = world_to_pixels({7, 8}, 90, {-2, 2, -1, 1}, {0, 0, 400, 100});
  EXPECT_EQ(apply(m, {7, 8}), glm::dvec2(200, 50));
  EXPECT_EQ(apply(m, {7, 9}), glm::dvec2(250, 50));
  EXPECT_EQ(apply(m, {6, 8}), glm::dvec2(200, 0));
}

TEST(Transform2d, HostileInputIsAnError) {
  const double nan = std::nan("");
  expect_error([&] { CompositeTransform2d().translate({nan, 0}); }, ErrorKind::usage, "translate");
  expect_error([&] { CompositeTransform2d().rotate_degrees(infinity); }, ErrorKind::usage, "degrees is inf");
  expect_error([&] { CompositeTransform2d().rotate_about_degrees({nan, 0}, 1); }, ErrorKind::usage, "rotate_about");
  expect_error([&] { CompositeTransform2d().scale_about({1e200, 0}, {1e200, 1}); }, ErrorKind::usage, "scale_about");
  expect_error([] { CompositeTransform2d().scale({1e200, 1}).scale({1e200, 1}).matrix(); }, ErrorKind::usage,
               "product");
  expect_error([] { view_to_ndc({1, 1, 0, 1}); }, ErrorKind::usage, "right is 1");
  expect_error([] { ndc_to_pixels({0, 0, 0, 1}); }, ErrorKind::usage, "width");
}

}  // namespace
}  // namespace morphcl
