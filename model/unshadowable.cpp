#include "model/unshadowable.h"

#include <algorithm>
#include <cstddef>

#include "model/reference/triangle.h"

namespace kagesen {
namespace {

constexpr int kTileShift = 3;         // log2 of a tile's side, texels
constexpr std::int64_t kLargest = 8;  // tiles of one level that a caster may span an axis
constexpr std::uint32_t kFar = 0xffffffffu;
constexpr std::uint32_t kNobody = 0xffffffffu;

/// The two nearest objects of a tile, so that a fragment can pass over its own.
struct Tile {
  struct Surface {
    std::uint32_t depth = kFar, object = kNobody;
  };
  Surface first, second;

  void add(const Surface& s) {
    if (s.object == first.object) {
      first.depth = std::min(first.depth, s.depth);
    } else if (s.depth < first.depth) {
      second = first;
      first = s;
    } else if (s.depth < second.depth) {
      second = s;
    }
  }
};

/// Tiles of 8 x 8 texels, and coarser ones above them, each level half as fine.
class TilePyramid {
 public:
  TilePyramid(std::int64_t width, std::int64_t height) : width_(width), height_(height) {
    std::int64_t columns = ((width - 1) >> kTileShift) + 1;
    std::int64_t rows = ((height - 1) >> kTileShift) + 1;
    for (;;) {
      levels_.push_back({columns, std::vector<Tile>(std::size_t(columns * rows))});
      if (columns <= kLargest && rows <= kLargest) break;
      columns = (columns + 1) / 2;
      rows = (rows + 1) / 2;
    }
  }

  /// Texels, inclusive; what lies off the map is cut away.
  void add(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1,
           const Tile::Surface& surface) {
    if (x1 < 0 || y1 < 0 || x0 >= width_ || y0 >= height_) return;
    x0 = std::max<std::int64_t>(x0, 0) >> kTileShift;
    y0 = std::max<std::int64_t>(y0, 0) >> kTileShift;
    x1 = std::min(x1, width_ - 1) >> kTileShift;
    y1 = std::min(y1, height_ - 1) >> kTileShift;
    std::size_t level = 0;
    while (x1 - x0 >= kLargest || y1 - y0 >= kLargest) {
      x0 >>= 1, y0 >>= 1, x1 >>= 1, y1 >>= 1;
      ++level;
    }
    for (std::int64_t y = y0; y <= y1; ++y) {
      for (std::int64_t x = x0; x <= x1; ++x) levels_[level].at(x, y).add(surface);
    }
  }

  /// Hands what coarse tiles hold down to the finest ones.
  void settle() {
    for (std::size_t level = levels_.size() - 1; level > 0; --level) {
      Level& fine = levels_[level - 1];
      const auto rows = std::int64_t(fine.tiles.size()) / fine.columns;
      for (std::int64_t y = 0; y < rows; ++y) {
        for (std::int64_t x = 0; x < fine.columns; ++x) {
          const Tile& coarse = levels_[level].at(x >> 1, y >> 1);
          fine.at(x, y).add(coarse.first);
          fine.at(x, y).add(coarse.second);
        }
      }
    }
  }

  const Tile& tile_of_texel(std::int64_t x, std::int64_t y) {
    return levels_[0].at(x >> kTileShift, y >> kTileShift);
  }

 private:
  struct Level {
    std::int64_t columns;
    std::vector<Tile> tiles;
    Tile& at(std::int64_t x, std::int64_t y) { return tiles[std::size_t(y * columns + x)]; }
  };
  std::int64_t width_, height_;
  std::vector<Level> levels_;
};

}  // namespace

std::vector<std::uint8_t> find_unshadowable(const Trace& trace, const UnitConfig& config) {
  const std::uint32_t bits = trace.header.fraction_bits;
  const std::int64_t half_width = config.map_width / 2, half_height = config.map_height / 2;
  TilePyramid tiles(config.map_width, config.map_height);
  for (const Caster& c : trace.all_casters) {
    if (doubled_area(c) == 0) continue;
    const Box box = bounding_box(c);
    tiles.add((box.x0 >> bits) + half_width - 1, (box.y0 >> bits) + half_height - 1,
              (box.x1 >> bits) + half_width + 1, (box.y1 >> bits) + half_height + 1,
              {nearest_depth(c), c.object});
  }
  tiles.settle();

  std::vector<std::uint8_t> out(trace.header.objects.size(), 1);
  for (const Fragment& f : trace.all_fragments) {
    if (f.flags & (Fragment::kAverted | Fragment::kOutside)) continue;
    const std::int64_t x = (f.position.x >> bits) + half_width;
    const std::int64_t y = (f.position.y >> bits) + half_height;
    if (x < 0 || y < 0 || x >= config.map_width || y >= config.map_height) continue;
    const Tile& tile = tiles.tile_of_texel(x, y);
    const bool pass_over = config.semantics == Semantics::kPaper && tile.first.object == f.object;
    if ((pass_over ? tile.second : tile.first).depth < f.position.z) out[f.object] = 0;
  }
  return out;
}

}  // namespace kagesen
