// Worked examples with known answers, as exact fractions or to more digits than fp64 has: morphcl's functions against
// them. The text of a number is "p/q" or a decimal.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "host/math/kahan.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/projection.hpp"
#include "morphcl/rotation.hpp"
#include "morphcl/transform.hpp"
#include "tests/math/check.hpp"
#include "tests/math/reference.hpp"

namespace morphcl {
namespace {

using reference::u32;
using reference::u64;

// fp64 within 2 ulp: 4u relative; where the answer is 0, of the numbers it is computed from.
void expect_value(double computed, const std::string& text, const std::string& what, double size = 0) {
  const reference::Exact exact = reference::decimal(text);
  EXPECT_TRUE(within(computed, exact, 4 * u64 * std::max(std::abs(exact.high), size))) << what << " is " << text;
}

using Text3 = std::array<const char*, 3>;
void expect_point(const glm::dvec3& computed, const Text3& expected, const std::string& what, double size = 0) {
  for (int i = 0; i < 3; ++i) expect_value(computed[i], expected[static_cast<std::size_t>(i)], what, size);
}

const glm::dvec3 pyramid[] = {{50, 50, 30}, {150, 50, 30}, {150, 150, 30}, {50, 150, 30}, {100, 100, 100}};

TEST(KnownValues, CentralProjectionOfAPoint) {
  const glm::dvec4 image = central_projection(10) * glm::dvec4(3, 5, 7, 1);
  expect_value(image.x / image.w, "10", "x");
  expect_value(image.y / image.w, "50/3", "y");
  // The homogeneous form (3, 5, 3/10) is this one divided by the eye's distance.
  expect_value(image.x / 10, "3", "X");
  expect_value(image.y / 10, "5", "Y");
  expect_value(image.w / 10, "3/10", "W");
}

TEST(KnownValues, PyramidOnThePlaneOfThePicture) {
  const glm::dmat4 m = projection_matrix(Orthographic{-1, 1, -1, 1, -200, 200, Fit::stretch}, 1);
  for (const glm::dvec3& corner : pyramid) {
    const glm::dvec4 image = m * glm::dvec4(corner, 1);
    EXPECT_EQ(image.x, corner.x);
    EXPECT_EQ(image.y, corner.y);
  }
}

TEST(KnownValues, PyramidTurnedByFortyFiveDegreesAndHalved) {
  const Text3 expected[] = {{"25", "7.071067811865475244008444", "28.28427124746190097603377"},
                            {"75", "7.071067811865475244008444", "28.28427124746190097603377"},
                            {"75", "42.42640687119285146405066", "63.63961030678927719607599"},
                            {"25", "42.42640687119285146405066", "63.63961030678927719607599"},
                            {"50", "0", "70.71067811865475244008444"}};
  const Text3 of_axes[] = {{"25", "28.28427124746190097603377", "-7.071067811865475244008444"},
                           {"75", "28.28427124746190097603377", "-7.071067811865475244008444"},
                           {"75", "63.63961030678927719607599", "-42.42640687119285146405066"},
                           {"25", "63.63961030678927719607599", "-42.42640687119285146405066"},
                           {"50", "70.71067811865475244008444", "0"}};
  const glm::dmat4 object = CompositeTransform().rotate_x_degrees(45).scale(glm::dvec3(0.5)).matrix();
  const glm::dmat4 axes = CompositeTransform().rotate_x_degrees(45).inverse().scale(glm::dvec3(0.5)).matrix();
  for (std::size_t i = 0; i < 5; ++i) {
    expect_point(transform_point(object, pyramid[i]), expected[i], "corner " + std::to_string(i), 100);
    expect_point(transform_point(axes, pyramid[i]), of_axes[i], "axes turned, corner " + std::to_string(i), 100);
  }
}

TEST(KnownValues, PyramidSeenFromTwoHundred) {
  const std::array<const char*, 2> expected[] = {
      {"1000/17", "1000/17"}, {"3000/17", "1000/17"}, {"3000/17", "3000/17"}, {"1000/17", "3000/17"}, {"200", "200"}};
  for (std::size_t i = 0; i < 5; ++i) {
    const glm::dvec3 image = transform_point(central_projection(200), pyramid[i]);
    expect_value(image.x, expected[i][0], "x");
    expect_value(image.y, expected[i][1], "y");
  }
}

TEST(KnownValues, MorphOfPyramidToBox) {
  const glm::dvec2 corners[] = {{50, 50}, {150, 50}, {150, 150}, {50, 150}};
  for (const int step : {0, 1, 37, 50, 99, 100})
    for (const glm::dvec2& corner : corners)
      for (int i = 0; i < 2; ++i) {
        const double expected = 100 + (corner[i] - 100) * step / 100;  // a multiple of 1/2
        EXPECT_EQ(static_cast<float>(lerp(100.0, corner[i], step / 100.0)), expected) << step;
      }
}

TEST(KnownValues, TeapotCentresInAFrustumAndABox) {
  const glm::dvec3 world[] = {{0, 0, 3}, {2, 2, 2}, {-2, 2, 1}, {-2, -2, 0}, {2, -2, -1}};
  const Text3 frustum[] = {{"0", "0", "1/7"},
                           {"1/2", "1/2", "3/7"},
                           {"-3/7", "3/7", "31/49"},
                           {"-3/8", "-3/8", "11/14"},
                           {"1/3", "-1/3", "19/21"}};
  const Text3 box[] = {{"0", "0", "1/2"},
                       {"2/5", "2/5", "3/5"},
                       {"-2/5", "2/5", "7/10"},
                       {"-2/5", "-2/5", "4/5"},
                       {"2/5", "-2/5", "9/10"}};
  for (std::size_t i = 0; i < 5; ++i) {
    const glm::dvec3 eye = world[i] - glm::dvec3(0, 0, 8);
    const glm::dmat4 p = projection_matrix(Frustum{-2, 2, -2, 2, 3, 10, Fit::stretch}, 1);
    const glm::dmat4 o = projection_matrix(Orthographic{-5, 5, -5, 5, -10, 10, Fit::stretch}, 1);
    expect_point(transform_point(p, eye), frustum[i], "frustum", 1);
    expect_point(transform_point(o, eye), box[i], "box", 1);
  }
}

TEST(KnownValues, CavalierAndCabinet) {
  expect_value(oblique_factor(45), "1", "cavalier");
  expect_value(degrees(arc_tangent(2, 1)), "63.43494882292201064842781", "cabinet's angle");
  expect_value(oblique_factor(63.43494882292201), "1/2", "cabinet");
}

// Row-vector matrices of a model and a camera, as columns here.
TEST(KnownValues, ModelAndCameraInThePlane) {
  glm::dmat4 model(1.0);
  model[0] = {3.0 / 25, -4.0 / 25, 0, 0};
  model[1] = {4.0 / 25, 3.0 / 25, 0, 0};
  model[3] = {3, 3, 0, 1};
  expect_point(transform_point(CompositeTransform().matrix_step(model).matrix(), {3, 4, 0}), {"4", "3", "0"}, "world");
  expect_value(glm::length(glm::dvec3(model[0])), "1/5", "length of the basis");
  // Camera at (6, 3) with axes (-1, -1) and (-1, 1): the point (4, 3).
  CompositeTransform to_world;
  glm::dmat4 axes(1.0);
  axes[0] = {-1, -1, 0, 0};
  axes[1] = {-1, 1, 0, 0};
  to_world.matrix_step(axes).translate({6, 3, 0});
  const glm::dmat4 inverse = to_world.inverse().matrix();
  expect_point(transform_point(inverse, {4, 3, 0}), {"1", "1", "0"}, "in the camera");
  const Text3 columns[] = {{"-1/2", "-1/2", "0"}, {"-1/2", "1/2", "0"}};
  for (int c = 0; c < 2; ++c) expect_point(glm::dvec3(inverse[c]), columns[c], "inverse");
  expect_point(glm::dvec3(inverse[3]), {"9/2", "3/2", "0"}, "inverse");
}

TEST(KnownValues, DepthBetweenOneAndThree) {
  const glm::dmat4 m = projection_matrix(Perspective{90, 1, 3}, 1);
  expect_value(transform_point(m, {0, 0, -1}).z, "-1", "near");
  expect_value(transform_point(m, {0, 0, -1.5}).z, "0", "middle", 1);
  expect_value(transform_point(m, {0, 0, -3}).z, "1", "far");
}

TEST(KnownValues, UnsymmetricFrustumAndBox) {
  const glm::dmat4 f = projection_matrix(Frustum{-1, 3, -2, 1, 2, 10, Fit::stretch}, 1);
  expect_point(transform_point(f, {-1, -2, -2}), {"-1", "-1", "-1"}, "lower left near", 1);
  expect_point(transform_point(f, {3, 1, -2}), {"1", "1", "-1"}, "upper right near", 1);
  expect_point(transform_point(f, {15, 5, -10}), {"1", "1", "1"}, "upper right far", 1);
  expect_point(transform_point(f, {1, 1, -4}), {"-1/4", "2/3", "1/4"}, "inside", 1);
  const glm::dmat4 o = projection_matrix(Orthographic{-1, 3, -2, 1, 2, 10, Fit::stretch}, 1);
  expect_point(transform_point(o, {3, 1, -10}), {"1", "1", "1"}, "upper right far", 1);
  expect_point(transform_point(o, {1, 1, -4}), {"0", "1", "-1/2"}, "inside", 1);
}

TEST(KnownValues, WindowWidenedToTheImage) {
  const FittedWindow fit = fitted({-2, 2, -1, 1}, Fit::widen, 400.0 / 100);
  EXPECT_EQ(fit.window.left, -4);
  EXPECT_EQ(fit.window.right, 4);
}

// y upwards in the example: rows are counted from the other side here.
TEST(KnownValues, Viewport) {
  const Viewport viewport{10, 20, 640, 480};
  const glm::dvec2 ndc[] = {{0, 0}, {1, -1}, {-0.5, 0.25}}, upwards[] = {{330, 260}, {650, 20}, {170, 320}};
  for (int i = 0; i < 3; ++i) {
    const glm::dvec2 pixels = viewport.to_pixels(ndc[i]);
    EXPECT_EQ(pixels.x, upwards[i].x);
    EXPECT_EQ(20 + (20 + 480) - pixels.y, upwards[i].y);
  }
}

TEST(KnownValues, ProjectorsAlongOneOneOne) {
  const ObliqueShear shear = oblique_shear_along({1, 1, 1});
  const glm::dvec3 p(1, 1, 1);
  EXPECT_EQ(p.x - shear.x * p.z, 0);
  EXPECT_EQ(p.y - shear.y * p.z, 0);
}

// Attributes on the image of an edge from depth 1 to depth 3: half-way in the picture.
TEST(KnownValues, PerspectiveMiddleOfAnEdge) {
  expect_value(perspective_lerp(0.0, 1.0, 1.0, 3.0, 0.5), "1/4", "attribute");
  expect_value(perspective_lerp(1.0, 1.0, 3.0, 3.0, 0.5), "3/2", "depth");
}

struct KnownRotation {
  glm::vec3 axis;
  float radians;
  std::array<Text3, 3> rows;
};

TEST(KnownValues, RotationAboutAnyAxis) {
  const KnownRotation rotations[] = {
      {{1, 2, 3},
       0.7f,
       {{{"0.78163918103815010643", "-0.48292927800094150482", "0.39473979165457763441"},
         {"0.55011722229689531823", "0.83203013926011546648", "-0.071392500272375417065"},
         {"-0.29395787521064691429", "0.27295633316023685729", "0.91601506963005773324"}}}},
      {{-1, 0, 0},
       0.7f,
       {{{"1", "0", "0"},
         {"0", "0.76484219496416165308", "0.64421767812006163143"},
         {"0", "-0.64421767812006163143", "0.76484219496416165308"}}}},
      {{1, 1e-20f, 1e-20f},
       0.7f,
       {{{"1", "-4.0905986010292196188e-21", "8.7937545524937852830e-21"},
         {"8.7937545524937852830e-21", "0.76484219496416165308", "-0.64421767812006163143"},
         {"-4.0905986010292196188e-21", "0.64421767812006163143", "0.76484219496416165308"}}}},
      {{1e30f, 2e30f, 3e30f},
       0.7f,
       {{{"0.78163918212598817721", "-0.48292926653302854077", "0.39473980353048685714"},
         {"0.55011721518033463732", "0.83203014361146774963", "-0.071392504397266736944"},
         {"-0.29395788563610550384", "0.27295634018602944354", "0.91601506419086737931"}}}},
      {{1, 2, 3},
       1e-6f,
       {{{"0.99999999999953571429", "-8.0178365228425914729e-7", "5.3452258961807674528e-7"},
         {"8.0178379514140128306e-7", "0.99999999999964285714", "-2.6726102695189686807e-7"},
         {"-5.3452237533236354162e-7", "2.6726145552332327538e-7", "0.99999999999982142857"}}}},
      {{1, 2, 3},
       1e6f,
       {{{"0.94126983270934873073", "0.28965450450714355204", "-0.17352628057454527827"},
         {"-0.27158368380232777688", "0.95482294823796056210", "0.12064592910880221756"},
         {"0.20063251163176894101", "-0.066433466994354892079", "0.97741147411898028105"}}}},
  };
  for (const KnownRotation& known : rotations) {
    const glm::dmat3 m = axis_rotation_radians(known.axis, known.radians).matrix;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        const reference::Exact exact =
            reference::decimal(known.rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)]);
        EXPECT_TRUE(within(m[c][r], exact, 4 * u64)) << known.radians << ": " << r << ", " << c;
        EXPECT_TRUE(within(static_cast<float>(m[c][r]), exact, u32)) << known.radians << ": " << r << ", " << c;
      }
  }
}

TEST(KnownValues, DifferenceOfProducts) {
  EXPECT_EQ(difference_of_products(33962.035f, -30438.8f, 41563.4f, -24871.969f), -75.1656036376953125f);
}

TEST(KnownValues, PerspectiveAttributeAtExtremeRatios) {
  struct Case {
    double w2;
    float t;
    const char* value;
  };
  for (const Case& c : {Case{1e6, 0.5f, "0.7499997500002499997500002"},
                        Case{1e6, 0.99999994f, "0.5140629451801083578052018"}, Case{1, 0.25f, "0.6875"}}) {
    const auto exact = reference::decimal(c.value);
    // 5 ulp of fp32; in fp64 the digits of the text.
    EXPECT_TRUE(within(perspective_lerp(0.75f, 1.0f, 0.5f, static_cast<float>(c.w2), c.t), exact, 5 * 0x1p-24));
    expect_value(perspective_lerp(0.75, 1.0, 0.5, c.w2, static_cast<double>(c.t)), c.value, "attribute");
  }
}

TEST(KnownValues, EdgeFunctionAcrossAHugeImage) {
  EXPECT_EQ(orientation(glm::dvec2(0, 0), {4194303, 4194302}, {4194302, 4194301}), -1);
}

TEST(KnownValues, Lerp) {
  EXPECT_EQ(lerp(-3e38f, 3e38f, 0.5f), 0);
  EXPECT_EQ(lerp(123.456f, 123.456f, 0.3f), 123.456f);
  EXPECT_NEAR(lerp(1e-40f, 2e-40f, 0.5f), 1.5e-40, 0x1p-149);
  EXPECT_NE(lerp(1e-40f, 2e-40f, 0.5f), 0);
}

}  // namespace
}  // namespace morphcl
