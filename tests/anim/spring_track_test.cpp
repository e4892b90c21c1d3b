// Tracks on springs: the motion that their keys describe, at whichever tick it is asked for.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "morphcl/track.hpp"
#include "tests/anim/spring_reference.hpp"
#include "tests/anim/value_at.hpp"
#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

constexpr std::int64_t second_ticks = 24 * 1'000'000, frame_ticks = 1'000'000;

// Frames 0 to `last`, 24 a second, through g_k = ((7 k^2 + 3 k) mod 11) / 8.
Track zigzag(const Spring& spring, std::int64_t last) {
  std::vector<std::int64_t> ticks;
  std::vector<double> values;
  for (std::int64_t k = 0; k <= last; ++k) {
    ticks.push_back(k * frame_ticks);
    values.push_back(static_cast<double>((7 * k * k + 3 * k) % 11) / 8);
  }
  return Track({Interpolation::linear, 1, false, second_ticks, ticks, values}).on_spring(spring);
}

// Computed with 120 digits by a matrix exponential, or the closed form where that is too stiff. Each step adds at most
// 8 u (1 + omega_d h) of the largest target 1.25; 1e-12 holds that for 48 steps with room for the h = 1/24 of a double.
TEST(SpringTrack, FollowsTheReferenceMotions) {
  struct Row {
    double omega, zeta;
    const char* after_1;
    const char* after_24;
    const char* after_48;
  };
  const std::vector<Row> rows = {
      {1, 0.1, "0.00036090624015842341218", "0.22324201752459186402", "0.63695730870763840694"},
      {10, 0.2, "0.034414898828523658632", "0.53375528872868870553", "0.47883405260409465318"},
      {24, 1, nullptr, nullptr, "0.54259527642594081638"},
      {50, 1, "0.35506045503810131928", "0.69975516413081896008", "0.55505116045535923785"},
      {50, 1.000000001, "0.35506045484823936465", "0.69975516388296410868", "0.55505116043643152941"},
      {1e3, 0.5, "1.2200000000143202997", "0.15199999997279143052", "0.38399999998854376020"},
      {1e3, 1e3, "0.012930573820998584732", "0.20126668725508230913", "0.31931330391896760492"},
      {1e6, 0.5, "1.2499700000000000000", "0.12502700000000000000", "0.37500900000000000000"},
      {1e6, 1e3, "1.1900000000537461404", "0.17899999989788233335", "0.39299999995700308777"},
  };
  for (const Row& row : rows) {
    const Track track = zigzag({row.omega, row.zeta}, 48);
    const auto check = [&](std::int64_t k, const char* digits) {
      if (!digits) return;
      EXPECT_TRUE(within(value_at(track, k * frame_ticks), reference::decimal(digits), 1e-12))
          << "omega " << row.omega << ", zeta " << row.zeta << ", frame " << k;
    };
    check(1, row.after_1);
    check(24, row.after_24);
    check(48, row.after_48);
  }
}

// Between keys and long after them, by the reference's own steps from key to key.
TEST(SpringTrack, IsExactBetweenKeysOfEveryKind) {
  Random random(7);
  constexpr std::int64_t binary_second = 1 << 20;  // ticks: every time is a double
  for (int trial = 0; trial < 60; ++trial) {
    const Spring spring{std::exp(random.in(-1, 6)), random.in(0, 2)};
    const auto kind = std::array{Interpolation::step, Interpolation::linear, Interpolation::cubic}[trial % 3];
    const std::size_t per_key = kind == Interpolation::cubic ? 3 : 1;
    std::vector<std::int64_t> ticks = {0, 300'000, 1'000'000, 1'500'000};
    std::vector<double> values;
    for (std::size_t i = 0; i < ticks.size() * per_key; ++i) values.push_back(random.in(-2, 2));
    const Track track = Track({kind, 1, false, binary_second, ticks, values}).on_spring(spring);
    SpringState from{values[per_key / 2], 0};
    double bound = 0;
    for (std::size_t key = 0; key < ticks.size(); ++key) {
      const std::int64_t end = key + 1 < ticks.size() ? ticks[key + 1] : 5'000'000;
      // The curve itself is off by a few u of its coefficients; the phase by 3u a radian.
      bound += u64 * (200 + 6 * spring.angular_frequency * static_cast<double>(end - ticks[key]) / binary_second) * 8;
      const Cubic curve = track.curve_from(key, 0);
      const auto exact_at = [&](std::int64_t tick) {
        return reference::spring_state(spring, from, curve, static_cast<double>(tick - ticks[key]) / binary_second);
      };
      const std::int64_t middle = ticks[key] + (end - ticks[key]) / 3;
      EXPECT_TRUE(within(value_at(track, middle), exact_at(middle).position, bound))
          << "trial " << trial << ", key " << key;
      const reference::ExactState next = exact_at(end);
      EXPECT_TRUE(within(value_at(track, end), next.position, bound)) << "trial " << trial << ", key " << key;
      from = {next.position.high, next.velocity.high};
    }
  }
}

TEST(SpringTrack, CurvesAreThoseOfTheKeys) {
  const Track cubic({Interpolation::cubic, 1, false, 1000, {0, 2000}, {9, 1, -3, 5, 2, 9}});
  const Cubic c = cubic.curve_from(0, 0);
  for (std::int64_t tick = 0; tick <= 2000; tick += 125) {
    const double t = static_cast<double>(tick) / 1000;
    EXPECT_TRUE(within(((c[3] * t + c[2]) * t + c[1]) * t + c[0], value_at(cubic, tick), 64 * u64 * 10)) << tick;
  }
  EXPECT_EQ(cubic.curve_from(1, 0), (Cubic{2, 0, 0, 0}));
}

TEST(SpringTrack, RestsBeforeItsFirstKeyAndSettlesAfterItsLast) {
  const Track track = Track({Interpolation::step, 1, false, second_ticks, {10 * frame_ticks, 11 * frame_ticks}, {2, 5}})
                          .on_spring(spring_of_frequency(3, 0.25));
  for (const std::int64_t k : {-1'000'000, 0, 10, 11}) EXPECT_EQ(value_at(track, k * frame_ticks), 2) << k;
  double max = 0;
  for (std::int64_t k = 11; k < 60; ++k) max = std::max(max, value_at(track, k * frame_ticks));
  EXPECT_GT(max, 6);
  EXPECT_LT(max, 5 + 3 * 0.45);  // the first overshoot is exp(-pi zeta / sqrt(1 - zeta^2)) = 0.444
  EXPECT_NEAR(value_at(track, track.end_tick()), 5, 3e-3);
  EXPECT_GT(track.end_tick(), track.last_tick());
  EXPECT_EQ(value_at(track, 4'000 * frame_ticks), 5);
}

TEST(SpringTrack, AFrameAloneIsThatOfTheSequence) {
  const Track track = zigzag({31, 0.1}, 48);
  std::vector<double> forwards;
  for (std::int64_t k = 0; k < 90; ++k) forwards.push_back(value_at(track, k * frame_ticks));
  for (std::int64_t k = 89; k >= 0; --k)
    EXPECT_EQ(value_at(zigzag({31, 0.1}, 48), k * frame_ticks), forwards[static_cast<std::size_t>(k)]) << k;
}

TEST(SpringTrack, RotationsAreUnitAndKeepTheirSide) {
  const double h = std::sqrt(0.5);
  // A quarter turn about z, written with the opposite sign and another length.
  const auto turning = [&](double factor) {
    return Track({Interpolation::linear,
                  4,
                  true,
                  second_ticks,
                  {0, 10 * frame_ticks},
                  {0, 0, 0, 3, 0, 0, factor * h, factor * h}})
        .on_spring(spring_of_frequency(2, 0.3));
  };
  const Track track = turning(1), other = turning(-7);
  double max = 0;
  for (std::int64_t k = 0; k < 60; ++k) {
    std::array<double, 4> q{}, same{};
    track.evaluate(k * frame_ticks, q.data());
    other.evaluate(k * frame_ticks, same.data());
    for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(within(q[i], same[i], 8 * u64)) << k;
    EXPECT_TRUE(within(std::sqrt(q[2] * q[2] + q[3] * q[3]), 1.0, 8 * u64)) << k;
    EXPECT_GT(q[3], 0) << k;
    max = std::max(max, q[2]);
  }
  EXPECT_GT(max, h + 0.02) << "it goes on past the key";
}

TEST(SpringTrack, RangeContainsWhatItOvershoots) {
  Random random(11);
  double tightest = 1e9;
  for (int trial = 0; trial < 150; ++trial) {
    const Spring spring{std::exp(random.in(0, 5)), trial % 5 == 0 ? 0 : random.in(0, 1.2)};
    const bool cubic = trial % 2 == 1;
    std::vector<std::int64_t> ticks;
    std::vector<double> values;
    for (std::int64_t key = 0; key < 12; ++key) {
      ticks.push_back(ticks.empty() ? 0 : ticks.back() + 1 + static_cast<std::int64_t>(random.in(0, 600)));
      for (int i = 0; i < (cubic ? 3 : 1); ++i) values.push_back(random.in(-10, 10));
    }
    const Track track =
        Track({cubic ? Interpolation::cubic : Interpolation::linear, 1, false, 1000, ticks, values}).on_spring(spring);
    const ValueRange range = track.range(0);
    ValueRange seen{1e9, -1e9};
    for (std::int64_t tick = -5; tick < ticks.back() + 3000; tick += 3)
      seen = {std::min(seen.lower, value_at(track, tick)), std::max(seen.upper, value_at(track, tick))};
    EXPECT_LE(range.lower, seen.lower) << trial;
    EXPECT_GE(range.upper, seen.upper) << trial;
    tightest = std::min(tightest, (range.upper - range.lower) / (seen.upper - seen.lower));
  }
  EXPECT_LT(tightest, 1.5) << "not wider than need be";
  const Track still = Track({Interpolation::linear, 1, false, 1000, {0, 10}, {3, 3}}).on_spring({5, 0});
  EXPECT_EQ(still.range(0).lower, 3);
  EXPECT_EQ(still.range(0).upper, 3);
}

// A square wave at the spring's own frequency drives it further with every key: only the way of the target bounds it.
TEST(SpringTrack, RangeContainsResonance) {
  std::vector<std::int64_t> ticks;
  std::vector<double> values;
  for (std::int64_t key = 0; key < 40; ++key) {
    ticks.push_back(key * 500);
    values.push_back(key % 2 ? 1 : 0);
  }
  const Track track = Track({Interpolation::step, 1, false, 1000, ticks, values}).on_spring(spring_of_frequency(1, 0));
  double max = 0;
  for (std::int64_t tick = 0; tick < 25'000; ++tick) max = std::max(max, value_at(track, tick));
  EXPECT_GT(max, 35);
  EXPECT_GE(track.range(0).upper, max);
  EXPECT_LT(track.range(0).upper, 1.1 * max);
}

TEST(SpringTrack, AreEqualWhereKeysAndSpringAre) {
  const Spring spring{5, 0.25};
  const Track track = zigzag(spring, 10);
  EXPECT_EQ(track, zigzag(spring, 10));  // made apart
  EXPECT_NE(track, zigzag(spring, 11));
  EXPECT_NE(track, zigzag({5, 0.5}, 10));
  EXPECT_NE(track, zigzag({6, 0.25}, 10));
  const TickKeys keys{Interpolation::linear, 1, false, second_ticks, {0, 1}, {0, 1}};
  EXPECT_NE(Track(keys), Track(keys).on_spring(spring));
}

TEST(SpringTrack, BadSpringsAreErrors) {
  const auto refuses = [](const Spring& spring, Interpolation follows, const char* part) {
    expect_error([&] { Track({follows, 1, false, 24, {0, 1}, {0, 1}}).on_spring(spring); }, ErrorKind::bad_input, part);
  };
  refuses({0, 0.5}, Interpolation::linear, "angular frequency is 0");
  refuses({-1, 0.5}, Interpolation::linear, "angular frequency is -1");
  refuses({1e9, 0.5}, Interpolation::linear, "angular frequency");
  refuses({std::nan(""), 0.5}, Interpolation::linear, "angular frequency is nan");
  refuses({1, -0.1}, Interpolation::linear, "damping ratio is -0.1");
  refuses({1, 1e7}, Interpolation::linear, "damping ratio");
  refuses({1, 1}, Interpolation::spring, "a spring track needs a spring");
  refuses({1, 1}, Interpolation::cubic, "needs 3 a key");
}

}  // namespace
}  // namespace morphcl
