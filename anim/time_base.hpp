// Integer time. One second is fps_numerator * 1,000,000 ticks, so frame k starts at exactly k * fps_denominator *
// 1,000,000 ticks, and a key given in seconds is kept to 1/(fps_numerator * 1e6) s: closer than that, two keys are one.
#pragma once

#include <cstdint>

namespace morphcl {

struct TimeBase {
  std::int64_t fps_numerator = 25;   // > 0, at most 1,000,000
  std::int64_t fps_denominator = 1;  // > 0, at most 1,000,000

  std::int64_t ticks_per_second() const { return fps_numerator * 1'000'000; }
  std::int64_t ticks_per_frame() const { return fps_denominator * 1'000'000; }
  std::int64_t frame_ticks(std::int64_t frame) const { return frame * ticks_per_frame(); }  // |frame| <= 1,000,000
  // Nearest tick, ties to even; throws Error(bad_input) when not finite or beyond 2^62 ticks.
  std::int64_t seconds_to_ticks(double seconds) const;
  // The same for a time stored in 32 bits, as glTF does. Where `seconds` is the float nearest to a frame's time, that
  // frame is meant: a step at 1.04f must not come a frame late because 1.04f is a little more than 26/25. Keeps
  // different times apart.
  std::int64_t float_seconds_to_ticks(float seconds) const;
  std::int64_t frames_to_ticks(double frame) const;  // the same for a key given as a (fractional) frame number
};

}  // namespace morphcl
