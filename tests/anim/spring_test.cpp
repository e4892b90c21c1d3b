// Springs in closed form against the Taylor series of their equation in 300 digits.
#include "anim/spring.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/anim/spring_reference.hpp"
#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

struct Case {
  Spring spring;
  SpringState from;
  Cubic target;
  double seconds;
};

// The largest of the terms that make up the solution, times u and 1 + omega_d t: the phase omega_d t is a product of
// doubles, so it is off by 3u of itself, and with it the oscillation while it lasts. The factors count roundings: a
// unit response is off by at most 24u of its scale (series: terms up to e^1.8 = 6 times their sum; cascade: a
// difference of phi functions that cancels at most a factor of 6), the recurrence to t^2 and t^3 at x = omega t >= 1
// multiplies errors by at most 2 i zeta <= 4.6 and 6.9.
struct Bound {
  double position, velocity;
};

double phase(const Case& c) {
  const double zeta = c.spring.damping_ratio, x = c.spring.angular_frequency * c.seconds;
  return zeta < 1 ? 3 * x * std::sqrt((1 - zeta) * (1 + zeta)) * std::exp(-zeta * x) : 0;
}

Bound bound_of(const Case& c) {
  const double omega = c.spring.angular_frequency, zeta = c.spring.damping_ratio, t = c.seconds;
  const double strain = std::abs(c.target[0]) + std::abs(c.from.position);
  const double speed = std::abs(c.from.velocity) + std::abs(c.target[1]);
  const double reach = std::abs(c.from.velocity) * std::min(t, 1 / (omega * std::max(zeta, 1.0)));
  const double curve = 5 * 7 * (std::abs(c.target[2]) * t * t + std::abs(c.target[3]) * t * t * t);
  const double units = u64 * (24 + phase(c));
  return {units * (strain + reach + std::abs(c.target[1]) * t + curve),
          units * (omega * strain + speed + (omega + 1 / t) * curve)};
}

testing::AssertionResult agrees(const Case& c, double* worst = nullptr) {
  const SpringState state = SpringStep(c.spring, c.seconds).apply(c.from, c.target);
  const reference::ExactState exact = reference::spring_state(c.spring, c.from, c.target, c.seconds);
  const Bound bound = bound_of(c);
  if (worst) {
    worst[0] = std::max(worst[0], std::abs(exact.position.error_of(state.position)) / bound.position);
    worst[1] = std::max(worst[1], std::abs(exact.velocity.error_of(state.velocity)) / bound.velocity);
  }
  const testing::AssertionResult position = within(state.position, exact.position, bound.position),
                                 velocity = within(state.velocity, exact.velocity, bound.velocity);
  if (position && velocity) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "omega " << c.spring.angular_frequency << ", zeta " << c.spring.damping_ratio
                                     << ", t " << c.seconds << ": position " << position.message() << "; velocity "
                                     << velocity.message();
}

double log_uniform(Random& random, double min, double max) { return std::exp(random.in(std::log(min), std::log(max))); }

TEST(Spring, RandomOverTwelveDecades) {
  Random random(2026);
  double worst[2] = {};
  for (int i = 0; i < 1000; ++i) {
    const double t = log_uniform(random, 1e-4, 1e2), x = log_uniform(random, 1e-6, 1e6);
    const double zeta = i % 3 == 0 ? random.in(0, 1) : i % 3 == 1 ? random.in(1, 2) : log_uniform(random, 1e-6, 1e6);
    const double scale = log_uniform(random, 1e-3, 1e3);
    const Case c{{x / t, zeta},
                 {random.in(-scale, scale), random.in(-scale, scale) / t},
                 {random.in(-scale, scale), random.in(-scale, scale) / t,
                  i % 2 ? random.in(-scale, scale) / (t * t) : 0, i % 2 ? random.in(-scale, scale) / (t * t * t) : 0},
                 t};
    EXPECT_TRUE(agrees(c, worst)) << "case " << i;
  }
  std::printf("largest error: %.3f of the bound in position, %.3f in velocity\n", worst[0], worst[1]);
}

// From zeta = 1 - 1e-2 to 1 + 1e-2 by way of 1 +- 1 ulp, at every length of a step.
TEST(Spring, ThroughCriticalDamping) {
  double worst[2] = {};
  for (const double off : {0.0, 0x1p-52, 1e-15, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2})
    for (const double zeta : {1 - off, 1 + off})
      for (double x = 1e-6; x < 2e6; x *= 3.7)
        EXPECT_TRUE(agrees({{24 * x, zeta}, {1, -3}, {0.25, 2, -5, 7}, 1.0 / 24}, worst));
  std::printf("largest error: %.3f of the bound in position, %.3f in velocity\n", worst[0], worst[1]);
}

// Where one way of computing gives way to the next: omega t = 1, |d| t = 1/2, zeta = 1.15, a fast rate of 1/t, and
// where phi functions leave their series.
TEST(Spring, AtTheSeamsOfItsMethods) {
  double worst[2] = {};
  const auto on_both_sides = [&](double zeta, double x) {
    for (const double near : {1 - 1e-15, 1.0, 1 + 1e-15})
      for (const double damping : {zeta * (1 - 1e-15), zeta, zeta * (1 + 1e-15)})
        EXPECT_TRUE(agrees({{16 * x * near, damping}, {0.5, 1}, {-1, 3, 2, -4}, 0.0625}, worst));
  };
  for (const double zeta : {0.0, 0.3, 0.999, 1.0, 1.1, 1.15, 1.2, 5.0, 1e3, 1e6}) {
    const double fast = zeta > 1 ? zeta + std::sqrt((zeta - 1) * (zeta + 1)) : 1;
    for (const double x :
         {1.0, 0.5 / std::sqrt(std::abs((1 - zeta) * (1 + zeta)) + 1e-9), 1 / fast, 2 / fast, 2 * fast})
      on_both_sides(zeta, x);
  }
  std::printf("largest error: %.3f of the bound in position, %.3f in velocity\n", worst[0], worst[1]);
}

// exp(-a t) cosh(d t) and its like, as textbooks have them.
SpringState naive_step(const Spring& spring, const SpringState& from, const Cubic& g, double t) {
  const double omega = spring.angular_frequency, zeta = spring.damping_ratio;
  const double a = zeta * omega, d = std::sqrt(a * a - omega * omega), r1 = -a + d, r2 = -a - d;
  const double lag = 2 * zeta * g[1] / omega, strain = from.position - (g[0] - lag), speed = from.velocity - g[1];
  const double c2 = (speed - r1 * strain) / (r2 - r1), c1 = strain - c2;
  return {g[0] + g[1] * t - lag + c1 * std::exp(r1 * t) + c2 * std::exp(r2 * t),
          g[1] + c1 * r1 * std::exp(r1 * t) + c2 * r2 * std::exp(r2 * t)};
}

TEST(Spring, TheTwoExponentialsOfTextbooksMissTheBound) {
  const std::vector<Case> cases = {
      {{50, 1 + 1e-12}, {1, 0}, {0, 0, 0, 0}, 1.0 / 24},  // the roots nearly meet
      {{1e3, 1e3}, {1, 0}, {0, 0, 0, 0}, 1.0},            // the slow root is a difference of large numbers
      {{1e-6, 2}, {1, 0}, {1.5, 1, 0, 0}, 1.0},           // a large lag cancels
      {{2, 1e6}, {0, 0}, {0, 1, 0, 0}, 1.0 / 24},         // the same, with much damping
  };
  for (const Case& c : cases) {
    EXPECT_TRUE(agrees(c));
    const double naive = naive_step(c.spring, c.from, c.target, c.seconds).position;
    const reference::ExactState exact = reference::spring_state(c.spring, c.from, c.target, c.seconds);
    EXPECT_FALSE(within(naive, exact.position, bound_of(c).position)) << c.spring.damping_ratio;
  }
}

TEST(Spring, WithoutDampingKeepsItsEnergyForAMillionSteps) {
  const Spring spring{17, 0};
  const SpringStep step(spring, 1.0 / 24);
  SpringState state{1, 0};
  for (int i = 0; i < 1'000'000; ++i) state = step.apply(state, {0, 0, 0, 0});
  const double amplitude = std::hypot(state.position, state.velocity / spring.angular_frequency);
  EXPECT_TRUE(within(amplitude, 1.0, 1e6 * 4 * u64));
}

TEST(Spring, ComesToRestOnItsTargetExactly) {
  for (const double zeta : {0.01, 0.5, 1.0, 3.0, 1e3}) {
    const SpringState state = SpringStep({100, zeta}, 1e5).apply({5, 1e3}, {0.1, 0, 0, 0});
    EXPECT_EQ(state.position, 0.1) << zeta;
    EXPECT_EQ(state.velocity, 0) << zeta;
  }
}

// The first overshoot after a step of the target is exp(-pi zeta / sqrt(1 - zeta^2)): the bound's series of them all.
TEST(Spring, LargestOvershootIsThatOfThePeaksInStep) {
  for (const double zeta : {0.05, 0.2, 0.7}) {
    const double peak = std::exp(-M_PI * zeta / std::sqrt(1 - zeta * zeta));
    EXPECT_NEAR(largest_overshoot(zeta), (1 + peak) / (1 - peak), 1e-12);
  }
  EXPECT_EQ(largest_overshoot(1), 1);
  EXPECT_EQ(largest_overshoot(7), 1);
  EXPECT_EQ(largest_overshoot(0), std::numeric_limits<double>::infinity());
}

TEST(Spring, HasSettledToAThousandth) {
  for (const double zeta : {0.2, 0.6, 1.0, 2.0, 30.0}) {
    const Spring spring{60, zeta};
    const double seconds = settling_seconds(spring);
    EXPECT_LT(seconds, 10);
    // At critical damping the envelope is (1 + omega t) exp(-omega t), eight times as much.
    EXPECT_LT(std::abs(SpringStep(spring, seconds).apply({1, 0}, {0, 0, 0, 0}).position), 8e-3) << zeta;
  }
  EXPECT_EQ(settling_seconds({60, 0}), 10);
}

}  // namespace
}  // namespace morphcl
