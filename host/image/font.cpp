#include "host/image/font.hpp"

#include <array>

namespace morphcl {

namespace {

// Some characters side by side, glyph_advance columns each.
struct Band {
  std::string_view characters;
  std::array<std::string_view, glyph_height> rows;
};

// clang-format off
constexpr std::array<Band, 3> bands = {{
    {"ABCDEFGHIJKLMNO",
     {{
         " ###  ####   #### ####  ##### #####  #### #   #  ###    ### #   # #     #   # #   #  ###  ",
         "#   # #   # #     #   # #     #     #     #   #   #      #  #  #  #     ## ## ##  # #   # ",
         "#   # #   # #     #   # #     #     #     #   #   #      #  # #   #     # # # ##  # #   # ",
         "##### ####  #     #   # ####  ####  #  ## #####   #      #  ##    #     # # # # # # #   # ",
         "#   # #   # #     #   # #     #     #   # #   #   #      #  # #   #     #   # #  ## #   # ",
         "#   # #   # #     #   # #     #     #   # #   #   #   #  #  #  #  #     #   # #  ## #   # ",
         "#   # ####   #### ####  ##### #      #### #   #  ###   ##   #   # ##### #   # #   #  ###  ",
     }}},
    {"PQRSTUVWXYZ0123",
     {{
         "####   ###  ####   #### ##### #   # #   # #   # #   # #   # #####  ###    #    ###  ##### ",
         "#   # #   # #   # #       #   #   # #   # #   # #   # #   #     # #   #  ##   #   #    #  ",
         "#   # #   # #   # #       #   #   # #   # #   #  # #   # #     #  #  ##   #       #   #   ",
         "####  #   # ####   ###    #   #   # #   # # # #   #     #     #   # # #   #     ##    ##  ",
         "#     # # # # #       #   #   #   #  # #  # # #  # #    #    #    ##  #   #    #        # ",
         "#     #  #  #  #      #   #   #   #  # #  ## ## #   #   #   #     #   #   #   #     #   # ",
         "#      ## # #   # ####    #    ###    #   #   # #   #   #   #####  ###   ###  #####  ###  ",
     }}},
    {"456789.,:-/()",
     {{
         "   #  #####   ##  #####  ###   ###                              #    #   #    ",
         "  ##  #      #        # #   # #   #              ##             #   #     #   ",
         " # #  ####  #        #  #   # #   #              ##            #   #       #  ",
         "#  #      # ####    #    ###   ####                   #####   #    #       #  ",
         "#####     # #   #  #    #   #     #        ##    ##          #     #       #  ",
         "   #  #   # #   #  #    #   #    #   ##     #    ##         #       #     #   ",
         "   #   ###   ###   #     ###   ##    ##    #                #        #   #    ",
     }}},
}};
// clang-format on

void fill_square(RgbImage& image, int left, int top, int side, Rgb color) {
  for (int y = top; y < top + side; ++y)
    for (int x = left; x < left + side; ++x)
      if (x >= 0 && y >= 0 && x < image.width && y < image.height) image.at(x, y) = color;
}

}  // namespace

bool glyph_dot(char character, int x, int y) {
  if (x < 0 || x >= glyph_width || y < 0 || y >= glyph_height) return false;
  const bool small = character >= 'a' && character <= 'z';
  const char capital = small ? static_cast<char>(character - 'a' + 'A') : character;
  for (const Band& band : bands) {
    const std::size_t index = band.characters.find(capital);
    if (index != std::string_view::npos) return band.rows[y][index * glyph_advance + x] == '#';
  }
  return false;
}

void draw_text(RgbImage& image, int left, int top, int scale, std::string_view text, Rgb color) {
  for (const char character : text) {
    for (int y = 0; y < glyph_height; ++y)
      for (int x = 0; x < glyph_width; ++x)
        if (glyph_dot(character, x, y)) fill_square(image, left + x * scale, top + y * scale, scale, color);
    left += glyph_advance * scale;
  }
}

}  // namespace morphcl
