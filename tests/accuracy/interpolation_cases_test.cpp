// Catalogue of extreme cases: interpolation of numbers, rotations, normals and times.
#include "host/math/direction.hpp"
#include "host/math/kahan.hpp"
#include "morphcl/numerics.hpp"
#include "morphcl/rotation.hpp"
#include "morphcl/track.hpp"
#include "tests/accuracy/demand.hpp"
#include "tests/accuracy/exact_value.hpp"
#include "tests/accuracy/naive_forms.hpp"
#include "tests/math/reference.hpp"
#include "tests/support/random.hpp"

namespace morphcl::accuracy {
namespace {

using test_support::Random;

// A pair of unit quaternions of fp32, `angle` apart as 4-vectors.
struct Pair {
  glm::quat a, b;
};
Pair quaternions_apart(double angle) {
  const glm::dquat a = glm::normalize(glm::dquat(0.5, 0.1, -0.7, 0.3)), turned(-a.x, a.w, a.z, -a.y);
  return {glm::quat(a), glm::quat(a * std::cos(angle) + turned * std::sin(angle))};
}
reference::Quaternion components(const glm::quat& q) { return {q.x, q.y, q.z, q.w}; }

TEST(ExtremeCase, AngleBetweenQuaternions) {
  Worst stable, naive_form;
  for (const double angle : {1.0, 0.1, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const auto [a, b] = quaternions_apart(angle);
    const Real value = exact(reference::angle_between(components(a), components(b)));
    stable.add_relative(angle_between(glm::dquat(a), glm::dquat(b)), value, 4 * u32);
    naive_form.add_relative(naive::angle_between(a, b), value, 4 * u32);
  }
  expect_demand(stable, naive_form);
}

TEST(ExtremeCase, SlerpOfNearAndOppositeQuaternions) {
  Worst stable, naive_form;
  const auto length = [](const auto& q) {
    return static_cast<double>(Real(sqrt(Real(Real(q.x) * q.x + Real(q.y) * q.y + Real(q.z) * q.z + Real(q.w) * q.w))));
  };
  for (const double angle : {0.0, 1e-8, 1e-5, 1e-4, 1e-2, 1.0, 1.5707, 3.0, 3.1415926})
    for (const float t : {0.0f, 0.25f, 0.5f, 0.9f, 1.0f}) {
      const auto [a, b] = quaternions_apart(angle);
      stable.add(length(slerp(glm::dquat(a), glm::dquat(b), t)), 1, 2 * u32);
      naive_form.add(length(naive::slerp(a, b, t)), 1, 2 * u32);
    }
  expect_demand(stable, naive_form);
}

// The largest angle between a form and the way at constant speed, all as angles of unit quaternions: of the object that
// is turned they are twice as large.
template <typename Form>
double largest_deviation(Form form, double angle) {
  const glm::dquat a(1, 0, 0, 0), b(std::cos(angle), 0, 0, std::sin(angle));
  double largest = 0;
  for (int i = 0; i <= 2000; ++i) {
    const double t = i / 2000.0;
    const glm::dquat even(std::cos(t * angle), 0, 0, std::sin(t * angle));
    largest = std::max(largest, angle_between(form(a, b, t), even));
  }
  return largest;
}

// nlerp turns at a changing speed: it is off by as much as the table says; slerp, along the shorter arc, is not.
TEST(ExtremeCase, NlerpVersusSlerp) {
  struct Row {
    double angle, deviation;  // radians
  };
  constexpr double shorter_arc = 1.5707963267948966;
  Worst stable, naive_form;
  for (const Row& row : {Row{0.1, 1.60455e-5}, Row{1.0, 0.0168884}, Row{1.5, 0.0611329}, Row{3.0, 0.930256}}) {
    const double deviation = largest_deviation(naive::nlerp, row.angle);
    // Six digits, and what 2000 steps may miss of the maximum.
    EXPECT_NEAR(deviation, row.deviation, 1e-5 * row.deviation) << "nlerp over " << row.angle << " rad";
    if (row.angle < shorter_arc) stable.add(largest_deviation(slerp, row.angle), 0, 1e-14);
    naive_form.add(deviation, 0, 1e-14);
  }
  expect_demand(stable, naive_form);
}

TEST(ExtremeCase, LengthOfHugeAndTinyVectors) {
  Worst stable, naive_form;
  for (const float size : {1e20f, 1e-23f, 1.0f, 1e38f, 1e-38f}) {
    const glm::vec3 v(size, 2 * size, 3 * size * (size > 1e37f ? 0.5f : 1.0f));
    const Real square = Real(v.x) * v.x + Real(v.y) * v.y + Real(v.z) * v.z;
    const glm::dvec3 direction = unit(v);
    for (int i = 0; i < 3; ++i) {
      const Real component = Real(v[i]) / sqrt(square);
      stable.add_relative(direction[i], component, 2 * u32);
      naive_form.add_relative(v[i] / naive::length(v), component, 2 * u32);
    }
  }
  // In fp64 at the ends of its own range.
  for (const double size : {1e300, 1e-300, 5e-324}) {
    const glm::dvec3 v(size, 2 * size, 3 * size), direction = unit(v);
    for (int i = 0; i < 3; ++i) stable.add_relative(direction[i], Real(i + 1) / sqrt(Real(14)), 4 * u64);
  }
  expect_demand(stable, naive_form);
}

// Rising values with keys that nearly coincide: the curve stays between the keys around it.
TEST(ExtremeCase, HermiteWithNearlyCoincidentKeys) {
  const std::vector<double> frames = {0, 1, 1 + 1e-6, 2, 2.5}, values = {0, 1, 1.5, 2, 2.25};
  std::vector<std::int64_t> ticks;
  for (const double frame : frames) ticks.push_back(static_cast<std::int64_t>(std::llround(frame * 1e6)));
  Worst stable, naive_form;
  for (const auto& tangents : {default_tangents(frames, values), monotone_tangents(frames, values)}) {
    std::vector<double> keys;
    for (std::size_t i = 0; i < frames.size(); ++i) keys.insert(keys.end(), {tangents[i], values[i], tangents[i]});
    const Track track({Interpolation::cubic, 1, false, 1'000'000, ticks, keys});
    for (std::size_t key = 0; key + 1 < frames.size(); ++key)
      for (int i = 0; i <= 200; ++i) {
        const std::int64_t tick = ticks[key] + (ticks[key + 1] - ticks[key]) * i / 200;
        const auto in_hull = [&](double value) {
          return value >= values[key] * (1 - 4 * u64) && value <= values[key + 1] * (1 + 4 * u64);
        };
        double value = 0;
        track.evaluate(tick, &value);
        stable.add_exact(in_hull(value));
        naive_form.add_exact(in_hull(naive::hermite_by_differences(frames, values, static_cast<double>(tick) * 1e-6)));
      }
  }
  expect_demand(stable, naive_form);
}

// Evenly spaced keys have the tangents of Catmull and Rom, whatever their values.
TEST(Tangents, OfEvenKeysAreCatmullRoms) {
  const std::vector<double> frames = {0, 0.1, 0.2, 0.30000000000000004, 0.4}, values = {0, 0, 5, -1, 2};
  const std::vector<double> tangents = default_tangents(frames, values), expected = {0, 25, -5, -15, 30};
  for (std::size_t i = 0; i < frames.size(); ++i) EXPECT_NEAR(tangents[i], expected[i], 1e-12) << i;
}

TEST(ExtremeCase, TimeOfTenMillionSeconds) {
  const TimeBase time{24, 1};
  Worst stable, naive_form;
  constexpr int second = 1'000'000;  // the largest frame number that is allowed is 41,666 s; ticks reach further
  for (const int frame : {1, 24, 999'999, 1'000'000}) {
    const std::int64_t start = time.seconds_to_ticks(1e7);
    const std::int64_t ticks = start + time.frame_ticks(frame);
    stable.add_exact(ticks == std::int64_t{10'000'000} * 24 * second + std::int64_t{frame} * second);
  }
  naive_form.add(naive::by_adding(1e7f, 1.0f / 24, 24), Real(10'000'001), 0.5);
  // Half-way between two keys an hour apart, 1e7 s after the start: the parameter is exact.
  const Track track({Interpolation::linear,
                     1,
                     false,
                     time.ticks_per_second(),
                     {time.seconds_to_ticks(1e7), time.seconds_to_ticks(1e7 + 3600)},
                     {0, 1}});
  double value = 0;
  track.evaluate(time.seconds_to_ticks(1e7 + 1800), &value);
  stable.add_exact(value == 0.5);
  expect_demand(stable, naive_form);
}

template <typename Form>
Worst lerp_error(Form form) {
  Random random(5);
  Worst worst;
  for (int i = 0; i < 20'000; ++i) {
    const float a = random.float_in(-1e3, 1e3), b = random.float_in(-1, 1), t = random.float_in(0, 1);
    worst.add_exact(form(a, b, 0.0f) == a);
    worst.add_exact(form(a, b, 1.0f) == b);
    worst.add_exact(form(a, a, t) == a);
    const Real value = (1 - Real(t)) * a + Real(t) * b;
    const double half_ulp = 0.5 * ulp32(value);
    worst.add(form(a, b, t), value, a * b > 0 ? 2 * half_ulp : half_ulp + u32 * std::abs(a));
  }
  worst.add(form(-3e38f, 3e38f, 0.5f), 0, 1e30);
  worst.add(form(1e-40f, 2e-40f, 0.5f), Real(1.5) * Real(1e-40f), 0x1p-149);
  return worst;
}

TEST(ExtremeCase, MorphLerp) { expect_demand(lerp_error(morphcl::lerp<float>), lerp_error(naive::lerp)); }

template <typename Form>
Worst product_difference_error(Form form) {
  Worst worst;
  Random random(6);
  const auto add = [&](float a, float b, float c, float d) {
    const Real value = Real(a) * b - Real(c) * d;
    worst.add(form(a, b, c, d), value, 1.5 * ulp32(value));
  };
  add(33962.035f, -30438.8f, 41563.4f, -24871.969f);
  for (int i = 0; i < 20'000; ++i) {
    const float a = random.float_in(1, 2), b = random.float_in(1, 2), c = random.float_in(1, 2);
    add(a, b, c, static_cast<float>(static_cast<double>(a) * b / c * (1 + random.in(-1, 1) * 0x1p-20)));
  }
  return worst;
}

TEST(ExtremeCase, DifferenceOfProducts) {
  expect_demand(product_difference_error(morphcl::difference_of_products<float>),
                product_difference_error(naive::difference_of_products));
}

// The ratio of distances up to 1e6, attributes of one sign and of both.
template <typename Form>
Worst perspective_error(Form form) {
  Worst worst;
  Random random(11);
  for (int i = 0; i < 20'000; ++i) {
    const bool one_sign = i % 2 == 0;
    const float a1 = random.float_in(one_sign ? 0.25 : -1, 1), a2 = random.float_in(one_sign ? 0.25 : -1, 1);
    const float w1 = random.float_in(0.5, 2), w2 = static_cast<float>(w1 * std::pow(10.0, random.in(-6, 6)));
    const float t = i % 5 == 0 ? 1 - random.float_in(0, 1e-6) : random.float_in(0, 1);
    const Real first = (1 - Real(t)) * w2, second = Real(t) * w1, value = (a1 * first + a2 * second) / (first + second);
    worst.add(form(a1, w1, a2, w2, t), value,
              one_sign ? 5 * ulp32(value) : 5 * u32 * std::max(std::abs(a1), std::abs(a2)));
    worst.add_exact(form(a1, w1, a2, w2, 0) == a1 && form(a1, w1, a2, w2, 1) == a2);
  }
  return worst;
}

TEST(ExtremeCase, PerspectiveInterpolation) {
  expect_demand(perspective_error(perspective_lerp<float>), perspective_error(naive::perspective_lerp));
}

double half_ulp_of_half(const Real& value) { return 0.5 * std::max(ulp(static_cast<double>(value), 11), 0x1p-24); }

TEST(ExtremeCase, HalfStorage) {
  Worst stable, naive_form;
  Random random(7);
  std::vector<double> values = {1 + 0x1p-11 + 0x1p-40, 1 + 0x1p-11, 1 + 0x3p-11, 0x1p-25, 0x1p-25 + 0x1p-60, 65519.999};
  for (int i = 0; i < 20'000; ++i) values.push_back(random.in(-70'000, 70'000) * 0x1p-10);
  for (const double value : values) {
    stable.add(from_half(to_half(value)), value, half_ulp_of_half(value));
    naive_form.add(naive::half_by_way_of_float(value), value, half_ulp_of_half(value));
  }
  EXPECT_EQ(from_half(to_half(1 + 0x1p-11)), 1) << "a tie goes to even";
  EXPECT_EQ(from_half(to_half(1 + 0x3p-11)), 1 + 0x1p-9) << "a tie goes to even";
  EXPECT_TRUE(std::isinf(from_half(to_half(65520))));
  EXPECT_EQ(to_half(0.0), 0);
  EXPECT_EQ(to_half(-0.0), 0x8000);
  EXPECT_EQ(from_half(to_half(-0x1p-24)), -0x1p-24);

  // About the middle of the range: half an ulp of a half of size 1 times the range's scale.
  std::vector<double> far;
  for (int i = 0; i < 1000; ++i) far.push_back(random.in(1000, 1002));
  const HalfRange range = half_range(far);
  for (const double value : far) {
    stable.add(range.load(range.store(value)), value, 0x1p-12 * range.scale + 2 * ulp64(value));
    naive_form.add(naive::half_by_way_of_float(value), value, 0x1p-12 * range.scale + 2 * ulp64(value));
  }
  expect_demand(stable, naive_form);
}

}  // namespace
}  // namespace morphcl::accuracy
