#include "sim/systemc/winding/plane_setup.h"

#include <algorithm>
#include <cstdlib>

namespace kagesen::tlm_model::winding {

void PlaneSetup::begin_pass(const UnitConfig& config, unsigned texel_bits) {
  const unit::winding::Widths widths(config, static_cast<int>(texel_bits));
  const auto fraction_bits = static_cast<unsigned>(widths.fraction_bits);
  constexpr unsigned kDenominatorBits = 57, kMaxFraction = 26;
  quotient_bits_ = (fraction_bits + 41) / 2 * 2;
  code_bits_ = static_cast<unsigned>(widths.step_bits + widths.gradient_bits + 1);
  small_area_ = std::int64_t{1} << (kDenominatorBits + 2 * (kMaxFraction - fraction_bits) - 3) / 2;
  next_ = in_flight_ = divider_ = 0;
}

Cycle PlaneSetup::triangle(const unit::winding::TriangleTrail& triangle, Cycle at,
                           EdgeSetup& first_edge) {
  const Figures& plane = triangle.plane;
  edge_ = &first_edge;
  edge_->begin(triangle.edges[0].figures, at + kArea + kFirstEdge);
  next_ = at + kProgram;
  encoder_ = 0;
  sum(kShortSum);  // area
  sum(kShortSum);  // corner function 0
  if (!triangle.shares) {
    sum(kShortSum);  // gradients
    sum(kShortSum);
  }
  sum(kShortSum);  // corner function 1
  const bool judged = !triangle.shares && triangle.twice_area < small_area_;
  // Of a narrow triangle it is worked out again: what it is at first, nobody waits for.
  step(plane.shape == Figures::kPlane ? plane.step_x : 0);
  sum(kShortSum);  // corner function 2
  if (judged) {
    for (int edge = 0; edge < 3; ++edge) sum(kShortSum);  // lengths
    sum(kSquareSum);
    const Cycle known = next_ - 1 + kSum;
    serve(*edge_, known + 1);
    next_ = std::max(next_, known + 1);
    if (plane.shape != Figures::kPlane) {
      divider_ = known + 1;
      encoder_ = 0;
      if (plane.shape == Figures::kNarrow) narrow(plane);
      step(plane.step_x);
    }
  }
  step(plane.step_y);
  encoded_ = encoder_ + 1;
  sum(kStartSum);
  const Cycle finished = std::max(divide(plane.start), encoded_);
  divider_ = finished + 1;
  return finished + 1;
}

/// The longest edge's gradient, and how far along it the third vertex lies.
void PlaneSetup::narrow(const Figures& plane) {
  sum(kNarrowSum);
  sum(kNarrowSum);
  sum(kShortSum);
  for (;;) {
    const Cycle before = next_;
    serve(*edge_, std::max(next_, in_flight_) + 1);
    next_ = std::max(next_, in_flight_);
    if (next_ == before) break;
  }
  sum(kShortSum);
  const Cycle done = divide(plane.third);
  divider_ = done + 1;
  serve(*edge_, done + 1);
  next_ = std::max(next_, done + 1);
}

/// A texel's step goes to the divider, and its quotient to the encoder.
void PlaneSetup::step(std::int64_t quotient) {
  sum(kShortSum);
  const Cycle taken = std::max(divide(quotient), encoder_);
  divider_ = taken + 1;
  encoder_ = taken + encoding_cycles(quotient);
}

void PlaneSetup::sum(Cycle digits) {
  serve(*edge_, next_ + 1);
  next_ += digits;
  in_flight_ = next_ + kSum;
}

/// The last sum is divided; no digit goes on until the divider has taken it. Returns when the quotient
/// is there.
Cycle PlaneSetup::divide(std::int64_t quotient) {
  const Cycle taken = std::max(next_ - 1 + kSum, divider_);
  next_ = taken + 1;
  return taken + division_cycles(quotient, quotient_bits_);
}

/// Products that are asked for before cycle `until`, while nothing else is to be worked out.
void PlaneSetup::serve(EdgeSetup& edge, Cycle until) {
  while (edge.wanted() != kNever && edge.wanted() < until) {
    next_ = std::max(next_, edge.wanted()) + kEdgeDigits;
    if (until != kNever) until = std::max(until, next_ + 1);
    in_flight_ = next_ + kSum;
    edge.product(next_ - 1 + kSum);
  }
}

/// From the cycle in which a gradient is taken to the one in which the encoder is free: normalised and
/// spread out again bit by bit.
Cycle PlaneSetup::encoding_cycles(std::int64_t gradient) const {
  const std::int64_t size = std::abs(gradient);
  Cycle exponent = 0;
  while (size >> (code_bits_ + exponent) != 0) ++exponent;
  return 8 + 2 * exponent;
}

}  // namespace kagesen::tlm_model::winding
