// Scene-linear halves as sRGB codes (IEC 61966-2-1) of 8 and 16 bits.
//
// One rule: the code is that of the exact value, clamped to [0, 1], times 255 or 65535, rounded to the nearest whole
// number, and up where two are as near. It is found among boundaries between codes, which are computed with correctly
// rounded operations alone, so that it is the same on every machine; the test shows that no value comes so near to a
// boundary that the rounding of one could decide.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace morphcl {

// By the half's bits: its value for a mean, from 0 to 65504; negative values and NaN are 0, +Inf is 65504.
const std::array<float, 65536>& displayable_from_half();

// By the half's bits: the correctly rounded code of the value clamped to [0, 1]; NaN is 0.
const std::array<std::uint8_t, 65536>& srgb8_from_half();
const std::array<std::uint16_t, 65536>& srgb16_from_half();

// The correctly rounded code of the value clamped to [0, 1]; NaN is 0.
std::uint16_t srgb16_of(double value);

// The correctly rounded code of gain * color / alpha, color and alpha displayable halves, alpha above 0.
std::uint16_t srgb16_of_ratio(float color, float alpha, double gain = 1);

// The code of 8 bits of the value that has this code of 16 bits: rounding twice is rounding once, as the boundaries
// between codes of 8 bits are boundaries between codes of 16 bits.
std::uint8_t srgb8_from_srgb16(std::uint16_t code);

// The same as srgb8_from_half() for a finite float, rounded to half first: that error stays below 1/20 of a code.
std::uint8_t srgb8(float linear);

// The value of a code, from 0 to 1, within 2^-49; as float within one rounding more.
double linear_from_srgb16(std::uint16_t code);
float linear_from_srgb8(std::uint8_t code);

// The values between the codes k and k + 1, k = 0 to 65534, ascending: of (2k + 1) / 131070. Up to k = 2650 the nearest
// doubles, above within 2^-49.
const std::vector<double>& srgb16_boundaries();

}  // namespace morphcl
