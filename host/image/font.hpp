// A font of 5 x 7 dots for a few words in a picture: capitals, digits and . , : - / ( ); the rest is blank.
#pragma once

#include <string_view>

#include "host/image/png_file.hpp"

namespace morphcl {

inline constexpr int glyph_width = 5, glyph_height = 7;     // dots
inline constexpr int glyph_advance = 6, line_advance = 10;  // dots from one character, or line, to the next

// Whether the character has a dot at column x, row y (0, 0 is the upper left). Small letters are drawn as capitals.
bool glyph_dot(char character, int x, int y);

// Draws one line with its upper left corner at (left, top), each dot as a square of scale x scale pixels. What lies
// outside the image is left out.
void draw_text(RgbImage& image, int left, int top, int scale, std::string_view text, Rgb color);

}  // namespace morphcl
