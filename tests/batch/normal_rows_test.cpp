// The matrix for normals: special matrices whose answer is known exactly.
#include "morphcl/batch.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "morphcl/error.hpp"

namespace morphcl {
namespace {

template <class Real>
class NormalRows : public ::testing::Test {
 protected:
  using Rows = AffineRows<Real>;

  static Rows diagonal(Real x, Real y, Real z) { return {{x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, z, 0}}; }
  static void expect(const Rows& of, const Rows& expected) {
    const Rows actual = normal_rows(of);
    EXPECT_EQ(actual.x, expected.x);
    EXPECT_EQ(actual.y, expected.y);
    EXPECT_EQ(actual.z, expected.z);
  }
};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(NormalRows, Precisions);

TYPED_TEST(NormalRows, OfTheIdentityAndATranslation) {
  this->expect({}, this->diagonal(0.5, 0.5, 0.5));
  this->expect({{1, 0, 0, 7}, {0, 1, 0, -8}, {0, 0, 1, TypeParam(1e30)}}, this->diagonal(0.5, 0.5, 0.5));
}

TYPED_TEST(NormalRows, OfAScaleIsItsInverse) {
  // 1/2, 1/4, 1/8 up to a power of two
  this->expect(this->diagonal(2, 4, 8), this->diagonal(0.5, 0.25, 0.125));
}

TYPED_TEST(NormalRows, OfAMirrorTurnsTheMirroredAxisOnly) {
  this->expect(this->diagonal(-1, 1, 1), this->diagonal(-0.5, 0.5, 0.5));
}

TYPED_TEST(NormalRows, OfAShearLeansTheOtherWay) {
  // x' = x + 2 y: the plane x = 0 becomes x - 2 y = 0.
  this->expect({{1, 2, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}, {{0.25, 0, 0, 0}, {-0.5, 0.25, 0, 0}, {0, 0, 0.25, 0}});
}

TYPED_TEST(NormalRows, OfAFlattenedSpaceHoldTheNormalOfItsPlane) {
  this->expect(this->diagonal(1, 1, 0), this->diagonal(0, 0, 0.5));
}

TYPED_TEST(NormalRows, OfALineAreZero) { this->expect({{1, 2, 3, 0}, {2, 4, 6, 0}, {-1, -2, -3, 0}}, {{}, {}, {}}); }

TYPED_TEST(NormalRows, NeitherOverflowNorVanish) {
  using Limits = std::numeric_limits<TypeParam>;
  for (const TypeParam scale : {Limits::max(), Limits::min(), 8 * Limits::denorm_min()}) {
    const auto rows = normal_rows(this->diagonal(scale, scale, scale));
    EXPECT_EQ(rows.x[0], rows.y[1]) << scale;
    EXPECT_EQ(rows.x[0], rows.z[2]) << scale;
    EXPECT_GE(rows.x[0], 0.5) << scale;
    EXPECT_LE(rows.x[0], 1) << scale;
  }
}

TYPED_TEST(NormalRows, RefuseWhatIsNotFinite) {
  using Limits = std::numeric_limits<TypeParam>;
  for (const TypeParam bad : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
    EXPECT_THROW(normal_rows(this->diagonal(1, bad, 1)), Error);
}

}  // namespace
}  // namespace morphcl
