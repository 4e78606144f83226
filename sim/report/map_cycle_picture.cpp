#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/report/fragment_figures.h"
#include "sim/report/palette.h"
#include "sim/report/pictures.h"

namespace kagesen {
namespace {

constexpr std::uint32_t kTile = PassCycles::kTile;
constexpr double kDoublings = 14;  // of a cycle a tile, until the scale ends
constexpr int kPanel = 512, kBand = 30, kGap = 8;

Rgb colour_of(double cycles) {
  return heat_colour(std::clamp(std::log2(std::max(cycles, 1.0)) / kDoublings, 0.0, 1.0));
}

/// Cycles of each tile of the map, row by row.
struct Tiles {
  std::uint32_t columns, rows;
  std::vector<std::uint64_t> cycles;
};

void draw_panel(Canvas& picture, int left, const char* title, const Tiles& tiles, int cell) {
  const Rgb ink{235, 235, 235};
  picture.text(left + 4, 4, title, ink);
  int x = left + 4;
  for (int doubling = 0; doubling <= int(kDoublings); doubling += 2) {
    const std::string words = fmt::format("{:.0f}", std::exp2(doubling));
    picture.rectangle(x, 16, 7, 7, colour_of(std::exp2(doubling)));
    picture.text(x + 10, 16, words, ink);
    x += 16 + Canvas::text_width(words);
  }
  for (std::uint32_t row = 0; row < tiles.rows; ++row) {
    for (std::uint32_t column = 0; column < tiles.columns; ++column) {
      const std::uint64_t here = tiles.cycles[std::size_t(row) * tiles.columns + column];
      if (here == 0) continue;
      picture.rectangle(left + int(column) * cell, kBand + int(row) * cell, cell, cell,
                        colour_of(double(here)));
    }
  }
}

}  // namespace

std::vector<std::uint64_t> fragment_tiles(const Trace& trace, const RunResult& result) {
  const MapContents& map = result.contents;
  const std::uint32_t columns = (map.width + kTile - 1) / kTile;
  std::vector<std::uint64_t> tiles(std::size_t(columns) * ((map.height + kTile - 1) / kTile));
  const std::vector<std::uint32_t> costs = fragment_costs(result.fragment_cycles);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    if ((trace.all_fragments[i].flags & Fragment::kOutside) != 0) continue;
    const auto texel = [&](std::int32_t place, std::uint32_t side) {
      return std::int64_t{place >> trace.header.fraction_bits} + side / 2;
    };
    const std::int64_t x = texel(trace.all_fragments[i].position.x, map.width);
    const std::int64_t y = texel(trace.all_fragments[i].position.y, map.height);
    if (x < 0 || y < 0 || x >= map.width || y >= map.height) continue;
    tiles[std::size_t(y / kTile) * columns + std::size_t(x / kTile)] += costs[i];
  }
  return tiles;
}

Canvas map_cycle_picture(const Trace& trace, const RunResult& result) {
  const MapContents& map = result.contents;
  Tiles tiles{(map.width + kTile - 1) / kTile, (map.height + kTile - 1) / kTile, {}};
  const int cell = std::max(1, kPanel / int(std::max(tiles.columns, tiles.rows)));
  const int panel = std::max(int(tiles.columns) * cell, kPanel / 2);
  Canvas picture(2 * panel + kGap, int(tiles.rows) * cell + kBand, {24, 24, 28});
  if (result.cycles->pass1 && !result.cycles->pass1->tiles.empty()) {
    tiles.cycles = result.cycles->pass1->tiles;
    draw_panel(picture, 0, "pass 1: cycles a tile of 8 x 8 texels", tiles, cell);
  }
  if (!result.fragment_cycles.empty()) {
    tiles.cycles = fragment_tiles(trace, result);
    draw_panel(picture, panel + kGap, "pass 2: cycles a tile of 8 x 8 texels", tiles, cell);
  }
  return picture;
}

}  // namespace kagesen
