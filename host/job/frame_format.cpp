#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "host/job/frame_pattern.hpp"
#include "host/lower_case.hpp"
#include "morphcl/error.hpp"
#include "morphcl/job.hpp"

namespace morphcl {

namespace {

constexpr std::array<std::string_view, 10> video_endings{".mp4", ".mov", ".webm", ".mkv", ".avi",
                                                         ".m4v", ".mpg", ".mpeg", ".gif", ".apng"};

// The last of the name's parts that begin with a dot; "" when there is none, or when it holds a frame number.
std::string_view ending_of(std::string_view pattern) {
  const std::string_view name = pattern.substr(pattern.rfind('/') + 1);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || dot + 1 == name.size()) return {};
  const std::string_view ending = name.substr(dot);
  return ending.find_first_of("#%") == std::string_view::npos ? ending : std::string_view();
}

// The pattern with another ending, and a place for the frame number if it has none.
std::string with_ending(std::string_view pattern, std::string_view old_ending, std::string_view ending) {
  std::string other(pattern.substr(0, pattern.size() - old_ending.size()));
  const std::string_view name = std::string_view(other).substr(other.rfind('/') + 1);
  const bool has_number = name.find_first_of("#%") != std::string_view::npos;
  while (other.ends_with('.')) other.pop_back();
  return other + (has_number ? "" : ".####") + std::string(ending);
}

}  // namespace

FrameFormat frame_format(const std::string& pattern) {
  [[maybe_unused]] const FramePattern is_one(pattern);
  const std::string_view ending = ending_of(pattern);
  const std::string lower = lower_case(ending);
  if (lower == ".exr") return FrameFormat::exr;
  if (lower == ".png") return FrameFormat::png;
  const std::string exr = with_ending(pattern, ending, ".exr"), png = with_ending(pattern, ending, ".png");
  if (ending.empty())
    throw Error(
        ErrorKind::usage, "",
        fmt::format("the output '{}' does not end in what it is to be: '{}' for EXR frames, '{}' for PNG frames",
                    pattern, exr, png));
  if (std::find(video_endings.begin(), video_endings.end(), lower) != video_endings.end())
    throw Error(ErrorKind::usage, "",
                fmt::format("the output '{}' asks for a video, and morphcl writes frames; write '{}', and let another "
                            "tool make the video of them, as in ffmpeg -framerate 25 -i frame.%04d.png film{}",
                            pattern, png, lower));
  throw Error(ErrorKind::usage, "",
              fmt::format("the output '{}' ends in {}, and frames are EXR or PNG files: '{}' or '{}'; other tools "
                          "convert them",
                          pattern, ending, exr, png));
}

}  // namespace morphcl
