#include "morphcl/rotation.hpp"

#include <limits>
#include <vector>

#include "morphcl/numerics.hpp"
#include "morphcl/transform.hpp"
#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

// The unit axis carries 4.5u, the versine 2u, the sine 1u; the largest sum over all axes and angles is below 16u.
constexpr double rotation_bound = 16 * u64;
// fp32 numbers below 1 are 2^-24 apart.
constexpr double fp32_bound = 0x1p-25 + rotation_bound;

glm::dmat4 about_axis(const glm::dvec3& from, const glm::dvec3& to, double degrees) {
  return CompositeTransform().rotate_about_axis(from, to, degrees).matrix();
}

void expect_rotation(const glm::dvec3& axis, double degrees, const std::string& what) {
  const glm::dmat4 computed = about_axis(glm::dvec3(0), axis, degrees);
  const reference::Affine exact = reference::rotation_about_line(glm::dvec3(0), axis, degrees);
  expect_affine(computed, exact, rotation_bound, 0, what);
  expect_affine(glm::dmat4(to_fp32(computed)), exact, fp32_bound, 0, what + " in fp32");
}

TEST(Rotation, RandomAxesOfEveryLength) {
  Random random(11);
  for (int i = 0; i < 10000; ++i) {
    glm::dvec3 axis = random.vector(1);
    if (i % 3 == 1) axis = axis * std::pow(10.0, random.in(-30, 30));
    if (i % 3 == 2) axis = axis * glm::dvec3{1, std::pow(10.0, random.in(-24, 0)), std::pow(10.0, random.in(-24, 0))};
    const double degrees = i % 5 == 0 ? random.in(-1e-4, 1e-4) : random.in(-720, 720);
    expect_rotation(axis, degrees, "axis " + std::to_string(i));
  }
}

TEST(Rotation, AdversarialAxes) {
  for (const double degrees : {40.1070456591576, 5.729577951308232e-05, 180.0, 179.99999999999997, 59.99999999999999})
    for (const glm::dvec3& axis :
         {glm::dvec3(-1, 0, 0), glm::dvec3(1e-30, 0, 0), glm::dvec3(1, 1e-24, 1e-24), glm::dvec3(1, 1e-20, 1e-20),
          glm::dvec3(1e30, 2e30, 3e30), glm::dvec3(1e-30, 2e-30, 3e-30), glm::dvec3(1e300, 1e300, -1e300),
          glm::dvec3(1e-300, -1e-300, 1e-300)})
      expect_rotation(axis, degrees, "axis of length about " + std::to_string(axis.x));
}

TEST(Rotation, AxesApartByAPowerOfTwoGiveTheSameBits) {
  Random random(12);
  for (const int exponent : {-1000, -99, 100, 1000}) {
    const glm::dvec3 axis = random.vector(1);
    const glm::dvec3 longer(std::ldexp(axis.x, exponent), std::ldexp(axis.y, exponent), std::ldexp(axis.z, exponent));
    EXPECT_EQ(about_axis(glm::dvec3(0), axis, 33), about_axis(glm::dvec3(0), longer, 33)) << "2^" << exponent;
  }
}

// Published to 20 digits for the axis (1, 2, 3) and 0.7 rad, as 32-bit numbers; the angle's conversion adds 1u.
TEST(Rotation, GenericWorkedExample) {
  const double angle = degrees(static_cast<double>(0.7f));
  const char* rows[3][3] = {{"0.78163918103815010643", "-0.48292927800094150482", "0.39473979165457763441"},
                            {"0.55011722229689531823", "0.83203013926011546648", "-0.071392500272375417065"},
                            {"-0.29395787521064691429", "0.27295633316023685729", "0.91601506963005773324"}};
  const glm::dmat4 m = about_axis(glm::dvec3(0), {1, 2, 3}, angle);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      EXPECT_TRUE(within(m[c][r], reference::decimal(rows[r][c]), rotation_bound + u64)) << r << ", " << c;
}

TEST(Rotation, HugeAndTinyAngleWorkedExamples) {
  // 1e6 rad in degrees is rounded by 1e6 u64 rad at most.
  const glm::dmat4 huge = about_axis(glm::dvec3(0), {1, 2, 3}, degrees(1e6));
  EXPECT_TRUE(within(huge[0][0], reference::decimal("0.94126983270934873073"), rotation_bound + 1e6 * u64));
  EXPECT_TRUE(within(huge[1][0], reference::decimal("0.28965450450714355204"), rotation_bound + 1e6 * u64));
  const glm::dmat4 tiny = about_axis(glm::dvec3(0), {1, 2, 3}, degrees(static_cast<double>(1e-6f)));
  EXPECT_TRUE(within(tiny[1][0], reference::decimal("-8.0178365228425914729e-7"), rotation_bound));
  EXPECT_TRUE(within(tiny[0][1], reference::decimal("8.0178379514140128306e-7"), rotation_bound));
}

TEST(Rotation, QuarterTurnsAboutCoordinateAxesAreExact) {
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const double sines[] = {0, 1, 0, -1}, cosines[] = {1, 0, -1, 0};
    const int turn = ((quarter % 4) + 4) % 4;
    const double s = sines[turn], c = cosines[turn], degrees = 90.0 * quarter;
    const glm::dmat4 x(1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1);
    const glm::dmat4 y(c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1);
    const glm::dmat4 z(c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    EXPECT_EQ(CompositeTransform().rotate_x_degrees(degrees).matrix(), x) << degrees;
    EXPECT_EQ(CompositeTransform().rotate_y_degrees(degrees).matrix(), y) << degrees;
    EXPECT_EQ(CompositeTransform().rotate_z_degrees(degrees).matrix(), z) << degrees;
    EXPECT_EQ(about_axis(glm::dvec3(0), {7, 0, 0}, degrees), x) << degrees;
    EXPECT_EQ(about_axis(glm::dvec3(0), {0, -1e-30, 0}, -degrees), y) << degrees;
    EXPECT_EQ(about_axis(glm::dvec3(0), {0, 0, 1e30}, degrees), z) << degrees;
  }
}

// Right-handed: a quarter turn about y takes z to x, about z it takes x to y.
TEST(Rotation, SignConvention) {
  expect_point(transform_point(CompositeTransform().rotate_y_degrees(90).matrix(), {0, 0, 1}), {1, 0, 0}, 0, "y");
  expect_point(transform_point(CompositeTransform().rotate_z_degrees(90).matrix(), {1, 0, 0}), {0, 1, 0}, 0, "z");
  expect_point(transform_point(CompositeTransform().rotate_x_degrees(90).matrix(), {0, 1, 0}), {0, 0, 1}, 0, "x");
}

TEST(Rotation, TinyAngleKeepsItsVersine) {
  const AxisRotation r = axis_rotation({0, 0, 1}, degrees(1e-8));
  EXPECT_TRUE(within_relative(r.identity_minus[0][0], reference::decimal("5e-17"), 16 * u64));
}

// The translation is (I - R) point: each of three products of an entry (16u) and a coordinate, two sums.
TEST(Rotation, AboutALineThroughAPoint) {
  Random random(13);
  for (int i = 0; i < 2000; ++i) {
    const double size = std::pow(10.0, random.in(-3, 8));
    const glm::dvec3 from = random.vector(size), to = from + random.vector(i % 2 == 0 ? 1 : size);
    const double degrees = random.in(-360, 360);
    expect_affine(about_axis(from, to, degrees), reference::rotation_about_line(from, to, degrees), rotation_bound,
                  (3 * 16 + 3) * u64 * size, "line " + std::to_string(i));
  }
}

TEST(Rotation, PointsOnTheLineStay) {
  const glm::dvec3 from(100, 100, 30), to(150, 100, 80);
  const glm::dmat4 m = about_axis(from, to, 77);
  // Four products with entries and coordinates up to 150, 16u each.
  expect_point(transform_point(m, from), from, 4 * 16 * 150 * u64, "from");
  expect_point(transform_point(m, to), to, 4 * 16 * 150 * u64, "to");
}

// To the origin, into the xz plane, onto z, turn, and back: each step is within 16u, its angle within 3u.
TEST(Rotation, AgreesWithTheSevenStepChain) {
  Random random(14);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 from = random.vector(10), axis = random.vector(1);
    const double degrees_about = random.in(-180, 180);
    const double shadow = std::sqrt(axis.y * axis.y + axis.z * axis.z);
    const double about_x = degrees(std::atan2(axis.y, axis.z)), about_y = degrees(std::atan2(axis.x, shadow));
    const glm::dmat4 chain = CompositeTransform()
                                 .translate(-from)
                                 .rotate_x_degrees(about_x)
                                 .rotate_y_degrees(-about_y)
                                 .rotate_z_degrees(degrees_about)
                                 .rotate_y_degrees(about_y)
                                 .rotate_x_degrees(-about_x)
                                 .translate(from)
                                 .matrix();
    const double bound = 7 * (16 + 3) * u64;
    expect_affine(chain, reference::rotation_about_line(from, from + axis, degrees_about), bound, 3 * 10 * bound,
                  "chain " + std::to_string(i));
  }
}

// Full turns composed of many small factors: three products and two sums an entry, all factors of norm 1.
TEST(Rotation, TenThousandFactors) {
  Random random(15);
  CompositeTransform chain;
  std::vector<glm::dmat4> factors;
  constexpr int count = 10000;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 axis = random.vector(1);
    chain.rotate_about_axis(glm::dvec3(0), axis, random.in(-180, 180));
    factors.push_back(chain.steps().back().matrix);
  }
  expect_affine(chain.matrix(), reference::product(factors), count * 4 * u64, 0, "product");
}

TEST(Rotation, EqualPointsAndNotFiniteAnglesAreErrors) {
  CompositeTransform t;
  expect_error([&] { t.rotate_about_axis({1, 2, 3}, {1, 2, 3}, 10); }, ErrorKind::usage, "two different points");
  expect_error([&] { t.rotate_about_axis({1, 2, 3}, {1, 2, std::nan("")}, 10); }, ErrorKind::usage, "NaN or infinite");
  expect_error([&] { t.rotate_x_degrees(std::numeric_limits<double>::infinity()); }, ErrorKind::usage,
               "rotate_x_degrees");
  EXPECT_TRUE(t.steps().empty());
}

TEST(Rotation, PointsAtTheEndsOfTheRangeGiveAnAxis) {
  const glm::dmat4 m = about_axis({-1.7e308, 0, 0}, {1.7e308, 0, 0}, 90);
  EXPECT_EQ(m[1][2], 1);
  const double min = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(about_axis(glm::dvec3(0), {0, 0, min}, 90)[0][1], 1);
}

}  // namespace
}  // namespace morphcl
