#include "model/unit/span_filler.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace kagesen::unit {
namespace {

std::int64_t turn(const LightPoint& a, const LightPoint& b, std::int64_t x, std::int64_t y) {
  return (std::int64_t{b.x} - a.x) * (y - a.y) - (std::int64_t{b.y} - a.y) * (x - a.x);
}

}  // namespace

Polygon::Polygon(const Caster& caster, int bits)
    : v_{caster.vertex[0], caster.vertex[1], caster.vertex[2]}, bits_(bits) {
  twice_area_ = turn(v_[0], v_[1], v_[2].x, v_[2].y);
  if (twice_area_ < 0) {
    std::swap(v_[1], v_[2]);
    twice_area_ = -twice_area_;
  }
  least_ = std::min({v_[0].z, v_[1].z, v_[2].z});
  most_ = std::max({v_[0].z, v_[1].z, v_[2].z});
}

bool Polygon::covers_corner(std::int32_t texel_x, std::int32_t texel_y) const {
  const std::int64_t texel = std::int64_t{1} << bits_;
  const std::int64_t x = texel_x * texel, y = texel_y * texel;
  for (int i = 0; i < 3; ++i) {
    const LightPoint& a = v_[i];
    const LightPoint& b = v_[(i + 1) % 3];
    const std::int64_t side = turn(a, b, x, y);
    if (side < 0) return false;
    if (side > 0) continue;
    // On the line: moving by +e in y adds (b.x - a.x) e; where that is 0, +e^2 in x subtracts (b.y
    // - a.y) e^2.
    const bool inside = b.x != a.x ? b.x > a.x : b.y < a.y;
    if (!inside) return false;
  }
  return true;
}

void Polygon::make_plane() const {
  plane_ready_ = true;
  const std::int64_t x1 = std::int64_t{v_[1].x} - v_[0].x, y1 = std::int64_t{v_[1].y} - v_[0].y;
  const std::int64_t x2 = std::int64_t{v_[2].x} - v_[0].x, y2 = std::int64_t{v_[2].y} - v_[0].y;
  const std::int64_t z1 = std::int64_t{v_[1].z} - v_[0].z, z2 = std::int64_t{v_[2].z} - v_[0].z;
  gradient_x_ = z1 * y2 - z2 * y1;
  gradient_y_ = x1 * z2 - x2 * z1;
  const Int128 rise = (Int128{std::abs(gradient_x_)} + std::abs(gradient_y_)) << (bits_ - 1);
  const Int128 bounded = rise / twice_area_ + 1;
  half_texel_rise_ =
      bounded > most_ - least_ ? most_ - least_ + 1 : static_cast<std::uint32_t>(bounded);
}

Int128 Polygon::depth_numerator(std::int32_t texel_x, std::int32_t texel_y) const {
  if (!plane_ready_) make_plane();
  const std::int64_t texel = std::int64_t{1} << bits_, half = texel / 2;
  const std::int64_t x = texel_x * texel + half - v_[0].x;
  const std::int64_t y = texel_y * texel + half - v_[0].y;
  return Int128{gradient_x_} * x + Int128{gradient_y_} * y;
}

std::uint32_t Polygon::clamp(std::int64_t depth) const {
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(depth, least_, most_));
}

std::uint32_t Polygon::centre_depth(std::int32_t texel_x, std::int32_t texel_y) const {
  // Far outside a sliver the plane exceeds 64 bits: bound it before it is narrowed.
  const Int128 offset = depth_numerator(texel_x, texel_y);
  const Int128 lowest = -Int128{kDepthMax} * twice_area_, highest = Int128{kDepthMax} * twice_area_;
  return clamp(v_[0].z + floor_div(std::clamp(offset, lowest, highest), twice_area_));
}

ExactRamp Polygon::centre_ramp(std::int32_t texel_x, std::int32_t texel_y) const {
  const Int128 offset = depth_numerator(texel_x, texel_y);
  return ExactRamp::make(v_[0].z, offset, Int128{gradient_x_} * (std::int64_t{1} << bits_),
                         twice_area_);
}

std::uint32_t Polygon::farthest(std::uint32_t centre) const {
  if (!plane_ready_) make_plane();
  return std::min(most_, centre + half_texel_rise_);
}

void VisitedRows::begin(std::int32_t first_row, std::int32_t last_row) {
  first_row_ = first_row;
  count_ = last_row < first_row ? 0 : static_cast<std::size_t>(last_row - first_row) + 1;
  if (rows_.size() < count_) rows_.resize(count_);
  constexpr std::int32_t kNever = std::numeric_limits<std::int32_t>::max();
  const Row empty{{kNever, kNever, kNever}, {-kNever, -kNever, -kNever}};
  std::fill_n(rows_.begin(), count_, empty);
}

}  // namespace kagesen::unit
