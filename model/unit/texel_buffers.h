#pragma once
/// The three two-dimensional buffers: shadow (depth), ID and edge (3.2, Table 1).
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kagesen::unit {

/// One texel of the three buffers, read at once.
struct Texel {
  static constexpr std::uint32_t kNoId = (1u << 30) - 1;
  static constexpr std::uint32_t kEdge = 1u << 30;  ///< the SLB holds lines of this texel
  static constexpr std::uint32_t kOverflow = 1u
                                             << 31;  ///< capacity ran out: only depth and ID count

  std::uint32_t depth = 0;  ///< nearest covering depth; the farthest there is where nothing covers
  std::uint32_t tag = kNoId;  ///< ID of what covers, and flags

  std::uint32_t id() const { return tag & kNoId; }
  bool edge() const { return (tag & kEdge) != 0; }
  bool overflow() const { return (tag & kOverflow) != 0; }
  void set_edge(bool on) { tag = on ? tag | kEdge : tag & ~kEdge; }
  void set_overflow() { tag |= kOverflow; }
  /// Keeps the nearer depth and its ID.
  void cover(std::uint32_t new_depth, std::uint32_t new_id) {
    if (new_depth >= depth) return;
    depth = new_depth;
    tag = (tag & ~kNoId) | new_id;
  }
};

class TexelBuffers {
 public:
  void clear(std::uint32_t width, std::uint32_t height, std::uint32_t farthest) {
    width_ = width;
    height_ = height;
    texels_.assign(std::size_t{width} * height, Texel{farthest, Texel::kNoId});
  }

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  bool holds(std::int32_t x, std::int32_t y) const {
    return static_cast<std::uint32_t>(x) < width_ && static_cast<std::uint32_t>(y) < height_;
  }
  std::uint32_t index(std::uint32_t x, std::uint32_t y) const { return y * width_ + x; }
  Texel& operator[](std::uint32_t index) { return texels_[index]; }
  const Texel& operator[](std::uint32_t index) const { return texels_[index]; }

 private:
  std::uint32_t width_ = 0, height_ = 0;
  std::vector<Texel> texels_;
};

}  // namespace kagesen::unit
