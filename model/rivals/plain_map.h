#pragma once
/// The plain shadow map with object IDs: nearest depth and ID at each texel's centre.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/engine.h"
#include "model/reference/reference.h"

namespace kagesen {

/// One axis of a plain map: `side` texels over the extent of `map_side` unit texels.
///
/// A texel is sampled at its centre, rounded down to a light-space unit where the centre lies
/// between two. Exact for any side up to 2^24.
class PlainAxis {
 public:
  PlainAxis(std::uint64_t side, std::uint32_t map_side, std::uint32_t fraction_bits)
      : side_(std::int64_t(side)),
        extent_(std::int64_t{map_side} << fraction_bits),
        origin_(-(std::int64_t{map_side / 2} << fraction_bits)) {
    if (extent_ % side_ == 0 && is_power_of_two(extent_ / side_)) {
      while ((side_ << shift_) < extent_) ++shift_;
    } else {
      shift_ = kNoShift;
    }
  }
  std::int64_t side() const { return side_; }
  /// The texel that holds v; the first or the last for a v outside the map.
  std::int64_t texel(std::int32_t v) const {
    const std::int64_t offset = std::clamp<std::int64_t>(v - origin_, 0, extent_ - 1);
    return shift_ != kNoShift ? offset >> shift_ : offset * side_ / extent_;
  }
  /// Where a texel is sampled, units. May lie outside the range of coordinates on the largest maps.
  std::int64_t sample(std::int64_t texel) const {
    __extension__ using Wide = __int128;
    return origin_ + std::int64_t(Wide{2 * texel + 1} * extent_ / (2 * side_));
  }
  /// The first texel whose sample is at or after v: 0 to side.
  std::int64_t first_from(std::int64_t v) const;

 private:
  static constexpr int kNoShift = -1;
  static bool is_power_of_two(std::int64_t v) { return (v & (v - 1)) == 0; }

  std::int64_t side_, extent_, origin_;  ///< extent_, origin_: units
  int shift_ = 0;                        ///< log2 of units a texel
};

/// A plain map of `width` x `height` texels over the same area as a W x H unit map of
/// 2^fraction_bits units a texel. Holds depth and ID of the nearest surface at texel centres; of
/// surfaces of equal depth (rounded down) the first one drawn.
class PlainMap {
 public:
  PlainMap(std::uint32_t width, std::uint32_t height, std::uint32_t map_width,
           std::uint32_t map_height, std::uint32_t fraction_bits);
  /// Rasterises a caster: texels whose centre it covers (edges included).
  void draw(const Caster& caster);
  /// Paper semantics: dark iff the texel's ID differs from the fragment's and its depth is nearer.
  /// Physical: dark iff the depth is nearer by more than `bias`.
  Verdict decide(const Fragment& f, Semantics semantics, std::uint32_t bias = 0) const {
    return decide(sample(f), f, semantics, bias);
  }
  /// What the fragment's texel holds.
  DepthSample sample(const Fragment& f) const {
    const Texel& t =
        texels_[std::size_t(y_.texel(f.position.y) * x_.side() + x_.texel(f.position.x))];
    return {t.depth, t.object};
  }
  /// The verdict from the sample of the fragment's texel.
  static Verdict decide(const DepthSample& sample, const Fragment& f, Semantics semantics,
                        std::uint32_t bias = 0) {
    if (f.flags & Fragment::kAverted) return Verdict::kDark;
    if ((f.flags & Fragment::kOutside) || !sample.hit()) return Verdict::kLit;
    if (semantics == Semantics::kPaper) {
      const bool dark = sample.object != f.object && sample.depth < f.position.z;
      return dark ? Verdict::kDark : Verdict::kLit;
    }
    return std::uint64_t{sample.depth} + bias < f.position.z ? Verdict::kDark : Verdict::kLit;
  }
  /// What the map would cost in memory, packed; by default 24-bit depths and 16-bit IDs.
  std::uint64_t bytes(std::uint32_t depth_bits = kDepthBits, std::uint32_t id_bits = 16) const {
    return (texels_.size() * (depth_bits + id_bits) + 7) / 8;
  }

 private:
  struct Texel {
    std::uint32_t depth, object;
  };
  std::vector<Texel> texels_;  ///< row by row
  PlainAxis x_, y_;
  std::vector<std::int32_t> columns_;  ///< samples of the columns, units
};

/// What the fragment's texel would hold in a plain map of the given side, from one exact query at
/// its centre; for sides far too large to store.
DepthSample plain_map_sample(const ExactReference& reference, const Fragment& f, std::uint64_t side,
                             std::uint32_t map_width, std::uint32_t map_height,
                             std::uint32_t fraction_bits);
/// The verdict from that sample.
Verdict plain_map_verdict(const ExactReference& reference, const Fragment& f, Semantics semantics,
                          std::uint64_t side, std::uint32_t map_width, std::uint32_t map_height,
                          std::uint32_t fraction_bits);

}  // namespace kagesen
