#include "cli/progress_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace morphcl::cli {

namespace {

using Phase = ProgressState::Phase;

constexpr std::size_t longest_bar = 30, shortest_bar = 8;  // cells
constexpr std::size_t around_bar = 3;                      // brackets and a space

std::string clock_text(double seconds) {
  const long whole = std::lround(std::min(seconds, 359'999.0));  // at most 99:59:59
  return whole < 3600 ? fmt::format("{:02}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{:02}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string speed_text(double frames_per_second) {
  return frames_per_second >= 1 ? fmt::format("{:.1f} frames/s", frames_per_second)
                                : fmt::format("{:.1f} s/frame", 1 / frames_per_second);
}

// What to say, the longest first.
std::vector<std::string> words_of(const ProgressState& state) {
  const std::string count = fmt::format("{}/{}", state.done, state.total);
  switch (state.phase) {
    case Phase::checking:
      return {count + " frames, checking what is finished", "checking " + count, count};
    case Phase::compiling:
      return {
          fmt::format("{} frames  compiling kernels, {} so far; the first frame waits for them", count, state.kernels),
          fmt::format("{} frames  compiling kernels, {} so far", count, state.kernels),
          fmt::format("{}  compiling kernels", count), "compiling kernels", count};
    case Phase::drawing:
      break;
  }
  if (!(state.frames_per_second > 0)) return {count + " frames", count};
  const std::string left = clock_text(state.seconds_left);
  return {fmt::format("{} frames  {}  {} left", count, speed_text(state.frames_per_second), left),
          fmt::format("{} frames  {} left", count, left), fmt::format("{}  {} left", count, left),
          fmt::format("{}  {}", count, left), count};
}

std::string bar_of(const ProgressState& state, std::size_t cells, bool colors) {
  const std::size_t done = std::min(state.done, state.total);
  const std::size_t full = state.total == 0 ? cells : cells * done / state.total;
  const std::string filled(full, '#');
  return "[" + (colors ? "\033[32m" + filled + "\033[0m" : filled) + std::string(cells - full, '.') + "] ";
}

}  // namespace

std::string progress_line(const ProgressState& state, int columns, bool colors) {
  const std::size_t room = columns > 1 ? static_cast<std::size_t>(columns) - 1 : 0;
  const std::vector<std::string> words = words_of(state);
  const auto fits = [room](const std::string& text) { return text.size() <= room; };
  const auto longest = std::find_if(words.begin(), words.end(), fits);
  if (longest == words.end()) return words.back().substr(0, room);
  const std::size_t rest = room - longest->size();
  if (rest < around_bar + shortest_bar) return *longest;
  return bar_of(state, std::min(longest_bar, rest - around_bar), colors) + *longest;
}

}  // namespace morphcl::cli
