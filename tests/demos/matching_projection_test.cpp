#include "demos/viewer/matching_projection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <limits>

namespace morphcl::viewer {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kWide = 16.0 / 9.0;
// The planes go through the tangent of the field of view, a product or two and a division; the matrices through two
// more of each, then a product and a division of the point: below 32 roundings of 2^-53, of values up to 1.
constexpr double kNdcBound = 32 * 0x1p-53;

glm::dvec2 ndc(const Projection& projection, double aspect, const glm::dvec3& eye_point) {
  const glm::dvec4 clip = projection_matrix(projection, aspect) * glm::dvec4(eye_point, 1.0);
  return {clip.x / clip.w, clip.y / clip.w};
}

// Points of the plane `distance` in front of the eye are seen in the same place.
void expect_same_picture_at(double distance, const Projection& a, const Projection& b, double aspect) {
  EXPECT_NO_THROW(validate(a));
  EXPECT_NO_THROW(validate(b));
  for (const double x : {-0.3, 0.0, 0.2}) {
    for (const double y : {-0.25, 0.0, 0.4}) {
      const glm::dvec3 point(x * distance, y * distance, -distance);
      const glm::dvec2 from_a = ndc(a, aspect, point), from_b = ndc(b, aspect, point);
      EXPECT_NEAR(from_a.x, from_b.x, kNdcBound) << "point " << x << ' ' << y;
      EXPECT_NEAR(from_a.y, from_b.y, kNdcBound) << "point " << x << ' ' << y;
    }
  }
}

TEST(MatchingProjection, OrthographicShowsTheTargetAsPerspectiveDoes) {
  const Perspective perspective{.fovy_degrees = 45, .near = 0.1, .far = 100};
  const Orthographic matching = matching_orthographic(perspective, 6.5, kWide);
  expect_same_picture_at(6.5, perspective, matching, kWide);
  EXPECT_EQ(matching.near, 0.1);
  EXPECT_EQ(matching.far, 100);
}

TEST(MatchingProjection, OrthographicShowsTheTargetAsAnOffCentreFrustumDoes) {
  const Frustum frustum{.left = -1, .right = 3, .bottom = -0.5, .top = 2.5, .near = 2, .far = 40};
  expect_same_picture_at(5.0, frustum, matching_orthographic(frustum, 5.0, 1.0), 1.0);
}

TEST(MatchingProjection, FrustumShowsTheTargetAsOrthographicDoes) {
  const Orthographic planes{.left = -5, .right = 4, .bottom = -4, .top = 5, .near = 1, .far = 20};
  const Frustum matching = matching_frustum(planes, 8.0, 1.0);
  expect_same_picture_at(8.0, planes, matching, 1.0);
  EXPECT_EQ(matching.near, 1);
  EXPECT_EQ(matching.far, 20);
}

TEST(MatchingProjection, NearPlaneBehindTheEyeIsBroughtBeforeIt) {
  const Orthographic planes{.left = -5, .right = 5, .bottom = -5, .top = 5, .near = -10, .far = 10};
  const Frustum matching = matching_frustum(planes, 8.0, 1.0);
  expect_same_picture_at(8.0, planes, matching, 1.0);
  EXPECT_EQ(matching.near, 8.0e-3);
  EXPECT_EQ(matching.far, 10);
}

TEST(MatchingProjection, BothPlanesBehindTheEyeGiveAValidFrustum) {
  const Orthographic planes{.left = -5, .right = 5, .bottom = -5, .top = 5, .near = -10, .far = -5};
  EXPECT_NO_THROW(validate(matching_frustum(planes, 8.0, 1.0)));
}

TEST(MatchingProjection, InfiniteFarPlaneBecomesFiniteForOrthographic) {
  const Perspective perspective{.fovy_degrees = 60, .near = 0.5, .far = kInfinity};
  const Orthographic matching = matching_orthographic(perspective, 4.0, 1.0);
  EXPECT_NO_THROW(validate(matching));
  EXPECT_EQ(matching.far, 4000.0);
}

TEST(MatchingProjection, TheSameKindIsReturnedAsItIs) {
  const Orthographic planes{.left = -5, .right = 4, .bottom = -4, .top = 5, .near = -3, .far = 20};
  EXPECT_EQ(matching_orthographic(planes, 8.0, kWide).left, -5);
  EXPECT_EQ(matching_orthographic(planes, 8.0, kWide).near, -3);
  const Frustum frustum{.left = -2, .right = 2, .bottom = -2, .top = 2, .near = 3, .far = 10};
  EXPECT_EQ(matching_frustum(frustum, 8.0, kWide).right, 2);
}

TEST(WidenedProjection, FittingAspectChangesNoBit) {
  const Orthographic planes = widened(Orthographic{-5, 5, -5, 5, -10, 10}, 1.0);
  EXPECT_EQ(planes.left, -5);
  EXPECT_EQ(planes.right, 5);
  EXPECT_EQ(planes.bottom, -5);
  EXPECT_EQ(planes.top, 5);
  EXPECT_EQ(planes.near, -10);
  EXPECT_EQ(planes.far, 10);
}

TEST(WidenedProjection, WideWindowsMoveTheSidesOutwards) {
  const Orthographic planes = widened(Orthographic{-5, 5, -5, 5, -10, 10}, 2.0);
  EXPECT_EQ(planes.left, -10);
  EXPECT_EQ(planes.right, 10);
  EXPECT_EQ(planes.bottom, -5);
  EXPECT_EQ(planes.top, 5);
}

TEST(WidenedProjection, TallWindowsMoveTopAndBottomOutwards) {
  const Frustum frustum = widened(Frustum{-2, 2, -2, 2, 3, 10}, 0.5);
  EXPECT_EQ(frustum.left, -2);
  EXPECT_EQ(frustum.right, 2);
  EXPECT_EQ(frustum.bottom, -4);
  EXPECT_EQ(frustum.top, 4);
}

}  // namespace
}  // namespace morphcl::viewer
