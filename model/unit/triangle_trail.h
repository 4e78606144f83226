#pragma once
/// What pass 1 does with one triangle, in the unit's order: what a model of its time needs.
#include <array>
#include <cstdint>
#include <vector>

#include "model/unit/fixed.h"

namespace kagesen::unit {

struct TriangleTrail {
  /// A texel, from the map's corner.
  struct Texel {
    std::int32_t x, y;
  };
  /// A run of texels on the map between outlines.
  struct Gap {
    std::int32_t y, from, to;
  };

  bool flat = true;  ///< without area: nothing else below
  // Its plane, as fractions of twice the area.
  std::int64_t twice_area = 1;
  std::int64_t gradient_x = 0, gradient_y = 0;
  std::array<Int128, 3> start;  ///< of an edge: depth in its first texel's centre, less its first end's
  std::vector<Texel> outline;   ///< of the edges, one after the other, off the map too
  std::array<std::uint32_t, 4> edge;  ///< edge i: from edge[i] to edge[i + 1]
  std::vector<Gap> gaps;

  void clear() {
    flat = true;
    outline.clear();
    gaps.clear();
  }
};

}  // namespace kagesen::unit
