#include <morphcl/track.hpp>

bool use_track() {
  const morphcl::TimeBase time;
  double value = 0;
  morphcl::Track::linear(time, {{0, 0.0}, {10, 1.0}}).evaluate(time.frame_ticks(5), &value);
  return value == 0.5;
}
