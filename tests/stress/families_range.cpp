// Ends of the ranges of coordinates, depths, gradients and sizes; and everything at once.
#include <algorithm>

#include "tests/stress/families.h"

namespace kagesen::stress {
namespace {

std::int64_t end_of_range(Builder& b) {
  return b.dice.one_in(2) ? kCoordinateMin + b.dice.in(0, 1) : kCoordinateMax - b.dice.in(0, 1);
}

}  // namespace

void build_range_ends(Builder& b) {
  const auto bits = static_cast<std::uint32_t>(
      b.dice.one_in(2) ? b.dice.in(kMinFractionBits, kMaxFractionBits)
                       : b.dice.pick({kMinFractionBits, 22, kMaxFractionBits}));
  const auto side = static_cast<std::uint32_t>(b.dice.pick({1, 4, 8, 16, 33, 64}));
  b.map(side, side, bits);
  const auto count = b.dice.in(1, 20);
  for (std::int64_t i = 0; i < count; ++i) {
    Point v[3];
    for (Point& p : v) {
      p = b.dice.one_in(3) ? b.anywhere()
                           : Point{b.dice.in(kCoordinateMin, kCoordinateMax),
                                   b.dice.in(kCoordinateMin, kCoordinateMax), b.some_depth()};
      if (b.dice.one_in(3)) p.x = end_of_range(b);
      if (b.dice.one_in(3)) p.y = end_of_range(b);
      if (b.dice.one_in(6)) p.z = b.dice.one_in(2) ? 0 : kDepthMax;
    }
    b.triangle(v[0], v[1], v[2], b.some_object());
  }
}

void build_map_sides(Builder& b) {
  b.small_map();
  const auto count = b.dice.in(2, 30);
  const auto outside = [&](std::int64_t low, std::int64_t high) {
    const std::int64_t t = b.texel();
    const std::int64_t off = b.dice.pick<std::int64_t>({0, 1, t / 2, t, 10 * t, 100 * t});
    return b.dice.one_in(2) ? low - off + b.dice.in(0, 1) : high + off + b.dice.in(0, 1);
  };
  for (std::int64_t i = 0; i < count; ++i) {
    Point v[3];
    for (Point& p : v) {
      p = b.anywhere();
      if (b.dice.one_in(2)) p.x = outside(b.left(), b.right());
      if (b.dice.one_in(2)) p.y = outside(b.low(), b.high());
    }
    b.triangle(v[0], v[1], v[2], b.some_object());
  }
}

void build_scale_1024(Builder& b) {
  const auto side = static_cast<std::uint32_t>(b.dice.pick({1, 2, 4, 8, 64}));
  b.map(side, side, kMaxFractionBits);
  switch (b.dice.in(0, 7)) {
    case 0:
      return build_torus(b);
    case 1:
      return build_knot(b);
    case 2:
      return build_interpenetrating(b);
    case 3:
      return build_terrain(b);
    case 4:
      return build_boxes(b);
    case 5:
      return build_fan(b);
    default:
      break;
  }
  const auto count = b.dice.in(10, 200);
  for (std::int64_t i = 0; i < count; ++i) {
    const Point p = b.anywhere();
    const std::int64_t size = b.dice.magnitude(24);
    const auto near = [&] {
      return p + Point{b.dice.in(-size, size), b.dice.in(-size, size), b.dice.in(-9999, 9999)};
    };
    const Point q = near(), r = near();
    b.triangle(p, q, r, b.some_object());
  }
}

void build_grazing(Builder& b) {
  b.small_map();
  const auto count = b.dice.in(2, 20);
  for (std::int64_t i = 0; i < count; ++i) {
    // A wall that the light barely sees: a strip whose two long sides lie at different depths.
    const Point from = b.dice.one_in(3) ? b.corner() : b.anywhere();
    const std::int64_t reach = std::min(8 * b.texel(), b.span());
    const Point to =
        from + Point{b.dice.in(-reach, reach), b.dice.in(-reach, reach), b.dice.in(-5000, 5000)};
    const std::int64_t wide = b.dice.magnitude(static_cast<int>(b.dice.in(1, 20)));
    const std::int64_t deep = b.dice.magnitude(24);
    const Point off{b.dice.in(-wide, wide), b.dice.in(-wide, wide), b.dice.either(deep)};
    const std::uint32_t object = b.some_object();
    b.quad(from, to, to + off, from + off, object);
    if (b.dice.one_in(2)) {
      b.quad(from, to, to + Point{b.texel(), b.texel(), 100}, from + Point{b.texel(), 0, 100},
             object);
    }
  }
}

void build_depth_ends(Builder& b) {
  b.small_map();
  const auto count = b.dice.in(2, 30);
  for (std::int64_t i = 0; i < count; ++i) {
    Point v[3];
    const Point place = b.anywhere();
    const std::int64_t size = b.dice.in(1, 8 * b.texel());
    const bool near = b.dice.one_in(2);
    for (Point& p : v) {
      const std::int64_t off = b.dice.one_in(2) ? b.dice.in(0, 2) : b.dice.in(0, 200);
      p = {place.x + b.dice.in(-size, size), place.y + b.dice.in(-size, size),
           near ? off : kDepthMax - off};
      if (b.dice.one_in(8)) p.z = near ? kDepthMax : 0;
    }
    b.triangle(v[0], v[1], v[2], b.some_object());
  }
}

void build_soup(Builder& b) {
  b.small_map();
  const auto count = b.dice.in(5, 200);
  for (std::int64_t i = 0; i < count; ++i) {
    const Point p = b.anywhere();
    const std::int64_t size = b.dice.magnitude(27), deep = b.dice.magnitude(20);
    const auto near = [&] {
      return p + Point{b.dice.in(-size, size), b.dice.in(-size, size), b.dice.in(-deep, deep)};
    };
    const Point q = near(), r = near();
    b.triangle(p, q, r, b.some_object());
  }
}

void build_mixture(Builder& b) {
  b.small_map();
  for (int i = 0; i < 2; ++i) {
    const Family& family = families()[b.dice.index(families())];
    if (family.build != build_mixture) family.build(b);
  }
}

}  // namespace kagesen::stress
