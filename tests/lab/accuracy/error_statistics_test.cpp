// The statistics of errors on arrays whose answers are known.
#include "lab/accuracy/error_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace morphcl::accuracy {
namespace {

ExactValue<Wide> exact(double value, double magnitude = 0) { return {Wide(value), Wide(magnitude)}; }

Figures figures_of(const ErrorStatistics& statistics) {
  Figures figures;
  statistics.write(figures);
  return figures;
}

TEST(Ulp, IsThatOfTheExactValuesBinade) {
  EXPECT_EQ(ulp_at(1.0, binary32), 0x1p-23);
  EXPECT_EQ(ulp_at(std::nextafter(2.0, 0.0), binary32), 0x1p-23);
  EXPECT_EQ(ulp_at(2.0, binary32), 0x1p-22);
  EXPECT_EQ(ulp_at(1.0, binary64), 0x1p-52);
}

TEST(Ulp, BelowTheNormalNumbersIsTheSmallestDenormal) {
  EXPECT_EQ(ulp_at(0x1p-126, binary32), 0x1p-149);
  EXPECT_EQ(ulp_at(0x1p-140, binary32), 0x1p-149);
  EXPECT_EQ(ulp_at(0.0, binary32), 0x1p-149);
  EXPECT_EQ(ulp_at(0.0, binary64), 0x1p-1074);
}

TEST(ErrorStatistics, MaximumAndRmsOfAKnownArray) {
  ErrorStatistics statistics(binary32);
  // Errors of 3 and 4 ulp of 1, and one exact: the rms of (3, 4, 0) is 5 / sqrt 3.
  statistics.add(1 + 3 * 0x1p-23, exact(1));
  statistics.add(1 - 4 * 0x1p-23, exact(1));
  statistics.add(1, exact(1));
  const Figures figures = figures_of(statistics);
  EXPECT_EQ(figures[Measure::max_ulp], 4);
  EXPECT_DOUBLE_EQ(figures[Measure::rms_ulp], 5 / std::sqrt(3.0));
  EXPECT_EQ(figures[Measure::max_absolute], 4 * 0x1p-23);
  EXPECT_DOUBLE_EQ(figures[Measure::rms_absolute], 5 * 0x1p-23 / std::sqrt(3.0));
  EXPECT_EQ(figures[Measure::not_finite], 0);
  EXPECT_FALSE(figures.has(Measure::max_scaled)) << "no terms were given to scale by";
}

TEST(ErrorStatistics, UlpsAndAbsoluteErrorsHaveTheirOwnMaxima) {
  ErrorStatistics statistics(binary32);
  statistics.add(1024 + 0x1p-13, exact(1024));            // one ulp
  statistics.add(0x1p-10 + 8 * 0x1p-33, exact(0x1p-10));  // eight, but a smaller error
  EXPECT_EQ(figures_of(statistics)[Measure::max_ulp], 8);
  EXPECT_EQ(figures_of(statistics)[Measure::max_absolute], 0x1p-13);
}

TEST(ErrorStatistics, ScaledErrorsAreInUnitRoundoffsOfTheTerms) {
  ErrorStatistics statistics(binary32);
  // 1 - 1 that came out as 2^-24: far off in ulps, one roundoff of terms that add up to 1.
  statistics.add(0x1p-24, exact(0, 1));
  EXPECT_EQ(figures_of(statistics)[Measure::max_scaled], 1);
  EXPECT_EQ(figures_of(statistics)[Measure::max_ulp], 0x1p-24 / 0x1p-149);
}

TEST(ErrorStatistics, AnErrorBelowTheDigitsOfADoubleIsSeen) {
  ErrorStatistics statistics(binary64);
  const ExactValue<Wide> value{Wide(1) + ldexp(Wide(1), -100), Wide(1)};
  statistics.add(1.0, value);
  EXPECT_EQ(figures_of(statistics)[Measure::max_absolute], 0x1p-100);
}

TEST(ErrorStatistics, WhatIsNotFiniteIsCountedAndNoError) {
  ErrorStatistics statistics(binary32);
  statistics.add(std::numeric_limits<double>::quiet_NaN(), exact(1));
  statistics.add(std::numeric_limits<double>::infinity(), exact(1));
  statistics.add(1, exact(1));
  EXPECT_EQ(figures_of(statistics)[Measure::not_finite], 2);
  EXPECT_EQ(figures_of(statistics)[Measure::max_ulp], 0);
}

TEST(ErrorStatistics, NothingFiniteIsInfinitelyWrong) {
  ErrorStatistics statistics(binary32);
  statistics.add(std::numeric_limits<double>::quiet_NaN(), exact(1));
  EXPECT_EQ(figures_of(statistics)[Measure::max_ulp], std::numeric_limits<double>::infinity());
  EXPECT_EQ(figures_of(statistics)[Measure::rms_absolute], std::numeric_limits<double>::infinity());
}

TEST(Figures, ArePrintedWithThreeDigitsAndComparedSo) {
  Figures a, b;
  EXPECT_EQ(printed(a[Measure::max_ulp]), "");
  EXPECT_TRUE(same_digits(a, b));
  a[Measure::max_ulp] = 1.2344;
  b[Measure::max_ulp] = 1.2341;
  EXPECT_EQ(printed(a[Measure::max_ulp]), "1.23");
  EXPECT_TRUE(same_digits(a, b));
  b[Measure::max_ulp] = 1.236;
  EXPECT_FALSE(same_digits(a, b));
}

}  // namespace
}  // namespace morphcl::accuracy
