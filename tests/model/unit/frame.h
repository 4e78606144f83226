#pragma once
/// Small frames, drawn and decided through the Engine interface.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

#include "model/engine.h"

namespace kagesen {

inline constexpr std::int32_t kTexel = 1 << kMinFractionBits;

struct Frame {
  std::vector<Caster> casters;
  std::vector<Fragment> fragments;
};

struct Outcome {
  std::vector<Verdict> verdicts;
  MapContents contents;
  UnitCounters counters;
};

inline Fragment fragment_at(std::int32_t x, std::int32_t y, std::uint32_t z, std::uint32_t object) {
  Fragment f;
  f.position = {x, y, z};
  f.object = object;
  return f;
}

/// Index of a fragment's texel in a square map.
inline std::size_t texel_of(const Fragment& f, int side) {
  return static_cast<std::size_t>((f.position.y >> kMinFractionBits) + side / 2) * side +
         static_cast<std::size_t>((f.position.x >> kMinFractionBits) + side / 2);
}

inline Caster triangle(LightPoint a, LightPoint b, LightPoint c, std::uint32_t object,
                       std::uint32_t polygon = 0) {
  return {{a, b, c}, object, polygon};
}

inline Outcome run(const Frame& frame, const UnitConfig& config, const FrameSetup& setup = {}) {
  const std::unique_ptr<Engine> engine = make_golden_engine();
  engine->begin(config, setup);
  engine->draw(frame.casters.data(), frame.casters.size());
  Outcome out;
  out.verdicts.resize(frame.fragments.size());
  engine->decide(frame.fragments.data(), frame.fragments.size(), out.verdicts.data());
  out.contents = engine->contents();
  out.counters = engine->counters();
  return out;
}

inline Verdict verdict_of(std::vector<Caster> casters, const Fragment& fragment,
                          const UnitConfig& config) {
  return run({std::move(casters), {fragment}}, config).verdicts[0];
}

inline UnitConfig small_config(std::int64_t side = 16) {
  UnitConfig config;
  config.map_width = config.map_height = side;
  return config;
}

// Records compare by value, so that whole buffers can.
inline auto as_tuple(const LineRecord& l) {
  return std::tie(l.fraction, l.slope, l.polygon, l.left, l.cross, l.x_major, l.x_positive,
                  l.start_here, l.end_here);
}
inline bool operator==(const LineRecord& a, const LineRecord& b) {
  return as_tuple(a) == as_tuple(b);
}
inline bool operator<(const LineRecord& a, const LineRecord& b) {
  return as_tuple(a) < as_tuple(b);
}
inline bool operator==(const TexelEntry& a, const TexelEntry& b) {
  return std::tie(a.texel_x, a.texel_y, a.object, a.nearest, a.vertex, a.lines) ==
         std::tie(b.texel_x, b.texel_y, b.object, b.nearest, b.vertex, b.lines);
}
inline bool operator==(const MapContents& a, const MapContents& b) {
  return std::tie(a.width, a.height, a.depth, a.object, a.overflowed, a.entries) ==
         std::tie(b.width, b.height, b.depth, b.object, b.overflowed, b.entries);
}

/// Closed solids: `count` random octahedra, each an object of its own, and fragments all over.
/// Only triangles that face the light are drawn, as docs/unit.md has it. No vertex lies on a
/// texel's border, and no edge is horizontal or vertical.
class RandomScene {
 public:
  RandomScene(unsigned seed, int side, int count = 12, int fragments = 800) : random_(seed) {
    for (int object = 0; object < count; ++object) add_octahedron(object, side);
    for (int i = 0; i < fragments; ++i) {
      frame.fragments.push_back(fragment_at(coordinate(side * kTexel / 2),
                                            coordinate(side * kTexel / 2), random_() & kDepthMax,
                                            random_() % (count + 1)));
    }
  }

  Frame frame;

 private:
  std::int32_t coordinate(std::int32_t half) {
    for (;;) {
      const auto c = static_cast<std::int32_t>(random_() % (2u * half)) - half;
      if (c % kTexel != 0) return c;
    }
  }

  void add_octahedron(int object, int side) {
    const std::int32_t radius = kTexel / 2 + static_cast<std::int32_t>(random_() % (4 * kTexel));
    const LightPoint centre{
        coordinate((side - 8) * kTexel / 2), coordinate((side - 8) * kTexel / 2),
        static_cast<std::uint32_t>(1 << 20) + static_cast<std::uint32_t>(random_() % (10u << 20))};
    LightPoint v[6];  // opposite ones: 0 and 1, 2 and 3, 4 and 5
    for (int axis = 0; axis < 3; ++axis) {
      const std::int32_t dx = coordinate(radius), dy = coordinate(radius);
      const auto dz = static_cast<std::int32_t>(random_() % (1 << 19));
      v[2 * axis] = {centre.x + dx, centre.y + dy, centre.z + dz};
      v[2 * axis + 1] = {centre.x - dx, centre.y - dy, centre.z - dz};
    }
    for (unsigned n = 0; n < 8; ++n) {
      const LightPoint &a = v[n & 1], &b = v[2 + (n >> 1 & 1)], &c = v[4 + (n >> 2)];
      if (faces_the_light(a, b, c, centre)) {
        frame.casters.push_back(triangle(a, b, c, static_cast<std::uint32_t>(object),
                                         static_cast<std::uint32_t>(frame.casters.size())));
      }
    }
  }

  /// Does the plane of a, b, c have the centre behind it, seen along +z?
  static bool faces_the_light(const LightPoint& a, const LightPoint& b, const LightPoint& c,
                              const LightPoint& centre) {
    const double ux = b.x - a.x, uy = b.y - a.y, uz = double(b.z) - a.z;
    const double vx = c.x - a.x, vy = c.y - a.y, vz = double(c.z) - a.z;
    const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz, nz = ux * vy - uy * vx;
    const double to_centre = nx * (double(centre.x) - a.x) + ny * (double(centre.y) - a.y) +
                             nz * (double(centre.z) - a.z);
    return nz != 0 && (to_centre > 0) == (nz > 0);
  }

  std::mt19937 random_;
};

}  // namespace kagesen
