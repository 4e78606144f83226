#include "model/unit/winding/plane.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace kagesen::unit::winding {
namespace {

constexpr int kMaxGradientBits = 16 - 1 - Widths::kExponentBits;

struct Edge {
  std::int64_t x, y, z;
  std::int64_t squared() const { return x * x + y * y; }
};

Edge edge(const LightPoint& a, const LightPoint& b) {
  return {std::int64_t{b.x} - a.x, std::int64_t{b.y} - a.y, std::int64_t{b.z} - a.z};
}

}  // namespace

Widths::Widths(const UnitConfig& config, int texel_bits_of_trace)
    : texel_bits(texel_bits_of_trace),
      fraction_bits(static_cast<int>(config.fraction_bits)),
      end_bits(std::min(fraction_bits + static_cast<int>(config.end_guard_bits), texel_bits)),
      step_bits(static_cast<int>(config.plane_step_bits)),
      gradient_bits(std::min(std::max(static_cast<int>(config.gradient_bits), fraction_bits - 1),
                             kMaxGradientBits)),
      tolerance(config.plane_tolerance) {}

std::uint16_t encode_gradient(std::int64_t value, const Widths& w) {
  const std::int64_t size = std::abs(value);
  int shift = w.step_bits, exponent = 0;
  while (size >> shift >= std::int64_t{2} << w.gradient_bits) ++shift, ++exponent;
  std::int64_t code = shift == 0 ? size : (size + (std::int64_t{1} << (shift - 1))) >> shift;
  // A mantissa with its leading one, or that it rounds to, is the next exponent's start.
  code += std::int64_t{exponent} << w.gradient_bits;
  const std::int64_t largest = (std::int64_t{1} << (Widths::kExponentBits + w.gradient_bits)) - 1;
  code = std::min(code, largest);
  return static_cast<std::uint16_t>(code | (value < 0 && code != 0 ? largest + 1 : 0));
}

FacetPlane::FacetPlane(const Caster& facet, const Caster* shared, const Widths& widths)
    : w_(widths) {
  if (shared != nullptr) {
    take_plane(*shared);
  } else if (!take_narrow(facet)) {
    take_plane(facet);
  }
  if (shared != nullptr) bias_ += w_.tolerance;
  store();
}

void FacetPlane::take_plane(const Caster& c) {
  const Edge a = edge(c.vertex[0], c.vertex[1]), b = edge(c.vertex[0], c.vertex[2]);
  std::int64_t area = a.x * b.y - a.y * b.x;
  gradient_x_ = a.z * b.y - b.z * a.y;
  gradient_y_ = a.x * b.z - b.x * a.z;
  if (area < 0) {
    area = -area;
    gradient_x_ = -gradient_x_;
    gradient_y_ = -gradient_y_;
  }
  denominator_ = area;
  origin_x_ = c.vertex[0].x;
  origin_y_ = c.vertex[0].y;
  origin_z_ = c.vertex[0].z;
}

bool FacetPlane::take_narrow(const Caster& caster) {
  // Of equally long edges the first in an order that the vertices' own order has no part in.
  Caster c = caster;
  std::sort(c.vertex, c.vertex + 3, [](const LightPoint& a, const LightPoint& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  int longest = 0;
  for (int i = 1; i < 3; ++i) {
    if (edge(c.vertex[i], c.vertex[(i + 1) % 3]).squared() >
        edge(c.vertex[longest], c.vertex[(longest + 1) % 3]).squared()) {
      longest = i;
    }
  }
  const LightPoint& from = c.vertex[longest];
  const Edge e = edge(from, c.vertex[(longest + 1) % 3]);
  const Edge third = edge(from, c.vertex[(longest + 2) % 3]);
  const Int128 radius = Int128{1} << (w_.texel_bits - w_.fraction_bits);
  const Int128 length = e.squared(), area = Int128{e.x} * third.y - Int128{e.y} * third.x;
  if (16 * length <= radius * radius) {
    origin_z_ = std::max({c.vertex[0].z, c.vertex[1].z, c.vertex[2].z});
    shape_ = Figures::kTiny;
    return true;
  }
  if (16 * area * area > length * radius * radius) return false;
  shape_ = Figures::kNarrow;
  narrow_third_ = c.vertex[(longest + 2) % 3];
  denominator_ = e.squared();
  gradient_x_ = e.z * e.x;
  gradient_y_ = e.z * e.y;
  origin_x_ = from.x;
  origin_y_ = from.y;
  const std::int64_t along = e.x * third.x + e.y * third.y;
  const std::int64_t below = -floor_div(Int128{e.z} * along, denominator_);  // ceil of the negative
  origin_z_ = std::int64_t{from.z} + std::max<std::int64_t>(0, third.z + below);
  return true;
}

void FacetPlane::store() {
  const Int128 texel = Int128{1} << w_.texel_bits;
  const std::int64_t x = floor_div(gradient_x_ * texel, denominator_);
  const std::int64_t y = floor_div(gradient_y_ * texel, denominator_);
  code_x_ = encode_gradient(x, w_);
  code_y_ = encode_gradient(y, w_);
  const std::int64_t stored_x = decode_gradient(code_x_, w_);
  const std::int64_t stored_y = decode_gradient(code_y_, w_);
  const std::int64_t rounding = std::abs(x - stored_x) + std::abs(y - stored_y) + 2;
  const std::int64_t steepness =
      std::max(std::abs(x) + 1 + std::abs(y) + 1, std::abs(stored_x) + std::abs(stored_y));
  // Half a texel's rounding of the gradient; a step that the outline may reach beyond the facet,
  // and one that the place is cut by; two roundings down.
  bias_ += (rounding + 1) / 2 + (2 * steepness >> w_.end_bits) + 1 + 2;
}

std::int32_t FacetPlane::base(std::int64_t centre_depth) const {
  const std::int64_t step = std::int64_t{1} << w_.step_bits;
  const std::int64_t steps = (centre_depth + bias_ + step - 1) >> w_.step_bits;
  const std::int64_t half = std::int64_t{1} << (w_.base_bits() - 1);
  return static_cast<std::int32_t>(((steps + half) & (2 * half - 1)) - half);
}

ExactRamp FacetPlane::ramp(std::int32_t texel_x, std::int32_t texel_y) const {
  const std::int64_t texel = std::int64_t{1} << w_.texel_bits;
  const Int128 x = texel_x * texel + texel / 2 - origin_x_;
  const Int128 y = texel_y * texel + texel / 2 - origin_y_;
  return ExactRamp::make(origin_z_, gradient_x_ * x + gradient_y_ * y, Int128{gradient_x_} * texel,
                         denominator_);
}

FacetPlane::Figures FacetPlane::figures(const Caster& facet, std::int32_t texel_x,
                                        std::int32_t texel_y) const {
  const Int128 texel = Int128{1} << w_.texel_bits;
  Figures out{shape_,
              denominator_,
              floor_div(gradient_x_ * texel, denominator_),
              floor_div(gradient_y_ * texel, denominator_),
              ramp(texel_x, texel_y).whole - origin_z_,
              0};
  if (shape_ != Figures::kNarrow) return out;
  // From the end that comes after the third vertex as the facet has them.
  for (int i = 0; i < 3; ++i) {
    const LightPoint& third = facet.vertex[i];
    const LightPoint& from = facet.vertex[(i + 1) % 3];
    if (third.x != narrow_third_.x || third.y != narrow_third_.y) continue;
    const Edge e = edge(from, facet.vertex[(i + 2) % 3]), way = edge(from, third);
    out.third = floor_div(Int128{e.z} * (e.x * way.x + e.y * way.y), denominator_);
    const Int128 x = texel_x * texel + texel / 2 - from.x, y = texel_y * texel + texel / 2 - from.y;
    out.start = floor_div(gradient_x_ * x + gradient_y_ * y, denominator_);
  }
  return out;
}

Threshold FacetPlane::in(std::int32_t texel_x, std::int32_t texel_y) const {
  return at(ramp(texel_x, texel_y));
}

}  // namespace kagesen::unit::winding
