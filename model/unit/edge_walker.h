#pragma once
/// Edge walker: visits every texel an outline crosses (Fig. 5, Tables 2 and 3), exactly.
#include <algorithm>

#include "model/unit/edge_setup.h"

namespace kagesen::unit {

/// One texel of an outline.
struct OutlineTexel {
  std::int32_t x = 0, y = 0;  ///< from the map's origin
  Line line;                  ///< but for the polygon
  std::uint32_t nearest = 0;  ///< floor of the edge's least depth in the texel
};

/// How a texel is left (Table 2).
enum class Exit : std::uint8_t { kAlongMajor, kVertex, kAlongMinor };

/// Walks one edge: `for (EdgeWalker w(...);; w.step()) { use(w.texel()); if (w.last()) break; }`
///
/// The position is exact (an integer remainder decides every step); only Fraction is rounded, to
/// the nearest 2^-fraction_bits, ties up, saturated. The two cases of 3.3.1 and Table 3 are one
/// rule here: where the line, produced backwards, meets the texel's near major side at or above its
/// near minor side, Cross is 0 and Fraction is taken there; else Cross is 1 and it is taken at the
/// far side.
class EdgeWalker {
 public:
  EdgeWalker(const EdgeSetup& edge, int texel_bits, int fraction_bits)
      : e_(edge),
        texel_bits_(texel_bits),
        fraction_bits_(fraction_bits),
        major_(edge.first_major),
        minor_(edge.first_minor),
        near_(edge.minor),
        entry_depth_(edge.first_depth) {
    flags_ = static_cast<std::uint8_t>((edge.left ? Line::kLeft : 0) |
                                       (edge.x_major ? Line::kXMajor : 0) |
                                       (edge.x_positive ? Line::kXPositive : 0));
    look_ahead();
  }

  bool last() const { return major_ == e_.last_major && minor_ == e_.last_minor; }
  Exit exit() const { return exit_; }

  OutlineTexel texel() const {
    OutlineTexel out;
    const std::int32_t u = e_.x_major ? major_ : minor_;
    out.x = e_.x_positive ? u : -u - 1;
    out.y = e_.x_major ? minor_ : major_;
    const bool cross = near_.whole < 0;
    const bool start = major_ == e_.first_major && minor_ == e_.first_minor;
    out.line.fraction = static_cast<std::uint16_t>(
        round_to_field(cross ? far_.whole : near_.whole, texel_bits_, fraction_bits_));
    out.line.slope = static_cast<std::uint16_t>(e_.slope);
    out.line.flags =
        static_cast<std::uint8_t>(flags_ | (cross ? Line::kCross : 0) |
                                  (start ? Line::kStartHere : 0) | (last() ? Line::kEndHere : 0));
    out.nearest = static_cast<std::uint32_t>(std::min(entry_depth_, exit_depth()));
    return out;
  }

  /// To the next texel. @pre !last()
  void step() {
    entry_depth_ = exit_depth();
    if (exit_ != Exit::kAlongMinor) {
      ++major_;
      near_ = far_;
      e_.major_depth.advance();
    }
    if (exit_ != Exit::kAlongMajor) {
      ++minor_;
      near_.whole -= std::int64_t{1} << texel_bits_;
      e_.minor_depth.advance();
    }
    look_ahead();
  }

 private:
  std::int64_t exit_depth() const {
    if (last()) return e_.last_depth;
    return exit_ == Exit::kAlongMinor ? e_.minor_depth.whole : e_.major_depth.whole;
  }

  void look_ahead() {
    far_ = near_;
    far_.advance();
    const std::int64_t above = far_.whole - (std::int64_t{1} << texel_bits_);
    exit_ = above < 0                      ? Exit::kAlongMajor
            : above == 0 && far_.rest == 0 ? Exit::kVertex
                                           : Exit::kAlongMinor;
  }

  EdgeSetup e_;
  int texel_bits_, fraction_bits_;
  std::int32_t major_, minor_;
  ExactRamp near_, far_;  // minor coordinate at the near and at the far major side
  Exit exit_ = Exit::kAlongMajor;
  std::uint8_t flags_ = 0;
  std::int64_t entry_depth_;
};

}  // namespace kagesen::unit
