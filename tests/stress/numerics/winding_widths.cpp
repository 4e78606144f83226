// The winding profile: how wide its numbers get.
#include <memory>

#include "model/engine.h"
#include "tests/stress/numerics/winding_inputs.h"

namespace kagesen::stress {
namespace {

using unit::winding::Widths;

/// Inputs: the ends of a segment and a place, steps of 2^-G and units; fraction bits of the trace.
std::optional<Exact> cross_bits(const Inputs& in) {
  if (!is_fraction_bits(in[6])) return {};
  const Widths w = widths_for(in[6]);
  for (int i = 0; i < 4; ++i) {
    if (in[i] < 0 || in[i] > std::int64_t{1} << w.end_bits) return {};
  }
  for (int i = 4; i < 6; ++i) {
    if (in[i] < 0 || in[i] >= std::int64_t{1} << w.texel_bits) return {};
  }
  const int shift = w.texel_bits - w.end_bits;
  const Exact side = (Exact(in[2]) - in[0]) * (Exact(in[5]) - (in[1] << shift)) -
                     (Exact(in[3]) - in[1]) * (Exact(in[4]) - (in[0] << shift));
  // In the unit both factors are in units; the steps' low bits are zero and cost no hardware.
  return Exact(signed_bits(side));
}

Inputs draw_cross(Dice& dice) {
  const std::int64_t bits = dice.one_in(2) ? kMaxFractionBits : dice.in(16, 26);
  const Widths w = widths_for(bits);
  Inputs in;
  const auto end = [&](int n) {
    const std::int64_t most = std::int64_t{1} << n;
    return dice.one_in(2) ? dice.in(0, 1) * most : dice.in(0, most);
  };
  for (int i = 0; i < 4; ++i) in.push_back(end(w.end_bits));
  for (int i = 0; i < 2; ++i) {
    in.push_back(std::min(end(w.texel_bits), (std::int64_t{1} << w.texel_bits) - 1));
  }
  in.push_back(bits);
  return in;
}

/// Where the line of an edge meets the next border of the other axis, in units: the walker's ramp.
std::optional<Exact> walker_bits(const Inputs& in) {
  const auto a = point_of(in, 0), b = point_of(in, 3);
  if (!a || !b || !is_fraction_bits(in[7])) return {};
  const Exact texel = Exact(std::int64_t{1} << in[7]);
  const Exact du = abs(Exact(b->x) - a->x), dv = abs(Exact(b->y) - a->y);
  // The dividend of a step along either axis, and a ramp's value after it.
  int bits = std::max(signed_bits(dv * texel), signed_bits(du * texel));
  if (du > 0) bits = std::max(bits, signed_bits(Exact(floor_of(a->y + dv * texel / du))));
  if (dv > 0) bits = std::max(bits, signed_bits(Exact(floor_of(a->x + du * texel / dv))));
  return Exact(bits);
}

/// The numerator of a plane's depth at a texel's centre.
std::optional<Exact> plane_bits(const Inputs& in) {
  const auto facet = caster_of(in);
  if (!facet) return {};
  const LightPoint* v = facet->vertex;
  const Exact x1 = Exact(v[1].x) - v[0].x, y1 = Exact(v[1].y) - v[0].y, z1 = Exact(v[1].z) - v[0].z;
  const Exact x2 = Exact(v[2].x) - v[0].x, y2 = Exact(v[2].y) - v[0].y, z2 = Exact(v[2].z) - v[0].z;
  const Exact gx = z1 * y2 - z2 * y1, gy = x1 * z2 - x2 * z1;
  Exact worst = 0;
  for (const std::int32_t x : {kCoordinateMin, kCoordinateMax}) {
    for (const std::int32_t y : {kCoordinateMin, kCoordinateMax}) {
      worst = std::max(worst, Exact(abs(gx * (Exact(x) - v[0].x) + gy * (Exact(y) - v[0].y))));
    }
  }
  return Exact(signed_bits(worst));
}

/// Inputs: how many facets of one plane hold a texel's corner.
std::optional<Exact> corner_count(const Inputs& in) {
  if (in[0] < 1 || in[0] > 1000) return {};
  UnitConfig config = default_config();
  config.map_width = config.map_height = 2;
  config.skip_receiver_mask = false;
  const std::unique_ptr<Engine> engine = make_golden_engine();
  engine->begin(config, FrameSetup{});
  const Caster facet{{{-99, -99, 5}, {9999, -99, 5}, {-99, 9999, 5}}, 0, 0};
  for (std::int64_t i = 0; i < in[0]; ++i) engine->draw(&facet, 1);
  std::uint32_t most = 0;
  for (const TexelCluster& c : engine->contents().clusters) most = std::max(most, c.corner);
  return Exact(most);
}

Inputs draw_extreme_facet(Dice& dice) {
  Inputs in = draw_facet(dice);
  for (std::size_t i = 0; i < in.size(); ++i) {
    const bool depth = i % 3 == 2;
    if (dice.one_in(4)) continue;
    if (depth) {
      in[i] = dice.one_in(2) ? 0 : kDepthMax;
    } else {
      in[i] = dice.one_in(2) ? kCoordinateMin : kCoordinateMax;
    }
  }
  return in;
}
Inputs draw_extreme_edge(Dice& dice) {
  Inputs in = draw_segment(dice);
  const std::size_t x0 = 0, x1 = 3;
  for (const std::size_t i : {x0, x0 + 1, x1, x1 + 1}) {
    if (dice.one_in(2)) in[i] = dice.one_in(2) ? kCoordinateMin : kCoordinateMax;
  }
  if (dice.one_in(3)) in[x1] = std::min<std::int64_t>(in[x0] + 1, kCoordinateMax);
  if (dice.one_in(2)) in[7] = kMaxFractionBits;
  return in;
}

const std::vector<std::string> kPlaneInputs = {"x0", "y0", "z0", "x1", "y1",
                                               "z1", "x2", "y2", "z2"};
const std::vector<std::string> kCrossInputs = {"x0", "y0", "x1", "y1", "px", "py", "fraction_bits"};
const std::vector<std::string> kCornerInputs = {"facets"};

}  // namespace

std::vector<Quantity> winding_width_quantities() {
  const int end_bits = widths_for(kMaxFractionBits).end_bits;
  const auto most_corners = (std::int64_t{1} << default_config().corner_bits) - 1;
  return {
      {"winding", "cross product of a decision", "two's complement",
       "bits, ends in steps of 2^-G texel, place in units, f = 26",
       "G + f + 2: twice a triangle in a texel", Exact(end_bits + kMaxFractionBits + 2), false,
       kCrossInputs, draw_cross, cross_bits},
      {"winding", "edge walker", "two's complement", "bits of the widest ramp or dividend",
       "28 + f + 2, f = 26", Exact(kCoordinateBits + kMaxFractionBits + 2), false, kSegmentInputs,
       draw_extreme_edge, walker_bits},
      {"winding", "plane numerator", "two's complement",
       "bits at the corners of the range of coordinates", "24 + 28 + 1 + 28 + 1 + 1", Exact(83),
       false, kPlaneInputs, draw_extreme_facet, plane_bits},
      {"winding", "corner count", "unsigned, 8 bits", "largest stored; beyond, the texel overflows",
       "2^8 - 1", Exact(most_corners), false, kCornerInputs,
       [](Dice& dice) { return Inputs{dice.in(1, 600)}; }, corner_count},
  };
}

}  // namespace kagesen::stress
