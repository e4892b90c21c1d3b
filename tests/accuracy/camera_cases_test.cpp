// Catalogue of extreme cases: cameras and projections.
#include <boost/math/constants/constants.hpp>

#include "morphcl/camera.hpp"
#include "morphcl/error.hpp"
#include "morphcl/projection.hpp"
#include "morphcl/transform.hpp"
#include "tests/accuracy/demand.hpp"
#include "tests/accuracy/exact_value.hpp"
#include "tests/accuracy/naive_forms.hpp"
#include "tests/math/reference.hpp"

namespace morphcl::accuracy {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The up vector is `angle` away from the view axis; all numbers are of fp32.
TEST(ExtremeCase, LookAtWithUpNearTheView) {
  Worst stable, naive_form;
  const glm::vec3 eye(1.25f, -2.5f, 3.75f), target(0.5f, 1.0f, -2.0f);
  const glm::vec3 view = target - eye;
  const glm::dvec3 aside = glm::normalize(glm::cross(glm::dvec3(view), glm::dvec3(0.3, 0.9, 0.1)));
  for (const double angle : {1.0, 1e-2, 1e-4, 1e-5, 1e-6}) {
    // By a function of the library: GCC 12 leaves the rounding out where it converts to fp32 and back in one piece.
    const glm::vec3 up = to_fp32(glm::dvec3(view) + angle * glm::length(glm::dvec3(view)) * aside);
    const LookAt camera = look_at(eye, target, up);
    EXPECT_FALSE(camera.up_replaced) << angle;
    const auto rows = reference::look_at(eye, target, up);
    const glm::vec3 naive_across = naive::across(up, eye - target);
    for (int c = 0; c < 3; ++c) {
      for (int r = 0; r < 3; ++r) stable.add(to_fp32(camera.world_to_eye)[c][r], exact(rows[r][c]), 4 * u32);
      naive_form.add(naive_across[c], exact(rows[0][c]), 4 * u32);
    }
  }
  expect_demand(stable, naive_form);
}

// Closer than that the direction is decided by rounding: a fixed basis is used, and it is said.
TEST(ExtremeCase, LookAtWithUpAlongTheView) {
  for (const glm::dvec3& up : {glm::dvec3(0, 0, -1), glm::dvec3(0, 0, 5), glm::dvec3(1e-13, 0, 1), glm::dvec3(0.0)}) {
    const LookAt camera = look_at({0, 0, 4}, {0, 0, 0}, up);
    EXPECT_TRUE(camera.up_replaced);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(glm::length(glm::dvec3(camera.world_to_eye[c])), 1, 8 * u64) << "column " << c;
  }
  EXPECT_FALSE(look_at({0, 0, 4}, {0, 0, 0}, {1e-11, 0, 1}).up_replaced);
}

double depth_at(const glm::dmat4& m, double distance) {
  const glm::dvec4 clip = m * glm::dvec4(0, 0, -distance, 1);
  return clip.z / clip.w;
}

TEST(ExtremeCase, FrustumOfAnyRatio) {
  Worst stable, naive_form;
  for (const double near : {0.1, 1e-5, 3.0}) {
    const glm::dmat4 endless = reversed_depth_matrix(Perspective{60, near, infinity}, 1);
    stable.add_exact(depth_at(endless, near) == 1);
    stable.add_exact(endless[2][2] == 0);  // depth is near / w: exactly 0 at infinity
    for (const double ratio : {1e8, 1e12, 1e43}) {
      const glm::dmat4 m = reversed_depth_matrix(Perspective{60, near, near * ratio}, 1);
      stable.add(depth_at(m, near), 1, 2 * u64);
      stable.add(depth_at(m, near * ratio), 0, 4 * u64 / ratio);
      const auto n = static_cast<float>(near), f = static_cast<float>(near * ratio);
      if (!std::isfinite(f)) continue;
      // In its own convention, 1 at far and less before it.
      naive_form.add(naive::depth_of(-f, n, f), 1, 2 * u32);
      naive_form.add_exact(naive::depth_of(-f / 2, n, f) < naive::depth_of(-f, n, f));
    }
  }
  expect_demand(stable, naive_form);
}

TEST(ExtremeCase, FrustumPlanesNearTheLargestFloat) {
  const glm::dmat4 m = projection_matrix(Perspective{90, 1e-5, 3e38}, 1);
  EXPECT_EQ(m[3][2], -2e-5);
  EXPECT_FALSE(std::isfinite(naive::depth_of(-1e30f, 1e-5f, 3e38f))) << "2 f n overflows where the quotient would not";
}

// The shift of what lies z behind the plane, from an angle: rounding of the angle's own fp64 is all that may show.
TEST(ExtremeCase, ObliqueAngleSmall) {
  Worst stable, naive_form;
  const Real& pi = boost::math::constants::pi<Real>();
  for (const float beta : {1.0f, 1.5f, 10.0f, 45.0f, 63.43495f, 89.0f}) {
    const float z = 100;
    const Real radians = Real(beta) * pi / 180, sine = sin(radians), shift = z * cos(radians) / sine;
    const double bound = static_cast<double>(Real(4 * u32 * z * radians / (sine * sine)));
    stable.add(static_cast<float>(z * oblique_factor(beta)), shift, bound);
  }
  const Real radians = Real(1e-4f) * pi / 180;
  // At 1e-4 degrees half an ulp of the angle alone moves the picture by more than a unit.
  const double moved = static_cast<double>(Real(100 * u32 * radians / (sin(radians) * sin(radians))));
  EXPECT_GT(moved, 1);
  EXPECT_THROW(oblique_factor(1e-4), Error);
  EXPECT_THROW(oblique_shear_along({1, 1, 1e-5}), Error);
  naive_form.add(naive::oblique_shift(100, 1e-4f), 100 * cos(radians) / sin(radians), 1e-2);
  expect_demand(stable, naive_form);
}

}  // namespace
}  // namespace morphcl::accuracy
