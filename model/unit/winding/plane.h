#pragma once
/// The depth that a facet shadows beyond: a plane, stored texel by texel in few bits.
#include <cstdint>

#include "model/unit/config.h"
#include "model/unit/fixed.h"
#include "traces/format/records.h"

namespace kagesen::unit::winding {

/// Widths that follow from the configuration and the frame.
struct Widths {
  Widths() = default;
  Widths(const UnitConfig& config, int texel_bits_of_trace);

  int texel_bits = 16;    ///< log2 of a texel's units
  int fraction_bits = 8;  ///< F: the contract's radius is 2^-F texel
  int end_bits = 11;      ///< of a segment's ends, and of the place a plane is evaluated at
  int step_bits = 4;      ///< log2 of the depth step
  int gradient_bits = 7;  ///< mantissa
  std::int64_t tolerance = 16;

  static constexpr int kExponentBits = 5;
  /// A depth is kept modulo 2^kDepthRange: near a facet, where alone it is used, that is exact.
  static constexpr int kDepthRange = 31;
  int base_bits() const { return kDepthRange - step_bits; }
  int gradient_code_bits() const { return 1 + kExponentBits + gradient_bits; }
};

/// A depth per texel to sign, exponent and mantissa, nearest; and back. The smallest step is that
/// of the depth.
std::uint16_t encode_gradient(std::int64_t value, const Widths& w);
inline std::int64_t decode_gradient(std::uint16_t code, const Widths& w) {
  const int exponent = code >> w.gradient_bits & 31;
  const std::int64_t mantissa = code & ((1 << w.gradient_bits) - 1);
  const std::int64_t size = exponent == 0 ? mantissa << w.step_bits
                                          : (mantissa | std::int64_t{1} << w.gradient_bits)
                                                << (w.step_bits + exponent - 1);
  return code >> (w.gradient_bits + Widths::kExponentBits) ? -size : size;
}

/// The threshold in one texel, as stored: a fragment inside and strictly beyond it is dark.
struct Threshold {
  std::int32_t base = 0;  ///< at the texel's centre, units of 2^step_bits, modular
  std::uint16_t gradient_x = 0, gradient_y = 0;

  friend bool operator==(const Threshold& a, const Threshold& b) {
    return a.base == b.base && a.gradient_x == b.gradient_x && a.gradient_y == b.gradient_y;
  }
};

/// A threshold spread out: what its reader computes once.
struct ThresholdPlane {
  ThresholdPlane(const Threshold& t, const Widths& w)
      : base(t.base * (std::int64_t{1} << w.step_bits)),
        x(decode_gradient(t.gradient_x, w)),
        y(decode_gradient(t.gradient_y, w)) {}

  /// At a point of the texel. @param px, py  steps of 2^-end_bits texel from its lower corner
  std::int64_t at(std::int64_t px, std::int64_t py, const Widths& w) const {
    const std::int64_t half = std::int64_t{1} << (w.end_bits - 1);
    const std::int64_t depth = base + ((x * (px - half) + y * (py - half)) >> w.end_bits);
    constexpr std::int64_t kHalf = std::int64_t{1} << (Widths::kDepthRange - 1);
    return ((depth + kHalf) & (2 * kHalf - 1)) - kHalf;
  }
  std::int64_t steepness() const { return (x < 0 ? -x : x) + (y < 0 ? -y : y); }
  /// Too steep for its bounds over the texel to be known from what is stored.
  bool steep() const { return steepness() >= std::int64_t{1} << 27; }
  /// Bounds over the texel; none where it is steep.
  std::int64_t nearest() const { return steep() ? -kUnbounded : base - (steepness() + 1) / 2 - 1; }
  std::int64_t farthest() const { return steep() ? kUnbounded : base + (steepness() + 1) / 2; }

  static constexpr std::int64_t kUnbounded = std::int64_t{1} << Widths::kDepthRange;
  std::int64_t base, x, y;
};

/// The plane of a facet, in exact rationals.
///
/// A triangle no higher than r/4 over its longest edge (r = 2^-F texel) takes the depth along that
/// edge, or of its third vertex if that lies farther; one no longer than r/4 the depth of its
/// farthest vertex: across so little the plane means nothing, and its gradient would know no
/// bound. docs/unit.md has the errors.
class FacetPlane {
 public:
  /// @param shared  the triangle whose plane this facet shares with its neighbours, or null
  FacetPlane(const Caster& facet, const Caster* shared, const Widths& widths);

  /// The threshold in a texel: never nearer than the facet there and 2^-end_bits texel round it.
  Threshold in(std::int32_t texel_x, std::int32_t texel_y) const;
  /// base() of texels along a row, one addition each.
  ExactRamp ramp(std::int32_t texel_x, std::int32_t texel_y) const;
  /// What the setup divides; quotients are rounded down.
  struct Figures {
    enum Shape : std::uint8_t { kPlane, kNarrow, kTiny } shape;
    std::int64_t denominator;
    std::int64_t step_x, step_y;  ///< depth a texel
    std::int64_t start;           ///< in a texel, less the origin's
    std::int64_t third;  ///< narrow: along the longest edge, from one of its ends to the third vertex
  };
  /// @param facet  as at construction  @param texel_x, texel_y  of `start`
  Figures figures(const Caster& facet, std::int32_t texel_x, std::int32_t texel_y) const;
  Threshold at(const ExactRamp& depth) const { return {base(depth.whole), code_x_, code_y_}; }

 private:
  void take_plane(const Caster& c);
  bool take_narrow(const Caster& c);
  void store();
  std::int32_t base(std::int64_t centre_depth) const;

  Widths w_;
  // Depth at (x, y) from the origin, in units:
  // origin_z_ + (gradient_x_ x + gradient_y_ y) / denominator_.
  std::int64_t origin_x_ = 0, origin_y_ = 0, origin_z_ = 0;
  std::int64_t gradient_x_ = 0, gradient_y_ = 0, denominator_ = 1;
  Figures::Shape shape_ = Figures::kPlane;
  LightPoint narrow_third_{};  // beside the longest edge
  std::uint16_t code_x_ = 0, code_y_ = 0;
  std::int64_t bias_ = 0;
};

}  // namespace kagesen::unit::winding
