// Frame rates that are written as decimals, as ratios of whole numbers.
#pragma once

#include <optional>
#include <string_view>

#include "morphcl/track.hpp"

namespace morphcl {

// 29.97 is 30000/1001, so are 23.976, 23.98, 59.94 and 119.88 such ratios; others are what their three decimals say:
// 12.5 is 25/2. Nothing for what is not from 0.001 to 1000.
std::optional<TimeBase> exact_rate(double frames_per_second);

// The rate of a text: "25", "29.97", "30000/1001". Nothing for other texts.
std::optional<TimeBase> rate_in_text(std::string_view text);

}  // namespace morphcl
