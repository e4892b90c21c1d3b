// The matrix for normals: special matrices whose answer is known exactly.
#include "host/device/normal_rows.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "host/error.hpp"

namespace morphcl {
namespace {

void expect_rows(const AffineRows& actual, const AffineRows& expected) {
  EXPECT_EQ(actual.x, expected.x);
  EXPECT_EQ(actual.y, expected.y);
  EXPECT_EQ(actual.z, expected.z);
}

TEST(NormalRows, OfTheIdentityAndATranslation) {
  const AffineRows half{{0.5f, 0, 0, 0}, {0, 0.5f, 0, 0}, {0, 0, 0.5f, 0}};
  expect_rows(normal_rows({}), half);
  expect_rows(normal_rows({{1, 0, 0, 7}, {0, 1, 0, -8}, {0, 0, 1, 1e30f}}), half);
}

TEST(NormalRows, OfAScaleIsItsInverse) {
  // 1/2, 1/4, 1/8 up to a power of two
  expect_rows(normal_rows({{2, 0, 0, 0}, {0, 4, 0, 0}, {0, 0, 8, 0}}),
              {{0.5f, 0, 0, 0}, {0, 0.25f, 0, 0}, {0, 0, 0.125f, 0}});
}

TEST(NormalRows, OfAMirrorTurnsTheMirroredAxisOnly) {
  expect_rows(normal_rows({{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}),
              {{-0.5f, 0, 0, 0}, {0, 0.5f, 0, 0}, {0, 0, 0.5f, 0}});
}

TEST(NormalRows, OfAShearLeansTheOtherWay) {
  // x' = x + 2 y: the plane x = 0 becomes x - 2 y = 0.
  expect_rows(normal_rows({{1, 2, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}),
              {{0.25f, 0, 0, 0}, {-0.5f, 0.25f, 0, 0}, {0, 0, 0.25f, 0}});
}

TEST(NormalRows, OfAFlattenedSpaceHoldTheNormalOfItsPlane) {
  expect_rows(normal_rows({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}}), {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0.5f, 0}});
}

TEST(NormalRows, OfALineAreZero) {
  expect_rows(normal_rows({{1, 2, 3, 0}, {2, 4, 6, 0}, {-1, -2, -3, 0}}), {{}, {}, {}});
}

TEST(NormalRows, NeitherOverflowNorVanish) {
  const float huge = 3e38f, tiny = 1e-44f;
  const AffineRows half{{0.5f, 0, 0, 0}, {0, 0.5f, 0, 0}, {0, 0, 0.5f, 0}};
  for (const float scale : {huge, tiny}) {
    const AffineRows rows = normal_rows({{scale, 0, 0, 0}, {0, scale, 0, 0}, {0, 0, scale, 0}});
    EXPECT_EQ(rows.x[0], rows.y[1]) << scale;
    EXPECT_EQ(rows.x[0], rows.z[2]) << scale;
    EXPECT_GE(rows.x[0], 0.5f) << scale;
    EXPECT_LT(rows.x[0], 1.0f) << scale;
  }
  expect_rows(normal_rows({{0x1p100f, 0, 0, 0}, {0, 0x1p100f, 0, 0}, {0, 0, 0x1p100f, 0}}), half);
}

TEST(NormalRows, RefuseWhatIsNotFinite) {
  for (const float bad : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()})
    EXPECT_THROW(normal_rows({{1, 0, 0, 0}, {0, bad, 0, 0}, {0, 0, 1, 0}}), Error);
}

}  // namespace
}  // namespace morphcl
