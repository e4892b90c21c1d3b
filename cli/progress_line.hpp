// What a progress bar says, in as many columns as the terminal has.
#pragma once

#include <cstddef>
#include <string>

namespace morphcl::cli {

struct ProgressState {
  // checking: finished frames are looked for. compiling: no frame is drawn yet, and kernels are compiled for the first.
  enum class Phase { checking, compiling, drawing } phase = Phase::drawing;
  std::size_t done = 0, total = 0;  // frames; of checking those that were looked for
  std::size_t kernels = 0;          // compiled so far
  double frames_per_second = 0;     // 0: not known yet, and so is the time
  double seconds_left = 0;
};

// ASCII, shorter than `columns` (at least 1), so that no terminal wraps it. What does not fit is left out: the bar gets
// shorter, then the speed goes, then words, then the time; the count goes last. With `colors` escapes, which take no
// column, colour the bar.
std::string progress_line(const ProgressState& state, int columns, bool colors);

}  // namespace morphcl::cli
