#include "demos/viewer/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/image/font.hpp"

namespace morphcl::viewer {
namespace {

constexpr int kMargin = 4;      // dots between the box's border and the text, and the picture's and the box's
constexpr int kLargestDot = 4;  // pixels

struct Box {
  int left, top, right, bottom;  // half-open, pixels
};

void darken(RgbImage& picture, const Box& box) {
  constexpr int part = 4;  // the picture shines through
  const int right = std::min(box.right, picture.width), bottom = std::min(box.bottom, picture.height);
  for (int y = box.top; y < bottom; ++y) {
    for (int x = box.left; x < right; ++x) {
      Rgb& pixel = picture.at(x, y);
      pixel.red /= part;
      pixel.green /= part;
      pixel.blue /= part;
    }
  }
}

}  // namespace

std::vector<std::string> help_lines(const DemoLimits& limits) {
  std::vector<std::string> lines;
  for (const KeyInfo& entry : key_table()) {
    if (entry.name.empty() || (entry.needs_turn && limits.turn_ticks == 0)) continue;
    if (!entry.needs_steps || limits.last_step > 0) lines.push_back(fmt::format("{:<6} {}", entry.name, entry.does));
  }
  return lines;
}

void draw_text_box(const std::vector<std::string>& lines, RgbImage& picture) {
  int columns = 0;
  for (const std::string& line : lines) columns = std::max(columns, static_cast<int>(line.size()));
  const int width = columns * glyph_advance + 2 * kMargin;  // dots
  const int height = static_cast<int>(lines.size()) * line_advance + 2 * kMargin;
  // Half of the width at most, where a dot is not a single pixel already: the picture is what one came for.
  const int fitting = std::min(picture.width / 2 / (width + kMargin), picture.height / (height + 2 * kMargin));
  const int dot = std::clamp(fitting, 1, kLargestDot);

  const int corner = kMargin * dot;
  darken(picture, {corner, corner, corner + width * dot, corner + height * dot});
  int top = corner + kMargin * dot;
  for (const std::string& line : lines) {
    draw_text(picture, corner + kMargin * dot, top, dot, line, {255, 255, 255});
    top += line_advance * dot;
  }
}

}  // namespace morphcl::viewer
