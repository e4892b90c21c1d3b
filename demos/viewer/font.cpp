#include "demos/viewer/font.hpp"

#include <array>
#include <cctype>
#include <string_view>

namespace morphcl::viewer {
namespace {

// Some characters side by side, kGlyphAdvance columns each.
struct Band {
  std::string_view characters;
  std::array<std::string_view, kGlyphHeight> rows;
};

// clang-format off
constexpr std::array<Band, 3> kBands = {{
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
         "####   ###  ####   #### ##### #   # #   # #   # #   # #   # #####  ###    #    ###  ####  ",
         "#   # #   # #   # #       #   #   # #   # #   # #   # #   #     # #   #  ##   #   #     # ",
         "#   # #   # #   # #       #   #   # #   # #   #  # #   # #     #  #  ##   #       #     # ",
         "####  #   # ####   ###    #   #   # #   # # # #   #     #     #   # # #   #     ##   ###  ",
         "#     # # # # #       #   #   #   #  # #  # # #  # #    #    #    ##  #   #    #        # ",
         "#     #  #  #  #      #   #   #   #  # #  ## ## #   #   #   #     #   #   #   #         # ",
         "#      ## # #   # ####    #    ###    #   #   # #   #   #   #####  ###   ###  ##### ####  ",
     }}},
    {"456789.,:-/()",
     {{
         "#   # #####  ###  #####  ###   ###                              #    #   #    ",
         "#   # #     #         # #   # #   #              ##             #   #     #   ",
         "#   # ####  #        #  #   # #   #              ##            #   #       #  ",
         "#####     # ####     #   ###   ####                   #####   #    #       #  ",
         "    #     # #   #   #   #   #     #        ##    ##          #     #       #  ",
         "    # #   # #   #   #   #   #     #  ##     #    ##         #       #     #   ",
         "    #  ###   ###    #    ###   ###   ##    #                #        #   #    ",
     }}},
}};
// clang-format on

}  // namespace

bool glyph_dot(char character, int x, int y) {
  if (x < 0 || x >= kGlyphWidth || y < 0 || y >= kGlyphHeight) return false;
  const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
  for (const Band& band : kBands) {
    const std::size_t index = band.characters.find(capital);
    if (index != std::string_view::npos) return band.rows[y][index * kGlyphAdvance + x] == '#';
  }
  return false;
}

}  // namespace morphcl::viewer
