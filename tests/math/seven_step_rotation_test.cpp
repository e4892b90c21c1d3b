#include "morphcl/transform.hpp"

#include <algorithm>

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

// The largest error of an entry of the upper 3x3 against the exact rotation.
double error_of(const glm::dmat4& computed, const glm::dvec3& from, const glm::dvec3& to, double degrees) {
  const reference::Affine exact = reference::rotation_about_line(from, to, degrees);
  double largest = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      largest = std::max(largest, std::abs(exact[row][column].error_of(computed[column][row])));
  return largest;
}

double seven_step_error(const glm::dvec3& direction, double degrees) {
  return error_of(rotation_in_seven_steps(glm::dvec3(0), direction, degrees).matrix(), glm::dvec3(0), direction,
                  degrees);
}

// Five products of rotations, each with entries within 4u64 and three products of numbers up to 1.
constexpr double chain_bound = 5 * 3 * 6 * u64;

TEST(SevenStepRotation, AgreesWithTheStableFormOnBenignAxes) {
  Random random(201);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 from = random.vector(3), to = from + random.vector(3);
    if (std::abs(to.y - from.y) + std::abs(to.z - from.z) < 0.1) continue;
    const double degrees = random.in(-360, 360);
    const CompositeTransform steps = rotation_in_seven_steps(from, to, degrees);
    ASSERT_EQ(steps.steps().size(), 7u);
    // The axis is a difference of doubles: its rounding turns it by 4u64 over its length, seen at most twice.
    const double bound = chain_bound + 8 * u64 * 6 / glm::length(to - from);
    EXPECT_LE(error_of(steps.matrix(), from, to, degrees), bound) << i;
    expect_affine(steps.matrix(), reference::rotation_about_line(from, to, degrees), bound, 30 * bound,
                  "axis " + std::to_string(i));
  }
}

// Counter-clockwise seen from the tip: about z by 90 degrees, (1, 0, 0) goes to (0, 1, 0), not to (0, -1, 0).
TEST(SevenStepRotation, TurnsTheObjectAndNotTheAxes) {
  const glm::dmat4 m = rotation_in_seven_steps({0, 0, 0}, {0, 0, 2}, 90).matrix();
  EXPECT_EQ(m * glm::dvec4(1, 0, 0, 1), glm::dvec4(0, 1, 0, 1));
}

TEST(SevenStepRotation, StepsDoWhatTheySay) {
  const glm::dvec3 from(1, 2, 3), to(5, 5, 15);  // direction (4, 3, 12), of length 13
  const CompositeTransform all = rotation_in_seven_steps(from, to, 60);
  glm::dvec4 tip(to, 1);
  const auto after = [&](std::size_t step) { return tip = all.steps()[step].matrix * tip; };
  EXPECT_EQ(after(0), glm::dvec4(4, 3, 12, 1));
  expect_point(glm::dvec3(after(1)), {4, 0, std::sqrt(153.0)}, 16 * 13 * u64, "in the xz plane");
  expect_point(glm::dvec3(after(2)), {0, 0, 13}, 32 * 13 * u64, "on z");
  expect_point(glm::dvec3(after(3)), {0, 0, 13}, 32 * 13 * u64, "turned about itself");
  after(4);
  after(5);
  expect_point(glm::dvec3(after(6)), to, 64 * 13 * u64, "back");
  const std::string text = all.to_string();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 7);
  EXPECT_NE(text.find("1. translate by (-1, -2, -3)\n2. rotate_x sin "), std::string::npos) << text;
  EXPECT_NE(text.find("4. rotate_z sin "), std::string::npos) << text;
  EXPECT_NE(text.find("6. rotate_x step 2 undone\n7. translate by (1, 2, 3)\n"), std::string::npos) << text;
}

TEST(SevenStepRotation, IsUndoneByItsInverse) {
  const CompositeTransform steps = rotation_in_seven_steps({1, 2, 3}, {-2, 0, 5}, 77);
  const glm::dmat4 identity = steps.inverse().matrix() * steps.matrix();
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) EXPECT_TRUE(within(identity[c][r], c == r ? 1.0 : 0.0, 20 * chain_bound)) << c << r;
}

// Where the formulas have no answer, they say so; the stable form has one.
TEST(SevenStepRotation, UndefinedCasesAreErrorsThatNameTheReason) {
  expect_error([] { rotation_in_seven_steps({1, 2, 3}, {5, 2, 3}, 10); }, ErrorKind::usage, "is parallel to x");
  expect_error([] { rotation_in_seven_steps({1, 2, 3}, {1, 2, 3}, 10); }, ErrorKind::usage, "has length 0");
  expect_error([] { rotation_in_seven_steps({0, 0, 0}, {1, 1e-200, 0}, 10); }, ErrorKind::usage, "squares leave");
  expect_error([] { rotation_in_seven_steps({0, 0, 0}, {1e200, 1, 1}, 10); }, ErrorKind::usage, "squares leave");
  EXPECT_NO_THROW(CompositeTransform().rotate_about_axis({1, 2, 3}, {5, 2, 3}, 10));
  EXPECT_NO_THROW(CompositeTransform().rotate_about_axis({0, 0, 0}, {1, 1e-200, 0}, 10));
}

// Close to x the squares underflow, and what step 2 divides by is wrong: the failure that the stable form does not
// have.
TEST(SevenStepRotation, FailsCloseToXWhereTheStableFormDoesNot) {
  for (const double size : {1e-2, 1e-8, 1e-20, 1e-150})
    EXPECT_LE(seven_step_error({1, 3 * size, 4 * size}, 60), chain_bound) << size;
  const glm::dvec3 too_close(1, 3e-162, 4e-162);
  EXPECT_GT(seven_step_error(too_close, 60), 1e-3);
  const glm::dmat4 stable = CompositeTransform().rotate_about_axis({0, 0, 0}, too_close, 60).matrix();
  EXPECT_LE(error_of(stable, {0, 0, 0}, too_close, 60), 16 * u64);
}

}  // namespace
}  // namespace morphcl
