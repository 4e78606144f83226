#pragma once
/// Random and adversarial triangle soups, and the plainest possible answers about them.
#include <cstdint>
#include <random>
#include <vector>

#include "model/reference/reference.h"
#include "model/reference/triangle.h"

namespace kagesen {

enum class Soup {
  kSmall,         ///< many small triangles
  kHuge,          ///< up to the ends of the coordinate range
  kMixed,         ///< all sizes, many depth layers
  kConcentrated,  ///< everything within 2,000 units, far from the origin
  kTiny,          ///< within 12 units: points hit edges and vertices all the time, depths tie
  kSlivers,       ///< long and a few units wide
  kFan,           ///< all share a vertex
  kDuplicated,    ///< few different ones, many times
  kDegenerate,    ///< half of them without area
  kWalls,         ///< each covers everything
};
inline constexpr Soup kAllSoups[] = {
    Soup::kSmall,   Soup::kHuge, Soup::kMixed,      Soup::kConcentrated, Soup::kTiny,
    Soup::kSlivers, Soup::kFan,  Soup::kDuplicated, Soup::kDegenerate,   Soup::kWalls};

struct Generator {
  explicit Generator(std::uint64_t seed) : engine(seed) {}
  /// Uniform in [low, high].
  std::int64_t in(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(engine);
  }
  LightPoint point(std::int64_t low, std::int64_t high, std::int64_t z_low, std::int64_t z_high) {
    return {std::int32_t(in(low, high)), std::int32_t(in(low, high)),
            std::uint32_t(in(z_low, z_high))};
  }
  LightPoint near(const LightPoint& p, std::int64_t spread, std::int64_t z_spread) {
    auto shift = [&](std::int64_t v, std::int64_t s, std::int64_t low, std::int64_t high) {
      return std::clamp(v + in(-s, s), low, high);
    };
    return {std::int32_t(shift(p.x, spread, kCoordinateMin, kCoordinateMax)),
            std::int32_t(shift(p.y, spread, kCoordinateMin, kCoordinateMax)),
            std::uint32_t(shift(p.z, z_spread, 0, kDepthMax))};
  }
  std::mt19937_64 engine;
};

inline Caster random_caster(Soup soup, Generator& g, const std::vector<Caster>& earlier) {
  constexpr std::int64_t kMap = 1 << 25;
  Caster c;
  c.object = std::uint32_t(g.in(0, 3));
  LightPoint* v = c.vertex;
  auto cluster = [&](const LightPoint& centre, std::int64_t spread, std::int64_t z_spread) {
    for (int i = 0; i < 3; ++i) v[i] = g.near(centre, spread, z_spread);
  };
  switch (soup) {
    case Soup::kSmall:
      cluster(g.point(-kMap, kMap, 0, kDepthMax), kMap / 32, 100'000);
      break;
    case Soup::kHuge:
      for (int i = 0; i < 3; ++i) {
        v[i] = g.point(kCoordinateMin, kCoordinateMax, 0, kDepthMax);
        if (g.in(0, 3) == 0) v[i].x = g.in(0, 1) ? kCoordinateMin : kCoordinateMax;
        if (g.in(0, 3) == 0) v[i].y = g.in(0, 1) ? kCoordinateMin : kCoordinateMax;
        if (g.in(0, 3) == 0) v[i].z = g.in(0, 1) ? 0 : kDepthMax;
      }
      break;
    case Soup::kMixed:
      cluster(g.point(-kMap, kMap, 0, kDepthMax), std::int64_t{1} << g.in(4, 26), 1 << g.in(0, 20));
      break;
    case Soup::kConcentrated:
      cluster(g.point(70'000'000, 70'002'000, 5000, 6000), g.in(1, 400), g.in(0, 300));
      break;
    case Soup::kTiny:
      for (int i = 0; i < 3; ++i) v[i] = g.point(-6, 6, 10, 16);
      break;
    case Soup::kSlivers: {
      v[0] = g.point(-kMap, kMap, 0, kDepthMax);
      v[1] = g.point(-kMap, kMap, 0, kDepthMax);
      v[2] = g.near(v[0], 5, 1000);
      break;
    }
    case Soup::kFan:
      cluster(g.point(-kMap, kMap, 0, kDepthMax), kMap / 8, 100'000);
      v[0] = {12345, -54321, 777'777};
      break;
    case Soup::kDuplicated:
      if (earlier.size() >= 5) {
        const std::uint32_t object = c.object;
        c = earlier[std::size_t(g.in(0, 4))];
        c.object = object;
        break;
      }
      cluster(g.point(-kMap, kMap, 0, kDepthMax), kMap, 1'000'000);
      break;
    case Soup::kDegenerate:
      cluster(g.point(-100, 100, 0, 200), 60, 60);
      if (g.in(0, 1) == 0)
        v[2] = g.in(0, 1) ? v[0] : LightPoint{2 * v[1].x - v[0].x, 2 * v[1].y - v[0].y, 3};
      break;
    case Soup::kWalls:
      v[0] = g.near({kCoordinateMin, kCoordinateMin, 8'000'000}, 1000, 7'000'000);
      v[1] = g.near({kCoordinateMax, kCoordinateMin, 8'000'000}, 1000, 7'000'000);
      v[2] = g.near({0, kCoordinateMax, 8'000'000}, 1000, 7'000'000);
      break;
  }
  return c;
}

inline std::vector<Caster> random_soup(Soup soup, std::size_t count, std::uint64_t seed) {
  Generator g(seed * 1000 + std::uint64_t(soup));
  std::vector<Caster> casters;
  for (std::size_t i = 0; i < count; ++i) {
    casters.push_back(random_caster(soup, g, casters));
    casters.back().polygon = std::uint32_t(i);
  }
  return casters;
}

/// A query point that has something to do with the casters: on, near or between their vertices.
inline LightPoint random_query(const std::vector<Caster>& casters, Generator& g) {
  const Caster& c = casters[std::size_t(g.in(0, std::int64_t(casters.size()) - 1))];
  const LightPoint& a = c.vertex[g.in(0, 2)];
  const LightPoint& b =
      casters[std::size_t(g.in(0, std::int64_t(casters.size()) - 1))].vertex[g.in(0, 2)];
  LightPoint p = a;
  switch (g.in(0, 4)) {
    case 0:
      break;
    case 1:
      p = g.near(a, 3, 3);
      break;
    case 2: {  // the middle of an edge of the caster, exactly where it is an integer
      const LightPoint& e = c.vertex[g.in(0, 2)];
      p = {std::int32_t((std::int64_t{a.x} + e.x) / 2), std::int32_t((std::int64_t{a.y} + e.y) / 2),
           (a.z + e.z) / 2};
      break;
    }
    default: {
      const auto t = g.in(0, 1000);
      auto mix = [t](std::int64_t u, std::int64_t v) { return u + (v - u) * t / 1000; };
      p = {std::int32_t(mix(a.x, b.x)), std::int32_t(mix(a.y, b.y)), std::uint32_t(mix(a.z, b.z))};
    }
  }
  if (g.in(0, 2) == 0) p.z = b.z;
  return p;
}

/// dark() by trying every caster with the exact predicates.
inline bool dark_by_trying_all(const std::vector<Caster>& casters, const LightPoint& p,
                               std::uint32_t object, Semantics semantics) {
  for (const Caster& c : casters) {
    if (semantics == Semantics::kPaper && c.object == object) continue;
    const Weights w = weights_at(c, p.x, p.y);
    if (w.inside() && plane_nearer(c, w, p.z)) return true;
  }
  return false;
}

}  // namespace kagesen
