#include "morphcl/transform.hpp"

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

// Axes within 16u, three products and two sums to take apart, as many to put together.
constexpr double decompose_bound = 3 * (16 + 16 + 6) * u64;

TEST(Decompose, PutsTogetherWhatItTookApart) {
  Random random(91);
  for (int i = 0; i < 2000; ++i) {
    glm::dmat4 m(1.0);
    const double size = std::pow(10.0, random.in(-50, 50));
    for (int c = 0; c < 4; ++c) m[c] = glm::dvec4(random.vector(size), c == 3 ? 1 : 0);
    const Decomposition parts = decompose(m);
    const glm::dmat4 whole = parts.matrix();
    double residual = 0;
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r)
        residual = std::max(residual, std::abs(whole[c][r] - m[c][r]) / glm::length(glm::dvec3(m[c])));
    EXPECT_NEAR(parts.residual, residual, 1e-6 * residual) << i;
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 3; ++r)
        EXPECT_TRUE(within(whole[c][r], m[c][r], decompose_bound * glm::length(glm::dvec3(m[c]))))
            << i << ": " << c << ", " << r;
    const glm::dmat3 identity = glm::transpose(parts.rotation) * parts.rotation;
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) EXPECT_TRUE(within(identity[c][r], c == r ? 1.0 : 0.0, decompose_bound)) << i;
    EXPECT_GT(glm::determinant(parts.rotation), 0) << i;
    EXPECT_EQ(parts.scale.z < 0, glm::determinant(glm::dmat3(m / size)) < 0) << i;
  }
}

TEST(Decompose, FindsTheParts) {
  const glm::dmat4 m = CompositeTransform()
                           .scale({2, 3, 5})
                           .shear(0.25, -0.5, 0, 0.75, 0, 0)
                           .rotate_z_degrees(90)
                           .translate({7, 8, 9})
                           .matrix();
  const Decomposition parts = decompose(m);
  expect_point(parts.translation, {7, 8, 9}, 0, "translation");
  expect_point(parts.scale, {2, 3, 5}, 5 * decompose_bound, "scale");
  expect_point(parts.shear, {0.25, -0.5, 0.75}, decompose_bound, "shear");
  expect_point(parts.rotation * glm::dvec3(1, 0, 0), {0, 1, 0}, decompose_bound, "rotation");
}

TEST(Decompose, MirrorIsInTheScaleOfZ) {
  const Decomposition parts = decompose(CompositeTransform().scale({1, 1, -4}).matrix());
  EXPECT_EQ(parts.scale, glm::dvec3(1, 1, -4));
  EXPECT_EQ(parts.rotation, glm::dmat3(1.0));
}

// The closer two axes' images are, the smaller the volume; the parts still make up the map.
TEST(Decompose, NearlySingularMapsAreMeasured) {
  EXPECT_EQ(decompose(CompositeTransform().scale({1e-100, 1, -1e100}).matrix()).volume, 1);
  for (const double gap : {1.0, 1e-3, 1e-9, 1e-14}) {
    const Decomposition parts = decompose(CompositeTransform().shear(1 / gap, 0, 0, 0, 0, 0).matrix());
    // The angle between the images of x and y is atan(gap).
    EXPECT_TRUE(within(parts.volume, gap / std::sqrt(1 + gap * gap), 8 * u64)) << gap;
    EXPECT_LE(parts.residual, decompose_bound) << gap;
    EXPECT_TRUE(within(parts.shear.x * parts.scale.y, 1 / gap, decompose_bound / gap)) << gap;
  }
  expect_error([] { decompose(CompositeTransform().shear(1e17, 0, 0, 0, 0, 0).matrix()); }, ErrorKind::usage,
               "singular");
}

TEST(Decompose, SingularAndProjectiveMapsAreErrors) {
  expect_error([] { decompose(CompositeTransform().scale({1, 0, 1}).matrix()); }, ErrorKind::usage, "singular");
  expect_error([] { decompose(glm::dmat4(2.0)); }, ErrorKind::usage, "0 0 0 1");
  expect_error([] { decompose(glm::dmat4(std::nan(""))); }, ErrorKind::usage, "finite");
}

}  // namespace
}  // namespace morphcl
