// Geometry that lies on the lattice of texels, or just off it.
#include <algorithm>

#include "tests/stress/families.h"

namespace kagesen::stress {
namespace {

/// Depths that differ by up to `most`; often not at all.
std::int64_t tilt(Builder& b, std::int64_t most) {
  return b.dice.one_in(3) ? 0 : b.dice.in(-most, most);
}

}  // namespace

void build_corners(Builder& b) {
  b.small_map();
  const auto count = b.dice.in(3, 60);
  for (std::int64_t i = 0; i < count; ++i) {
    const Point base = b.corner();
    const auto reach = b.dice.pick<std::int64_t>({1, 2, 3, 8});
    const auto vertex = [&] {
      return base + Point{b.dice.in(-reach, reach) * b.texel() + b.dice.nudge(),
                          b.dice.in(-reach, reach) * b.texel() + b.dice.nudge(), tilt(b, 40'000)};
    };
    const Point p = vertex(), q = vertex(), r = vertex();
    b.triangle(p, q, r, b.some_object());
  }
}

void build_borders(Builder& b) {
  b.small_map();
  const auto count = b.dice.in(2, 30);
  const std::int64_t t = b.texel();
  for (std::int64_t i = 0; i < count; ++i) {
    const Point p = b.corner();
    const std::int64_t width = b.dice.in(1, 6) * t + b.dice.nudge(),
                       height = b.dice.in(1, 6) * t + b.dice.nudge();
    const std::int64_t dx = tilt(b, 30'000), dy = tilt(b, 30'000);
    const std::uint32_t object = b.some_object();
    if (b.dice.one_in(2)) {
      b.quad(p, p + Point{width, 0, dx}, p + Point{width, height, dx + dy},
             p + Point{0, height, dy}, object);
      continue;
    }
    // One side along a border, its ends and the third vertex wherever they fall.
    const std::int64_t from = b.dice.in(-t, t), to = from + b.dice.in(1, 5 * t);
    const Point off{b.dice.in(-3 * t, 3 * t), b.dice.in(-3 * t, 3 * t), dy};
    const std::int64_t side = b.dice.nudge();
    if (b.dice.one_in(2)) {
      b.triangle(p + Point{from, side, 0}, p + Point{to, side, dx}, p + off, object);
    } else {
      b.triangle(p + Point{side, from, 0}, p + Point{side, to, dx}, p + off, object);
    }
  }
}

void build_slopes(Builder& b) {
  b.small_map();
  const auto count = b.dice.in(3, 40);
  for (std::int64_t i = 0; i < count; ++i) {
    const Point from = b.dice.one_in(2) ? b.corner() : b.anywhere();
    const std::int64_t length =
        b.dice.one_in(2) ? b.dice.in(1, 8) * b.texel() : b.dice.in(1, 8 * b.texel());
    const std::int64_t rise = (b.dice.one_in(2) ? length : 0) + b.dice.in(-1, 1);
    const bool swap = b.dice.one_in(2);
    const std::int64_t dx = b.dice.either(swap ? rise : length),
                       dy = b.dice.either(swap ? length : rise);
    const Point to = from + Point{dx, dy, tilt(b, 50'000)};
    Point third = from;
    if (b.dice.one_in(3)) {
      third = between(from, to, b.dice.in(0, 8), 8);
      third = third + Point{b.dice.in(-3, 3), 2, 0};
    } else {
      third =
          third + Point{b.dice.in(-length, length), b.dice.in(-length, length), tilt(b, 50'000)};
    }
    b.triangle(from, to, third, b.some_object());
  }
}

void build_long_edges(Builder& b) {
  // A map a few texels high is all that an edge 4,096 texels long needs to be walked whole.
  const auto thin = static_cast<std::uint32_t>(b.dice.in(2, 8));
  switch (b.dice.in(0, 3)) {
    case 0:
      b.map(kMaxMapSide, thin, kMinFractionBits);
      break;
    case 1:
      b.map(thin, kMaxMapSide, kMinFractionBits);
      break;
    default:
      b.map(128, 128, kMinFractionBits);
  }
  const auto count = b.dice.in(2, 16);
  for (std::int64_t i = 0; i < count; ++i) {
    const Point through = b.anywhere();  // every edge crosses the map
    const std::int64_t length = b.texel() << b.dice.in(0, 12);
    const bool flat = b.dice.one_in(2);
    const std::int64_t across =
        b.dice.one_in(2) ? b.dice.in(-3 * b.texel(), 3 * b.texel()) : b.dice.in(-length, length);
    const Point along =
        flat ? Point{length, across, tilt(b, 1 << 20)} : Point{across, length, tilt(b, 1 << 20)};
    const Point from = through - between({}, along, b.dice.in(0, 16), 16);
    const Point third =
        b.dice.one_in(2) ? from + Point{b.dice.in(-length, length), b.dice.in(-length, length), 0}
                         : from + Point{b.dice.in(-4 * b.texel(), 4 * b.texel()),
                                        b.dice.in(-4 * b.texel(), 4 * b.texel()), 0};
    b.triangle(from, from + along, third, b.some_object());
  }
}

}  // namespace kagesen::stress
