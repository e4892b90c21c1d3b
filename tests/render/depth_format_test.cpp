// What depth buffers keep of a distance, against 113 bits and the catalogue of extreme cases: near = 0.1, far = 1e5.
#include "morphcl/depth_format.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "tests/math/reference.hpp"
#include "tests/support/random.hpp"

namespace morphcl::test {
namespace {

using reference::infinity;
using Exact = boost::multiprecision::cpp_bin_float_quad;  // 113 bits

const DepthRange catalogue{0.1, 1e5};
const DepthRange depth_ranges[] = {catalogue,   {0.1, infinity}, {1e-3, 1e9},
                                   {0.5, 0.75}, {-3, 7, true},   {0.1, 1e4, true}};

Exact exact_value(DepthFormat format, const DepthRange& range, double distance) {
  const Exact n = range.near, f = range.far, d = distance;
  if (format == DepthFormat::reversed_float) return range.parallel ? Exact(-d) : Exact(n / d);
  const Exact ratio = std::isinf(range.far) ? Exact(0) : Exact(n / f);
  const Exact normalized_depth = range.parallel ? Exact((f - d) / (f - n)) : Exact((n / d - ratio) / (1 - ratio));
  return format == DepthFormat::forward_float ? Exact(1 - normalized_depth)
                                              : Exact(normalized_depth * Exact(steps_of(format)));
}

// Spacing of the numbers around a value.
double spacing(DepthFormat format, double value) {
  if (steps_of(format) > 0) return 1;
  const float size = std::abs(static_cast<float>(value));
  return std::nextafter(size, std::numeric_limits<float>::infinity()) - double{size};
}

class LogUniform {
 public:
  LogUniform(const DepthRange& range, unsigned seed)
      : range_(range), far_(std::isinf(range.far) ? 1e9 : range.far), random_(seed) {}
  double operator()() {
    const double u = random_.in(0, 1);
    return range_.parallel ? range_.near + u * (far_ - range_.near) : range_.near * std::pow(far_ / range_.near, u);
  }

 private:
  DepthRange range_;
  double far_;
  test_support::Random random_;
};

TEST(DepthFormat, StoresTheExactValueRoundedToNearest) {
  for (const DepthFormat format : depth_formats)
    for (const DepthRange& range : depth_ranges) {
      LogUniform distance(range, 11);
      for (int i = 0; i < 5000; ++i) {
        const double d = distance(), stored = stored_depth(format, range, d);
        const Exact exact = exact_value(format, range, d);
        const double half = 0.5 * spacing(format, stored) + 0x1p-48 * std::abs(static_cast<double>(exact));
        EXPECT_LE(abs(exact - Exact(stored)), half) << name_of(format) << " at " << d;
      }
    }
}

TEST(DepthFormat, KeepsTheOrderOfNeighbouringDistances) {
  for (const DepthFormat format : depth_formats)
    for (const DepthRange& range : depth_ranges) {
      LogUniform distance(range, 12);
      for (int i = 0; i < 5000; ++i) {
        const double d = distance(), next = std::nextafter(d, infinity);
        EXPECT_FALSE(is_nearer(format, stored_depth(format, range, next), stored_depth(format, range, d)))
            << name_of(format) << " at " << d;
      }
    }
}

TEST(DepthFormat, DistancesAreThoseOfTheNumbers) {
  for (const DepthFormat format : depth_formats)
    for (const DepthRange& range : depth_ranges) {
      LogUniform distance(range, 13);
      for (int i = 0; i < 2000; ++i) {
        const double stored = stored_depth(format, range, distance());
        const double back = distance_of_stored(format, range, stored);
        if (std::isinf(back)) continue;  // a far plane at infinity
        const Exact exact = exact_value(format, range, back);
        // 8u64 of the distance, seen through the slope of the stored value at it.
        const double reach = range.parallel ? std::max(std::abs(back), range.far - range.near) : back;
        const Exact beside = exact_value(format, range, back + 8 * 0x1p-53 * reach);
        EXPECT_LE(abs(exact - Exact(stored)), 1.001 * abs(exact - beside) + 0x1p-90) << name_of(format);
      }
    }
}

TEST(DepthFormat, PlanesHaveTheEndsOfTheRange) {
  for (const DepthRange& range : depth_ranges) {
    EXPECT_EQ(stored_depth(DepthFormat::forward_float, range, range.near), 0);
    EXPECT_EQ(stored_depth(DepthFormat::forward_float, range, range.far), 1);
    for (const DepthFormat format : {DepthFormat::fixed16, DepthFormat::fixed24, DepthFormat::fixed32}) {
      EXPECT_EQ(stored_depth(format, range, range.near), steps_of(format));
      EXPECT_EQ(stored_depth(format, range, range.far), 0);
    }
    if (!range.parallel) {
      EXPECT_EQ(stored_depth(DepthFormat::reversed_float, range, range.near), 1);
    }
  }
  EXPECT_EQ(stored_depth(DepthFormat::reversed_float, {0.1, infinity}, infinity), 0);
}

// Width of a bucket, z^2 (f - n) / (f n (2^b - 1)), float: the spacing of the stored value times the same slope.
TEST(DepthFormat, BucketsHaveTheWidthOfTheCatalogue) {
  const struct {
    double z, fixed16, fixed24, fixed32, forward, reversed;
  } rows[] = {{1, 0.0001526, 5.960e-7, 2.328e-9, 5.960e-7, 7.451e-8},
              {10, 0.01526, 5.960e-5, 2.328e-7, 5.960e-5, 9.313e-7},
              {100, 1.526, 0.005960, 2.328e-5, 0.005960, 1.164e-5},
              {1e4, 1.526e4, 59.60, 0.2328, 59.60, 0.0009095},
              {9e4, 1.236e6, 4828, 18.86, 4828, 0.009209}};
  for (const auto& row : rows)
    for (const auto& [format, width] : {std::pair{DepthFormat::fixed16, row.fixed16},
                                        {DepthFormat::fixed24, row.fixed24},
                                        {DepthFormat::fixed32, row.fixed32},
                                        {DepthFormat::forward_float, row.forward},
                                        {DepthFormat::reversed_float, row.reversed}}) {
      const double stored = stored_depth(format, catalogue, row.z), step = spacing(format, stored * (1 - 0x1p-30));
      const double slope = row.z * row.z / catalogue.near *
                           (format == DepthFormat::reversed_float ? 1 : 1 - catalogue.near / catalogue.far);
      EXPECT_NEAR(step / std::max(steps_of(format), 1.0) * slope / width, 1, 6e-4)
          << name_of(format) << " at " << row.z;
    }
}

// Ties per pair at a relative gap of 1e-5, distances log-uniform. Bound: four standard deviations of 200,000 draws
// (0.5 %) beside the two digits of the figures.
TEST(DepthFormat, TiesOfNeighboursAreThoseOfTheCatalogue) {
  constexpr int pairs = 200'000;
  for (const auto& [format, share] : {std::pair{DepthFormat::fixed16, 0.95},
                                      {DepthFormat::fixed24, 0.56},
                                      {DepthFormat::forward_float, 0.56},
                                      {DepthFormat::fixed32, 0.16},
                                      {DepthFormat::reversed_float, 0.0}}) {
    LogUniform distance(catalogue, 14);
    int ties = 0, inversions = 0;
    for (int i = 0; i < pairs; ++i) {
      const double d = distance();
      const double near = stored_depth(format, catalogue, d), far = stored_depth(format, catalogue, d * (1 + 1e-5));
      ties += near == far;
      inversions += is_nearer(format, far, near);
    }
    EXPECT_NEAR(static_cast<double>(ties) / pairs, share, 0.01) << name_of(format);
    EXPECT_EQ(inversions, 0) << name_of(format);
  }
}

// The demand of row "depth bucket", for what renderers compute: near times the rounded 1 / w, in fp32.
TEST(DepthFormat, DepthBucketReversedFloatHasNoTieAtAGapOf2ToTheMinus21) {
  const auto rendered = [](float near, float w) { return near * (1.0f / w); };
  const auto naive_forward = [](float near, float far, float w) {  // clip z over w, both rounded
    return (far / (far - near) * w - far * near / (far - near)) / w;
  };
  LogUniform distance(catalogue, 15);
  int ties = 0, inversions = 0, naive_inversions = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const auto w = static_cast<float>(distance());
    // The next float whose gap is at least 2^-21.
    auto behind = static_cast<float>(w * (1 + 0x1p-21));
    if (behind < w * (1 + 0x1p-21)) behind = std::nextafter(behind, std::numeric_limits<float>::infinity());
    ties += rendered(0.1f, w) == rendered(0.1f, behind);
    inversions += rendered(0.1f, w) < rendered(0.1f, behind);
    const auto clear = static_cast<float>(w * (1 + 1e-3));
    naive_inversions += naive_forward(0.1f, 1e5f, clear) < naive_forward(0.1f, 1e5f, w);
  }
  EXPECT_EQ(ties, 0);
  EXPECT_EQ(inversions, 0);
  EXPECT_GT(naive_inversions, 0) << "the naive form must miss";
}

TEST(DepthFormat, NamesAreReadBack) {
  for (const DepthFormat format : depth_formats) EXPECT_EQ(depth_format_named(name_of(format)), format);
  EXPECT_EQ(depth_format_named("fixed"), std::nullopt);
}

}  // namespace
}  // namespace morphcl::test
