#include "host/image/digits.hpp"

#include <array>
#include <cstdint>

namespace morphcl {

namespace {

// Row by row from the top, the leftmost pixel in bit 4.
using Glyph = std::array<std::uint8_t, digit_height>;

constexpr std::array<Glyph, 10> digits{{
    {0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110},
    {0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110},
    {0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111},
    {0b11111, 0b00010, 0b00100, 0b00110, 0b00001, 0b10001, 0b01110},
    {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010},
    {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110},
    {0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110},
    {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000},
    {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110},
    {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100},
}};
constexpr Glyph minus_glyph{0, 0, 0, 0b11111, 0, 0, 0};
constexpr Glyph blank_glyph{};

const Glyph& glyph(char c) {
  if (c >= '0' && c <= '9') return digits[static_cast<std::size_t>(c - '0')];
  return c == '-' ? minus_glyph : blank_glyph;
}

void fill_square(RgbImage& image, int left, int top, int side, Rgb color) {
  for (int y = top; y < top + side; ++y)
    for (int x = left; x < left + side; ++x)
      if (x >= 0 && y >= 0 && x < image.width && y < image.height) image.at(x, y) = color;
}

}  // namespace

void draw_digits(RgbImage& image, int left, int top, int scale, std::string_view text, Rgb color) {
  for (const char c : text) {
    const Glyph& rows = glyph(c);
    for (int y = 0; y < digit_height; ++y)
      for (int x = 0; x < digit_width; ++x)
        if (rows[static_cast<std::size_t>(y)] >> (digit_width - 1 - x) & 1)
          fill_square(image, left + x * scale, top + y * scale, scale, color);
    left += digit_advance * scale;
  }
}

}  // namespace morphcl
