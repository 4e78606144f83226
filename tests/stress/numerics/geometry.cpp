#include "tests/stress/numerics/geometry.h"

namespace kagesen::stress {
namespace {

std::int64_t bounded(std::int64_t v) {
  return std::clamp<std::int64_t>(v, kCoordinateMin, kCoordinateMax);
}

void append_near(Inputs& out, std::int64_t x, std::int64_t y, std::int64_t z, Dice& dice) {
  const int bits = dice.small(1, kCoordinateBits);
  out.push_back(bounded(x + dice.either(dice.magnitude(bits))));
  out.push_back(bounded(y + dice.either(dice.magnitude(dice.one_in(2) ? bits : 27))));
  out.push_back(std::clamp<std::int64_t>(z + dice.either(dice.magnitude(24)), 0, kDepthMax));
}

Inputs draw_points(std::size_t count, Dice& dice) {
  const std::int64_t reach = dice.magnitude(26);
  Inputs out = {dice.in(-reach, reach), dice.in(-reach, reach), dice.in(0, kDepthMax)};
  for (std::size_t i = 1; i < count; ++i) append_near(out, out[0], out[1], out[2], dice);
  return out;
}

}  // namespace

std::optional<std::pair<ExactPoint, ExactPoint>> clip(const LightPoint& a, const LightPoint& b,
                                                      std::int64_t x, std::int64_t y,
                                                      std::int64_t side) {
  const Exact dx = Exact(b.x) - a.x, dy = Exact(b.y) - a.y;
  Exact from = 0, to = 1;
  const auto cut = [&](const Exact& delta, const Exact& low, const Exact& high) {
    if (delta == 0) return low <= 0 && 0 <= high;
    Exact t0 = low / delta, t1 = high / delta;
    if (t0 > t1) std::swap(t0, t1);
    from = std::max(from, t0);
    to = std::min(to, t1);
    return from <= to;
  };
  if (!cut(dx, Exact(x) - a.x, Exact(x) + side - a.x)) return {};
  if (!cut(dy, Exact(y) - a.y, Exact(y) + side - a.y)) return {};
  const auto at = [&](const Exact& t) { return ExactPoint{a.x + t * dx, a.y + t * dy}; };
  return std::pair(at(from), at(to));
}

Inputs draw_edge(Dice& dice) { return draw_points(2, dice); }
Inputs draw_facet(Dice& dice) { return draw_points(3, dice); }

}  // namespace kagesen::stress
