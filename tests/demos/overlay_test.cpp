#include "demos/viewer/overlay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "host/image/font.hpp"

namespace morphcl::viewer {
namespace {

constexpr Rgb kGrey{200, 100, 40};

bool equal(const Rgb& a, const Rgb& b) { return a.red == b.red && a.green == b.green && a.blue == b.blue; }

std::ptrdiff_t count(const RgbImage& image, const Rgb& color) {
  return std::ranges::count_if(image.pixels, [&](const Rgb& pixel) { return equal(pixel, color); });
}

int dots_of(char character) {
  int dots = 0;
  for (int y = 0; y < glyph_height; ++y) {
    for (int x = 0; x < glyph_width; ++x) dots += glyph_dot(character, x, y) ? 1 : 0;
  }
  return dots;
}

TEST(Font, DrawsEveryCharacterOfTheHelpDifferently) {
  std::string seen;
  for (const std::string& line : help_lines({.last_step = 100})) {
    for (const char letter : line) {
      const char character = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
      if (character == ' ' || seen.find(character) != std::string::npos) continue;
      EXPECT_GT(dots_of(character), 0) << character;
      for (const char other : seen) {
        bool differs = false;
        for (int i = 0; i < glyph_width * glyph_height; ++i) {
          const int x = i % glyph_width, y = i / glyph_width;
          differs = differs || glyph_dot(character, x, y) != glyph_dot(other, x, y);
        }
        EXPECT_TRUE(differs) << character << " looks like " << other;
      }
      seen += character;
    }
  }
}

TEST(Overlay, HelpLeavesOutStepsOfASceneWithoutAny) {
  const auto with_steps = help_lines({.last_step = 100}), without = help_lines({.last_step = 0});
  EXPECT_EQ(with_steps.size(), key_table().size() - 2);   // the turn and its tick
  EXPECT_EQ(without.size(), key_table().size() - 2 - 3);  // k, p and space
  EXPECT_EQ(help_lines({.last_step = 100, .turn_ticks = 720}).size(), key_table().size() - 1);
  EXPECT_EQ(with_steps.front().substr(0, 2), "k ");
  EXPECT_EQ(without.front().substr(0, 2), "o ");
}

TEST(Overlay, BoxIsDarkenedTextIsWhiteTheRestIsKept) {
  RgbImage picture(60, 40, kGrey);
  draw_text_box({"HI", "K"}, picture);
  // One pixel a dot: a box of (2 x 6 + 8) x (2 x 10 + 8) dots.
  const int box_pixels = 20 * 28;
  const int text_pixels = dots_of('H') + dots_of('I') + dots_of('K');
  EXPECT_EQ(count(picture, {255, 255, 255}), text_pixels);
  EXPECT_EQ(count(picture, {50, 25, 10}), box_pixels - text_pixels);
  EXPECT_EQ(count(picture, kGrey), 60 * 40 - box_pixels);
  EXPECT_TRUE(equal(picture.at(3, 3), kGrey));
  EXPECT_TRUE(equal(picture.at(4, 4), {50, 25, 10}));
  EXPECT_TRUE(equal(picture.at(8, 8), {255, 255, 255})) << "upper left dot of H";
}

TEST(Overlay, TextGrowsWithThePicture) {
  RgbImage picture(1600, 1200, kGrey);
  draw_text_box({"HI"}, picture);
  EXPECT_EQ(count(picture, {255, 255, 255}), 4 * 4 * (dots_of('H') + dots_of('I')));
}

TEST(Overlay, PicturesThatAreTooSmallCutItOff) {
  for (const int side : {1, 4, 5, 9, 30}) {
    RgbImage picture(side, side, kGrey);
    draw_text_box(help_lines({.last_step = 100}), picture);
    EXPECT_EQ(count(picture, kGrey), side * side - std::max(0, side - 4) * std::max(0, side - 4)) << side;
  }
}

}  // namespace
}  // namespace morphcl::viewer
