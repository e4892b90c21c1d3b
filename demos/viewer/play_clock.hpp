// When the next frame of an animation that plays is due. A slow device shows every frame, only later.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

namespace morphcl::viewer {

// Times are seconds of one steady clock.
class PlayClock {
 public:
  explicit PlayClock(double frames_per_second) : period_(1.0 / frames_per_second) {}

  // Tells whether a frame is due at `now`; the first one a period after `playing` became true.
  bool take_due(bool playing, double now) {
    if (!playing) {
      due_.reset();
    } else if (!due_) {
      due_ = now + period_;
    } else if (now >= *due_) {
      due_ = std::max(*due_ + period_, now);
      return true;
    }
    return false;
  }

  double next_due() const { return due_.value_or(std::numeric_limits<double>::infinity()); }

 private:
  double period_;
  std::optional<double> due_;
};

}  // namespace morphcl::viewer
