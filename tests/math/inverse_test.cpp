#include "morphcl/transform.hpp"

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

glm::dmat4 random_affine(Random& random, double size) {
  glm::dmat4 m(1.0);
  for (int c = 0; c < 4; ++c) m[c] = glm::dvec4(random.vector(size), c == 3 ? 1 : 0);
  return m;
}

// How much of the product of the columns' lengths the determinant is; 1 for orthogonal columns.
double hadamard_ratio(const glm::dmat4& m) {
  const glm::dvec3 a(m[0]), b(m[1]), c(m[2]);
  return glm::length(a) * glm::length(b) * glm::length(c) / std::abs(glm::determinant(glm::dmat3(m)));
}

// A cofactor is within 2u, the determinant within 5u times the Hadamard ratio, the quotient within 1u.
double inverse_bound(const glm::dmat4& m) { return (3 + 5 * hadamard_ratio(m)) * u64; }

TEST(AffineInverse, RandomMaps) {
  Random random(31);
  for (int i = 0; i < 3000; ++i) {
    const glm::dmat4 m = random_affine(random, 10);
    const glm::dmat4 computed = affine_inverse(m);
    const reference::Affine exact = reference::inverse(m);
    const double bound = inverse_bound(m);
    for (int r = 0; r < 3; ++r) {
      double shift = 0;
      for (int c = 0; c < 3; ++c) {
        EXPECT_TRUE(within_relative(computed[c][r], exact[r][c], bound)) << "map " << i << ": " << r << ", " << c;
        shift += std::abs(exact[r][c].high * m[3][c]);
      }
      EXPECT_TRUE(within(computed[3][r], exact[r][3], (bound + 3 * u64) * shift)) << "map " << i << ": shift " << r;
    }
  }
}

TEST(AffineInverse, ScalesFarApart) {
  const glm::dmat4 m = CompositeTransform().scale({0x1p-900, 0x1p900, 0x1p-3}).translate({0x1p-900, 0, 5}).matrix();
  const glm::dmat4 expected = CompositeTransform().translate({-0x1p-900, 0, -5}).scale({0x1p900, 0x1p-900, 8}).matrix();
  EXPECT_EQ(affine_inverse(m), expected);
}

TEST(AffineInverse, SingularMapsAreRefused) {
  const auto with_rows = [](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    return glm::dmat4(glm::transpose(glm::dmat3(a, b, c)));
  };
  for (const glm::dmat4& m : {with_rows({1, 2, 3}, {4, 5, 6}, {7, 8, 9}), with_rows({0, 0, 0}, {0, 1, 0}, {0, 0, 1}),
                              with_rows({0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}, {0.7, 0.8, 0.9}), glm::dmat4(0.0)})
    expect_error([&] { affine_inverse(m); }, ErrorKind::usage, "no inverse");
  EXPECT_FALSE(try_affine_inverse(glm::dmat4(std::nan(""))).has_value());
  EXPECT_FALSE(try_affine_inverse(CompositeTransform().scale({1e-310, 1, 1}).matrix()).has_value());
}

TEST(RigidInverse, IsTheInverse) {
  Random random(32);
  for (int i = 0; i < 500; ++i) {
    CompositeTransform t;
    const glm::dvec3 on_axis = random.vector(3), along_axis = random.vector(3);
    t.rotate_about_axis(on_axis, along_axis, random.in(-180, 180));
    t.translate(random.vector(100));
    // The rotation is orthonormal within 2 * 16u an entry pair; the translation is up to 110 long.
    const glm::dmat4 identity = rigid_inverse(t.matrix()) * t.matrix();
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r)
        EXPECT_TRUE(within(identity[c][r], r == c ? 1.0 : 0.0, (c < 3 ? 1 : 3 * 110) * 3 * 32 * u64)) << c << ", " << r;
  }
}

// Entries are cofactors times one power of two, so all of them have the same ratio to the inverse transpose.
TEST(NormalMatrix, IsTheInverseTransposeButForAPositiveFactor) {
  Random random(33);
  constexpr double ratio_bound = 2 * 2 * u64 + 2 * u64;
  for (int i = 0; i < 2000; ++i) {
    const glm::dmat4 m = random_affine(random, std::pow(10.0, random.in(-20, 20)));
    const glm::dmat3 normals = normal_matrix(m);
    const reference::Affine inverse = reference::inverse(m);
    double largest = 0, ratio = 0;
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r)
        if (std::abs(normals[c][r]) > largest) {
          largest = std::abs(normals[c][r]);
          ratio = normals[c][r] / inverse[c][r].high;
        }
    EXPECT_TRUE(largest >= 0.5 && largest <= 1) << largest;
    EXPECT_GT(ratio, 0) << "map " << i;
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r)
        EXPECT_TRUE(within_relative(normals[c][r], reference::Exact{inverse[c][r].high * ratio, 0}, ratio_bound))
            << "map " << i << ": column " << c << ", row " << r;
  }
}

TEST(NormalMatrix, FlattenedSurfaceGetsThePlanesNormal) {
  const glm::dmat3 flat = normal_matrix(CompositeTransform().scale({3, 5, 0}).matrix());
  EXPECT_EQ(flat, glm::dmat3(0, 0, 0, 0, 0, 0, 0, 0, flat[2][2]));
  EXPECT_GE(flat[2][2], 0.5);
  EXPECT_EQ(normal_matrix(CompositeTransform().scale({3, 0, 0}).matrix()), glm::dmat3(0.0));
  EXPECT_EQ(normal_matrix(glm::dmat4(0.0)), glm::dmat3(0.0));
}

TEST(NormalMatrix, MirrorKeepsOutwardNormalsOutward) {
  const glm::dmat3 mirrored = normal_matrix(CompositeTransform().scale({-1, 1, 1}).matrix());
  EXPECT_GT((mirrored * glm::dvec3(0, 1, 0)).y, 0);
  EXPECT_LT((mirrored * glm::dvec3(1, 0, 0)).x, 0);
}

TEST(NormalMatrix, ScalesFarApart) {
  const glm::dmat3 normals = normal_matrix(CompositeTransform().scale({1e-300, 1e300, 1}).matrix());
  EXPECT_GE(normals[0][0], 0.5);
  EXPECT_EQ(normals[1][1], 0);
}

}  // namespace
}  // namespace morphcl
