// The elementary functions of host/math against MPFR: every result is the nearest double. (As many arguments as one has
// time for: morphcl_count_misroundings.)
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "morphcl/numerics.hpp"
#include "tests/math/elementary_arguments.hpp"
#include "tests/math/reference.hpp"

namespace morphcl {
namespace {

using reference::infinity;
using reference::RoundedFunction;

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

void expect_nearest(const RoundedFunction& function, double x) {
  const double computed = function.computed(x), exact = function.exact(x);
  EXPECT_EQ(computed, exact) << function.name << std::hexfloat << " of " << x << ": expected " << exact << ", actual "
                             << computed;
}

class CorrectRounding : public testing::TestWithParam<RoundedFunction> {};

TEST_P(CorrectRounding, OfAllKindsOfArguments) {
  reference::ElementaryArguments arguments(1);
  for (int i = 0; i < 70'000; ++i) expect_nearest(GetParam(), arguments.next());
}

TEST_P(CorrectRounding, OfEveryPowerOfTwoAndItsNeighbours) {
  for (int exponent = -1074; exponent < 1024; ++exponent)
    for (const double x : {std::ldexp(1.0, exponent), std::nextafter(std::ldexp(1.0, exponent), 0.0),
                           std::nextafter(std::ldexp(1.0, exponent), infinity)}) {
      if (std::isinf(x)) continue;
      expect_nearest(GetParam(), x);
      expect_nearest(GetParam(), -x);
    }
}

TEST_P(CorrectRounding, WhereFormulasAreExchanged) {
  const double borders[] = {0x1p-27,
                            0x1p-54,
                            0x1.921fb54442d18p-1,
                            0.34657359027997264,
                            37.42994775023705,
                            708,
                            709,
                            709.782712893384,
                            710,
                            745.1332191019412,
                            746,
                            38,
                            0x1p-30,
                            0x1p-31,
                            0x1p-900,
                            22.5,
                            45,
                            67.5,
                            90,
                            135,
                            360};
  for (double x : borders) {
    for (int i = 0; i < 20; ++i) x = std::nextafter(x, 0.0);
    for (int i = 0; i < 40; ++i) {
      expect_nearest(GetParam(), x);
      expect_nearest(GetParam(), -x);
      x = std::nextafter(x, infinity);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Functions, CorrectRounding, testing::ValuesIn(reference::rounded_functions()),
                         [](const auto& function) { return function.param.name; });

struct HardArgument {
  const char* function;
  double x;
  int bits;  // the value is within 2^-bits ulp of the middle of two doubles
};

// The first phase alone, of some 70 bits, cannot round these: the first three need more than 100, the others were the
// hardest in 16 million arguments each.
const HardArgument hard_arguments[] = {
    {"exponential", 0x1.9e9cbbfd6080bp-31, 58},
    {"exponential", 0x1p-53, 50},
    {"exponential", -0x1p-54, 50},
    {"exponential", -0x1.3753e34219895p-5, 27},
    {"exponential_minus_1", -0x1.ade01ea4d00efp-25, 22},
    {"sine", 0x1.1d48aeb54db0bp-2, 24},
    {"cosine", 0x1.51b6709356278p+18, 23},
    {"tangent", -0x1.3ee82e08dd04fp+19, 25},
    {"arc_tangent_over_1", -0x1.56de7fa04737bp+8, 24},
    {"arc_tangent_under_1", 0x1.335895295607p+30, 24},
    {"arc_tangent_over_minus_3", -0x1.b1b3df089f969p+4, 25},
    {"sine_degrees", 0x1.6ec92d6e56ad9p+30, 20},
    {"cosine_degrees", 0x1.8f52b04cdd3dap+4, 20},
};

TEST(HardArguments, AreHardAndCorrectlyRounded) {
  for (const HardArgument& hard : hard_arguments) {
    const std::string name = hard.function;
    const RoundedFunction& function = reference::rounded_function(name);
    EXPECT_GE(function.bits_to_tie(hard.x), hard.bits) << hard.function << std::hexfloat << " of " << hard.x;
    expect_nearest(function, hard.x);
  }
}

// The double closest to a multiple of pi/2: its cosine is 2^-60.9.
TEST(HardArguments, ClosestToAMultipleOfARightAngle) {
  const double x = std::ldexp(6381956970095103.0, 797);
  EXPECT_LT(std::abs(cosine(x)), 0x1p-60);
  for (const char* name : {"sine", "cosine", "tangent"}) expect_nearest(reference::rounded_function(name), x);
}

TEST(ArcTangent, OfVectorsOfAllSizes) {
  std::mt19937_64 engine(2);
  const auto any = [&] {
    const std::uint64_t sign_and_fraction = engine() & 0x800fffffffffffffu, exponent = engine() % 2047;
    return std::bit_cast<double>(sign_and_fraction | exponent << 52);
  };
  const auto unit = [&] { return std::ldexp(static_cast<double>(static_cast<std::int64_t>(engine())), -63); };
  for (int i = 0; i < 50'000; ++i) {
    const double y = i % 2 == 0 ? any() : unit(), x = i % 4 < 2 ? unit() : i % 3 == 0 ? any() : y * (1 + 1e-9 * unit());
    EXPECT_EQ(arc_tangent(y, x), reference::exact_arc_tangent(y, x)) << std::hexfloat << y << ", " << x;
  }
}

// y / x lies exactly in the middle of two subnormal doubles; the arc tangent is a little less.
TEST(ArcTangent, OfQuotientsBetweenSubnormals) {
  for (const double odd : {1.0, 3.0, 5.0, 7.0, 1023.0, 0x1.fffffffffffffp52})
    for (int halves = 1; halves < 4; ++halves) {
      const double y = odd * 0x1p-1074, x = std::ldexp(1.0, halves);
      EXPECT_EQ(arc_tangent(y, x), reference::exact_arc_tangent(y, x)) << odd << " / 2^" << halves;
    }
}

TEST(ArcTangent, OfZerosAndInfinities) {
  const double values[] = {0.0, -0.0, 1.0, -1.0, 1e-310, -1e308, infinity, -infinity};
  for (const double y : values)
    for (const double x : values)
      EXPECT_TRUE(same_bits(arc_tangent(y, x), reference::exact_arc_tangent(y, x)))
          << y << ", " << x << ": " << arc_tangent(y, x);
  EXPECT_TRUE(std::isnan(arc_tangent(std::nan(""), 1)));
  EXPECT_TRUE(std::isnan(arc_tangent(1, std::nan(""))));
}

TEST(SpecialValues, AsTheStandardRecommends) {
  for (const double bad : {infinity, -infinity, std::nan("")}) {
    EXPECT_TRUE(std::isnan(sine(bad)));
    EXPECT_TRUE(std::isnan(cosine(bad)));
    EXPECT_TRUE(std::isnan(tangent(bad)));
  }
  EXPECT_TRUE(same_bits(sine(-0.0), -0.0));
  EXPECT_TRUE(same_bits(tangent(-0.0), -0.0));
  EXPECT_EQ(cosine(-0.0), 1);
  EXPECT_EQ(exponential(infinity), infinity);
  EXPECT_TRUE(same_bits(exponential(-infinity), 0.0));
  EXPECT_TRUE(std::isnan(exponential(std::nan(""))));
  EXPECT_EQ(exponential_minus_1(infinity), infinity);
  EXPECT_EQ(exponential_minus_1(-infinity), -1);
  EXPECT_TRUE(same_bits(exponential_minus_1(-0.0), -0.0));
  EXPECT_TRUE(std::isnan(exponential_minus_1(std::nan(""))));
}

}  // namespace
}  // namespace morphcl
