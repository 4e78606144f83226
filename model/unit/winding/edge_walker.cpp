#include "model/unit/winding/edge_walker.h"

#include <utility>

namespace kagesen::unit::winding {

EdgeWalker::EdgeWalker(const LightPoint& a, const LightPoint& b, const LightPoint& opposite,
                       int texel_bits, int end_bits)
    : bits_(texel_bits), end_bits_(end_bits) {
  const bool swap = b.y < a.y || (b.y == a.y && b.x < a.x);
  const LightPoint& from = swap ? b : a;
  const LightPoint& to = swap ? a : b;
  const std::int64_t dx = std::int64_t{to.x} - from.x, dy = std::int64_t{to.y} - from.y;
  positive_ = dx * (std::int64_t{opposite.y} - from.y) < dy * (std::int64_t{opposite.x} - from.x);
  x_positive_ = dx >= 0;
  const std::int32_t u0 = x_positive_ ? from.x : -from.x, v0 = from.y;
  to_ = {x_positive_ ? to.x : -to.x, to.y, 0};
  const std::int64_t du = std::int64_t{to_.x} - u0, dv = dy;
  u_ = u0 >> bits_;
  v_ = v0 >> bits_;
  const auto last = [this](std::int64_t end, std::int64_t extent) {
    return static_cast<std::int32_t>((extent > 0 ? end - 1 : end) >> bits_);
  };
  last_u_ = last(to_.x, du);
  last_v_ = last(to_.y, dv);
  const std::int64_t mask = texel() - 1;
  on_border_ = (du == 0 && (u0 & mask) == 0) || (dv == 0 && (v0 & mask) == 0);
  if (du > 0) v_at_u_ = ExactRamp::make(v0, (texel() - (u0 & mask)) * dv, dv * texel(), du);
  if (dv > 0) u_at_v_ = ExactRamp::make(u0, (texel() - (v0 & mask)) * du, du * texel(), dv);
  entry_ = {whole(u0), whole(v0)};
}

/// Does the edge leave the texel through, or at an end of, its far border along u?
bool EdgeWalker::leaves_u() const {
  if (u_ == last_u_) return false;
  if (v_ == last_v_) return true;
  const std::int64_t border = (std::int64_t{v_} + 1) * texel();
  return v_at_u_.whole < border || (v_at_u_.whole == border && v_at_u_.rest == 0);
}

bool EdgeWalker::leaves_v() const {
  if (v_ == last_v_) return false;
  if (u_ == last_u_) return true;
  return v_at_u_.whole >= (std::int64_t{v_} + 1) * texel();
}

EdgeWalker::End EdgeWalker::exit() const {
  const bool along_u = leaves_u(), along_v = leaves_v();
  if (!along_u && !along_v) return {whole(to_.x), whole(to_.y)};
  return {along_u ? whole((std::int64_t{u_} + 1) * texel()) : of(u_at_v_),
          along_v ? whole((std::int64_t{v_} + 1) * texel()) : of(v_at_u_)};
}

void EdgeWalker::step() {
  const bool along_u = leaves_u(), along_v = leaves_v();
  entry_ = exit();
  if (along_u) {
    ++u_;
    v_at_u_.advance();
  }
  if (along_v) {
    ++v_;
    u_at_v_.advance();
  }
}

std::int32_t EdgeWalker::snap(const Exact& value, std::int32_t texel_index) const {
  const std::int64_t within = value.whole - texel_index * texel();
  const int shift = bits_ - end_bits_;
  if (shift == 0) return static_cast<std::int32_t>(within + (2 * value.rest >= value.base));
  return static_cast<std::int32_t>((within + (std::int64_t{1} << (shift - 1))) >> shift);
}

bool EdgeWalker::segment(Segment& out) const {
  if (on_border_) return false;
  const End leave = exit();
  const std::int32_t side = 1 << end_bits_;
  const std::int32_t u0 = snap(entry_.u, u_), u1 = snap(leave.u, u_);
  out.x0 = x_positive_ ? u0 : side - u0;
  out.x1 = x_positive_ ? u1 : side - u1;
  out.y0 = snap(entry_.v, v_);
  out.y1 = snap(leave.v, v_);
  out.flags = positive_ ? Segment::kPositive : 0;

  // The left border is met on entry, mirrored on leaving. The sample lies above the lower corner.
  const End& left = x_positive_ ? entry_ : leave;
  const std::int64_t border = (std::int64_t{u_} + (x_positive_ ? 0 : 1)) * texel();
  const std::int64_t corner = v_ * texel();
  const bool crosses =
      left.u.whole == border && left.u.integer() && (left.v.whole > corner || !left.v.integer());
  if (crosses) {
    out.flags |= Segment::kCrossesLeft;
    if (x_positive_) {
      out.flags ^= Segment::kPositive;  // what lies right of a rising edge lies below it
    } else {
      std::swap(out.x0, out.x1);
      std::swap(out.y0, out.y1);
    }
  }
  if (out.dot()) out.flags = 0;  // it has no side
  return true;
}

void EdgeWalker::row(std::int32_t& low_x, std::int32_t& high_x) const {
  std::int32_t high_u = last_u_;
  if (v_ != last_v_) {
    // A corner belongs to the row above.
    high_u = static_cast<std::int32_t>((u_at_v_.whole - (u_at_v_.rest == 0)) >> bits_);
    if (high_u < u_) high_u = u_;  // no extent along u
  }
  low_x = x_positive_ ? u_ : -high_u - 1;
  high_x = x_positive_ ? high_u : -u_ - 1;
}

void EdgeWalker::next_row() {
  u_ = static_cast<std::int32_t>(u_at_v_.whole >> bits_);
  ++v_;
  u_at_v_.advance();
}

}  // namespace kagesen::unit::winding
