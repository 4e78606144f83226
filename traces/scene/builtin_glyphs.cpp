#include "traces/scene/builtin.h"
#include "traces/scene/fit.h"
#include "traces/scene/solids.h"

namespace kagesen {
namespace {

struct Glyph {
  const char* name;
  std::vector<std::string> rows;
};

// Strokes may not meet at a corner alone: the solid would not be a manifold there.
const std::vector<Glyph>& glyphs() {
  static const std::vector<Glyph> kGlyphs = {
      {"K", {"##..##", "##.###", "#####.", "####..", "#####.", "##.###", "##..##"}},
      {"A", {".####.", "######", "##..##", "##..##", "######", "##..##", "##..##"}},
      {"G", {".#####", "######", "##....", "##.###", "##..##", "######", ".#####"}},
      {"E", {"######", "######", "##....", "#####.", "##....", "######", "######"}},
      {"S", {".#####", "##....", "##....", "######", "....##", "....##", "#####."}},
      {"B", {"#####.", "##..##", "##..##", "######", "##..##", "##..##", "#####."}},
      {"8", {".####.", "##..##", "##..##", ".####.", "##..##", "##..##", ".####."}},
      {"H", {"##..##", "##..##", "##..##", "######", "##..##", "##..##", "##..##"}},
  };
  return kGlyphs;
}

/// Columns and rows of unequal width, so that strokes are thick and thin.
std::vector<double> spaced(const std::vector<double>& widths) {
  std::vector<double> at{0};
  for (const double w : widths) at.push_back(at.back() + w);
  return at;
}

}  // namespace

void build_glyphs(Scene& scene) {
  const std::vector<double> x = spaced({0.16, 0.22, 0.3, 0.3, 0.14, 0.18});
  const std::vector<double> y = spaced({0.24, 0.3, 0.36, 0.22, 0.34, 0.32, 0.2});
  int number = 0;
  for (const Glyph& glyph : glyphs()) {
    Object object = make_cells(glyph.rows, x, y, 0.14);
    for (glm::dvec3& p : object.positions) {
      p.x += 0.18 * p.y - 0.65;                // italic
      p.z += 0.1 * (p.x - 0.2) * (p.x - 0.2);  // and bent, so that no face is level with another
    }
    const int column = number % 4, row = number / 4;
    place(object, {-6.0 + 3 * column, 14.0 - 11 * column, 3.0 * row},
          {-2.9 + 1.9 * column + 0.5 * row, 0, 1.0 - 2.2 * row});
    rest_on_ground(object, 0.03 + 0.25 * row);
    const float tint = 0.1f * static_cast<float>(column);
    add(scene, std::move(object), glyph.name, {0.80f - tint, 0.42f + tint, 0.30f + 0.3f * row});
    ++number;
  }
  add_level_ground(scene, 0, 0, 8, 8);
  fit_camera(scene, 1.5);
  fit_light(scene);
}

}  // namespace kagesen
