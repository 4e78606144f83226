#pragma once
/// Edge walker of the winding profile: an outline's pieces, texel by texel.
#include "model/unit/fixed.h"
#include "model/unit/winding/segment.h"
#include "traces/format/records.h"

namespace kagesen::unit::winding {

/// Walks one edge of a facet and clips it to every texel it runs through:
/// `for (EdgeWalker w(...);; w.step()) { use(w.x(), w.y()); if (w.last()) break; }`
///
/// The direction is canonical, towards +y and for horizontal edges towards +x, so that both facets
/// of a shared edge get the same pieces but for their sign. Texels are those of the paper's
/// profile. Positions are exact rationals; only the ends handed out are rounded. u is x, mirrored
/// where the edge travels towards -x, so that both coordinates grow.
class EdgeWalker {
 public:
  /// The edge a-b of a facet whose third vertex is `opposite`. @pre a and b differ in x or y
  EdgeWalker(const LightPoint& a, const LightPoint& b, const LightPoint& opposite, int texel_bits,
             int end_bits);

  std::int32_t x() const { return x_positive_ ? u_ : -u_ - 1; }
  std::int32_t y() const { return v_; }
  bool last() const { return u_ == last_u_ && v_ == last_v_; }
  void step();
  /// The piece in this texel. False where it is no part of it (see Segment).
  bool segment(Segment& out) const;

  /// The first and the last texel along x of this edge in the walker's row, without a step within
  /// the row; then next_row(). Not to be mixed with step().
  void row(std::int32_t& low_x, std::int32_t& high_x) const;
  void next_row();
  bool last_row() const { return v_ == last_v_; }

  /// What the edge's setup works out: borders that it crosses, and of the other coordinate how far
  /// it is to the first of them, and from border to border; rounded down.
  struct Figures {
    std::int32_t borders_u, borders_v;
    std::int64_t offset_v, step_v;  ///< where borders along u are crossed
    std::int64_t offset_u, step_u;
  };
  /// @pre no step was made
  Figures figures() const {
    return {last_u_ - u_,
            last_v_ - v_,
            v_at_u_.whole - entry_.v.whole,
            v_at_u_.step_whole,
            u_at_v_.whole - entry_.u.whole,
            u_at_v_.step_whole};
  }

 private:
  struct Exact {  // whole + a fraction in [0, 1), units
    std::int64_t whole, rest, base;
    bool integer() const { return rest == 0; }
  };
  struct End {
    Exact u, v;
  };
  std::int64_t texel() const { return std::int64_t{1} << bits_; }
  static Exact whole(std::int64_t value) { return {value, 0, 1}; }
  static Exact of(const ExactRamp& ramp) { return {ramp.whole, ramp.rest, ramp.base}; }
  bool leaves_u() const;
  bool leaves_v() const;
  End exit() const;
  std::int32_t snap(const Exact& value, std::int32_t texel_index) const;

  int bits_, end_bits_;
  bool x_positive_, positive_;  // positive_: the facet lies right of the direction of travel
  bool on_border_ = false;      // within the left or the lower border of its texels
  std::int32_t u_, v_, last_u_, last_v_;
  LightPoint to_{};            // u, v
  ExactRamp v_at_u_, u_at_v_;  // where the next border of the other axis is met
  End entry_;
};

}  // namespace kagesen::unit::winding
