#include "morphcl/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <string_view>

#include "morphcl/error.hpp"

namespace morphcl {

namespace {

constexpr std::size_t max_parts = 10'000;

[[noreturn]] void fail(std::string_view text, const std::string& message) {
  constexpr std::size_t shown = 60;
  const std::string start = text.size() > shown ? std::string(text.substr(0, shown)) + "..." : std::string(text);
  throw Error(ErrorKind::usage, "", fmt::format("frame range \"{}\": {}", start, message));
}

// Reads one part of a range from the front to the back.
class PartReader {
 public:
  PartReader(std::string_view whole, std::string_view part) : whole_(whole), part_(part), rest_(part) {}

  bool at_end() const { return rest_.empty(); }
  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  std::int64_t integer() {
    std::int64_t value = 0;
    const auto [end, problem] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (problem == std::errc::invalid_argument) refuse();
    if (problem == std::errc::result_out_of_range || value > max_frame_number || value < -max_frame_number)
      fail(whole_, fmt::format("frame numbers and steps reach from {} to {}", -max_frame_number, max_frame_number));
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }
  [[noreturn]] void refuse() const {
    fail(whole_, fmt::format("\"{}\" is not a frame or range; write for example 7, 1-10 or 1-10x2", part_));
  }

 private:
  std::string_view whole_, part_, rest_;
};

FrameRange parse_part(std::string_view whole, std::string_view part) {
  PartReader reader(whole, part);
  FrameRange range;
  range.first = range.last = reader.integer();
  if (reader.take('-')) {
    range.last = reader.integer();
    if (reader.take('x')) range.step = reader.integer();
  }
  if (!reader.at_end()) reader.refuse();
  if (range.last < range.first)
    fail(whole, fmt::format("{}-{} runs backwards; write {}-{}", range.first, range.last, range.last, range.first));
  if (range.step < 1) fail(whole, fmt::format("the step {} must be at least 1", range.step));
  return range;
}

std::string_view without_spaces_around(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

std::vector<FrameRange> parse_frame_range(const std::string& text) {
  if (text.find(':') != std::string::npos)
    fail(text, "':' is a step in some farms and an interleaved order in others; write the step as 1-10x2");
  std::vector<FrameRange> ranges;
  std::string_view rest = text;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    more = comma != std::string_view::npos;
    const std::string_view part = without_spaces_around(rest.substr(0, comma));
    if (part.empty()) fail(text, "a frame is missing; write for example 7, 1-10 or 1-10x2,20");
    if (ranges.size() == max_parts) fail(text, fmt::format("more than {} parts", max_parts));
    ranges.push_back(parse_part(text, part));
    if (more) rest.remove_prefix(comma + 1);
  }
  return ranges;
}

std::vector<std::int64_t> frame_numbers(const std::vector<FrameRange>& ranges) {
  std::int64_t listed = 0;
  for (const FrameRange& range : ranges) {
    if (range.step < 1 || range.first < -max_frame_number || range.last > max_frame_number)
      throw Error(ErrorKind::usage, "",
                  fmt::format("frames {}-{}x{}: frame numbers reach from {} to {}, steps start at 1", range.first,
                              range.last, range.step, -max_frame_number, max_frame_number));
    if (range.last >= range.first) listed += (range.last - range.first) / range.step + 1;
    if (listed > max_frame_count)
      throw Error(ErrorKind::usage, "", fmt::format("more than {} frames are asked for", max_frame_count));
  }
  if (listed == 0) throw Error(ErrorKind::usage, "", "the frame range holds no frame");
  std::vector<std::int64_t> frames;
  frames.reserve(static_cast<std::size_t>(listed));
  std::vector<std::ptrdiff_t> ends;  // of the ranges in `frames`
  for (const FrameRange& range : ranges) {
    for (std::int64_t frame = range.first; frame <= range.last; frame += range.step) frames.push_back(frame);
    ends.push_back(std::ssize(frames));
  }
  // Each ascends already, so neighbours are merged: a tenth of the time that sorting takes.
  while (ends.size() > 1) {
    std::vector<std::ptrdiff_t> merged;
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      const std::ptrdiff_t begin = merged.empty() ? 0 : merged.back(), end = ends[std::min(i + 1, ends.size() - 1)];
      std::inplace_merge(frames.begin() + begin, frames.begin() + ends[i], frames.begin() + end);
      merged.push_back(end);
    }
    ends.swap(merged);
  }
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

}  // namespace morphcl
