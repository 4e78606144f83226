// How facets lie on and beside each other: layers and T-junctions.
#include <algorithm>
#include <vector>

#include "tests/stress/families.h"

namespace kagesen::stress {
namespace {

/// A facet beside the edge from a to b, its third vertex on the side that `sign` says.
Point beside(Builder& b, Point a, Point c, int sign) {
  const Point along = c - a;
  const Point middle = between(a, c, b.dice.in(1, 7), 8);
  const auto part = b.dice.in(1, 8);
  return middle + Point{-along.y * sign * part / 8, along.x * sign * part / 8, b.dice.in(-9, 9)};
}

}  // namespace

void build_dense(Builder& b) {
  b.small_map();
  // Facets far below a step take many to reach farther than the radius.
  const bool fine = b.dice.one_in(8);
  const int n = fine ? b.dice.small(60, 120) : b.dice.small(4, 24);
  // Steps of the ends are 2^-(F + 1) to 2^-(F + 4) texel.
  const std::int64_t step = std::max<std::int64_t>(1, b.texel() >> b.dice.in(5, 16));
  const std::int64_t spacing =
      std::max<std::int64_t>(1, step * (fine ? b.dice.in(1, 3) : b.dice.in(2, 12)) / 8);
  const std::int64_t rough = b.dice.one_in(2) ? b.dice.in(0, 200) : b.dice.magnitude(20);
  const bool aligned = b.dice.one_in(3);
  const Point place = b.dice.one_in(2) ? b.corner() : b.anywhere();
  std::vector<Point> at;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const std::int64_t jitter = aligned ? 0 : spacing / 3;
      at.push_back(place + Point{i * spacing + b.dice.in(-jitter, jitter),
                                 j * spacing + b.dice.in(-jitter, jitter),
                                 b.dice.in(-rough, rough)});
    }
  }
  const std::uint32_t object = b.object("dense");
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto corner = static_cast<std::size_t>(i * (n + 1) + j);
      const auto next = corner + static_cast<std::size_t>(n + 1);
      b.quad(at[corner], at[next], at[next + 1], at[corner + 1], object);
    }
  }
}

void build_layers(Builder& b) {
  b.small_map();
  const auto stacks = b.dice.in(1, 3);
  for (std::int64_t s = 0; s < stacks; ++s) {
    const Point p = b.dice.one_in(2) ? b.corner() : b.anywhere();
    const std::int64_t reach = std::min(b.dice.in(1, 8) * b.texel(), b.span());
    const std::int64_t steep = b.dice.one_in(3) ? 0 : b.dice.in(0, 1 << 18);
    const auto corner = [&](int x, int y) {
      return p + Point{x * reach + b.dice.nudge(b.texel()), y * reach + b.dice.nudge(b.texel()),
                       b.dice.in(-steep, steep)};
    };
    const Point at[4] = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
    const auto step = b.dice.pick<std::int64_t>({0, 1, 1, 1, 2, 16, 64, 100});
    const bool shared = b.dice.one_in(2);
    std::uint32_t object = b.some_object();
    const auto layers = b.dice.in(2, 24);
    for (std::int64_t i = 0; i < layers; ++i) {
      const Point shift{b.dice.nudge(), b.dice.nudge(), i * step};
      if (!shared) object = b.some_object();
      if (b.dice.one_in(2)) {
        b.quad(at[0] + shift, at[1] + shift, at[2] + shift, at[3] + shift, object);
      } else {
        b.quad(at[1] + shift, at[2] + shift, at[3] + shift, at[0] + shift, object);
      }
    }
  }
}

void build_exact_junctions(Builder& b) {
  b.small_map();
  const auto count = b.dice.in(1, 12);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::uint32_t object = b.some_object();
    const auto pieces = b.dice.in(2, 9);
    const std::int64_t reach = std::max<std::int64_t>(1, 6 * b.texel() / pieces);
    const Point step{b.dice.in(-reach, reach), b.dice.in(-reach, reach), b.dice.in(-2000, 2000)};
    const Point from = b.dice.one_in(2) ? b.corner() : b.anywhere();
    const Point to = from + Point{step.x * pieces, step.y * pieces, step.z * pieces};
    b.triangle(from, to, beside(b, from, to, 1), object);
    const Point other = beside(b, from, to, -1);
    for (std::int64_t n = 0; n < pieces; ++n) {
      b.triangle(from + Point{step.x * n, step.y * n, step.z * n},
                 from + Point{step.x * (n + 1), step.y * (n + 1), step.z * (n + 1)}, other, object);
    }
  }
}

void build_rounded_junctions(Builder& b) {
  b.small_map();
  const auto count = b.dice.in(1, 12);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::uint32_t object = b.some_object();
    const Point from = b.anywhere();
    const std::int64_t reach = std::min(6 * b.texel(), b.span());
    const Point to = from + Point{b.dice.in(-reach, reach), b.dice.in(-reach, reach),
                                  b.dice.in(-100'000, 100'000)};
    b.triangle(from, to, beside(b, from, to, 1), object);
    const Point other = beside(b, from, to, -1);
    const auto whole = b.dice.in(2, 1000);
    Point before = from;
    for (std::int64_t at = 0; at < whole;) {
      at = std::min(whole, at + b.dice.in(1, whole));
      Point next = between(from, to, at, whole);
      if (at < whole) next = next + Point{b.dice.nudge(), b.dice.nudge(), 0};
      b.triangle(before, next, other, object);
      before = next;
    }
  }
}

}  // namespace kagesen::stress
