#include "morphcl/scene.hpp"

#include <gtest/gtest.h>

#include <set>

#include "morphcl/error.hpp"
#include "tests/support/random.hpp"

namespace morphcl {
namespace {

using Frames = std::vector<std::int64_t>;

Frames frames(const std::string& text) { return frame_numbers(parse_frame_range(text)); }

TEST(FrameRange, NamesFrames) {
  EXPECT_EQ(frames("7"), (Frames{7}));
  EXPECT_EQ(frames("1-4"), (Frames{1, 2, 3, 4}));
  EXPECT_EQ(frames("1-10x3"), (Frames{1, 4, 7, 10}));
  EXPECT_EQ(frames("1-9x3"), (Frames{1, 4, 7}));
  EXPECT_EQ(frames("3-3"), (Frames{3}));
}

TEST(FrameRange, TakesNegativeNumbers) {
  EXPECT_EQ(frames("-5"), (Frames{-5}));
  EXPECT_EQ(frames("-5--3"), (Frames{-5, -4, -3}));
  EXPECT_EQ(frames("-2-1"), (Frames{-2, -1, 0, 1}));
}

TEST(FrameRange, SortsAndDropsDoubles) { EXPECT_EQ(frames("8, 1-3 ,2-9x3"), (Frames{1, 2, 3, 5, 8})); }

std::string range_refusal(const std::string& text) {
  try {
    frames(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    return error.message();
  }
  return "accepted";
}

TEST(FrameRange, ExplainsWhatIsWrong) {
  const std::string form = "is not a frame or range; write for example 7, 1-10 or 1-10x2";
  EXPECT_EQ(
      range_refusal("1:5"),
      "frame range \"1:5\": ':' is a step in some farms and an interleaved order in others; write the step as 1-10x2");
  EXPECT_EQ(range_refusal("5-1"), "frame range \"5-1\": 5-1 runs backwards; write 1-5");
  EXPECT_EQ(range_refusal(""), "frame range \"\": a frame is missing; write for example 7, 1-10 or 1-10x2,20");
  EXPECT_EQ(range_refusal("1,,2"), "frame range \"1,,2\": a frame is missing; write for example 7, 1-10 or 1-10x2,20");
  EXPECT_EQ(range_refusal("1,"), "frame range \"1,\": a frame is missing; write for example 7, 1-10 or 1-10x2,20");
  EXPECT_EQ(range_refusal("abc"), "frame range \"abc\": \"abc\" " + form);
  EXPECT_EQ(range_refusal("1.5"), "frame range \"1.5\": \"1.5\" " + form);
  EXPECT_EQ(range_refusal("1-"), "frame range \"1-\": \"1-\" " + form);
  EXPECT_EQ(range_refusal("1x2"), "frame range \"1x2\": \"1x2\" " + form);
  EXPECT_EQ(range_refusal("1 - 3"), "frame range \"1 - 3\": \"1 - 3\" " + form);
  EXPECT_EQ(range_refusal("1-9x0"), "frame range \"1-9x0\": the step 0 must be at least 1");
  EXPECT_EQ(range_refusal("1-9x-2"), "frame range \"1-9x-2\": the step -2 must be at least 1");
  EXPECT_EQ(range_refusal("0-1000001"),
            "frame range \"0-1000001\": frame numbers and steps reach from -1000000 to 1000000");
  EXPECT_EQ(range_refusal("99999999999999999999"),
            "frame range \"99999999999999999999\": frame numbers and steps reach from -1000000 to 1000000");
}

TEST(FrameRange, IsBounded) {
  EXPECT_EQ(frames("1-1000000").size(), 1'000'000u);
  EXPECT_EQ(range_refusal("0-1000000"), "more than 1000000 frames are asked for");
  std::string many = "0";
  for (int i = 0; i < 10'000; ++i) many += ",0-999999";
  EXPECT_NE(range_refusal(many).find("more than 10000 parts"), std::string::npos);
}

TEST(FrameNumbers, AreThoseOfAllRangesOnceAndInOrder) {
  test_support::Random random(7);
  for (int list = 0; list < 2000; ++list) {
    std::vector<FrameRange> ranges;
    std::set<std::int64_t> expected = {0};
    ranges.push_back({.first = 0, .last = 0, .step = 1});
    for (long long i = random.integer_in(0, 8); i > 0; --i) {
      const std::int64_t first = random.integer_in(-30, 30);
      ranges.push_back({.first = first, .last = first + random.integer_in(-3, 30), .step = random.integer_in(1, 4)});
      for (std::int64_t k = first; k <= ranges.back().last; k += ranges.back().step) expected.insert(k);
    }
    EXPECT_EQ(frame_numbers(ranges), std::vector<std::int64_t>(expected.begin(), expected.end())) << list;
  }
}

TEST(FrameNumbers, NeedAFrame) {
  EXPECT_THROW(frame_numbers({}), Error);
  EXPECT_THROW(frame_numbers({{.first = 5, .last = 1, .step = 1}}), Error);
  EXPECT_THROW(frame_numbers({{.first = 1, .last = 5, .step = 0}}), Error);
}

}  // namespace
}  // namespace morphcl
