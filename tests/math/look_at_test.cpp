#include "morphcl/camera.hpp"

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

// x axis: Kahan cross 2u, its low part 1u, normalisation 3.5u; z axis 4.5u; their cross product adds up and 2u more.
constexpr double axis_bound = 16 * u64;

// Shift: three products of an axis (16u) with the eye, and two sums.
void expect_look_at(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up, const std::string& what) {
  const LookAt view = look_at(eye, target, up);
  const double shift_bound = (16 + 3) * u64 * (std::abs(eye.x) + std::abs(eye.y) + std::abs(eye.z));
  EXPECT_FALSE(view.up_replaced) << what;
  expect_affine(view.world_to_eye, reference::look_at(eye, target, up), axis_bound, shift_bound, what);
}

void expect_rigid_pair(const LookAt& view, const std::string& what) {
  const glm::dmat4 identity = view.world_to_eye * view.eye_to_world;
  const double size = glm::length(glm::dvec3(view.eye_to_world[3])) + 1;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      EXPECT_TRUE(within(identity[c][r], r == c ? 1.0 : 0.0, 6 * axis_bound * size)) << what << ": " << c << ", " << r;
}

TEST(LookAt, RandomCameras) {
  Random random(41);
  for (int i = 0; i < 3000; ++i) {
    const double size = std::pow(10.0, random.in(-20, 20));
    const glm::dvec3 eye = random.vector(size), target = random.vector(size), up = random.vector(1e-5);
    expect_look_at(eye, target, up, "camera " + std::to_string(i));
    expect_rigid_pair(look_at(eye / size, target / size, up), "camera " + std::to_string(i));
  }
}

// Eye minus target is not exact here: where up is almost parallel to it, what its rounding loses decides the answer.
TEST(LookAt, UpNearlyAlongTheView) {
  Random random(42);
  for (int i = 0; i < 3000; ++i) {
    const glm::dvec3 eye = random.vector(1e3), target = random.vector(1), view = eye - target;
    const glm::dvec3 across = glm::normalize(glm::cross(view, random.vector(1))) * glm::length(view);
    const double angle = std::pow(10.0, random.in(-11.5, 0));
    expect_look_at(eye, target, 2.0 * view + 2 * angle * across, "camera " + std::to_string(i));
  }
}

TEST(LookAt, ViewOfTheTeapots) {
  const LookAt view = look_at({0, 0, 8}, {0, 0, 0}, {0, 1, 0});
  const glm::dvec3 world[] = {{0, 0, 3}, {2, 2, 2}, {-2, 2, 1}, {-2, -2, 0}, {2, -2, -1}};
  const glm::dvec3 eye[] = {{0, 0, -5}, {2, 2, -6}, {-2, 2, -7}, {-2, -2, -8}, {2, -2, -9}};
  for (int i = 0; i < 5; ++i)
    expect_point(transform_point(view.world_to_eye, world[i]), eye[i], 0, "teapot " + std::to_string(i));
  EXPECT_EQ(view.eye_to_world[3], glm::dvec4(0, 0, 8, 1));
}

// The camera's axes are the columns of eye -> world: its x axis here is the world's y.
TEST(LookAt, AxesAreColumns) {
  const LookAt view = look_at({0, 0, 0}, {0, 0, -1}, {-1, 0, 0});
  EXPECT_EQ(glm::dvec3(view.eye_to_world * glm::dvec4(1, 0, 0, 0)), glm::dvec3(0, 1, 0));
  EXPECT_EQ(glm::dvec3(view.eye_to_world * glm::dvec4(0, 1, 0, 0)), glm::dvec3(-1, 0, 0));
}

TEST(LookAt, UpAlongTheViewIsReplacedAndReported) {
  for (const glm::dvec3& up : {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -5), glm::dvec3(0), glm::dvec3(1e-14, 0, 1)}) {
    const LookAt view = look_at({0, 0, 5}, {0, 0, 0}, up);
    EXPECT_TRUE(view.up_replaced);
    // x is the world axis least aligned with z (ties: x first), taken as up.
    EXPECT_EQ(view.eye_to_world[1], glm::dvec4(1, 0, 0, 0));
    EXPECT_EQ(view.eye_to_world[2], glm::dvec4(0, 0, 1, 0));
    expect_rigid_pair(view, "replaced");
  }
  EXPECT_FALSE(look_at({0, 0, 5}, {0, 0, 0}, {1e-11, 0, 1}).up_replaced);
  EXPECT_TRUE(look_at({5, 0, 0}, {0, 0, 0}, {1, 0, 0}).up_replaced);
  EXPECT_EQ(look_at({5, 0, 0}, {0, 0, 0}, {1, 0, 0}).eye_to_world[1], glm::dvec4(0, 1, 0, 0));
}

TEST(LookAt, ExtremeSizes) {
  EXPECT_EQ(look_at({0, 0, 1e300}, {0, 0, -1e300}, {0, 1e-300, 0}).world_to_eye[3], glm::dvec4(0, 0, -1e300, 1));
  EXPECT_EQ(look_at({0, 0, 1.7e308}, {0, 0, -1.7e308}, {0, 1, 0}).eye_to_world[2], glm::dvec4(0, 0, 1, 0));
  EXPECT_EQ(look_at({0, 0, 5e-324}, {0, 0, 0}, {0, 5e-324, 0}).eye_to_world[1], glm::dvec4(0, 1, 0, 0));
}

TEST(LookAlong, IsLookAtWithADirection) {
  const glm::dvec3 eye(3, 2.4, 5.1), target(0.25, -1, 0.5);
  EXPECT_EQ(look_along({0, 0, 0}, target, {0, 1, 0}).world_to_eye, look_at({0, 0, 0}, target, {0, 1, 0}).world_to_eye);
  EXPECT_EQ(look_along(eye, {0, 0, -4}, {0, 2, 0}).eye_to_world[2], glm::dvec4(0, 0, 1, 0));
}

TEST(LookAt, DegenerateCamerasAreErrors) {
  const double nan = std::nan("");
  expect_error([] { look_at({1, 2, 3}, {1, 2, 3}, {0, 1, 0}); }, ErrorKind::usage, "both (1, 2, 3)");
  expect_error([&] { look_at({nan, 2, 3}, {1, 2, 3}, {0, 1, 0}); }, ErrorKind::usage, "eye is NaN");
  expect_error([&] { look_at({1, 2, 3}, {1, nan, 3}, {0, 1, 0}); }, ErrorKind::usage, "target is NaN");
  expect_error([&] { look_at({1, 2, 3}, {0, 2, 3}, {0, nan, 0}); }, ErrorKind::usage, "up is NaN");
  expect_error([] { look_along({1, 2, 3}, {0, 0, 0}, {0, 1, 0}); }, ErrorKind::usage, "direction is 0");
}

}  // namespace
}  // namespace morphcl
