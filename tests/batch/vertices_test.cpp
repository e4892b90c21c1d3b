#include "host/batch/vertices.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <vector>

#include "morphcl/error.hpp"
#include "tests/batch/expect_usage_error.hpp"

namespace morphcl {
namespace {

using testing::expect_usage_error;
using Floats = Vertices<float>;

void expect_refused(const Vertices<const float>& in, const Floats& out, const std::string& text) {
  expect_usage_error([&] { check_in_and_out(in, out); }, text);
}

TEST(Vertices, CoordinatesAreFoundInEveryLayout) {
  std::vector<float> x = {1, 2}, y = {3, 4}, z = {5, 6}, records = {1, 3, 5, 7, 2, 4, 6, 8};
  for (const Floats& vertices : {Floats::separate(x, y, z), Floats::xyzw(records)}) {
    ASSERT_EQ(vertices.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_EQ(vertices.coordinates(axis)[i * vertices.stride()], static_cast<float>(1 + i + 2 * axis));
  }
  EXPECT_EQ(Floats::xyzw(records).carried()[4], 8);
  EXPECT_EQ(Floats::xyz(std::span(records).first(6)).part(1, 1).coordinates(0)[0], 7);
}

TEST(Vertices, ArraysHaveOneSizeAndRecordsAreWhole) {
  std::vector<float> eight(8), seven(7);
  expect_usage_error([&] { Floats::separate(eight, seven, eight); }, "arrays of 8, 7 and 8 coordinates");
  expect_usage_error([&] { Floats::separate(eight, eight, seven); }, "arrays of 8, 8 and 7 coordinates");
  expect_usage_error([&] { Floats::xyz(eight); }, "8 values are not whole xyz vertices; a multiple of 3");
  expect_usage_error([&] { Floats::xyzw(seven); }, "7 values are not whole xyzw vertices; a multiple of 4");
}

TEST(Vertices, InAndOutHaveOneLayoutAndSize) {
  std::vector<float> in(12), out(12), longer(24);
  expect_refused(Floats::xyz(in), Floats::xyzw(out), "the input is xyz and the output xyzw");
  expect_refused(Floats::xyz(in), Floats::xyz(longer), "4 vertices in and 8 out");
}

TEST(Vertices, OutputsAreApartFromEachOtherAndFromInputsOrTheSame) {
  std::vector<float> a(32), b(32), c(32), d(32), e(32), f(32);
  const auto first = [](std::vector<float>& values) { return std::span(values).first(16); };
  const auto shifted = [](std::vector<float>& values) { return std::span(values).subspan(8, 16); };
  const Floats in = Floats::separate(first(a), first(b), first(c));
  expect_refused(in, Floats::separate(first(d), first(d), first(f)), "two output arrays share memory");
  expect_refused(in, Floats::separate(first(d), first(e), shifted(e)), "two output arrays share memory");
  expect_refused(in, Floats::separate(first(d), first(e), shifted(a)), "begins inside an input array");
  expect_refused(Floats::xyzw(first(a)), Floats::xyzw(shifted(a)), "begins inside an input array");
  check_in_and_out<float>(in, in);
  check_in_and_out<float>(in, Floats::separate(first(c), first(a), first(b)));
  check_in_and_out<float>(in, Floats::separate(std::span(a).last(16), first(e), first(f)));
}

}  // namespace
}  // namespace morphcl
