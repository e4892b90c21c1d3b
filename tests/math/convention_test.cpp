#include "morphcl/convention.hpp"

#include <array>
#include <bit>
#include <cstdint>

#include "morphcl/projection.hpp"
#include "morphcl/transform.hpp"
#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::infinity;
using reference::u64;
using test_support::Random;

constexpr std::pair<const char*, Convention> conventions[] = {
    {"column_right_handed", column_right_handed},
    {"row_right_handed", row_right_handed},
    {"row_left_handed", row_left_handed},
    {"row_left_handed_zero_to_one", row_left_handed_zero_to_one},
    {"column_right_handed_zero_to_one", column_right_handed_zero_to_one}};

using Bits = std::array<std::uint64_t, 16>;
bool same_bits(const glm::dmat4& a, const glm::dmat4& b) { return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b); }

TEST(Convention, ThereAndBackRestoresEachBit) {
  Random random(171);
  for (int i = 0; i < 20000; ++i) {
    glm::dmat4 m;
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) {
        m[c][r] = i % 2 ? 1 : std::pow(2.0, random.in(-60, 60));
        m[c][r] *= random.in(-1, 1);
        if (random.in(0, 1) < 0.2) m[c][r] = random.in(0, 1) < 0.5 ? -0.0 : 0.0;
        if (random.in(0, 1) < 0.1) m[c][r] = -1;
      }
    for (const auto& [name, convention] : conventions) {
      EXPECT_TRUE(same_bits(transform_from(convention, transform_to(convention, m)), m)) << name << " " << i;
      // A sum that is 0 does not say which sign a 0 had.
      const glm::dmat4 plain = m + 0.0;
      EXPECT_TRUE(same_bits(projection_from(convention, projection_to(convention, plain)) + 0.0, plain))
          << name << " " << i;
    }
  }
}

TEST(Convention, ThereAndBackRestoresProjections) {
  for (const Projection& p :
       {Projection(Perspective{45, 0.1, 100}), Projection(Perspective{45, 1e-6, 1e6}),
        Projection(Perspective{90, 0.3, infinity}), Projection(Frustum{-1, 3, -2, 1, 2, 10, Fit::stretch}),
        Projection(Orthographic{-0.3, 7, 1, 5, -3, 99, Fit::stretch}),
        Projection(Oblique{-1, 1, -1, 1, 0, 7, {0.3, 0.4}, 5})}) {
    const glm::dmat4 own = projection_matrix(p, 1.5);
    for (const auto& [name, convention] : conventions)
      EXPECT_TRUE(same_bits(projection_from(convention, projection_to(convention, own)) + 0.0, own + 0.0))
          << name << " " << p.index();
  }
}

// Half the sum of two rows rounds: without the rest, a bit of the depth row is lost.
TEST(Convention, TheRestIsNeeded) {
  int lost = 0;
  for (int far = 100; far < 120; ++far) {
    const glm::dmat4 own = projection_matrix(Perspective{45, 0.1, 1.0 * far}, 1);
    ForeignProjection there = projection_to(column_right_handed_zero_to_one, own);
    there.depth_rest = glm::dvec4(0);
    lost += projection_from(column_right_handed_zero_to_one, there)[2][2] != own[2][2];
  }
  EXPECT_GT(lost, 0);
}

// A textbook's left-handed camera with row vectors and depth from 0 to 1: x cot, y cot, z f/(f-n), -n f/(f-n), w = z.
TEST(Convention, LeftHandedRowsFromZeroToOne) {
  const double near = 1, far = 3;
  const glm::dmat4 m =
      projection_to(row_left_handed_zero_to_one, projection_matrix(Perspective{90, near, far}, 1600.0 / 900)).matrix;
  const auto depth = [&](double z) {
    const glm::dvec4 clip = glm::dvec4(0, 0, z, 1) * m;
    return clip.z / clip.w;
  };
  EXPECT_TRUE(within(depth(near), 0.0, 4 * u64));
  EXPECT_TRUE(within(depth(far), 1.0, 4 * u64));
  EXPECT_TRUE(within(depth(1.5), 0.5, 4 * u64));
  const glm::dvec4 clip = glm::dvec4(1, 1, 2, 1) * m;
  EXPECT_EQ(clip.w, 2);
  EXPECT_TRUE(within(clip.x, 9.0 / 16, 4 * u64));
  EXPECT_TRUE(within(clip.y, 1.0, 4 * u64));
}

// Row vectors turn a product round; a left-handed system turns about y the other way.
TEST(Convention, ProductsAndRotations) {
  const glm::dmat4 first = CompositeTransform().rotate_y_degrees(90).matrix();
  const glm::dmat4 second = CompositeTransform().translate({1, 2, 3}).matrix();
  const auto rows = [](const glm::dmat4& m) { return transform_to(row_right_handed, m); };
  EXPECT_EQ(rows(second * first), rows(first) * rows(second));
  EXPECT_EQ(glm::dvec4(0, 0, 1, 1) * rows(second * first), glm::dvec4(2, 2, 3, 1));
  const auto left = [](const glm::dmat4& m) { return transform_to(row_left_handed, m); };
  // (0, 0, 1) right-handed is (0, 0, -1) there, and so is its image but for the sign of z.
  EXPECT_EQ(glm::dvec4(0, 0, -1, 1) * left(second * first), glm::dvec4(2, 2, -3, 1));
}

// The drawing board's perspective from (0, 0, 10): the same picture by its own matrix and through eye space.
TEST(Convention, BoardCoordinates) {
  const glm::dmat4 through_eye =
      projection_matrix(CentralProjection{-100, 100, -100, 100, 1, infinity, 10}, 1) * board_to_eye(10);
  const glm::dvec3 image = transform_point(through_eye, {3, 5, 7}),
                   board = transform_point(central_projection(10), {3, 5, 7});
  EXPECT_TRUE(within(100 * image.x, 10.0, 400 * u64));
  EXPECT_TRUE(within(100 * image.y, board.y, 400 * u64));
  EXPECT_EQ(transform_to(row_right_handed, board_to_eye(10))[2][3], -10);
}

}  // namespace
}  // namespace morphcl
