#pragma once
/// The three two-dimensional buffers: shadow (depth), ID and edge (3.2, Table 1).
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kagesen::unit {

/// One texel of the three buffers, read at once.
struct Texel {
  std::uint32_t depth = 0;  ///< nearest covering depth; farthest() where nothing covers
  std::uint32_t id : 30;
  std::uint32_t edge : 1;      ///< the SLB holds lines of this texel
  std::uint32_t overflow : 1;  ///< capacity ran out: only depth and ID count here
};

class TexelBuffers {
 public:
  static constexpr std::uint32_t kNoId = (1u << 30) - 1;

  void clear(std::uint32_t width, std::uint32_t height, std::uint32_t farthest) {
    width_ = width;
    height_ = height;
    Texel empty{};
    empty.depth = farthest;
    empty.id = kNoId;
    empty.edge = empty.overflow = 0;
    texels_.assign(std::size_t{width} * height, empty);
  }

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  bool holds(std::int32_t x, std::int32_t y) const {
    return static_cast<std::uint32_t>(x) < width_ && static_cast<std::uint32_t>(y) < height_;
  }
  std::uint32_t index(std::uint32_t x, std::uint32_t y) const { return y * width_ + x; }
  Texel& operator[](std::uint32_t index) { return texels_[index]; }
  const Texel& operator[](std::uint32_t index) const { return texels_[index]; }
  /// Keeps the nearer depth and its ID.
  static void write(Texel& texel, std::uint32_t depth, std::uint32_t id) {
    if (depth < texel.depth) {
      texel.depth = depth;
      texel.id = id;
    }
  }

 private:
  std::uint32_t width_ = 0, height_ = 0;
  std::vector<Texel> texels_;
};

}  // namespace kagesen::unit
