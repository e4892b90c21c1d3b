#include "morphcl/projection.hpp"

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::infinity;
using reference::u64;
using test_support::Random;

// Tangent of two values of 1 ulp (2u relative), their quotient, and the division by the aspect; less for the others.
constexpr double entry_bound = 8 * u64;
// Worked examples are small fractions: 2 ulp of 1.
constexpr double point_bound = 4 * u64;

glm::dmat4 matrix(const Projection& projection) { return projection_matrix(projection, 1); }

void expect_image(const glm::dmat4& m, const glm::dvec3& eye_point, const glm::dvec3& ndc) {
  expect_point(transform_point(m, eye_point), ndc, point_bound, "image");
}

TEST(Frustum, GeneralWorkedExample) {
  const glm::dmat4 m = matrix(Frustum{-1, 3, -2, 1, 2, 10, Fit::stretch});
  expect_image(m, {-1, -2, -2}, {-1, -1, -1});
  expect_image(m, {3, 1, -2}, {1, 1, -1});
  expect_image(m, {15, 5, -10}, {1, 1, 1});
  expect_image(m, {1, 1, -4}, {-1.0 / 4, 2.0 / 3, 1.0 / 4});
}

// Shear before scale: with l = 0, r = 4, n = 1 the entry of z in x is 1, not 2.
TEST(Frustum, OffCentreEntry) { EXPECT_EQ(matrix(Frustum{0, 4, -1, 1, 1, 2, Fit::stretch})[2][0], 1); }

TEST(Frustum, TeapotDepths) {
  const glm::dmat4 m = matrix(Frustum{-2, 2, -2, 2, 3, 10, Fit::stretch});
  expect_image(m, {0, 0, -5}, {0, 0, 1.0 / 7});
  expect_image(m, {2, 2, -6}, {0.5, 0.5, 3.0 / 7});
  expect_image(m, {-2, 2, -7}, {-3.0 / 7, 3.0 / 7, 31.0 / 49});
  expect_image(m, {-2, -2, -8}, {-3.0 / 8, -3.0 / 8, 11.0 / 14});
  expect_image(m, {2, -2, -9}, {1.0 / 3, -1.0 / 3, 19.0 / 21});
}

TEST(Orthographic, GeneralWorkedExample) {
  const glm::dmat4 m = matrix(Orthographic{-1, 3, -2, 1, 2, 10, Fit::stretch});
  expect_image(m, {3, 1, -10}, {1, 1, 1});
  expect_image(m, {1, 1, -4}, {0, 1, -0.5});
  // The x scale is 2 / (r - l) whatever near is.
  expect_image(matrix(Orthographic{-1, 1, -1, 1, 2, 3, Fit::stretch}), {1, 0, -2}, {1, 0, -1});
}

TEST(Orthographic, TeapotDepthsWithNearBehindTheEye) {
  const glm::dmat4 m = matrix(Orthographic{-5, 5, -5, 5, -10, 10, Fit::stretch});
  expect_image(m, {0, 0, -5}, {0, 0, 0.5});
  expect_image(m, {2, 2, -6}, {0.4, 0.4, 0.6});
  expect_image(m, {-2, 2, -7}, {-0.4, 0.4, 0.7});
  expect_image(m, {-2, -2, -8}, {-0.4, -0.4, 0.8});
  expect_image(m, {2, -2, -9}, {0.4, -0.4, 0.9});
}

TEST(Orthographic, PyramidOnThePlane) {
  const glm::dmat4 m = matrix(Orthographic{0, 200, 0, 200, -200, 200, Fit::stretch});
  const glm::dvec3 corners[] = {{50, 50, 30}, {150, 50, 30}, {150, 150, 30}, {50, 150, 30}, {100, 100, 100}};
  for (const glm::dvec3& corner : corners)
    expect_image(m, corner, {corner.x / 100 - 1, corner.y / 100 - 1, -corner.z / 200});
}

// Depth runs from -1 at near to +1 at far: smaller is nearer.
TEST(Projection, DepthIsMinusOneAtNearAndOneAtFar) {
  for (const Projection& p : {Projection(Frustum{-1, 1, -1, 1, 1, 3, Fit::stretch}), Projection(Perspective{60, 1, 3}),
                              Projection(Orthographic{-1, 1, -1, 1, 1, 3, Fit::stretch})}) {
    const glm::dmat4 m = matrix(p);
    EXPECT_TRUE(within(transform_point(m, {0, 0, -1}).z, -1.0, point_bound)) << p.index();
    EXPECT_TRUE(within(transform_point(m, {0, 0, -3}).z, 1.0, point_bound)) << p.index();
    EXPECT_EQ(near_distance(p), 1);
    EXPECT_EQ(far_distance(p), 3);
    EXPECT_EQ(is_parallel(p), std::holds_alternative<Orthographic>(p));
  }
  expect_image(matrix(Frustum{-1, 1, -1, 1, 1, 3, Fit::stretch}), {0, 0, -1.5}, {0, 0, 0});
}

TEST(Perspective, AspectIsWidthOverHeight) {
  const glm::dmat4 m = projection_matrix(Perspective{90, 1, 10}, 1600.0 / 900);
  EXPECT_TRUE(within(m[0][0], 9.0 / 16, entry_bound));
  EXPECT_EQ(m[1][1], 1);
}

void expect_perspective_entries(const glm::dmat4& m, const Frustum& f, const std::string& what) {
  const auto exact = reference::frustum(f.left, f.right, f.near, f.far);
  EXPECT_TRUE(within_relative(m[0][0], exact.x_scale, entry_bound)) << what << ": x scale";
  EXPECT_TRUE(within_relative(m[2][0], exact.x_shift, entry_bound)) << what << ": x shift";
  EXPECT_TRUE(within_relative(m[2][2], exact.depth_scale, entry_bound)) << what << ": depth scale";
  EXPECT_TRUE(within_relative(m[3][2], exact.depth_offset, entry_bound)) << what << ": depth offset";
}

TEST(Frustum, RandomEntries) {
  Random random(51);
  for (int i = 0; i < 3000; ++i) {
    const double near = std::pow(10.0, random.in(-6, 6));
    const double left = random.in(-5, 5);
    const double right = left + std::pow(10.0, random.in(-9, 3));
    const double far = near * (1 + std::pow(10.0, random.in(-12, 14)));
    const Frustum f{left, right, -1, 1, near, far, Fit::stretch};
    expect_perspective_entries(matrix(f), f, "frustum " + std::to_string(i));
  }
}

TEST(Frustum, NearAndFarAtTheEndsOfTheRange) {
  for (const Frustum& f :
       {Frustum{-1, 1, -1, 1, 1e-300, 1e300, Fit::stretch}, Frustum{-1, 1, -1, 1, 1, 1e12, Fit::stretch},
        Frustum{-1, 1, -1, 1, 1e10, 1.7e308, Fit::stretch}, Frustum{-1, 1, -1, 1, 1, 1.0000000000000002, Fit::stretch}})
    expect_perspective_entries(matrix(f), f, "far " + std::to_string(f.far));
}

TEST(Perspective, RandomFieldsOfView) {
  Random random(52);
  for (int i = 0; i < 2000; ++i) {
    const double fovy = i % 2 == 0 ? random.in(1e-6, 180) : std::pow(10.0, random.in(-12, 2));
    EXPECT_TRUE(within_relative(matrix(Perspective{fovy, 1, 2})[1][1], reference::cotangent_of_half(fovy), entry_bound))
        << fovy;
  }
}

TEST(Projection, InfiniteFarPlane) {
  for (const Projection& p :
       {Projection(Frustum{-1, 1, -1, 1, 0.5, infinity, Fit::stretch}), Projection(Perspective{90, 0.5, infinity})}) {
    const glm::dmat4 m = matrix(p);
    EXPECT_EQ(m[2][2], -1);
    EXPECT_EQ(m[3][2], -1);
    EXPECT_EQ(transform_point(m, {0, 0, -0.5}).z, -1);
    EXPECT_EQ(transform_point(m, {0, 0, -1e300}).z, 1);
  }
}

TEST(ReversedDepth, ExactlyOneAtNearWithInfiniteFar) {
  for (const double near : {0.1, 1e-30, 3.3e5}) {
    const glm::dmat4 m = reversed_depth_matrix(Perspective{50, near, infinity}, 1.5);
    EXPECT_EQ(transform_point(m, {0, 0, -near}).z, 1) << near;
    // A direction, the point at infinity, has depth exactly 0.
    EXPECT_EQ((m * glm::dvec4(0, 0, -1, 0)).z, 0) << near;
  }
}

TEST(ReversedDepth, OneAtNearAndZeroAtFar) {
  for (const Projection& p :
       {Projection(Frustum{-1, 1, -1, 1, 0.3, 700, Fit::stretch}), Projection(Perspective{60, 0.3, 700}),
        Projection(Orthographic{-1, 1, -1, 1, 0.3, 700, Fit::stretch})}) {
    const glm::dmat4 m = reversed_depth_matrix(p, 1);
    EXPECT_TRUE(within(transform_point(m, {0, 0, -0.3}).z, 1.0, point_bound)) << p.index();
    EXPECT_TRUE(within(transform_point(m, {0, 0, -700}).z, 0.0, point_bound)) << p.index();
    const glm::dmat4 forward = matrix(p);
    EXPECT_EQ(m[0], forward[0]);
    EXPECT_EQ(m[1], forward[1]);
  }
}

TEST(HorizontalFieldOfView, GivesTheSameWidth) {
  Random random(53);
  EXPECT_TRUE(within_relative(fovy_from_fovx_degrees(90, 1), {90, 0}, 16 * u64));
  for (int i = 0; i < 500; ++i) {
    const double fovx = random.in(1e-3, 179.9), aspect = std::pow(10.0, random.in(-2, 2));
    // The quotient of two values of 1 ulp (4u and 2u for operations) and quadrant_angle (12u), and the conversion (2u).
    EXPECT_TRUE(
        within_relative(fovy_from_fovx_degrees(fovx, aspect), reference::fovy_from_fovx(fovx, aspect), 20 * u64))
        << fovx << " at " << aspect;
  }
}

TEST(CentralProjection, PointSeenFromTen) {
  const glm::dvec3 image = transform_point(central_projection(10), {3, 5, 7});
  EXPECT_EQ(image.x, 10);
  EXPECT_EQ(image.y, 50.0 / 3);
}

TEST(CentralProjection, PyramidSeenFromTwoHundred) {
  const glm::dvec3 corners[] = {{50, 50, 30}, {150, 50, 30}, {150, 150, 30}, {50, 150, 30}, {100, 100, 100}};
  const glm::dvec2 images[] = {{1000.0 / 17, 1000.0 / 17},
                               {3000.0 / 17, 1000.0 / 17},
                               {3000.0 / 17, 3000.0 / 17},
                               {1000.0 / 17, 3000.0 / 17},
                               {200, 200}};
  for (int i = 0; i < 5; ++i) {
    const glm::dvec3 image = transform_point(central_projection(200), corners[i]);
    EXPECT_EQ(image.x, images[i].x) << i;
    EXPECT_EQ(image.y, images[i].y) << i;
  }
}

// Equal lengths at different depths are seen 1 : 2; what lies on the board stays; order of depth is kept.
TEST(CentralProjection, ForeshortensAndKeepsTheBoard) {
  const glm::dmat4 m = central_projection(10);
  EXPECT_EQ(transform_point(m, {1, 0, 0}).x - transform_point(m, {0, 0, 0}).x, 1);
  EXPECT_EQ(transform_point(m, {1, 0, 5}).x - transform_point(m, {0, 0, 5}).x, 2);
  EXPECT_EQ(transform_point(m, {3, 4, 0}), glm::dvec3(3, 4, 0));
  EXPECT_LT(transform_point(m, {0, 0, -5}).z, transform_point(m, {0, 0, -4}).z);
  EXPECT_LE((m * glm::dvec4(0, 0, 10, 1)).w, 0);
}

TEST(Projection, DegenerateOnesAreErrorsThatNameTheParameter) {
  const double nan = std::nan("");
  const auto refuses = [](const Projection& p, const char* part) {
    expect_error([&] { validate(p); }, ErrorKind::usage, part);
    expect_error([&] { projection_matrix(p, 1); }, ErrorKind::usage, part);
  };
  for (const double fovy : {0.0, 180.0, -1.0, nan}) refuses(Perspective{fovy, 1, 2}, "fovy_degrees is");
  for (const double near : {0.0, -1.0, nan, infinity}) refuses(Perspective{45, near, 2}, "near is");
  for (const double far : {1.0, 0.5, nan, -10.0}) refuses(Perspective{45, 1, far}, "far is");
  refuses(Frustum{-10, 10, -10, 10, 10, -10, Fit::stretch}, "far is -10; it must be greater than near");
  refuses(Frustum{1, 1, -1, 1, 1, 2, Fit::stretch}, "right is");
  refuses(Frustum{nan, 1, -1, 1, 1, 2, Fit::stretch}, "left is");
  refuses(Frustum{-1, 1, 1, -1, 1, 2, Fit::stretch}, "top is");
  refuses(Frustum{-1.7e308, 1.7e308, -1, 1, 1, 2, Fit::stretch}, "right is");
  refuses(Orthographic{-1, 1, -1, 1, 2, 2, Fit::stretch}, "far is");
  refuses(Orthographic{-1, 1, -1, 1, 0, infinity, Fit::stretch}, "far is");
  refuses(Orthographic{-1, 1, -infinity, 1, 0, 1, Fit::stretch}, "bottom is");
  expect_error([] { projection_matrix(Perspective{}, 0); }, ErrorKind::usage, "aspect");
  expect_error([&] { projection_matrix(Perspective{}, nan); }, ErrorKind::usage, "aspect");
  expect_error([] { projection_matrix(Frustum{0, 1e-320, 0, 1, 1, 2, Fit::stretch}, 1); }, ErrorKind::usage,
               "overflows");
  expect_error([] { fovy_from_fovx_degrees(180, 1); }, ErrorKind::usage, "fovx_degrees");
  for (const double eye : {0.0, nan, infinity})
    expect_error([&] { central_projection(eye); }, ErrorKind::usage, "eye_z");
}

}  // namespace
}  // namespace morphcl
