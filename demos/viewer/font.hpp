// A font of 5 x 7 dots for a few words over a picture: capitals, digits and . , : - / ( ); the rest is blank.
#pragma once

namespace morphcl::viewer {

constexpr int kGlyphWidth = 5, kGlyphHeight = 7;     // dots
constexpr int kGlyphAdvance = 6, kLineAdvance = 10;  // dots from one character, or line, to the next

// Whether the character has a dot at column x, row y (0, 0 is the upper left). Small letters are drawn as capitals.
bool glyph_dot(char character, int x, int y);

}  // namespace morphcl::viewer
