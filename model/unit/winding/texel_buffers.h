#pragma once
/// Texel buffers of the winding profile: texels in tiles of 8 x 8, allocated as they are touched.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/unit/winding/plane.h"
#include "model/unit/winding/silhouette_buffer.h"

namespace kagesen::unit::winding {

/// One texel: nothing, one plane that covers it, or a list of clusters in the SLB.
struct Texel {
  static constexpr std::uint32_t kNobody = 0xffffffffu;  ///< object: nothing covers it
  static constexpr std::uint32_t kNoList = SilhouetteBuffer::kNone;
  static constexpr std::uint32_t kOverflow = kNoList - 1;  ///< list: capacity ran out

  std::uint32_t list = kNoList;
  std::uint32_t object = kNobody;  ///< of the cover; 0 in physical semantics
  /// Without a list: the cover's threshold. With one: base is the farthest depth of the nearest
  /// full cluster. Overflow: base is the depth beyond which a fragment is dark.
  Threshold cover;

  bool has_list() const { return list < kOverflow; }
  bool overflow() const { return list == kOverflow; }
  bool empty() const { return list == kNoList && object == kNobody; }
  bool one_plane() const { return list == kNoList && object != kNobody; }
};

/// 8 x 8 texels, and what is known of all of them at once.
struct Tile {
  static constexpr std::uint32_t kUntouched = 0xffffffffu;
  static constexpr std::uint32_t kSeveral = 0xfffffffeu;

  std::uint32_t slot = kUntouched;
  std::uint32_t object = Texel::kNobody;               ///< of all covers, kSeveral, or kNobody
  std::int64_t nearest = ThresholdPlane::kUnbounded;   ///< of every threshold in the tile
  std::int64_t farthest = ThresholdPlane::kUnbounded;  ///< some cover is nearer in every texel
  // Receiver mask.
  std::uint64_t occupied = 0;       ///< texels that a fragment falls into, row by row
  std::uint32_t last_fragment = 0;  ///< depth of the farthest
};

class TexelBuffers {
 public:
  static constexpr int kTileBits = 3;
  static constexpr std::uint32_t kTileTexels = 1u << (2 * kTileBits);

  void clear(std::uint32_t width, std::uint32_t height) {
    width_ = width;
    height_ = height;
    tiles_across_ = (width + 7) >> kTileBits;
    tiles_.assign(std::size_t{tiles_across_} * ((height + 7) >> kTileBits), Tile{});
    texels_.clear();
  }

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  bool holds(std::int32_t x, std::int32_t y) const {
    return static_cast<std::uint32_t>(x) < width_ && static_cast<std::uint32_t>(y) < height_;
  }
  Tile& tile(std::uint32_t x, std::uint32_t y) {
    return tiles_[(y >> kTileBits) * tiles_across_ + (x >> kTileBits)];
  }
  const Tile& tile(std::uint32_t x, std::uint32_t y) const {
    return tiles_[(y >> kTileBits) * tiles_across_ + (x >> kTileBits)];
  }
  static std::uint32_t within(std::uint32_t x, std::uint32_t y) {
    return (y & 7) << kTileBits | (x & 7);
  }
  /// Among the touched texels. @pre the tile is touched
  static std::uint32_t index(const Tile& tile, std::uint32_t x, std::uint32_t y) {
    return tile.slot * kTileTexels + within(x, y);
  }
  Texel& texel(const Tile& tile, std::uint32_t x, std::uint32_t y) {
    return texels_[index(tile, x, y)];
  }
  const Texel& texel(const Tile& tile, std::uint32_t x, std::uint32_t y) const {
    return texels_[index(tile, x, y)];
  }
  /// Gives the tile 64 empty texels: a map is cleared as far as it is used.
  void touch(Tile& tile) {
    tile.slot = static_cast<std::uint32_t>(texels_.size() / kTileTexels);
    texels_.resize(texels_.size() + kTileTexels);
  }
  std::uint64_t touched_texels() const { return texels_.size(); }
  std::size_t tile_count() const { return tiles_.size(); }
  std::vector<Tile>& tiles() { return tiles_; }
  const std::vector<Tile>& tiles() const { return tiles_; }

 private:
  std::uint32_t width_ = 0, height_ = 0, tiles_across_ = 0;
  std::vector<Tile> tiles_;
  std::vector<Texel> texels_;
};

}  // namespace kagesen::unit::winding
