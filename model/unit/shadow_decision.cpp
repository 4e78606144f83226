#include "model/unit/shadow_decision.h"

#include <algorithm>

namespace kagesen::unit {
namespace {

constexpr unsigned kEnds = Line::kStartHere | Line::kEndHere;

bool has_both_ends(const Line& line) {
  return line.has(Line::kStartHere) && line.has(Line::kEndHere);
}

}  // namespace

/// Orders directions by angle: x+ (0 to 45 degrees), y+ (to 90), y- (to 135), x- (to 180).
std::uint32_t ShadowDecision::angle(const Line& line) const {
  const std::uint32_t most = (1u << slope_bits_) - 1;
  const bool positive = line.has(Line::kXPositive);
  const bool x_major = line.has(Line::kXMajor);
  const std::uint32_t octant = x_major ? (positive ? 0 : 3) : (positive ? 1 : 2);
  // Slope is minor over major: along x+ and y- it grows with the angle, along y+ and x- it falls.
  const std::uint32_t within = octant == 0 || octant == 2 ? line.slope : most - line.slope;
  return octant << slope_bits_ | within;
}

Combine ShadowDecision::by_table7(const Line& a, const Line& b) const {
  if (angle(a) == angle(b)) return by_fractions(a, b);  // parallel lines do not meet
  const bool a_first = angle(a) < angle(b);
  const Line& low = a_first ? a : b;
  const Line& high = a_first ? b : a;
  bool end_of_low = low.has(Line::kEndHere);
  if (vertex_rule_ == VertexRule::kPerLine) {
    // Outlines that go on from one line to the other have equal L/R, outlines that both start or
    // both end in their vertex do not. That tells which end of an edge that lies wholly here is the
    // shared one, and which lines cannot meet at all.
    if (has_both_ends(low) && has_both_ends(high)) return by_fractions(a, b);
    const bool goes_on = low.has(Line::kLeft) == high.has(Line::kLeft);
    const bool end_seen_from_high = high.has(Line::kEndHere) != goes_on;
    if (has_both_ends(low)) {
      end_of_low = end_seen_from_high;
    } else if (!has_both_ends(high) && end_of_low != end_seen_from_high) {
      return by_fractions(a, b);
    }
  }
  // Exp1: L/R of B xnor End of A.
  return high.has(Line::kLeft) == end_of_low ? Combine::kOr : Combine::kAnd;
}

Combine ShadowDecision::by_table7_printed(const Line& a, const Line& b) const {
  const bool exp1 = b.has(Line::kLeft) == a.has(Line::kEndHere);
  const Combine first = exp1 ? Combine::kOr : Combine::kAnd;
  const Combine second = exp1 ? Combine::kAnd : Combine::kOr;
  const bool a_x = a.has(Line::kXMajor), b_x = b.has(Line::kXMajor);
  const bool a_plus = a.has(Line::kXPositive), b_plus = b.has(Line::kXPositive);
  if (a_x == b_x && a_plus == b_plus) return a.slope <= b.slope ? first : second;
  if (a_x) return a_plus ? first : second;
  // (y+, x+) and (y-, x-) are not printed; they follow the order of the angles.
  if (b_x && a_plus == b_plus) return a_plus ? second : first;
  return a_plus ? first : second;
}

/// Does `line` hold the border point where `other` takes its Fraction?
bool ShadowDecision::holds_fraction_of(const Line& line, const Line& other) const {
  const std::int64_t one = std::int64_t{1} << fraction_bits_;
  const std::int64_t major = other.has(Line::kCross) ? one : 0;
  const std::int64_t minor = other.fraction;
  const bool x_major = other.has(Line::kXMajor);
  const std::int64_t u = x_major ? major : minor;
  const SubTexel point{other.has(Line::kXPositive) ? u : one - u, x_major ? minor : major,
                       fraction_bits_};
  return contains(line, point);
}

/// Of two half planes, one within the other: where both lines run through the texel they bound two
/// layers that overlap (OR); where one ends here, AND is right more often (measured).
Combine ShadowDecision::by_fractions(const Line& a, const Line& b) const {
  const bool a_holds = holds_fraction_of(a, b), b_holds = holds_fraction_of(b, a);
  const bool both_through = ((a.flags | b.flags) & kEnds) == 0;
  const bool joined = both_through ? a_holds && b_holds : a_holds || b_holds;
  return joined ? Combine::kAnd : Combine::kOr;
}

Combine ShadowDecision::combine(const Line& a, const Line& b, bool vertex) const {
  const bool meet = vertex_rule_ == VertexRule::kPerEntry
                        ? vertex
                        : (a.flags & kEnds) != 0 && (b.flags & kEnds) != 0;
  if (!meet) return by_fractions(a, b);
  return table7_ == Table7::kPrinted ? by_table7_printed(a, b) : by_table7(a, b);
}

bool ShadowDecision::inside_of_many(const Line* lines, std::uint32_t count, bool vertex,
                                    const SubTexel& point) const {
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!contains(lines[i], point)) continue;
    bool all = true;
    for (std::uint32_t j = 0; j < count && all; ++j) {
      all = j == i || contains(lines[j], point) ||
            combine(lines[i], lines[j], vertex) == Combine::kOr;
    }
    if (all) return true;
  }
  return false;
}

}  // namespace kagesen::unit
