#include "morphcl/track.hpp"

#include <array>
#include <limits>
#include <vector>

#include "tests/anim/value_at.hpp"
#include "tests/math/check.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using reference::u64;
using test_support::Random;

constexpr std::int64_t second = 1000;  // ticks

Track make(Interpolation interpolation, int width, std::vector<std::int64_t> ticks, std::vector<double> values) {
  return Track({interpolation, width, false, second, std::move(ticks), std::move(values)});
}

TEST(Track, HoldsTheEndValuesOutside) {
  const std::int64_t far = std::numeric_limits<std::int64_t>::max();
  for (const Interpolation i : {Interpolation::step, Interpolation::linear}) {
    const Track track = make(i, 1, {-10, 0, 500}, {3, 7, 5});
    for (const std::int64_t before : {std::int64_t{-10}, std::int64_t{-11}, -far})
      EXPECT_EQ(value_at(track, before), 3);
    for (const std::int64_t after : {std::int64_t{500}, std::int64_t{501}, far}) EXPECT_EQ(value_at(track, after), 5);
  }
  const Track cubic = make(Interpolation::cubic, 1, {0, 10}, {9, 1, 100, 100, 2, 9});
  EXPECT_EQ(value_at(cubic, -far), 1);
  EXPECT_EQ(value_at(cubic, far), 2);
  EXPECT_EQ(value_at(make(Interpolation::linear, 1, {4}, {6}), 4), 6);
}

TEST(Track, StepHoldsUntilTheNextKey) {
  const Track track = make(Interpolation::step, 2, {0, 10, 20}, {1, 2, 3, 4, 5, 6});
  double out[2];
  track.evaluate(9, out);
  EXPECT_EQ(out[0], 1);
  EXPECT_EQ(out[1], 2);
  track.evaluate(10, out);
  EXPECT_EQ(out[0], 3);
  EXPECT_EQ(out[1], 4);
}

TEST(Track, LinearIsExactAtKeysAndNeverLeavesEqualOnes) {
  const Track track = make(Interpolation::linear, 1, {0, 3, 7, 1000}, {0.1, 0.7, 0.7, -1e300});
  EXPECT_EQ(value_at(track, 0), 0.1);
  EXPECT_EQ(value_at(track, 3), 0.7);
  for (std::int64_t t = 3; t <= 7; ++t) EXPECT_EQ(value_at(track, t), 0.7) << t;
  EXPECT_EQ(value_at(track, 1000), -1e300);
  EXPECT_EQ(value_at(make(Interpolation::linear, 1, {0, 2}, {-1.7e308, 1.7e308}), 1), 0);
}

// A hundred steps from 0 to 1: step i is the number nearest to i/100, from whichever side it is reached.
TEST(Track, HundredMorphStepsAreExact) {
  const TimeBase time;
  const Track track(
      {Interpolation::linear, 1, false, time.ticks_per_second(), {time.frame_ticks(0), time.frame_ticks(100)}, {0, 1}});
  for (int step = 100; step >= 0; --step) EXPECT_EQ(value_at(track, time.frame_ticks(step)), step / 100.0) << step;
  EXPECT_EQ(value_at(track, time.frame_ticks(101)), 1);
  EXPECT_EQ(value_at(track, time.frame_ticks(-1)), 0);
}

TEST(Track, KeysMayBeTheWholeRangeApart) {
  const std::int64_t min = std::numeric_limits<std::int64_t>::min(), max = std::numeric_limits<std::int64_t>::max();
  const Track track = make(Interpolation::linear, 1, {min, max}, {0, 1});
  EXPECT_EQ(value_at(track, 0), 0.5);
  EXPECT_EQ(value_at(track, max / 2), 0.75);
}

TEST(Track, ManyKeysAreSearched) {
  std::vector<std::int64_t> ticks;
  std::vector<double> values;
  for (std::int64_t key = 0; key < 100'000; ++key) {
    ticks.push_back(key * key);
    values.push_back(static_cast<double>(key % 17));
  }
  const Track track = make(Interpolation::step, 1, ticks, values);
  for (std::int64_t key = 1; key < 100'000; key += 13) {
    EXPECT_EQ(value_at(track, key * key), key % 17);
    EXPECT_EQ(value_at(track, key * key - 1), (key - 1) % 17);
  }
}

// Three operations in each of four weights, the lerp and the sum: 8u of the terms' magnitudes.
TEST(Track, CubicIsTheHermiteSplineWithTangentsPerSecond) {
  Random random(81);
  for (int i = 0; i < 3000; ++i) {
    const double a = random.in(-5, 5), b = random.in(-5, 5), out_tangent = random.in(-9, 9),
                 in_tangent = random.in(-9, 9);
    const auto ticks = static_cast<std::int64_t>(random.in(2, 5000));
    const auto position = static_cast<std::int64_t>(random.in(1, static_cast<double>(ticks)));
    const Track track = make(Interpolation::cubic, 1, {7, 7 + ticks}, {99, a, out_tangent, in_tangent, b, 99});
    const double seconds = static_cast<double>(ticks) / second;
    const double bound =
        8 * u64 * (std::abs(a) + std::abs(b) + seconds * (std::abs(out_tangent) + std::abs(in_tangent)));
    EXPECT_TRUE(within(value_at(track, 7 + position),
                       reference::hermite(a, out_tangent, b, in_tangent, position, ticks, second), bound))
        << "case " << i << ": " << position << " of " << ticks;
    EXPECT_EQ(value_at(track, 7), a);
    EXPECT_EQ(value_at(track, 7 + ticks), b);
  }
}

TEST(Track, CubicTangentsScaleWithTheKeyDistance) {
  // A straight line of slope 2 a second: every point of the spline lies on it, whatever the distance of the keys.
  for (const std::int64_t seconds : {1, 4, 16}) {
    const Track line =
        make(Interpolation::cubic, 1, {0, seconds * second}, {2, 0, 2, 2, 2.0 * static_cast<double>(seconds), 2});
    for (std::int64_t t = 0; t <= seconds * second; t += 125)
      EXPECT_TRUE(
          within(value_at(line, t), 2 * static_cast<double>(t) / second, 8 * u64 * 6 * static_cast<double>(seconds)));
  }
}

Track rotation(Interpolation interpolation, std::vector<double> values) {
  return Track({interpolation, 4, true, second, {0, 1000}, std::move(values)});
}

TEST(RotationTrack, SlerpsAlongTheShorterArc) {
  const double h = std::sqrt(0.5);
  for (const double sign : {1.0, -1.0}) {
    const Track track = rotation(Interpolation::linear, {0, 0, 0, 1, 0, 0, sign * h, sign * h});
    for (const std::int64_t tick : {250, 500, 999}) {
      double q[4];
      track.evaluate(tick, q);
      const auto exact = reference::slerp({0, 0, 0, 1}, {0, 0, sign * h, sign * h}, static_cast<double>(tick) / 1000);
      for (int i = 0; i < 4; ++i) EXPECT_TRUE(within(q[i], exact[i], 64 * u64)) << sign << ", " << tick << ", " << i;
    }
  }
}

TEST(RotationTrack, KeyValuesAreUsedAsTheyAre) {
  const Track track = rotation(Interpolation::linear, {0, 0, 0, 2, 0.1, 0.2, 0.3, 0.4});
  double q[4];
  track.evaluate(0, q);
  EXPECT_EQ((std::array{q[0], q[1], q[2], q[3]}), (std::array{0.0, 0.0, 0.0, 2.0}));
  track.evaluate(1000, q);
  EXPECT_EQ((std::array{q[0], q[1], q[2], q[3]}), (std::array{0.1, 0.2, 0.3, 0.4}));
}

TEST(RotationTrack, CubicIsNormalised) {
  const Track track = rotation(Interpolation::cubic, {0, 0, 0, 0, 0, 0,   0, 1,   0, 1, 0, 0,  //
                                                      0, 0, 2, 0, 0, 0.6, 0, 0.8, 0, 0, 0, 0});
  for (std::int64_t tick = 1; tick < 1000; tick += 37) {
    double q[4];
    track.evaluate(tick, q);
    EXPECT_TRUE(within(std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]), 1.0, 8 * u64)) << tick;
    EXPECT_NE(q[1], 0) << tick;
  }
}

TEST(RotationTrack, CubicThroughZeroKeepsTheKeyBefore) {
  const Track track = rotation(Interpolation::cubic, {0, 0, 0, 0, 1,  0, 0, 0, 0, 0, 0, 0,  //
                                                      0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0});
  double q[4];
  track.evaluate(500, q);
  EXPECT_EQ((std::array{q[0], q[1], q[2], q[3]}), (std::array{1.0, 0.0, 0.0, 0.0}));
}

TEST(Track, BadTracksAreErrors) {
  const auto refuses = [](Interpolation i, int width, bool is_rotation, std::vector<std::int64_t> ticks,
                          std::vector<double> values, const char* part) {
    expect_error([&] { Track({i, width, is_rotation, second, ticks, values}); }, ErrorKind::bad_input, part);
  };
  constexpr auto linear = Interpolation::linear, cubic = Interpolation::cubic;
  refuses(linear, 1, false, {}, {}, "0 keys");
  refuses(cubic, 1, false, {0}, {0, 0, 0}, "at least 2");
  refuses(linear, 0, false, {0}, {}, "0 components");
  refuses(linear, -3, false, {0}, {1}, "-3 components");
  refuses(linear, 3, true, {0}, {1, 2, 3}, "needs 4");
  refuses(linear, 1, false, {0, 1}, {1}, "has 1 values");
  refuses(linear, 2, false, {0, 1}, {1, 2, 3, 4, 5}, "needs 2 a key");
  refuses(cubic, 1, false, {0, 1}, {1, 2}, "needs 3 a key");
  refuses(linear, 1, false, {0, 5, 5}, {1, 2, 3}, "key 2 of a track is not later than key 1");
  refuses(linear, 1, false, {5, 0}, {1, 2}, "must increase");
  refuses(linear, 1, false, {0, 1}, {1, std::nan("")}, "key 1");
  refuses(linear, 1, false, {0}, {std::numeric_limits<double>::infinity()}, "NaN or infinite");
  refuses(linear, 4, true, {0}, {0, 0, 0, 0}, "0 0 0 0");
  expect_error([] { Track({linear, 1, false, 0, {0}, {0}}); }, ErrorKind::bad_input, "ticks a second");
  EXPECT_TRUE(Track().empty());
}

}  // namespace
}  // namespace morphcl
