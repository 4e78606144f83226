// Shapes of single facets: thin, small, many round a vertex, doubled, without area.
#include <algorithm>
#include <cmath>

#include "tests/stress/families.h"

namespace kagesen::stress {
namespace {

/// An end some way off, up to `texels`.
Point far_end(Builder& b, Point from, std::int64_t texels) {
  const std::int64_t reach = std::min(texels * b.texel(), b.span());
  return from + Point{b.dice.in(-reach, reach), b.dice.in(-reach, reach),
                      b.dice.one_in(3) ? 0 : b.dice.in(-60'000, 60'000)};
}

/// About the radius of the contract for some precision, in units: it decides what counts as narrow.
std::int64_t some_radius(Builder& b) {
  const std::int64_t radius = b.texel() >> b.dice.in(4, 12);
  return std::max<std::int64_t>(1, radius / b.dice.pick({1, 2, 4, 4, 4, 8}) + b.dice.in(-1, 1));
}

}  // namespace

void build_slivers(Builder& b) {
  b.small_map();
  const auto count = b.dice.in(3, 50);
  for (std::int64_t i = 0; i < count; ++i) {
    const Point from = b.dice.one_in(4) ? b.corner() : b.anywhere();
    const Point to = far_end(b, from, b.dice.pick({1, 2, 8, 16}));
    const std::int64_t width = b.dice.one_in(2) ? 1 : some_radius(b);
    Point third = between(from, to, b.dice.in(0, 64), 64);
    third = third + Point{b.dice.in(-width, width), b.dice.in(-width, width), 0};
    if (b.dice.one_in(3)) third.z = b.some_depth();  // a plane as steep as can be
    const std::uint32_t object = b.some_object();
    b.triangle(from, to, third, object);
    // Its other side, so that only the sliver separates two facets.
    if (b.dice.one_in(3)) b.triangle(from, third, far_end(b, from, 4), object);
  }
}

void build_specks(Builder& b) {
  b.small_map();
  const auto places = b.dice.in(1, 12);
  for (std::int64_t i = 0; i < places; ++i) {
    const Point place = b.dice.one_in(2) ? b.corner() : b.anywhere();
    const std::int64_t size = b.dice.one_in(2) ? b.dice.in(1, 6) : some_radius(b);
    const std::int64_t depth = b.dice.one_in(2) ? b.dice.in(0, 6) : b.dice.in(0, 100'000);
    const auto count = b.dice.in(1, 12);
    for (std::int64_t n = 0; n < count; ++n) {
      const auto vertex = [&] {
        return place +
               Point{b.dice.in(-size, size), b.dice.in(-size, size), b.dice.in(-depth, depth)};
      };
      const Point p = vertex(), q = vertex(), r = vertex();
      b.triangle(p, q, r, b.some_object());
    }
  }
}

void build_fan(Builder& b) {
  b.small_map();
  constexpr int kTriangles = 1000;
  const Point place = b.dice.one_in(2) ? b.corner() : b.anywhere();
  const Point centre = place + Point{b.dice.nudge(), b.dice.nudge(), 0};
  const std::int64_t reach =
      std::max<std::int64_t>(2000, b.span() / b.dice.pick({2, 4, 16, 64, 1024}));
  const std::int64_t rise = b.dice.one_in(3) ? 0 : b.dice.in(-500'000, 500'000);
  const bool ragged = b.dice.one_in(2);
  const double turn = b.dice.real(0, 6.28);
  const std::uint32_t object = b.object("fan");
  const auto rim = [&](int i) {
    const double angle = turn + 6.283185307179586 * i / kTriangles;
    const double radius = static_cast<double>(reach);
    return centre + Point{std::llround(radius * std::cos(angle)),
                          std::llround(radius * std::sin(angle)), rise};
  };
  const Point first = rim(0);
  Point before = first;
  for (int i = 1; i <= kTriangles; ++i) {
    Point next = i == kTriangles ? first : rim(i);
    if (ragged && i < kTriangles) {
      next = between(centre, next, b.dice.in(1, 8), 8);
      next.z += b.dice.in(-1000, 1000);
    }
    b.triangle(centre, before, next, object);
    before = next;
  }
}

void build_windings(Builder& b) {
  b.small_map();
  const auto meshes = b.dice.in(1, 4);
  for (std::int64_t m = 0; m < meshes; ++m) {
    const std::uint32_t object = b.object("strip");
    Point p = b.anywhere(), q = far_end(b, p, 3);
    const auto count = b.dice.in(2, 20);
    for (std::int64_t i = 0; i < count; ++i) {
      const Point r = far_end(b, b.dice.one_in(2) ? p : q, 3);
      const bool turned = b.dice.one_in(2);
      b.triangle(p, turned ? r : q, turned ? q : r, object);
      if (b.dice.one_in(3)) b.triangle(p, turned ? q : r, turned ? r : q, b.some_object());
      p = b.dice.one_in(2) ? q : p;
      q = r;
    }
  }
}

void build_degenerate(Builder& b) {
  b.small_map();
  const auto count = b.dice.in(2, 30);
  for (std::int64_t i = 0; i < count; ++i) {
    const Point p = b.dice.one_in(3) ? b.corner() : b.anywhere();
    const Point q = far_end(b, p, 6);
    const Point r = far_end(b, p, 6);
    const std::uint32_t object = b.some_object();
    switch (b.dice.in(0, 5)) {
      case 0:  // a point
        b.triangle(p, p, {p.x, p.y, b.some_depth()}, object);
        break;
      case 1:  // there and back
        b.triangle(p, q, {p.x, p.y, b.some_depth()}, object);
        break;
      case 2:  // a straight line through lattice points
        b.triangle(p, p + Point{(q.x - p.x) * 2, (q.y - p.y) * 2, 5}, q, object);
        break;
      case 3:  // seen edge on
        b.triangle({p.x, p.y, p.z}, {p.x, q.y, q.z}, {p.x, r.y, r.z}, object);
        break;
      default:
        break;
    }
    const auto copies = b.dice.in(1, b.dice.one_in(6) ? 40 : 3);
    for (std::int64_t n = 0; n < copies; ++n) {
      b.triangle(p, q, r, b.dice.one_in(2) ? object : b.some_object());
    }
  }
}

}  // namespace kagesen::stress
