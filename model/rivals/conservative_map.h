#pragma once
/// The conservative shadow map: what lies behind a triangle that covers a whole texel is surely
/// dark.
///
/// Source: Mizokuchi and Tokuyoshi, "Accelerating Frustum Traced Shadows Using Conservative Shadow
/// Maps" (IIEEJ 2018), sections 2.1 and 2.2, Table 3 and appendix A. There, as here, it spares the
/// exact test the fragments that it decides.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/unit/config.h"
#include "traces/format/records.h"

namespace kagesen {

/// When a triangle counts as covering a texel wholly. Both are decided exactly, in integers.
enum class CoverageTest : std::uint8_t {
  kCorners,  ///< all four corners lie inside or on its outline: necessary and sufficient
  kCircle,   ///< Hertel's: its edges leave the texel's circumscribed circle alone
};

/// Texels as the unit's: texel (i, j) of W x H covers [(i - W/2) T, (i + 1 - W/2) T] in x, T =
/// 2^fraction_bits units. Each keeps the nearest of its conservative depths: of every triangle that
/// covers it wholly, the depth of the plane's farthest corner there, rounded up.
class ConservativeMap {
 public:
  struct Texel {
    std::uint32_t depth = kDepthMax;  ///< kDepthMax, which nothing lies behind, where none covers
    std::uint32_t object = 0xffffffffu;  ///< of equal depths the lowest, whatever the order
  };
  ConservativeMap(std::uint32_t width, std::uint32_t height, std::uint32_t fraction_bits,
                  CoverageTest test);

  void draw(const Caster& caster);
  /// True only where the exact verdict is dark. A fragment that is averted, outside or off the map
  /// is left to others, and in paper semantics one whose own object the texel holds.
  bool surely_dark(const Fragment& f, Semantics semantics) const;

  const Texel& at(std::uint32_t column, std::uint32_t row) const {
    return texels_[std::size_t{row} * width_ + column];
  }
  std::uint64_t covered_texels() const;

 private:
  std::uint32_t width_, height_, fraction_bits_;
  CoverageTest test_;
  std::vector<Texel> texels_;  ///< row by row
};

/// What one coverage test brings and costs.
struct ReductionRate {
  std::uint64_t decided = 0;  ///< judged fragments that are surely dark
  std::uint64_t texels = 0;   ///< wholly covered ones
  double generation_s = 0;    ///< to clear the map and draw it, wall time, best of three
};
struct ReductionRates {
  std::uint64_t judged = 0;  ///< fragments that are neither averted, outside nor off the map
  ReductionRate corners, circle;
  /// The share of judged fragments that need no other test (the paper's Table 3), 0 to 1.
  double share(const ReductionRate& r) const {
    return judged ? double(r.decided) / double(judged) : 0;
  }
};

/// Both tests on a frame. Of the configuration, the map's size counts.
ReductionRates reduction_rates(const Trace& trace, const UnitConfig& config, Semantics semantics);

}  // namespace kagesen
