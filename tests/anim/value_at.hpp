// A track of one value at a time.
#pragma once

#include <cmath>
#include <cstdint>

#include "morphcl/track.hpp"

namespace morphcl {

inline double value_at(const Track& track, std::int64_t tick) {
  double value = std::nan("");
  track.evaluate(tick, &value);
  return value;
}

}  // namespace morphcl
