// Frame ranges: which frames are asked for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace morphcl {

struct FrameRange {  // first, first + step, ... up to last
  std::int64_t first = 0, last = 0, step = 1;
};

constexpr std::int64_t max_frame_number = 1'000'000;
constexpr std::int64_t max_frame_count = 1'000'000;

// "7", "1-10", "1-10x2", commas between, spaces around them; negative numbers are allowed ("-5--1"). Error(usage)
// explains what is wrong: anything else, last < first, a step below 1, |frame| > max_frame_number, more than 10,000
// parts. A ':' is refused with the reason.
std::vector<FrameRange> parse_frame_range(const std::string& text);

// Every frame once, in ascending order. Error(usage): no frame, the ranges together list more than max_frame_count, or
// |frame| > max_frame_number.
std::vector<std::int64_t> frame_numbers(const std::vector<FrameRange>& ranges);

}  // namespace morphcl
