#pragma once
/// Puts a stress case's geometry together.
#include <cstdint>
#include <string>

#include "tests/stress/dice.h"
#include "traces/format/records.h"

namespace kagesen::stress {

/// A point of light space before it is clamped to the range of a trace.
struct Point {
  std::int64_t x = 0, y = 0, z = 0;
};
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
/// a + (b - a) * part / whole, rounded to the nearest lattice point.
Point between(Point a, Point b, std::int64_t part, std::int64_t whole);

/// A trace that grows. Object 0 is a pure receiver, the ground.
class Builder {
 public:
  Builder(Dice& dice, Trace& trace) : dice(dice), trace_(trace) {}

  /// Sets the map unless it has been set.
  void map(std::uint32_t width, std::uint32_t height, std::uint32_t fraction_bits);
  /// A map of 8 to 64 texels a side, 16 to 24 fraction bits.
  void small_map();
  bool has_map() const { return !trace_.header.objects.empty(); }

  std::int64_t texel() const { return std::int64_t{1} << trace_.header.fraction_bits; }
  /// Ends of the map, units, inside the range of coordinates.
  std::int64_t left() const;
  std::int64_t right() const;
  std::int64_t low() const;
  std::int64_t high() const;
  /// The lesser extent of the map, units.
  std::int64_t span() const;

  /// A new object that casts shadows.
  std::uint32_t object(const std::string& name, bool closed = false);
  /// The object drawn to; one is made if there is none yet. Now and then a new one.
  std::uint32_t some_object();
  void triangle(Point a, Point b, Point c, std::uint32_t object);
  /// Two triangles a b c and a c d.
  void quad(Point a, Point b, Point c, Point d, std::uint32_t object);

  /// Anywhere on the map, at a depth that leaves room on both sides.
  Point anywhere();
  /// A texel corner of the map or of its neighbourhood.
  Point corner();
  std::int64_t some_depth() { return dice.in(1 << 16, kDepthMax - (1 << 20)); }

  Dice& dice;

 private:
  Trace& trace_;
};

}  // namespace kagesen::stress
