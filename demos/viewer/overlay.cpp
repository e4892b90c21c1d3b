#include "demos/viewer/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "demos/viewer/font.hpp"

namespace morphcl::viewer {
namespace {

constexpr int kMargin = 4;      // dots between the box's border and the text, and the picture's and the box's
constexpr int kLargestDot = 4;  // pixels

struct Box {
  int left, top, right, bottom;  // half-open, pixels
};

template <typename Change>
void for_each_pixel(RgbImage& picture, const Box& box, Change change) {
  const int right = std::min(box.right, picture.width), bottom = std::min(box.bottom, picture.height);
  for (int y = box.top; y < bottom; ++y) {
    for (int x = box.left; x < right; ++x) change(picture.at(x, y));
  }
}

void darken(Rgb& pixel) {
  constexpr int part = 4;  // the picture shines through
  pixel.red /= part;
  pixel.green /= part;
  pixel.blue /= part;
}

void draw_character(char character, int left, int top, int dot, RgbImage& picture) {
  for (int y = 0; y < kGlyphHeight; ++y) {
    for (int x = 0; x < kGlyphWidth; ++x) {
      if (!glyph_dot(character, x, y)) continue;
      const int dot_left = left + x * dot, dot_top = top + y * dot;
      for_each_pixel(picture, {dot_left, dot_top, dot_left + dot, dot_top + dot},
                     [](Rgb& pixel) { pixel = {255, 255, 255}; });
    }
  }
}

}  // namespace

std::vector<std::string> help_lines(const DemoLimits& limits) {
  std::vector<std::string> lines;
  for (const KeyInfo& entry : key_table()) {
    if (!entry.needs_steps || limits.last_step > 0) lines.push_back(fmt::format("{:<6} {}", entry.name, entry.does));
  }
  return lines;
}

void draw_text_box(const std::vector<std::string>& lines, RgbImage& picture) {
  int columns = 0;
  for (const std::string& line : lines) columns = std::max(columns, static_cast<int>(line.size()));
  const int width = columns * kGlyphAdvance + 2 * kMargin;  // dots
  const int height = static_cast<int>(lines.size()) * kLineAdvance + 2 * kMargin;
  // Half of the width at most, where a dot is not a single pixel already: the picture is what one came for.
  const int fitting = std::min(picture.width / 2 / (width + kMargin), picture.height / (height + 2 * kMargin));
  const int dot = std::clamp(fitting, 1, kLargestDot);

  const int corner = kMargin * dot;
  for_each_pixel(picture, {corner, corner, corner + width * dot, corner + height * dot}, darken);
  int top = corner + kMargin * dot;
  for (const std::string& line : lines) {
    int left = corner + kMargin * dot;
    for (const char character : line) {
      draw_character(character, left, top, dot, picture);
      left += kGlyphAdvance * dot;
    }
    top += kLineAdvance * dot;
  }
}

}  // namespace morphcl::viewer
