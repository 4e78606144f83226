#include "tests/stress/builder.h"

#include <algorithm>
#include <cmath>

namespace kagesen::stress {
namespace {

LightPoint clamped(Point p) {
  const auto coordinate = [](std::int64_t v) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(v, kCoordinateMin, kCoordinateMax));
  };
  return {coordinate(p.x), coordinate(p.y),
          static_cast<std::uint32_t>(std::clamp<std::int64_t>(p.z, 0, kDepthMax))};
}

std::int64_t blend(std::int64_t a, std::int64_t b, std::int64_t part, std::int64_t whole) {
  __extension__ typedef __int128 Wide;
  const Wide twice = Wide{b - a} * part * 2 + whole;
  const Wide quotient = twice / (Wide{whole} * 2);
  return a + static_cast<std::int64_t>(quotient - (twice % (Wide{whole} * 2) < 0));
}

}  // namespace

Point between(Point a, Point b, std::int64_t part, std::int64_t whole) {
  return {blend(a.x, b.x, part, whole), blend(a.y, b.y, part, whole), blend(a.z, b.z, part, whole)};
}

void Builder::map(std::uint32_t width, std::uint32_t height, std::uint32_t fraction_bits) {
  if (has_map()) return;
  TraceHeader& h = trace_.header;
  h.map_width = width;
  h.map_height = height;
  h.fraction_bits = fraction_bits;
  h.light = "directional";
  h.objects.push_back({"ground", 0, false, false});
}

void Builder::small_map() {
  const auto side = [&] {
    return static_cast<std::uint32_t>(dice.one_in(4) ? dice.in(7, 64)
                                                     : dice.pick({8, 16, 16, 24, 32, 64}));
  };
  const std::uint32_t width = side();
  map(width, dice.one_in(3) ? side() : width,
      static_cast<std::uint32_t>(dice.one_in(2) ? kMinFractionBits : dice.in(17, 24)));
}

std::int64_t Builder::left() const {
  return std::max<std::int64_t>(-std::int64_t{trace_.header.map_width / 2} * texel(),
                                kCoordinateMin);
}
std::int64_t Builder::low() const {
  return std::max<std::int64_t>(-std::int64_t{trace_.header.map_height / 2} * texel(),
                                kCoordinateMin);
}
std::int64_t Builder::right() const {
  const std::uint32_t w = trace_.header.map_width;
  return std::min<std::int64_t>(std::int64_t{w - w / 2} * texel() - 1, kCoordinateMax);
}
std::int64_t Builder::high() const {
  const std::uint32_t h = trace_.header.map_height;
  return std::min<std::int64_t>(std::int64_t{h - h / 2} * texel() - 1, kCoordinateMax);
}
std::int64_t Builder::span() const { return std::min(right() - left(), high() - low()); }

std::uint32_t Builder::object(const std::string& name, bool closed) {
  trace_.header.objects.push_back({name, 0, closed, true});
  return static_cast<std::uint32_t>(trace_.header.objects.size() - 1);
}

std::uint32_t Builder::some_object() {
  const auto last = static_cast<std::int64_t>(trace_.header.objects.size()) - 1;
  if (last == 0 || (last < 6 && dice.one_in(8))) return object("soup");
  return static_cast<std::uint32_t>(dice.in(1, last));
}

void Builder::triangle(Point a, Point b, Point c, std::uint32_t object) {
  Caster caster{{clamped(a), clamped(b), clamped(c)}, object, 0};
  caster.polygon = static_cast<std::uint32_t>(trace_.all_casters.size());
  trace_.header.objects[object].triangles += 1;
  trace_.all_casters.push_back(caster);
}

void Builder::quad(Point a, Point b, Point c, Point d, std::uint32_t object) {
  triangle(a, b, c, object);
  triangle(a, c, d, object);
}

Point Builder::anywhere() {
  return {dice.in(left(), right()), dice.in(low(), high()), some_depth()};
}

Point Builder::corner() {
  const std::int64_t t = texel();
  return {dice.in(left() / t - 1, right() / t + 1) * t, dice.in(low() / t - 1, high() / t + 1) * t,
          some_depth()};
}

}  // namespace kagesen::stress
