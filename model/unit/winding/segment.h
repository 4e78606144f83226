#pragma once
/// What the winding profile keeps of an outline in a texel.
#include <cstdint>

namespace kagesen::unit::winding {

/// A piece of a facet's outline clipped to a texel, its ends rounded to 2^-end_bits texel, ties up.
///
/// An edge within the left or the lower border is no part of the texel: the corner sample, moved
/// by (+e^2, +e), lies on its other side already.
struct Segment {
  enum Flag : std::uint8_t {
    kPositive = 1,     ///< +1 for what lies right of it; of a crossing one, for what lies above
    kCrossesLeft = 2,  ///< end 0 is where it crosses the texel's left border
    kInner = 4,        ///< of an inner edge: the facet beyond it has the same plane
  };
  // 0 to 2^end_bits. End 0: the crossing of the left border, else the end travelled from.
  std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  std::uint8_t flags = 0;

  bool positive() const { return (flags & kPositive) != 0; }
  bool crosses_left() const { return (flags & kCrossesLeft) != 0; }
  /// Rounded to one point, which the winding number does not see: only who is near it does.
  bool dot() const { return x0 == x1 && y0 == y1 && !crosses_left(); }
  bool inner() const { return (flags & kInner) != 0; }
  bool may_meet() const { return inner() || dot(); }
  bool same_ends(const Segment& s) const {
    return x0 == s.x0 && y0 == s.y0 && x1 == s.x1 && y1 == s.y1;
  }
  /// The two pieces of an inner edge. Others never cancel, however equal: a needle whose sides
  /// round to one segment would vanish from between its neighbours.
  bool opposes(const Segment& s) const {
    return inner() && same_ends(s) && (flags ^ s.flags) == kPositive;
  }
};

/// A point within a texel, units of the trace.
struct Place {
  std::int64_t x, y;
};

/// What a point learns of a segment: what it adds to the winding number, and whether the point is
/// so near that rounding may have moved the outline across it.
struct Crossing {
  int winding = 0;
  bool near = false;
};

/// Is the point within half a step of the segment's bounding box?
/// @param shift  texel bits less end_bits: units a step of the ends = 2^shift
inline bool boxed(const Segment& s, const Place& p, int shift) {
  // Half a step, in units; half a unit reaches no farther along an axis than 0 does.
  const std::int64_t reach = shift == 0 ? 0 : std::int64_t{1} << (shift - 1);
  const auto between = [&](std::int64_t e, std::int64_t f, std::int64_t at) {
    return ((e < f ? e : f) << shift) - reach <= at && at <= ((e < f ? f : e) << shift) + reach;
  };
  return between(s.x0, s.x1, p.x) && between(s.y0, s.y1, p.y);
}

/// The winding number at a point is the corner count, plus the crossings of the left border at or
/// below the point, plus what the segments at or left of the point add. "Near" is a square of one
/// step round the point that touches the segment: half a step each way is what rounding moves.
inline Crossing crossing(const Segment& s, const Place& p, int shift) {
  const std::int64_t x0 = std::int64_t{s.x0} << shift, y0 = std::int64_t{s.y0} << shift;
  const std::int64_t x1 = std::int64_t{s.x1} << shift, y1 = std::int64_t{s.y1} << shift;
  const std::int64_t dx = x1 - x0, dy = y1 - y0;
  const std::int64_t side = dx * (p.y - y0) - dy * (p.x - x0);  // > 0: the point lies left of 0-1

  Crossing out;
  const int sign = s.positive() ? 1 : -1;
  if (s.crosses_left() && y0 <= p.y) out.winding += sign;
  // A crossing segment that rises from the border has its inside right of it where the border has
  // it below.
  const bool rises = y1 > y0;
  const bool level = rises ? y0 <= p.y && p.y < y1 : y1 <= p.y && p.y < y0;
  if (level && (rises ? side <= 0 : side >= 0)) {
    out.winding += s.crosses_left() && rises ? -sign : sign;
  }
  out.near = boxed(s, p, shift) &&
             2 * (side < 0 ? -side : side) <= ((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy)) << shift;
  return out;
}

}  // namespace kagesen::unit::winding
