#pragma once
/// A silhouette line as the SLB stores it (3.1, Fig. 1), in one machine word.
#include <cstdint>

namespace kagesen::unit {

struct Line {
  enum Flag : std::uint8_t {
    kLeft = 1,   ///< L/R: the polygon lies to the right of the direction of travel
    kCross = 2,  ///< Fraction is taken at the texel's far side along the major axis
    kXMajor = 4,
    kXPositive = 8,
    kStartHere = 16,  ///< the lower end lies in this texel
    kEndHere = 32,    ///< End Flag: the upper end lies in this texel
  };
  std::uint16_t fraction = 0;  ///< UQ0.fraction_bits texel
  std::uint16_t slope = 0;     ///< UQ0.slope_bits
  std::uint32_t polygon : 24;
  std::uint32_t flags : 8;

  Line() : polygon(0), flags(0) {}
  bool has(Flag flag) const { return (flags & flag) != 0; }
};

}  // namespace kagesen::unit
