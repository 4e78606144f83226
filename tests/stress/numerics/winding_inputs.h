#pragma once
/// What the measurements of the winding profile share: default widths, edges and their walk.
#include "model/unit/winding/plane.h"
#include "tests/stress/numerics/geometry.h"

namespace kagesen::stress {

inline UnitConfig default_config() {
  UnitConfig config;
  config.profile = Profile::kWinding;
  return config;
}

inline bool is_fraction_bits(std::int64_t bits) {
  return bits >= kMinFractionBits && bits <= kMaxFractionBits;
}
inline unit::winding::Widths widths_for(std::int64_t fraction_bits) {
  return unit::winding::Widths(default_config(), static_cast<int>(fraction_bits));
}

/// x0 y0 z0 x1 y1 z1, how many texels along the walk, fraction bits.
inline Inputs draw_segment(Dice& dice) {
  Inputs in = draw_edge(dice);
  in.push_back(dice.one_in(2) ? 0 : dice.in(0, 100));
  in.push_back(dice.in(kMinFractionBits, kMaxFractionBits));
  return in;
}

inline const std::vector<std::string> kSegmentInputs = {"x0", "y0", "z0",   "x1",
                                                        "y1", "z1", "walk", "fraction_bits"};

}  // namespace kagesen::stress
