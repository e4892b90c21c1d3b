#include "morphcl/projection.hpp"

#include <limits>

#include "morphcl/camera.hpp"
#include "morphcl/transform.hpp"
#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

const Perspective lens{90, 0.1, std::numeric_limits<double>::infinity()};

VanishingPoints seen_from(const glm::dvec3& eye, const glm::dvec3& target) {
  return vanishing_points(lens, 1, look_at(eye, target, {0, 1, 0}).world_to_eye);
}

// Looking along an axis, its lines meet in the middle, and the others stay parallel.
TEST(VanishingPoints, OneAlongAnAxis) {
  const VanishingPoints points = seen_from({3, 4, 10}, {3, 4, 0});
  EXPECT_EQ(count(points), 1);
  EXPECT_EQ(*points[2], glm::dvec2(0, 0));
  EXPECT_EQ(count(seen_from({-5, 1, 1}, {0, 1, 1})), 1);
}

// At 45 degrees to x and z, upright: they meet on the horizon, 1 (tan 45) to the right and the left.
TEST(VanishingPoints, TwoOnTheHorizon) {
  const VanishingPoints points = seen_from({5, 2, 5}, {0, 2, 0});
  ASSERT_EQ(count(points), 2);
  EXPECT_FALSE(points[1]);
  EXPECT_TRUE(within(points[0]->x, -1.0, 64 * u64));
  EXPECT_TRUE(within(points[0]->y, 0.0, 64 * u64));
  EXPECT_TRUE(within(points[2]->x, 1.0, 64 * u64));
  EXPECT_TRUE(within(points[2]->y, 0.0, 64 * u64));
}

// From (5, 5, 5) the three are 120 degrees apart around the middle: sqrt 2 away, as the axes lean by tan = sqrt 2 from
// the view.
TEST(VanishingPoints, ThreeFromACorner) {
  const VanishingPoints points = seen_from({5, 5, 5}, {0, 0, 0});
  ASSERT_EQ(count(points), 3);
  for (const auto& point : points) EXPECT_TRUE(within(glm::dot(*point, *point), 2.0, 256 * u64));
  EXPECT_LT(points[1]->y, 0);  // verticals meet below the picture's middle when one looks down
  EXPECT_TRUE(within(points[1]->x, 0.0, 64 * u64));
}

// A shifted window shifts the points; the projection of a far point comes close to them.
TEST(VanishingPoints, AreWhereFarPointsAre) {
  Random random(191);
  for (int i = 0; i < 500; ++i) {
    const double left = random.in(-2, 1), bottom = random.in(-2, 1);
    const Frustum frustum{left, left + random.in(0.5, 2), bottom, bottom + random.in(0.5, 2), 1, 9};
    const glm::dvec3 eye = random.vector(5), target = random.vector(5), up = random.vector(1);
    const glm::dmat4 to_eye = look_at(eye, target, up).world_to_eye;
    const glm::dmat4 to_ndc = projection_matrix(frustum, 1) * to_eye;
    const VanishingPoints points = vanishing_points(frustum, 1, to_eye);
    for (int axis = 0; axis < 3; ++axis) {
      if (!points[axis] || std::abs(to_eye[axis].z) < 0.01) continue;
      glm::dvec3 far(0.0);
      far[axis] = 1e12;
      const glm::dvec3 image = transform_point(to_ndc, far);
      // What lies 10 beside a line of length 1e12 that leans by 0.01 is seen less than 1e-6 beside its end.
      EXPECT_NEAR(image.x, points[axis]->x, 1e-6) << i;
      EXPECT_NEAR(image.y, points[axis]->y, 1e-6) << i;
    }
  }
}

TEST(VanishingPoints, NoneInParallelProjections) {
  const glm::dmat4 turned = look_at({5, 5, 5}, {0, 0, 0}, {0, 1, 0}).world_to_eye;
  EXPECT_EQ(count(vanishing_points(Orthographic{}, 1, turned)), 0);
  EXPECT_EQ(count(vanishing_points(Oblique{-1, 1, -1, 1, 0, 1, {0.5, 0.5}}, 1, turned)), 0);
}

// A right angle that rounding has spoiled is one; a billionth of a degree is not.
TEST(VanishingPoints, RoundedRightAnglesCount) {
  const auto leaning = [](double degrees) {
    return count(vanishing_points(lens, 1, CompositeTransform().rotate_y_degrees(degrees).matrix()));
  };
  EXPECT_EQ(leaning(1e-13), 1);
  EXPECT_EQ(leaning(1e-9), 2);
}

}  // namespace
}  // namespace morphcl
