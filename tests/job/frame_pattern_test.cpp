#include "host/job/frame_pattern.hpp"

#include <gtest/gtest.h>

#include <climits>

#include "morphcl/error.hpp"

namespace morphcl {
namespace {

TEST(FramePattern, PlacesForTheNumber) {
  const struct {
    const char* pattern;
    std::int64_t frame;
    const char* path;
  } cases[] = {
      {"a.####.exr", 7, "a.0007.exr"},
      {"a.####.exr", 12345, "a.12345.exr"},
      {"a.##.exr", 7, "a.07.exr"},
      {"a.#.exr", 7, "a.0007.exr"},
      {"a.%04d.exr", 7, "a.0007.exr"},
      {"a.%02d.exr", 7, "a.07.exr"},
      {"a.%d.exr", 7, "a.7.exr"},
      {"a.%010d.exr", 7, "a.0000000007.exr"},
      {"####", 0, "0000"},
      {"a.####.exr", -5, "a.-005.exr"},
      {"a.%04d.exr", -5, "a.-005.exr"},
      {"a.%d.exr", -5, "a.-5.exr"},
      {"out/a.###.exr", 1, "out/a.001.exr"},
      {"/##/b/a_%03d", 1, "/##/b/a_001"},
      {"50%/a.##.exr", 1, "50%/a.01.exr"},
      {"100%.##.exr", 1, "100%.01.exr"},
      {"a%s.##", 1, "a%s.01"},
      {"{}{0}.##", 1, "{}{0}.01"},
      {"a.%05d", LLONG_MIN, "a.-9223372036854775808"},
  };
  for (const auto& [pattern, frame, path] : cases) {
    EXPECT_EQ(FramePattern(pattern).path(frame), path) << pattern;
    EXPECT_TRUE(FramePattern(pattern).has_number()) << pattern;
  }
}

TEST(FramePattern, WithoutPlaceIsThePathItself) {
  for (const char* pattern : {"a.exr", "out/a.exr", "##/a.exr", "a%.exr", "a%5d.exr", "a%0", "a%04x.exr", "a%%.exr"}) {
    EXPECT_FALSE(FramePattern(pattern).has_number()) << pattern;
    EXPECT_EQ(FramePattern(pattern).path(7), pattern);
  }
}

TEST(FramePattern, WhatMakesNoSenseIsAUsageError) {
  const std::string many(21, '#');
  for (const std::string& pattern :
       {std::string(), std::string("out/"), std::string("a##b##.exr"), std::string("a.##.%04d.exr"), many,
        std::string("a%021d"), std::string("a%0999999999999999999999d"), std::string("#.#")})
    try {
      FramePattern taken(pattern);
      // More digits than a format can ask for are no place for a number either.
      EXPECT_FALSE(taken.has_number()) << pattern;
      EXPECT_NE(pattern.find("99999"), std::string::npos) << pattern << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage) << pattern;
    }
}

TEST(FramePattern, TwentyDigitsAreTheMost) {
  EXPECT_EQ(FramePattern(std::string(20, '#')).path(3), "00000000000000000003");
}

}  // namespace
}  // namespace morphcl
