#include "morphcl/rotation.hpp"

#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::Quaternion;
using reference::u64;
using test_support::Random;

glm::dquat make(const Quaternion& q) { return {q[3], q[0], q[1], q[2]}; }
Quaternion components(const glm::dquat& q) { return {q.x, q.y, q.z, q.w}; }
double length(const glm::dquat& q) { return std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w); }

Quaternion random_quaternion(Random& random, double size) {
  return {random.in(-size, size), random.in(-size, size), random.in(-size, size), random.in(-size, size)};
}

// Both ends normalised (4u), two weights (quotient of sincs of 6u each, three more operations), the sum, the last
// normalisation (4u); the angle's 24u move a point of the arc by at most 24u times the angle, below pi/2.
constexpr double slerp_bound = (4 + 15 + 2 + 4 + 24 * 1.58) * u64;

void expect_slerp(const Quaternion& a, const Quaternion& b, double t, const std::string& what) {
  const Quaternion computed = components(slerp(make(a), make(b), t));
  const auto exact = reference::slerp(a, b, t);
  for (int i = 0; i < 4; ++i)
    EXPECT_TRUE(within(computed[i], exact[i], slerp_bound)) << what << " at " << t << ": component "
                                                            << "xyzw"[i];
  EXPECT_TRUE(within(length(make(computed)), 1.0, 8 * u64)) << what;
}

TEST(Slerp, RandomRotations) {
  Random random(71);
  for (int i = 0; i < 2000; ++i)
    expect_slerp(random_quaternion(random, 2), random_quaternion(random, 2), random.in(0, 1),
                 "pair " + std::to_string(i));
}

TEST(Slerp, NearlyEqualAndNearlyOppositeQuaternions) {
  Random random(72);
  for (int i = 0; i < 1000; ++i) {
    const Quaternion a = random_quaternion(random, 1);
    const double distance = std::pow(10.0, random.in(-17, -1)), sign = i % 2 == 0 ? 1 : -1;
    Quaternion b = a;
    for (double& component : b) component = sign * (component + distance * random.in(-1, 1));
    expect_slerp(a, b, random.in(0, 1), "pair " + std::to_string(i));
  }
}

TEST(Slerp, EqualAndOppositeQuaternionsStay) {
  const glm::dquat q = normalized({0.5, 0.1, -0.7, 0.3});
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    for (const glm::dquat& other : {q, -q}) {
      const glm::dquat between = slerp(q, other, t);
      EXPECT_TRUE(within(std::abs(glm::dot(between, q)), 1.0, 8 * u64)) << t;
    }
  }
}

TEST(Slerp, HalfWayBetweenTwoQuarterTurns) {
  // 0 and 90 degrees about z: 45 degrees about z.
  const glm::dquat half = slerp({1, 0, 0, 0}, {1, 0, 0, 1}, 0.5);
  const reference::ExactSinCos eighth = reference::sin_cos_degrees(22.5);
  EXPECT_TRUE(within(half.w, eighth.cos, slerp_bound));
  EXPECT_TRUE(within(half.z, eighth.sin, slerp_bound));
}

// How far normalised linear interpolation strays, in rad, for a given angle between the quaternions: the known maxima.
TEST(Slerp, DiffersFromNormalisedLerpByTheKnownAmount) {
  const double angles[] = {0.1, 1.0, 1.5}, deviations[] = {1.60455e-5, 0.0168884, 0.0611329};
  for (int i = 0; i < 3; ++i) {
    const glm::dquat a(1, 0, 0, 0), b(std::cos(angles[i]), std::sin(angles[i]), 0, 0);
    double largest = 0;
    for (int step = 0; step <= 2000; ++step) {
      const double t = step / 2000.0;
      const glm::dquat straight = a * (1 - t) + b * t;
      largest = std::max(largest, angle_between(slerp(a, b, t), straight));
    }
    // Six published digits; the maximum is flat, 2000 steps find it to 1e-6 of itself.
    EXPECT_TRUE(within(largest, deviations[i], 5e-6 * deviations[i])) << angles[i];
  }
}

TEST(AngleBetween, RelativeAccuracyHoweverSmall) {
  Random random(73);
  for (int i = 0; i < 2000; ++i) {
    const Quaternion a = random_quaternion(random, 3);
    Quaternion b = a;
    const double distance = std::pow(10.0, random.in(-15, 1));
    for (double& component : b) component += distance * random.in(-1, 1);
    EXPECT_TRUE(within_relative(angle_between(make(a), make(b)), reference::angle_between(a, b), 24 * u64)) << i;
  }
  EXPECT_EQ(angle_between({1, 2, 3, 4}, {-2, -4, -6, -8}), 0);
}

TEST(RotationMatrix, RandomQuaternionsOfEveryLength) {
  Random random(74);
  for (int i = 0; i < 2000; ++i) {
    const Quaternion q = random_quaternion(random, std::pow(10.0, random.in(-200, 200)));
    const glm::dmat3 m = rotation_matrix(make(q));
    const auto exact = reference::rotation_matrix(q);
    // Numerator and denominator: four products and three sums, 4u of |q|^2 each; one quotient.
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) EXPECT_TRUE(within(m[c][r], exact[r][c], 9 * u64)) << i << ": " << r << ", " << c;
  }
}

TEST(RotationMatrix, QuarterTurnsAreExact) {
  const double h = std::sqrt(0.5);
  EXPECT_EQ(rotation_matrix({h, h, 0, 0}), glm::dmat3(1, 0, 0, 0, 0, 1, 0, -1, 0));
  EXPECT_EQ(rotation_matrix({h, 0, h, 0}), glm::dmat3(0, 0, -1, 0, 1, 0, 1, 0, 0));
  EXPECT_EQ(rotation_matrix({h, 0, 0, h}), glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1));
  EXPECT_EQ(rotation_matrix({0, 0, 0, 1}), glm::dmat3(-1, 0, 0, 0, -1, 0, 0, 0, 1));
  EXPECT_EQ(rotation_matrix({1, 0, 0, 0}), glm::dmat3(1.0));
}

TEST(Normalized, EveryLength) {
  Random random(75);
  for (const double size : {1e-300, 1e-20, 1.0, 1e20, 1e300})
    EXPECT_TRUE(within(length(normalized(make(random_quaternion(random, size)))), 1.0, 4 * u64)) << size;
}

}  // namespace
}  // namespace morphcl
