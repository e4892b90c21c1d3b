// docs/errata.md, line by line: what the printed formula gives for the counter-example, and what morphcl gives.
#include <gtest/gtest.h>

#include "morphcl/camera.hpp"
#include "morphcl/error.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/projection.hpp"
#include "morphcl/rotation.hpp"
#include "morphcl/solids.hpp"
#include "morphcl/track.hpp"

namespace morphcl {
namespace {

constexpr double few_ulps = 1e-15;

glm::dvec3 image(const glm::dmat4& m, const glm::dvec3& p) {
  const glm::dvec4 clip = m * glm::dvec4(p, 1);
  return glm::dvec3(clip) / clip.w;
}

TEST(Errata, W1_OrthographicScaleHasNoNear) {
  const double left = -1, right = 1, near = 2, x = 1;
  EXPECT_EQ(2 * near / (right - left) * x, 2);
  EXPECT_EQ(image(projection_matrix(Orthographic{left, right, -1, 1, near, 10, Fit::stretch}, 1), {x, 0, -3}).x, 1);
}

TEST(Errata, W2_BackFromThePicture) {
  const double x = 2, z = -4, e = 1;
  const double p = image(projection_matrix(Frustum{-1, 1, -1, 1, e, 100, Fit::stretch}, 1), {x, 0, z}).x;
  EXPECT_EQ(p, 0.5);
  EXPECT_EQ(-(p * e) / z, 1.0 / 8);
  EXPECT_EQ(-p * z / e, x);
}

TEST(Errata, W3_ProportionsOfTheWindow) {
  const double left = -1, right = 3, x = 1;
  EXPECT_EQ(2 * (x + 1) / (right - left), 1);
  EXPECT_EQ(image(projection_matrix(Frustum{left, right, -1, 1, 1, 100, Fit::stretch}, 1), {x, 0, -1}).x, 0);
}

TEST(Errata, W4_ClipSpaceIsNoCube) {
  const glm::dvec4 clip = projection_matrix(Frustum{-1, 1, -1, 1, 1, 100, Fit::stretch}, 1) * glm::dvec4(3, 0, -4, 1);
  EXPECT_GT(clip.x, 1) << "outside the cube of +-1";
  EXPECT_LE(clip.x, clip.w) << "and yet in the picture";
}

TEST(Errata, W5_WidenedWindow) {
  const double ymax = 1, k = 2;
  EXPECT_EQ(ymax + k, 3);
  EXPECT_EQ(fitted({-2, 2, -1, ymax}, Fit::widen, 400.0 / 100).window.right, 4);
}

TEST(Errata, W6_WhatPerspectiveMapsToTheCube) {
  const glm::dmat4 m = projection_matrix(Frustum{-1, 1, -1, 1, 1, 10, Fit::stretch}, 1);
  EXPECT_NEAR(image(m, {1, 1, -10}).x, 0.1, few_ulps) << "the far corner of a cuboid";
  EXPECT_NEAR(image(m, {10, 10, -10}).x, 1, few_ulps) << "the far corner of the frustum";
}

TEST(Errata, W7_BasisVectorsAreColumns) {
  const glm::dvec3 u(0, 1, 0), v(-1, 0, 0), w(0, 0, 1), point(1, 0, 0);
  EXPECT_EQ(glm::dvec3(glm::dot(u, point), glm::dot(v, point), glm::dot(w, point)), glm::dvec3(0, -1, 0));
  const LookAt camera = look_at({0, 0, 0}, -w, v);
  EXPECT_EQ(glm::dvec3(camera.eye_to_world * glm::dvec4(point, 1)), glm::dvec3(0, 1, 0));
}

TEST(Errata, W8_CentreOfTheDepthRange) {
  const double near = 1, far = 3, w = -1, scale = -2 / (far - near);
  EXPECT_EQ(scale * (w - (near + far) / 2), 3);
  EXPECT_EQ(image(projection_matrix(Orthographic{-1, 1, -1, 1, near, far, Fit::stretch}, 1), {0, 0, w}).z, -1);
}

TEST(Errata, W9_ShearBeforeScale) {
  const double left = 0, right = 4, near = 1;
  const double shear = (left + right) / (2 * near);
  EXPECT_EQ(shear, 2) << "entry (1, 3) of H S";
  EXPECT_EQ(projection_matrix(Frustum{left, right, -1, 1, near, 10, Fit::stretch}, 1)[2][0], 1);
}

TEST(Errata, W10_ShearOfAnObliqueProjection) {
  const double cotangent = 1 / std::sqrt(2.0);  // of the angle between (1, 1, 1) and u: cos = 1/sqrt 3
  EXPECT_NEAR(1 - cotangent, 0.2928932188134525, few_ulps);
  const ObliqueShear shear = oblique_shear_along({1, 1, 1});
  EXPECT_EQ(1 - shear.x, 0);
  EXPECT_EQ(1 - shear.y, 0);
}

TEST(Errata, W11_DepthOrderReverses) {
  const glm::dmat4 m = projection_matrix(Perspective{90, 1, 3}, 1);
  const double nearer = image(m, {0, 0, -1}).z, farther = image(m, {0, 0, -3}).z;
  EXPECT_NEAR(nearer, -1, few_ulps);
  EXPECT_NEAR(farther, 1, few_ulps);
  EXPECT_LT(nearer, farther) << "although -1 > -3";
}

TEST(Errata, W12_TheFrameIsRightHanded) {
  const glm::dmat3 axes(look_at({1, 2, 3}, {-2, 0, 1}, {0, 1, 0}).eye_to_world);
  EXPECT_NEAR(glm::dot(glm::cross(axes[0], axes[1]), axes[2]), 1, few_ulps);
}

TEST(Errata, W13_FieldOfViewAndItsCotangent) {
  const double theta = 1.5707963267948966;  // printed as the scale
  EXPECT_GT(theta, 1.5);
  EXPECT_EQ(projection_matrix(Perspective{90, 1, 3}, 1)[1][1], 1);
}

TEST(Errata, W14_CavalierKeepsLengths) {
  const ObliqueShear shear = oblique_shear(30, cavalier_factor);
  EXPECT_NE(std::hypot(shear.x, shear.y), 0) << "the printed factor";
  EXPECT_NEAR(std::hypot(shear.x, shear.y), 1, few_ulps);
}

TEST(Errata, W15_PerspectiveKeepsNoProportions) {
  const glm::dmat4 m = central_projection(10);
  const double on_the_board = image(m, {1, 0, 0}).x, before_it = image(m, {1, 0, 5}).x;
  EXPECT_EQ(on_the_board, 1);
  EXPECT_EQ(before_it, 2);
}

TEST(Errata, W16_TheTargetIsABox) {
  glm::vec3 low(1e9f), high(-1e9f);
  const Mesh solid = make_solid("pyramid_to_cube");
  for (const glm::vec3& p : solid.targets.at(0).positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  EXPECT_EQ(high - low, glm::vec3(100, 100, 70)) << "neither a square nor a cube";
}

TEST(Errata, W17_StepsThatAddUp) {
  float t = 0;
  int presses = 0;
  for (; t < 1.0; ++presses) {
    t = static_cast<float>(t + 0.01);
    if (presses + 1 == 100) {
      EXPECT_EQ(t, 0.999999344348907470703125f);
    }
  }
  EXPECT_EQ(presses, 101);
  EXPECT_EQ(t, 1.00999939441680908203125f) << "beyond the target";
  for (presses = 0; t > 0.0; ++presses) t = static_cast<float>(t - 0.01);
  EXPECT_EQ(presses, 102);
  EXPECT_EQ(t, -0.00999993644654750823974609375f);
  const Track growing({Interpolation::linear, 1, false, 25'000'000, {0, 100'000'000}, {0, 1}});
  for (int step = 0; step <= 103; ++step) {
    double value = 0;
    growing.evaluate(step * std::int64_t{1'000'000}, &value);
    EXPECT_EQ(value, std::min(step, 100) / 100.0) << step;
  }
}

TEST(Errata, W18_FarMustBePositive) {
  const double near = 10, far = -10, z = -30;
  EXPECT_NEAR((-(far + near) / (far - near) * z + -2 * far * near / (far - near)) / -z, -1.0 / 3, few_ulps);
  EXPECT_THROW(projection_matrix(Frustum{-10, 10, -10, 10, near, far, Fit::stretch}, 1), Error);
}

TEST(Errata, W19_TheCameraIsNotAddedUp) {
  const glm::dmat4 view = look_at({0, 0, 8}, {0, 0, 0}, {0, 1, 0}).world_to_eye;
  EXPECT_EQ((view * view)[3].z, -16) << "set twice without a reset";
  EXPECT_EQ(look_at({0, 0, 8}, {0, 0, 0}, {0, 1, 0}).world_to_eye, view);
}

TEST(Errata, W20_ATurnHasSevenHundredAndTwentyHalfDegrees) {
  double angle = 0;
  int poses = 0;
  do {
    angle += 0.5;
    if (angle > 360) angle = 0;
    ++poses;
  } while (angle != 0);
  EXPECT_EQ(poses, 721) << "360 and 0 are both drawn";
  EXPECT_EQ(sin_cos_degrees(360).sin, sin_cos_degrees(0).sin);
  EXPECT_EQ(sin_cos_degrees(360).cos, sin_cos_degrees(0).cos);
  EXPECT_EQ((719 + 1) % 720, 0);
}

TEST(Errata, W21_SignOfTheDepthOffset) {
  const double front = 1, back = 3, z = 1;
  EXPECT_EQ((front + back) / (back - front) * z + 2 * front * back / (back - front), 5);
  EXPECT_NEAR(image(projection_matrix(Perspective{90, front, back}, 1), {0, 0, -z}).z, -1, few_ulps);
}

TEST(Errata, W22_AspectIsWidthOverHeight) {
  const double printed = 1 / (900.0 / 1600);
  EXPECT_NEAR(printed, 16.0 / 9, few_ulps);
  EXPECT_NEAR(projection_matrix(Perspective{90, 1, 3}, 1600.0 / 900)[0][0], 9.0 / 16, few_ulps);
}

TEST(Errata, W23_RangeOfTheDepthBuffer) {
  const Perspective p{90, 1, 3};
  EXPECT_LT(image(projection_matrix(p, 1), {0, 0, -1}).z, 0) << "not in [0, 1]";
  const glm::dmat4 m = reversed_depth_matrix(p, 1);
  EXPECT_NEAR(image(m, {0, 0, -1}).z, 1, few_ulps);
  EXPECT_NEAR(image(m, {0, 0, -3}).z, 0, few_ulps);
}

TEST(Errata, W24_AxesOfACameraAreUnitVectors) {
  EXPECT_NE(glm::length(glm::dvec2(-1, -1)), 1) << "lengths are scaled by 1 / sqrt 2";
  const LookAt camera = look_at({6, 0, 3}, {4, 0, 1}, {0, 2, 0});
  const glm::dvec3 moved(camera.world_to_eye * glm::dvec4(3, 4, 12, 0));
  EXPECT_NEAR(glm::length(moved), 13, 13 * few_ulps);
}

TEST(Errata, W25_ATriangleStaysATriangleOnlyBeforeTheEye) {
  const glm::dvec4 before(1, 0, 0, 1), behind(1, 0, 0, -0.5);
  const glm::dvec4 between = 0.75 * before + 0.25 * behind;
  const double a = before.x / before.w, b = behind.x / behind.w, c = between.x / between.w;
  EXPECT_GT(c, std::max(a, b)) << "the image of a point between the two lies beside their images";
}

TEST(Errata, TrapRotationAboutY) {
  // Printed for -90 degrees beside +90 about x and z.
  EXPECT_EQ(axis_rotation({0, 1, 0}, 90).matrix * glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0));
  EXPECT_EQ(axis_rotation({0, 1, 0}, -90).matrix * glm::dvec3(0, 0, 1), glm::dvec3(-1, 0, 0));
}

TEST(Errata, TrapObjectOrAxesAreTurned) {
  const glm::dmat3 object = axis_rotation({0, 0, 1}, 90).matrix;
  EXPECT_EQ(object * glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0));
  EXPECT_EQ(glm::transpose(object) * glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0));
}

TEST(Errata, TrapUpVectorNeedsAUnitNormal) {
  const glm::dvec3 n(0, 0, 2), up(0, 1, 1);
  EXPECT_EQ(up - glm::dot(up, n) * n, glm::dvec3(0, 1, -3));
  const LookAt camera = look_along({0, 0, 0}, -n, up);
  EXPECT_EQ(glm::dvec3(camera.eye_to_world[1]), glm::dvec3(0, 1, 0));
}

TEST(Errata, TrapHorizontalOrVerticalFieldOfView) {
  const glm::dmat4 across = projection_matrix(HorizontalPerspective{90, 1, 3}, 2),
                   up = projection_matrix(Perspective{90, 1, 3}, 2);
  EXPECT_NEAR(across[0][0], 1, few_ulps);
  EXPECT_NEAR(across[1][1], 2, 2 * few_ulps);
  EXPECT_NEAR(up[0][0], 0.5, few_ulps);
  EXPECT_NEAR(up[1][1], 1, few_ulps);
}

TEST(Errata, TrapQuotientsOfDepths) {
  const double z1 = 2, z2 = 2, z3 = 2;
  EXPECT_TRUE(std::isnan((z3 - z1) / (z2 - z1)));
  EXPECT_EQ(perspective_lerp(1.0, z1, 3.0, z2, 0.5), 2);
}

TEST(Errata, TrapRightEdgeOfTheViewport) {
  const Viewport viewport{0, 0, 640, 480};
  EXPECT_EQ(viewport.to_pixels({1, 0}).x, 640) << "one past the last pixel";
  EXPECT_FALSE(viewport.pixel_of({1, 0}));
}

TEST(Errata, TrapSumOfAnglesOnTheBoundary) {
  const std::vector<glm::dvec2> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, clockwise(square.rbegin(), square.rend());
  EXPECT_EQ(place_in_polygon(square, {2, 1}), PointPlace::boundary);
  EXPECT_EQ(place_in_polygon(square, {2, 2}), PointPlace::boundary);
  EXPECT_EQ(place_in_polygon(square, {1, 1}), PointPlace::inside);
  EXPECT_EQ(place_in_polygon(clockwise, {1, 1}), PointPlace::inside) << "the sum is -2 pi";
}

}  // namespace
}  // namespace morphcl
