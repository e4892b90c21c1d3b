// Nets of springs: forces, modes, and steps that never add energy.
#include "anim/tr_bdf2.hpp"
#include "anim/spring.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "anim/vibration_modes.hpp"
#include "tests/anim/chain_reference.hpp"
#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::stiff_chain;
using reference::u64;
using test_support::Random;

Displacements random_displacements(Random& random, std::size_t count) {
  Displacements x;
  for (std::size_t i = 0; i < count; ++i) x.push_back(random.vector(1));
  return x;
}

// A ladder with diagonals: every piece of it is stiff in another way, and its edges make cycles.
SpringNet ladder(std::size_t rungs, double ratio, std::uint64_t seed) {
  Random random(seed);
  SpringNet net;
  net.masses = 2 * rungs;
  const auto tie = [&](std::size_t a, std::size_t b) {
    net.edges.push_back(
        {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), std::exp(random.in(0, std::log(ratio)))});
  };
  for (std::size_t i = 0; i < rungs; ++i) {
    tie(2 * i, 2 * i + 1);
    if (i + 1 == rungs) break;
    tie(2 * i, 2 * i + 2);
    tie(2 * i + 1, 2 * i + 3);
    tie(2 * i, 2 * i + 3);
  }
  return net;
}

TEST(SpringNet, AUniformMotionStrainsNoEdge) {
  const SpringNet net = stiff_chain(16);
  const Displacements x(16, glm::dvec3(0.1, -7, 1e5));
  Displacements force(16, glm::dvec3(0.0));
  add_stiffness(net, x, 1, force);
  for (const glm::dvec3& f : force) EXPECT_EQ(f, x[0]);
  // The same with an assembled matrix: the anchor is rounded away beside 1e12.
  double worst = 0;
  for (std::size_t i = 1; i + 1 < 16; ++i) {
    const double left = net.edges[i - 1].stiffness, right = net.edges[i].stiffness;
    const double diagonal = net.anchor + left + right;
    worst = std::max(worst, std::abs(diagonal * 0.1 - left * 0.1 - right * 0.1 - 0.1));
  }
  EXPECT_GT(worst, 1e-6);
}

TEST(StiffnessSolver, SolvesWhatSpringsSay) {
  Random random(3);
  for (const double ratio : {1.0, 1e6, 1e12}) {
    const SpringNet net = ladder(20, ratio, 8);
    const Displacements x = random_displacements(random, net.masses);
    Displacements b(net.masses), found;
    for (std::size_t i = 0; i < b.size(); ++i) b[i] = 3.0 * x[i];
    add_stiffness(net, x, 0.25, b);
    StiffnessSolver(net, 3, 0.25).solve(b, found);
    // The right side itself is rounded: u of k |x| an edge, which the weakest direction, 3, turns into displacement.
    const double bound = 64 * u64 * ratio;
    for (std::size_t i = 0; i < b.size(); ++i)
      for (int c = 0; c < 3; ++c) EXPECT_TRUE(within(found[i][c], x[i][c], bound)) << ratio << ", " << i;
  }
}

TEST(VibrationModes, AreOrthonormalAndSwingAlone) {
  for (const double ratio : {1.0, 1e6, 1e12}) {
    SpringNet net = ladder(16, ratio, 5);
    net.anchor = 1.5;
    net.masses += 3;  // two masses tied to each other and one to nothing but its anchor
    net.edges.push_back({32, 33, 40});
    net.edges.push_back({0, 1, 0});
    const VibrationModes modes = find_modes(net);
    ASSERT_EQ(modes.masses(), 35u);
    for (std::size_t a = 0; a < 35; ++a) {
      Displacements x(35), force(35, glm::dvec3(0.0));
      for (std::size_t i = 0; i < 35; ++i) x[i].x = modes.shape(a)[i];
      add_stiffness(net, x, 1, force);
      for (std::size_t b = 0; b <= a; ++b) {
        double dot = 0, work = 0;
        for (std::size_t i = 0; i < 35; ++i) {
          dot += modes.shape(b)[i] * modes.shape(a)[i];
          work += modes.shape(b)[i] * force[i].x;
        }
        EXPECT_TRUE(within(dot, a == b ? 1 : 0, 35 * 8 * u64)) << ratio << ": " << a << ' ' << b;
        const double scale = std::max(modes.stiffness[a], modes.stiffness[b]);
        EXPECT_TRUE(within(work, a == b ? modes.stiffness[a] : 0, 35 * 64 * u64 * std::max(scale, ratio * 1e-3)))
            << ratio << ": " << a << ' ' << b;
      }
      EXPECT_GE(modes.stiffness[a], net.anchor);
    }
    int alone = 0;
    for (const double k : modes.stiffness) alone += k == net.anchor;
    EXPECT_EQ(alone, 3) << "three pieces move as a whole";
  }
}

// Two masses on springs far apart: eigenvalues known in closed form; an assembled matrix has no digit of the lower
// one's distance from the anchor.
TEST(VibrationModes, SmallOnesAreAccurateBesideLargeOnes) {
  SpringNet net;
  net.masses = 3;
  net.anchor = 1e-6;
  net.edges = {{0, 1, 1e12}, {1, 2, 1e-3}};
  std::vector<double> stiffness = find_modes(net).stiffness;
  std::sort(stiffness.begin(), stiffness.end());
  EXPECT_EQ(stiffness[0], 1e-6);
  EXPECT_NEAR(stiffness[1], 1e-6 + 1.5e-3, 1e-15);  // masses 0 and 1 as one of 2: k (1/2 + 1), but for 1e-15 of itself
  EXPECT_NEAR(stiffness[2], 2e12, 1e-3);
}

TEST(TrBdf2, EnergyNeverGrowsWithoutInput) {
  Random random(9);
  for (const double ratio : {1.0, 1e4, 1e8, 1e12})
    for (const double damping : {0.0, 2.0}) {
      SpringNet net = ladder(12, ratio, 4);
      net.damping = damping;
      net.stiffness_damping = damping * 1e-9;
      const Displacements rest = random_displacements(random, net.masses);
      NetState state{random_displacements(random, net.masses), random_displacements(random, net.masses)};
      for (const double h : {1.0 / 24, 1.0 / 384}) {
        const TrBdf2 stepper(net, EdgeRest::driven, h);
        double before = energy(net, state.position, state.velocity, rest);
        // Positions are rounded to u of their size, 4 at most, and the springs make energy of that.
        const double rounding = 24 * ratio * std::pow(4 * u64, 2) * 64;
        for (int i = 0; i < 400; ++i) {
          stepper.step(state, rest, rest);
          const double now = energy(net, state.position, state.velocity, rest);
          ASSERT_LE(now, before * (1 + 1e-10) + rounding) << "ratio " << ratio << ", step " << i;
          before = now;
        }
        EXPECT_TRUE(std::isfinite(before));
      }
    }
}

// The trapezoidal rule alone keeps what is too fast for it ringing; TR-BDF2 has no trace of it after a few steps.
TEST(TrBdf2, DampsWhatIsTooFastForItsStep) {
  SpringNet net;
  net.masses = 2;
  net.anchor = 1;
  net.edges = {{0, 1, 1e12}};
  const Displacements rest(2, glm::dvec3(0.0));
  NetState state{{glm::dvec3(1), glm::dvec3(-1)}, rest};
  const TrBdf2 stepper(net, EdgeRest::driven, 1.0 / 24);
  for (int i = 0; i < 20; ++i) stepper.step(state, rest, rest);
  EXPECT_LT(std::abs(state.position[0].x - state.position[1].x), 1e-12);
}

TEST(TrBdf2, IsOfSecondOrder) {
  SpringNet net;
  net.masses = 1;
  net.anchor = 90;
  net.damping = 1;
  const Displacements rest(1, glm::dvec3(0.0));
  const double omega = std::sqrt(90.0);
  const double exact = SpringStep({omega, 0.5 / omega}, 1).apply({1, 0}, {0, 0, 0, 0}).position;
  double before = 0;
  for (const int steps : {64, 128, 256, 512}) {
    NetState state{{glm::dvec3(1)}, rest};
    const TrBdf2 stepper(net, EdgeRest::base, 1.0 / steps);
    for (int i = 0; i < steps; ++i) stepper.step(state, rest, rest);
    const double error = std::abs(state.position[0].x - exact);
    if (steps > 64) {
      EXPECT_NEAR(before / error, 4, 0.3) << steps;
    }
    before = error;
  }
}

}  // namespace
}  // namespace morphcl
