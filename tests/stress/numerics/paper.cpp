// The paper profile: what the SLB and the buffers store, against the exact edge or plane.
#include "model/unit/edge_walker.h"
#include "model/unit/span_filler.h"
#include "tests/stress/numerics/geometry.h"

namespace kagesen::stress {
namespace {

using unit::EdgeSetup;
using unit::EdgeWalker;
using unit::Line;
using unit::OutlineTexel;

constexpr int kTexelBits = 16;
constexpr int kFieldBits = 8;  // of Fraction and Slope: the default
constexpr std::int64_t kTexel = 1 << kTexelBits;

Exact field(std::uint32_t stored) { return Exact(stored) / (1 << kFieldBits); }
bool saturated(std::uint32_t stored) { return stored == (1u << kFieldBits) - 1; }

/// A texel that an edge runs through, its stored line, and the exact one in that texel.
struct StoredLine {
  OutlineTexel texel;
  LightPoint from, to;  // in the direction of travel
  Exact slope;          // minor over major
  Exact fraction;       // minor coordinate at the side where Fraction is taken, texels
};

/// Inputs: x0 y0 z0 x1 y1 z1 and how far along the walk, per mille.
std::optional<StoredLine> stored_line(const Inputs& in) {
  const auto a = point_of(in, 0), b = point_of(in, 3);
  if (!a || !b || (a->x == b->x && a->y == b->y) || in[6] < 0 || in[6] > 1000) return {};
  const EdgeSetup setup = unit::setup_edge(*a, *b, {0, 0, 0}, kTexelBits, kFieldBits);
  EdgeWalker walker(setup, kTexelBits, kFieldBits);
  const std::int64_t texels =
      std::int64_t{setup.last_major} - setup.first_major + setup.last_minor - setup.first_minor;
  for (std::int64_t i = texels * in[6] / 1000; i > 0 && !walker.last(); --i) walker.step();

  StoredLine out;
  out.texel = walker.texel();
  const bool swap = b->y < a->y || (b->y == a->y && b->x < a->x);
  out.from = swap ? *b : *a;
  out.to = swap ? *a : *b;
  const std::int64_t u0 = setup.x_positive ? out.from.x : -std::int64_t{out.from.x};
  const std::int64_t u1 = setup.x_positive ? out.to.x : -std::int64_t{out.to.x};
  const std::int64_t major0 = setup.x_major ? u0 : out.from.y;
  const std::int64_t minor0 = setup.x_major ? out.from.y : u0;
  const std::int64_t length = setup.x_major ? u1 - u0 : out.to.y - out.from.y;
  const std::int64_t rise = setup.x_major ? out.to.y - out.from.y : u1 - u0;
  // Texel indices along the direction of travel.
  const std::int64_t column = setup.x_positive ? out.texel.x : -std::int64_t{out.texel.x} - 1;
  const std::int64_t major = setup.x_major ? column : out.texel.y;
  const std::int64_t minor = setup.x_major ? out.texel.y : column;
  const std::int64_t side = (major + (out.texel.line.has(Line::kCross) ? 1 : 0)) * kTexel;
  out.slope = Exact(rise) / length;
  out.fraction = (minor0 + out.slope * (side - major0) - minor * kTexel) / kTexel;
  return out;
}

Inputs draw_line(Dice& dice) {
  Inputs in = draw_edge(dice);
  in.push_back(dice.in(0, 1000));
  return in;
}

std::optional<Exact> fraction_error(const Inputs& in, bool of_saturated) {
  const auto line = stored_line(in);
  if (!line || saturated(line->texel.line.fraction) != of_saturated) return {};
  return Exact(abs(field(line->texel.line.fraction) - line->fraction) * (1 << kFieldBits));
}

std::optional<Exact> slope_error(const Inputs& in, bool of_saturated) {
  const auto line = stored_line(in);
  if (!line || saturated(line->texel.line.slope) != of_saturated) return {};
  return Exact(abs(field(line->texel.line.slope) - line->slope) * (1 << kFieldBits));
}

/// Along the minor axis, at the worse of the texel's two sides.
std::optional<Exact> displacement(const Inputs& in, bool of_saturated) {
  const auto line = stored_line(in);
  if (!line) return {};
  const Line& stored = line->texel.line;
  if ((saturated(stored.slope) || saturated(stored.fraction)) != of_saturated) return {};
  Exact worst = 0;
  for (const int major : {0, 1}) {
    const int along = stored.has(Line::kCross) ? major - 1 : major;
    const Exact off =
        field(stored.fraction) - line->fraction + (field(stored.slope) - line->slope) * along;
    worst = std::max(worst, Exact(abs(off)));
  }
  return Exact(worst * (1 << kFieldBits));
}

/// The exact depth at the nearer of the two ends of the edge's piece in the texel, less the stored.
std::optional<Exact> edge_depth_error(const Inputs& in) {
  const auto line = stored_line(in);
  if (!line) return {};
  const LightPoint &from = line->from, &to = line->to;
  const auto piece = clip(from, to, line->texel.x * kTexel, line->texel.y * kTexel, kTexel);
  if (!piece) return Exact(1000);  // the edge does not meet the texel at all
  const auto depth = [&](const ExactPoint& p) -> Exact {
    const Exact along = to.x != from.x ? Exact((p.x - from.x) / (Exact(to.x) - from.x))
                                       : Exact((p.y - from.y) / (Exact(to.y) - from.y));
    return from.z + along * (Exact(to.z) - from.z);
  };
  return Exact(std::min(depth(piece->first), depth(piece->second)) - line->texel.nearest);
}

/// Inputs: a facet, and a texel by its column and row.
struct Centre {
  Caster facet;
  std::int32_t column, row;
  Exact depth;  // of the plane at the texel's centre
};
std::optional<Centre> centre_of(const Inputs& in) {
  const auto facet = caster_of(in);
  if (!facet || in[9] < -2048 || in[9] > 2047 || in[10] < -2048 || in[10] > 2047) return {};
  const auto at = [](std::int64_t texel) { return Exact(texel * kTexel + kTexel / 2); };
  const auto depth = plane_at(*facet, at(in[9]), at(in[10]));
  if (!depth) return {};
  return Centre{*facet, static_cast<std::int32_t>(in[9]), static_cast<std::int32_t>(in[10]),
                *depth};
}

Inputs draw_run(Dice& dice) {
  Inputs in = draw_facet(dice);
  in.push_back(std::clamp<std::int64_t>((in[0] >> kTexelBits) + dice.in(-8, 8), -2048, 2047));
  in.push_back(std::clamp<std::int64_t>((in[1] >> kTexelBits) + dice.in(-8, 8), -2048, 2047));
  in.push_back(dice.in(0, 64));  // texels along the row
  return in;
}
Inputs draw_centre(Dice& dice) {
  Inputs in = draw_run(dice);
  in.pop_back();
  return in;
}

std::optional<Exact> centre_depth_error(const Inputs& in) {
  const auto centre = centre_of(in);
  if (!centre) return {};
  const unit::Polygon polygon(centre->facet, kTexelBits);
  const auto* v = centre->facet.vertex;
  const auto [least, most] = std::minmax({v[0].z, v[1].z, v[2].z});
  const Exact clamped = std::clamp(centre->depth, Exact(least), Exact(most));
  return Exact(clamped - polygon.centre_depth(centre->column, centre->row));
}

std::optional<Exact> span_depth_error(const Inputs& in) {
  const auto centre = centre_of(in);
  if (!centre || in[11] < 0 || in[11] > 4096) return {};
  // Beyond the facet's own range of depths nothing is filled.
  if (abs(centre->depth) > Exact(kDepthMax) * 2) return {};
  const unit::Polygon polygon(centre->facet, kTexelBits);
  const auto first = static_cast<std::int32_t>(centre->column - in[11]);
  const auto start = plane_at(centre->facet, Exact(first * kTexel + kTexel / 2),
                              Exact(centre->row * kTexel + kTexel / 2));
  if (!start || abs(*start) > Exact(kDepthMax) * 2) return {};
  unit::ExactRamp ramp = polygon.centre_ramp(first, centre->row);
  for (std::int64_t i = 0; i < in[11]; ++i) ramp.advance();
  return Exact(centre->depth - ramp.whole);
}

const std::vector<std::string> kLineInputs = {"x0", "y0", "z0", "x1", "y1", "z1", "walk"};
const std::vector<std::string> kCentreInputs = {"x0", "y0", "z0", "x1",     "y1", "z1",
                                                "x2", "y2", "z2", "column", "row"};
const std::vector<std::string> kRunInputs = {"x0", "y0", "z0", "x1",     "y1",  "z1",
                                             "x2", "y2", "z2", "column", "row", "run"};

}  // namespace

std::vector<Quantity> paper_quantities() {
  const Exact half(1, 2), one(1);
  return {
      {"paper", "Fraction", "UQ0.8 texel, nearest", "off by, units of 2^-8 texel", "1/2", half,
       false, kLineInputs, draw_line, [](const Inputs& in) { return fraction_error(in, false); }},
      {"paper", "Fraction, largest", "255: 1.0 saturates", "off by, units of 2^-8 texel", "1", one,
       false, kLineInputs, draw_line, [](const Inputs& in) { return fraction_error(in, true); }},
      {"paper", "Slope", "UQ0.8, nearest", "off by, units of 2^-8", "1/2", half, false, kLineInputs,
       draw_line, [](const Inputs& in) { return slope_error(in, false); }},
      {"paper", "Slope, largest", "255: 1.0 saturates", "off by, units of 2^-8", "1", one, false,
       kLineInputs, draw_line, [](const Inputs& in) { return slope_error(in, true); }},
      {"paper", "line displacement", "Fraction and Slope",
       "along the minor axis within the texel, units of 2^-8 texel", "1/2 + 1/2", one, false,
       kLineInputs, draw_line, [](const Inputs& in) { return displacement(in, false); }},
      {"paper", "line displacement, saturated", "Fraction or Slope at 255",
       "along the minor axis within the texel, units of 2^-8 texel", "1 + 1", Exact(2), false,
       kLineInputs, draw_line, [](const Inputs& in) { return displacement(in, true); }},
      {"paper", "edge depth", "24 bits, floor of an exact ramp",
       "exact depth in the texel less the stored one, depth units", "below 1", one, true,
       kLineInputs, draw_line, edge_depth_error},
      {"paper", "span depth", "24 bits, floor of an exact ramp",
       "exact depth at the texel's centre less the ramp's, depth units", "below 1", one, true,
       kRunInputs, draw_run, span_depth_error},
      {"paper", "centre depth", "24 bits, floor, clamped to the facet's range",
       "exact depth at the texel's centre less the stored one, depth units", "below 1", one, true,
       kCentreInputs, draw_centre, centre_depth_error},
  };
}

}  // namespace kagesen::stress
