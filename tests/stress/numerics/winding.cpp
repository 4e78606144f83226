// The winding profile: segments and threshold planes, against the exact outline and plane.
#include <cmath>

#include "model/reference/contact.h"
#include "model/reference/triangle.h"
#include "model/unit/winding/edge_walker.h"
#include "model/unit/winding/plane.h"
#include "tests/stress/numerics/winding_inputs.h"

namespace kagesen::stress {
namespace {

using unit::winding::EdgeWalker;
using unit::winding::FacetPlane;
using unit::winding::Place;
using unit::winding::Segment;
using unit::winding::ThresholdPlane;
using unit::winding::Widths;

/// Planes of their own: nothing is granted to shared ones.
UnitConfig own_planes() {
  UnitConfig config = default_config();
  config.plane_tolerance = 0;
  return config;
}

/// A stored segment and the exact piece of its edge, both within the texel, steps of 2^-G texel.
struct StoredSegment {
  ExactPoint stored[2], exact[2];
};

/// Inputs: x0 y0 z0 x1 y1 z1, how many texels along the walk, fraction bits.
std::optional<StoredSegment> stored_segment(const Inputs& in) {
  const auto a = point_of(in, 0), b = point_of(in, 3);
  if (!a || !b || (a->x == b->x && a->y == b->y)) return {};
  if (in[6] < 0 || in[6] > 200 || !is_fraction_bits(in[7])) return {};
  const Widths w = widths_for(in[7]);
  EdgeWalker walker(*a, *b, {0, 0, 0}, w.texel_bits, w.end_bits);
  for (std::int64_t i = 0; i < in[6] && !walker.last(); ++i) walker.step();
  Segment segment;
  if (!walker.segment(segment)) return {};
  const std::int64_t texel = std::int64_t{1} << w.texel_bits;
  const std::int64_t x = walker.x() * texel, y = walker.y() * texel;
  const auto piece = clip(*a, *b, x, y, texel);
  StoredSegment out;
  out.stored[0] = {segment.x0, segment.y0};
  out.stored[1] = {segment.x1, segment.y1};
  if (!piece) return StoredSegment{{{0, 0}, {0, 0}}, {{1000, 1000}, {1000, 1000}}};
  const Exact step = Exact(texel) / (1 << w.end_bits);
  out.exact[0] = {(piece->first.x - x) / step, (piece->first.y - y) / step};
  out.exact[1] = {(piece->second.x - x) / step, (piece->second.y - y) / step};
  return out;
}

/// Of the two ways to pair the ends, the one that errs less.
template <class Measure>
Exact over_ends(const StoredSegment& s, Measure measure) {
  const auto pairing = [&](int turned) {
    return std::max(Exact(measure(s.stored[0], s.exact[turned])),
                    Exact(measure(s.stored[1], s.exact[1 - turned])));
  };
  return std::min(pairing(0), pairing(1));
}

std::optional<Exact> end_error(const Inputs& in) {
  const auto segment = stored_segment(in);
  if (!segment) return {};
  return over_ends(*segment, [](const ExactPoint& p, const ExactPoint& q) {
    return std::max(Exact(abs(p.x - q.x)), Exact(abs(p.y - q.y)));
  });
}

std::optional<Exact> segment_error_squared(const Inputs& in) {
  const auto segment = stored_segment(in);
  if (!segment) return {};
  return over_ends(*segment, [](const ExactPoint& p, const ExactPoint& q) {
    return Exact((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
  });
}

/// A place on a facet: where in it, and what the unit takes for its depth there.
struct OnFacet {
  Exact depth;      // of the facet, exact
  Exact threshold;  // as the unit reads it
  double contact;   // B
};

/// Inputs: a facet, two weights of 2^-10 that place a point on it, fraction bits.
std::optional<OnFacet> on_facet(const Inputs& in) {
  const auto facet = caster_of(in);
  if (!facet || in[9] < 0 || in[10] < 0 || in[9] + in[10] > 1024) return {};
  if (!is_fraction_bits(in[11])) return {};
  const LightPoint* v = facet->vertex;
  const auto coordinate = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
    const std::int64_t sum = a * (1024 - in[9] - in[10]) + b * in[9] + c * in[10];
    return sum >> 10;
  };
  const std::int64_t x = coordinate(v[0].x, v[1].x, v[2].x);
  const std::int64_t y = coordinate(v[0].y, v[1].y, v[2].y);
  const Weights weights =
      weights_at(*facet, static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
  if (!weights.inside()) return {};
  const Widths w = widths_for(in[11]);
  const FacetPlane plane(*facet, nullptr, w);
  const auto column = static_cast<std::int32_t>(x >> w.texel_bits);
  const auto row = static_cast<std::int32_t>(y >> w.texel_bits);
  const std::int64_t mask = (std::int64_t{1} << w.texel_bits) - 1;
  const int shift = w.texel_bits - w.end_bits;
  OnFacet out;
  out.threshold = Exact(
      ThresholdPlane(plane.in(column, row), w).at((x & mask) >> shift, (y & mask) >> shift, w));
  out.depth = *plane_at(*facet, Exact(x), Exact(y));
  out.contact = contact_distance(*facet, own_planes(), static_cast<std::uint32_t>(in[11]));
  return out;
}

Inputs draw_on_facet(Dice& dice) {
  Inputs in = draw_facet(dice);
  const std::int64_t first = dice.one_in(3) ? 0 : dice.in(0, 1024);
  in.push_back(first);
  in.push_back(dice.one_in(3) ? 1024 - first : dice.in(0, 1024 - first));
  in.push_back(dice.in(kMinFractionBits, kMaxFractionBits));
  return in;
}

/// How far the threshold is in front of the facet: must not be at all.
std::optional<Exact> threshold_before(const Inputs& in) {
  const auto at = on_facet(in);
  if (!at) return {};
  return Exact(at->depth - at->threshold);
}

/// Is the facet so narrow that it takes the depth along its longest edge, or of a vertex?
bool is_narrow(const Caster& c, const Widths& w) {
  Exact longest = 0;
  for (int i = 0; i < 3; ++i) {
    const Exact x = Exact(c.vertex[(i + 1) % 3].x) - c.vertex[i].x;
    const Exact y = Exact(c.vertex[(i + 1) % 3].y) - c.vertex[i].y;
    longest = std::max(longest, Exact(x * x + y * y));
  }
  const Exact area = doubled_area(c), radius = std::int64_t{1} << (w.texel_bits - w.fraction_bits);
  return 16 * area * area <= longest * radius * radius;
}

/// How far the threshold is behind the facet, as a part of the contact distance.
std::optional<Exact> threshold_behind(const Inputs& in) {
  const auto at = on_facet(in);
  if (!at || is_narrow(*caster_of(in), widths_for(in[11]))) return {};
  return Exact((at->threshold - at->depth) / Exact(at->contact));
}

/// The same of a narrow facet, whose contact distance holds what its stored plane leaves out.
std::optional<Exact> threshold_behind_narrow(const Inputs& in) {
  const auto at = on_facet(in);
  if (!at || !is_narrow(*caster_of(in), widths_for(in[11]))) return {};
  return Exact((at->threshold - at->depth) / Exact(at->contact));
}

/// A facet within a snap step or two across, at any place.
Inputs draw_on_narrow_facet(Dice& dice) {
  Inputs in = draw_on_facet(dice);
  const std::int64_t width = std::int64_t{1} << dice.in(0, in[11] - 8);
  for (int axis = 0; axis < 2; ++axis) {
    const std::int64_t along = dice.one_in(4) ? 0 : dice.in(0, 1024);
    in[6 + axis] = in[axis] + (in[3 + axis] - in[axis]) * along / 1024 + dice.in(-width, width);
  }
  return in;
}

/// Inputs: a gradient a texel. In units of what its code can tell apart.
std::optional<Exact> gradient_error(const Inputs& in) {
  const std::int64_t value = in[0];
  if (std::abs(value) > std::int64_t{1} << 39) return {};
  const Widths w = widths_for(kMinFractionBits);
  const std::int64_t stored = decode_gradient(encode_gradient(value, w), w);
  const std::int64_t least = std::int64_t{1} << w.step_bits;
  std::int64_t step = least;
  while (step << (w.gradient_bits + 1) <= std::abs(value)) step *= 2;
  return Exact(Exact(std::abs(stored - value)) / step);
}

const std::vector<std::string> kFacetInputs = {"x0", "y0", "z0", "x1", "y1", "z1",
                                               "x2", "y2", "z2", "w1", "w2", "fraction_bits"};
const std::vector<std::string> kGradientInputs = {"gradient"};

}  // namespace

std::vector<Quantity> winding_value_quantities() {
  const Exact half(1, 2), one(1);
  return {
      {"winding", "segment end", "UQ1.G texel, nearest, ties up",
       "off by along an axis, units of 2^-G texel", "1/2", half, false, kSegmentInputs,
       draw_segment, end_error},
      {"winding", "segment", "two ends", "square of an end's displacement, units of 4^-G texel",
       "1/4 + 1/4", half, false, kSegmentInputs, draw_segment, segment_error_squared},
      {"winding", "threshold, nearest", "base and gradient codes",
       "in front of the facet by, depth units", "0", Exact(0), false, kFacetInputs, draw_on_facet,
       threshold_before},
      {"winding", "threshold, farthest", "base and gradient codes",
       "behind a facet that is not narrow, parts of its contact distance B", "1", one, false,
       kFacetInputs, draw_on_facet, threshold_behind},
      {"winding", "threshold, narrow facet", "base and gradient codes",
       "behind a narrow facet, parts of its contact distance B", "1", one, false, kFacetInputs,
       draw_on_narrow_facet, threshold_behind_narrow},
      {"winding", "gradient code", "sign, 5 exponent bits, mantissa",
       "off by, units of its last mantissa bit", "1/2", half, false, kGradientInputs,
       [](Dice& dice) { return Inputs{dice.either(dice.magnitude(39))}; }, gradient_error},
  };
}

}  // namespace kagesen::stress
