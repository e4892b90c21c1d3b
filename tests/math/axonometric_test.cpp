#include "morphcl/camera.hpp"

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

constexpr double component_bound = 8 * u64;

void expect_orthonormal(const ViewDirection& view, const std::string& what) {
  EXPECT_TRUE(within(glm::dot(view.towards_eye, view.towards_eye), 1.0, 2 * component_bound)) << what;
  EXPECT_TRUE(within(glm::dot(view.up, view.up), 1.0, 2 * component_bound)) << what;
  EXPECT_TRUE(within(glm::dot(view.up, view.towards_eye), 0.0, 2 * component_bound)) << what;
}

TEST(Axonometric, IsometricLooksAlongTheDiagonal) {
  const ViewDirection view = view_from_ratios({1, 1, 1});
  const double third = 0.57735026918962576451, sixth = 0.40824829046386301637;
  expect_point(view.towards_eye, glm::dvec3(third), component_bound, "towards the eye");
  expect_point(view.up, {-sixth, 2 * sixth, -sixth}, component_bound, "up");
  // sqrt(2/3)
  expect_point(foreshortening(view), glm::dvec3(0.81649658092772603273), component_bound, "foreshortening");
}

// Of technical drawing: towards the eye (1, 1, sqrt 7) / 3; x and y are drawn 2 sqrt 2 / 3 as long, z half of that.
TEST(Axonometric, DimetricOfTechnicalDrawing) {
  const double root7 = 2.6457513110645905905, f = 0.94280904158206336587;
  const ViewDirection view = view_from_ratios({1, 1, 0.5});
  expect_point(view.towards_eye, {1.0 / 3, 1.0 / 3, root7 / 3}, component_bound, "towards the eye");
  expect_point(foreshortening(view), {f, f, f / 2}, component_bound, "foreshortening");
}

TEST(Axonometric, RatiosAreKeptByTheForeshortening) {
  Random random(161);
  int possible = 0;
  for (int i = 0; i < 8000; ++i) {
    const double size = std::pow(10.0, random.in(-150, 150));
    const glm::dvec3 r = size * glm::dvec3{random.in(0, 1), random.in(0, 1), random.in(0, 1)};
    const glm::dvec3 s = (r / size) * (r / size);
    const double slack = std::min({s.y + s.z - s.x, s.x + s.z - s.y, s.x + s.y - s.z});
    if (slack < 0.01) continue;
    ++possible;
    const ViewDirection view = view_from_ratios(r);
    expect_orthonormal(view, std::to_string(i));
    const glm::dvec3 f = foreshortening(view);
    EXPECT_TRUE(within(glm::dot(f, f), 2.0, 4 * component_bound)) << i;
    // Proportional, so the cross product vanishes. Squares within 4u64 are factors within 2u64 / f, and 2u64 more for
    // the root and the sum; twice, times ratios of up to 1, and three roundings.
    const double bound = (2 * (2 / std::min({f.x, f.y, f.z}) + 2) + 3) * u64;
    expect_point(glm::cross(f, r / size), glm::dvec3(0), bound, std::to_string(i));
  }
  EXPECT_GT(possible, 1000);
}

// The picture's axes, from the rows across and up, lie at the angles that were asked for.
TEST(Axonometric, AxisAnglesAreThoseOfThePicture) {
  Random random(162);
  for (int i = 0; i < 1000; ++i) {
    const double x = random.in(0.1, 89), z = random.in(0.1, 0.999) * (90 - x);
    const ViewDirection view = view_from_axis_angles(x, z);
    expect_orthonormal(view, std::to_string(i));
    const glm::dvec3 across = glm::cross(view.up, view.towards_eye);
    const auto angle_x = reference::sin_cos_degrees(x), angle_z = reference::sin_cos_degrees(z);
    // Cross products of unit vectors with components within 8u64.
    EXPECT_TRUE(within(across.x * angle_x.sin.high + view.up.x * angle_x.cos.high, 0.0, 4 * component_bound)) << i;
    EXPECT_TRUE(within(across.z * -angle_z.sin.high + view.up.z * angle_z.cos.high, 0.0, 4 * component_bound)) << i;
    EXPECT_GT(across.x, 0) << i;
    EXPECT_LT(across.z, 0) << i;
    EXPECT_TRUE(within(across.y, 0.0, component_bound)) << i;
  }
  expect_point(view_from_axis_angles(30, 30).towards_eye, glm::dvec3(0.57735026918962576451), component_bound,
               "isometric");
}

TEST(Axonometric, AnglesTurnTheEyeAboutTheObject) {
  Random random(163);
  for (int i = 0; i < 500; ++i) {
    const double azimuth = random.in(-360, 360), elevation = random.in(-90, 90);
    const ViewDirection view = view_from_angles(azimuth, elevation);
    const auto a = reference::sin_cos_degrees(azimuth), e = reference::sin_cos_degrees(elevation);
    expect_point(view.towards_eye, {a.sin.high * e.cos.high, e.sin.high, a.cos.high * e.cos.high}, component_bound,
                 "towards the eye");
    expect_point(view.up, {-a.sin.high * e.sin.high, e.cos.high, -a.cos.high * e.sin.high}, component_bound, "up");
  }
  EXPECT_EQ(view_from_angles(90, 0).towards_eye, glm::dvec3(1, 0, 0));
  EXPECT_EQ(view_from_angles(0, 90).up, view_direction(PrincipalView::top).up);
}

TEST(Axonometric, CornersMirrorTheDirection) {
  const ViewDirection view = seen_from_corner(view_from_angles(30, 20), {-1, -1, 1});
  const ViewDirection expected = view_from_angles(-30, -20);
  expect_point(view.towards_eye, expected.towards_eye, component_bound, "towards the eye");
  expect_point(view.up, expected.up, component_bound, "up");
}

TEST(Axonometric, PrincipalViewsAreTheirLimits) {
  EXPECT_EQ(view_from_ratios({1, 1, 0}).towards_eye, glm::dvec3(0, 0, 1));
  EXPECT_EQ(view_from_ratios({1, 0, 1}).up, glm::dvec3(0, 0, -1));
  const ViewDirection top = view_direction(PrincipalView::top), left = view_direction(PrincipalView::left);
  EXPECT_EQ(top.towards_eye, glm::dvec3(0, 1, 0));
  EXPECT_EQ(top.up, glm::dvec3(0, 0, -1));
  EXPECT_EQ(left.towards_eye, glm::dvec3(-1, 0, 0));
  EXPECT_EQ(left.up, glm::dvec3(0, 1, 0));
}

TEST(Axonometric, ImpossibleViewsAreErrors) {
  const double nan = std::nan("");
  for (const glm::dvec3& r : {glm::dvec3(1, 0.5, 0.5), glm::dvec3(0), glm::dvec3(1, 1, -1), glm::dvec3(nan, 1, 1),
                              glm::dvec3(1, INFINITY, 1)})
    expect_error([&] { view_from_ratios(r); }, ErrorKind::usage, "ratios are");
  for (const auto& angles : {std::pair{45.0, 45.0}, {0.0, 0.0}, {-1.0, 30.0}, {nan, 30.0}, {80.0, 20.0}})
    expect_error([&] { view_from_axis_angles(angles.first, angles.second); }, ErrorKind::usage, "axes' angles");
  for (const double e : {91.0, -90.5, nan})
    expect_error([&] { view_from_angles(0, e); }, ErrorKind::usage, "elevation");
  expect_error([&] { view_from_angles(nan, 0); }, ErrorKind::usage, "");
  expect_error([] { seen_from_corner({}, {1, 0, 1}); }, ErrorKind::usage, "corner is");
}

}  // namespace
}  // namespace morphcl
