#include "tests/stress/transforms.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "model/reference/triangle.h"
#include "tests/stress/builder.h"

namespace kagesen::stress {
namespace {

Point wide(const LightPoint& p) { return {p.x, p.y, p.z}; }
LightPoint narrow(const Point& p) {
  return {static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y),
          static_cast<std::uint32_t>(p.z)};
}

bool in_range(std::int64_t v) { return v >= kCoordinateMin && v <= kCoordinateMax; }

/// Applies `move` to every point; false, with the trace half moved, where one leaves the range.
template <class Move>
bool move_points(Trace& trace, Move move) {
  const auto moved = [&](LightPoint& p) {
    std::int64_t x = p.x, y = p.y;
    move(x, y);
    if (!in_range(x) || !in_range(y)) return false;
    p.x = static_cast<std::int32_t>(x);
    p.y = static_cast<std::int32_t>(y);
    return true;
  };
  for (Caster& c : trace.all_casters) {
    for (LightPoint& v : c.vertex) {
      if (!moved(v)) return false;
    }
  }
  return std::all_of(trace.all_fragments.begin(), trace.all_fragments.end(),
                     [&](Fragment& f) { return moved(f.position); });
}

/// How far everything may move along an axis, in texels.
std::pair<std::int64_t, std::int64_t> room(const Trace& trace, std::int32_t LightPoint::*axis) {
  std::int64_t least = 0, most = 0;
  const auto see = [&](const LightPoint& p) {
    least = std::min<std::int64_t>(least, p.*axis);
    most = std::max<std::int64_t>(most, p.*axis);
  };
  for (const Caster& c : trace.all_casters) {
    for (const LightPoint& v : c.vertex) see(v);
  }
  for (const Fragment& f : trace.all_fragments) see(f.position);
  const std::uint32_t bits = trace.header.fraction_bits;
  return {-((least - kCoordinateMin) >> bits), (kCoordinateMax - most) >> bits};
}

/// Turns the vertices of a caster by `by` places, then swaps the last two; its facet's edges too.
void rewind(Caster& c, Facet* facet, std::int64_t by, bool reverse) {
  std::rotate(c.vertex, c.vertex + by, c.vertex + 3);
  if (reverse) std::swap(c.vertex[1], c.vertex[2]);
  if (!facet) return;
  std::uint8_t edges = facet->inner_edges & 7;
  edges = static_cast<std::uint8_t>(((edges >> by) | (edges << (3 - by))) & 7);
  // After the swap edge 0 runs along what was edge 2, and the other way round.
  if (reverse) edges = static_cast<std::uint8_t>((edges & 2) | (edges & 1) << 2 | edges >> 2);
  facet->inner_edges = edges;
}

}  // namespace

Trace shuffled(const Trace& trace, Dice& dice, FrameSetup* setup) {
  const bool facets = setup && !setup->facets.empty();
  Trace out = trace;
  for (std::size_t i = out.all_casters.size(); i > 1; --i) {
    const auto other = static_cast<std::size_t>(dice.in(0, static_cast<std::int64_t>(i) - 1));
    std::swap(out.all_casters[i - 1], out.all_casters[other]);
    if (facets) std::swap(setup->facets[i - 1], setup->facets[other]);
  }
  for (std::size_t i = 0; i < out.all_casters.size(); ++i) {
    const std::int64_t by = dice.in(0, 2);
    rewind(out.all_casters[i], facets ? &setup->facets[i] : nullptr, by, dice.one_in(2));
  }
  return out;
}

bool translate(Trace& trace, Dice& dice) {
  const auto some = [&](std::pair<std::int64_t, std::int64_t> room, std::uint32_t side) {
    const auto reach = std::max<std::int64_t>(1, side / 2);
    return dice.in(std::max(room.first, -reach), std::min(room.second, reach));
  };
  const std::int64_t x = some(room(trace, &LightPoint::x), trace.header.map_width);
  const std::int64_t y = some(room(trace, &LightPoint::y), trace.header.map_height);
  if (x == 0 && y == 0) return false;
  const std::int64_t texel = std::int64_t{1} << trace.header.fraction_bits;
  return move_points(trace, [=](std::int64_t& px, std::int64_t& py) {
    px += x * texel;
    py += y * texel;
  });
}

bool turn(Trace& trace, Dice& dice) {
  const auto kind = dice.in(1, 7);  // which of the square's other seven symmetries
  if (kind & 4) std::swap(trace.header.map_width, trace.header.map_height);
  return move_points(trace, [=](std::int64_t& x, std::int64_t& y) {
    if (kind & 1) x = -x;
    if (kind & 2) y = -y;
    if (kind & 4) std::swap(x, y);
  });
}

Trace refined(const Trace& trace, Dice& dice, bool& exact) {
  Trace out = trace;
  exact = true;
  std::vector<Caster>& casters = out.all_casters;
  const std::size_t cuts = std::min<std::size_t>(200, 2 * casters.size());
  for (std::size_t n = 0; n < cuts; ++n) {
    const std::size_t index = dice.index(casters);
    const Caster whole = casters[index];
    const auto i = static_cast<int>(dice.in(0, 2));
    const Point a = wide(whole.vertex[i]), b = wide(whole.vertex[(i + 1) % 3]);
    const Point d = b - a;
    const std::int64_t steps = std::gcd(std::gcd(d.x, d.y), d.z);
    // Where the edge passes the lattice, pieces are exact; elsewhere a cut now and then.
    Point cut;
    if (steps > 1) {
      cut = between(a, b, dice.in(1, steps - 1), steps);
    } else if (dice.one_in(4)) {
      cut = between(a, b, dice.in(1, 15), 16);
      exact = false;
    } else {
      continue;
    }
    Caster first = whole, second = whole;
    first.vertex[(i + 1) % 3] = narrow(cut);
    second.vertex[i] = narrow(cut);
    second.polygon = static_cast<std::uint32_t>(casters.size());
    casters[index] = first;
    casters.push_back(second);
  }
  return out;
}

std::uint32_t add_hidden(Trace& trace, Dice& dice) {
  std::vector<std::uint32_t> depths;
  for (const Fragment& f : trace.all_fragments) depths.push_back(f.position.z);
  std::sort(depths.begin(), depths.end());
  const std::uint32_t depth =
      depths.empty() ? kDepthMax : depths[std::min(depths.size() - 1, depths.size() * 3 / 4)];
  Builder builder(dice, trace);
  const std::uint32_t object = builder.object("hidden");
  const auto count = dice.in(1, 10);
  for (std::int64_t i = 0; i < count; ++i) {
    Point v[3];
    for (Point& p : v) {
      p = dice.one_in(2) ? builder.anywhere() : builder.corner();
      p.z = depth;
    }
    builder.triangle(v[0], v[1], v[2], object);
  }
  return depth;
}

}  // namespace kagesen::stress
