#pragma once
/// Pass 1: the casters of a scene as triangles on the integer grid of light space.
#include <cstdint>
#include <vector>

#include "traces/raster/light_space.h"

namespace kagesen {

struct CasterSet {
  std::vector<Caster> casters;       ///< in scene order
  std::vector<std::uint32_t> first;  ///< of polygon p: casters [first[p], first[p + 1])
  std::uint64_t culled = 0;          ///< triangles: averted, of closed objects
  std::uint64_t degenerate = 0;      ///< triangles of zero area after snapping
  std::uint64_t clipped = 0;         ///< triangles cut by the light's frustum
  std::uint64_t outside = 0;         ///< triangles wholly outside it
};

/// Snaps, clips and culls every caster triangle. Polygons are numbered through the whole scene,
/// receivers included.
CasterSet make_casters(const Scene& scene, const LightSpace& space);

/// Twice the signed area of the snapped triangle, square units; above 0 where it faces the light.
inline std::int64_t doubled_area(const LightPoint& a, const LightPoint& b, const LightPoint& c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
         (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

}  // namespace kagesen
