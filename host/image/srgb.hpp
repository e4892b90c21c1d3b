// Scene-linear halves as the 8-bit sRGB codes (IEC 61966-2-1) of pictures for people.
#pragma once

#include <array>
#include <cstdint>

namespace morphcl {

// By the half's bits: its value for a mean, from 0 to 65504; negative values and NaN are 0, +Inf is 65504.
const std::array<float, 65536>& displayable_from_half();

// By the half's bits: the correctly rounded code of the value clamped to [0, 1]; NaN is 0.
const std::array<std::uint8_t, 65536>& srgb8_from_half();

// The same for a finite float, rounded to half first: that error stays below 1/20 of a code.
std::uint8_t srgb8(float linear);

// The value of a code, from 0 to 1.
float linear_from_srgb8(std::uint8_t code);

}  // namespace morphcl
