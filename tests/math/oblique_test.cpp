#include "morphcl/projection.hpp"

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::infinity;
using reference::u64;
using test_support::Random;

TEST(Oblique, CavalierAndCabinetFactors) {
  EXPECT_EQ(oblique_factor(45), cavalier_factor);
  EXPECT_TRUE(within(oblique_factor(63.434948822922010648), cabinet_factor, 4 * u64));
  EXPECT_EQ(oblique_factor(90), 0);
  EXPECT_EQ(oblique_factor(1), max_oblique_factor);
}

// cot has a quotient of two values within 1 ulp; the shear's components one more product and value.
TEST(Oblique, ShearIsFactorTimesDirection) {
  Random random(151);
  for (int i = 0; i < 500; ++i) {
    const double direction = random.in(-360, 360), beta = random.in(1, 90);
    const auto angle = reference::sin_cos_degrees(direction);
    const auto cotangent = reference::cotangent_of_half(2 * beta);
    const ObliqueShear shear = oblique_shear(direction, oblique_factor(beta));
    const double bound = 8 * u64 * cotangent.high;
    EXPECT_TRUE(within(shear.x, cotangent.high * angle.cos.high, bound)) << direction << " " << beta;
    EXPECT_TRUE(within(shear.y, cotangent.high * angle.sin.high, bound)) << direction << " " << beta;
  }
  EXPECT_EQ(oblique_shear(90, 0.5).x, 0);
  EXPECT_EQ(oblique_shear(90, 0.5).y, 0.5);
}

// Projectors along (1, 1, 1) carry (1, 1, 1) to the origin. With the cotangent of the angle between the direction and
// the x axis, as a lecture slide has it, the point lands on (0.293, 0.293).
TEST(Oblique, FromADirection) {
  const ObliqueShear shear = oblique_shear_along({1, 1, 1});
  const glm::dmat4 m = projection_matrix(Oblique{-1, 1, -1, 1, -2, 2, shear}, 1);
  expect_point(transform_point(m, {1, 1, 1}), {0, 0, -0.5}, 0, "image");
  const ObliqueShear scaled = oblique_shear_along({-3e200, 4e200, -2e200});
  EXPECT_EQ(scaled.x, 1.5);
  EXPECT_EQ(scaled.y, -2);
}

// A unit segment straight away from the viewer is drawn at 45 degrees, in its full length or half of it; the plane
// keeps its shape and place.
TEST(Oblique, DrawsDepthAlongTheDirection) {
  const double half_root = std::sqrt(0.5);
  for (const double factor : {cavalier_factor, cabinet_factor}) {
    const glm::dmat4 m = projection_matrix(Oblique{-2, 2, -2, 2, 0, 10, oblique_shear(45, factor), 5}, 1);
    expect_point(transform_point(m, {1, -1, -5}), {0.5, -0.5, 0}, 4 * u64, "on the plane");
    expect_point(transform_point(m, {1, -1, -6}), {0.5 + factor * half_root / 2, -0.5 + factor * half_root / 2, 0.2},
                 8 * u64, "one behind it");
  }
}

TEST(Oblique, WithoutShearIsOrthographic) {
  const glm::dmat4 oblique = projection_matrix(Oblique{-1, 3, -2, 1, 2, 10, {}, 7, Fit::stretch}, 1),
                   orthographic = projection_matrix(Orthographic{-1, 3, -2, 1, 2, 10, Fit::stretch}, 1);
  EXPECT_EQ(oblique, orthographic);
}

TEST(Oblique, DegenerateOnesAreErrors) {
  const double nan = std::nan("");
  for (const double beta : {0.0, 1e-4, 0.999, 90.001, -45.0, nan})
    expect_error([&] { oblique_factor(beta); }, ErrorKind::usage, "beta_degrees is");
  for (const double factor : {-0.5, 57.3, infinity, nan})
    expect_error([&] { oblique_shear(45, factor); }, ErrorKind::usage, "factor is");
  expect_error([&] { oblique_shear(nan, 1); }, ErrorKind::usage, "");
  for (const glm::dvec3& flat : {glm::dvec3(1, 0, 0), glm::dvec3(0), glm::dvec3(58, 0, 1), glm::dvec3(nan, 0, 1)})
    expect_error([&] { oblique_shear_along(flat); }, ErrorKind::usage, "projectors' direction");
  expect_error([] { validate(Oblique{-1, 1, -1, 1, 0, 1, {60, 0}}); }, ErrorKind::usage, "oblique factor");
  expect_error([&] { validate(Oblique{-1, 1, -1, 1, 0, 1, {nan, 0}}); }, ErrorKind::usage, "oblique factor");
  expect_error([&] { validate(Oblique{-1, 1, -1, 1, 0, infinity}); }, ErrorKind::usage, "far is");
  expect_error([&] { validate(Oblique{-1, 1, -1, 1, 0, 1, {}, infinity}); }, ErrorKind::usage, "plane is");
}

}  // namespace
}  // namespace morphcl
