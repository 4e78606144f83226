#include "sim/report/font.h"

#include <cctype>
#include <string_view>

namespace kagesen {
namespace {

/// Glyphs side by side, one blank column between them.
struct Strip {
  std::string_view letters;
  std::string_view rows[kGlyphHeight];
};

constexpr Strip kStrips[] = {
    {"ABCDEFGHIJKLM",
     {
         " ###  ####   ###  ####  ##### #####  ###  #   #  ###    ### #   # #     #   #",
         "#   # #   # #   # #   # #     #     #   # #   #   #      #  #  #  #     ## ##",
         "#   # #   # #     #   # #     #     #     #   #   #      #  # #   #     # # #",
         "##### ####  #     #   # ####  ####  # ### #####   #      #  ##    #     # # #",
         "#   # #   # #     #   # #     #     #   # #   #   #      #  # #   #     #   #",
         "#   # #   # #   # #   # #     #     #   # #   #   #   #  #  #  #  #     #   #",
         "#   # ####   ###  ####  ##### #      ###  #   #  ###   ##   #   # ##### #   #",
     }},
    {"NOPQRSTUVWXYZ",
     {
         "#   #  ###  ####   ###  ####   #### ##### #   # #   # #   # #   # #   # #####",
         "##  # #   # #   # #   # #   # #       #   #   # #   # #   # #   # #   #     #",
         "# # # #   # #   # #   # #   # #       #   #   # #   # #   #  # #   # #     # ",
         "#  ## #   # ####  #   # ####   ###    #   #   # #   # # # #   #     #     #  ",
         "#   # #   # #     # # # # #       #   #   #   # #   # # # #  # #    #    #   ",
         "#   # #   # #     #  #  #  #      #   #   #   #  # #  ## ## #   #   #   #    ",
         "#   #  ###  #      ## # #   # ####    #    ###    #   #   # #   #   #   #####",
     }},
    {"0123456789.,:",
     {
         " ###    #    ###  #####    #  #####   ##  #####  ###   ###                   ",
         "#   #  ##   #   #    #    ##  #      #        # #   # #   #              ##  ",
         "#  ##   #       #   #    # #  ####  #        #  #   # #   #              ##  ",
         "# # #   #      #     #  #  #      # ####    #    ###   ####                  ",
         "##  #   #     #       # #####     # #   #   #   #   #     #              ##  ",
         "#   #   #    #    #   #    #  #   # #   #   #   #   #    #   ##    ##    ##  ",
         " ###   ###  #####  ###     #   ###   ###    #    ###   ##    ##    #         ",
     }},
    {"+-/%()=<>_",
     {
         "                  ##      #   #               #   #        ",
         "  #             # ##  #  #     #             #     #       ",
         "  #            #     #  #       #   #####   #       #      ",
         "##### #####   #     #   #       #          #         #     ",
         "  #          #     #    #       #   #####   #       #      ",
         "  #         #     #  ##  #     #             #     #       ",
         "                     ##   #   #               #   #   #####",
     }},
};

}  // namespace

bool glyph_bit(char letter, int column, int row) {
  const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  for (const Strip& strip : kStrips) {
    const std::size_t index = strip.letters.find(capital);
    if (index == std::string_view::npos) continue;
    const std::size_t at = index * (kGlyphWidth + 1) + static_cast<std::size_t>(column);
    return at < strip.rows[row].size() && strip.rows[row][at] == '#';
  }
  return false;
}

}  // namespace kagesen
