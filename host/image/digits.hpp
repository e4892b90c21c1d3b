// Digits and the minus sign in a raster of 5 x 7 pixels.
#pragma once

#include <string_view>

#include "host/image/png_file.hpp"

namespace morphcl {

inline constexpr int digit_width = 5, digit_height = 7, digit_advance = 6;  // pixels at scale 1

// Draws `text` with its upper left corner at (left, top), each raster pixel as a square of scale x scale. Other
// characters than digits and '-' are blanks; what lies outside the image is left out.
void draw_digits(RgbImage& image, int left, int top, int scale, std::string_view text, Rgb color);

}  // namespace morphcl
