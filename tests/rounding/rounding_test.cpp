// The compiler keeps the roundings that are written, with the flags and the optimisation that ship.
#include <gtest/gtest.h>

#include <array>

#include "tests/rounding/roundings.hpp"

namespace morphcl::test {
namespace {

// No compiler knows what it reads here, nor may it keep a result unrounded.
volatile double source = 0.7123;

double source_number(int i) { return source * (i + 1); }

double rounded(double value) {
  volatile float stored = static_cast<float>(value);
  volatile double again = stored;
  return again;
}

std::array<double, 8> numbers() {
  std::array<double, 8> values;
  for (int i = 0; i < 8; ++i) values[static_cast<std::size_t>(i)] = source_number(i);
  return values;
}

// The first `count` of the numbers are rounded, the others are untouched.
void expect_rounded(const std::array<double, 8>& values, int count) {
  for (int i = 0; i < 8; ++i)
    EXPECT_EQ(values[static_cast<std::size_t>(i)], i < count ? rounded(source_number(i)) : source_number(i))
        << "number " << i;
}

TEST(Rounding, EveryNumberIsChangedByIt) {
  for (int i = 0; i < 8; ++i) EXPECT_NE(rounded(source_number(i)), source_number(i)) << i;
}

TEST(Rounding, OfNeighboursIsKept) {
  const auto check = [](void (*round)(double*), int count) {
    std::array<double, 8> values = numbers();
    round(values.data());
    expect_rounded(values, count);
  };
  check(round_pair, 2);
  check(round_triple, 3);
  check(round_four, 4);
  check(round_eight, 8);
}

TEST(Rounding, InALoopIsKept) {
  for (int count = 0; count <= 8; ++count) {
    std::array<double, 8> values = numbers();
    round_all(values.data(), count);
    expect_rounded(values, count);
  }
}

TEST(Rounding, OfProductsIsKept) {
  const std::array<double, 8> values = numbers();
  std::array<double, 2> products;
  scale_pair(products.data(), values.data());
  for (std::size_t i = 0; i < 2; ++i) {
    volatile double product = 1.5 * values[i];
    EXPECT_EQ(products[i], rounded(product)) << i;
  }
}

TEST(Rounding, LeavesARest) {
  const std::array<double, 8> values = numbers();
  std::array<double, 2> high, low;
  split_pair(high.data(), low.data(), values.data());
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(high[i], rounded(values[i])) << i;
    EXPECT_EQ(low[i], values[i] - rounded(values[i])) << i;
    EXPECT_NE(low[i], 0) << i;
  }
}

TEST(Rounding, OfADirectionThatIsAddedIsKept) {
  glm::dvec3 sum(0.0);
  add_stored(sum, {source_number(0), source_number(1), source_number(2)});
  EXPECT_EQ(sum, glm::dvec3(rounded(source_number(0)), rounded(source_number(1)), rounded(source_number(2))));
}

}  // namespace
}  // namespace morphcl::test
