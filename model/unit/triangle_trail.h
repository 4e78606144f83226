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

  /// A visit of the store: what it found in the texel, and of the lines of its entry.
  struct EdgeVisit {
    static constexpr std::int32_t kNone = -1;
    std::uint32_t nearest;   ///< of the line
    bool edge, overflow;     ///< flags of the texel
    bool corner, vertex;     ///< the triangle holds the texel's corner; the line ends in the texel
    bool hidden;             ///< the line, by what covers the texel
    std::int32_t cancelled;  ///< which line of the entry, oldest first
    std::int32_t emptied;    ///< the entry is without a line then: which one of `emptied`
  };
  /// An entry that an edge's visit emptied, after all edges.
  struct Emptied {
    bool edge;                ///< flag of the texel
    bool covered;             ///< all over; then, behind which depth lines are hidden:
    std::uint32_t hide_depth;
  };
  /// A texel of a span that has lines.
  struct Hiding {
    std::int32_t x, y;
    std::uint32_t hide_depth;
  };

  bool flat = true;  ///< without area: nothing else below
  // Its plane, as fractions of twice the area.
  std::int64_t twice_area = 1;
  std::int64_t gradient_x = 0, gradient_y = 0;
  std::array<Int128, 3> start;  ///< of an edge: depth in its first texel's centre, less its first end's
  std::vector<Texel> outline;   ///< of the edges, one after the other, off the map too
  std::array<std::uint32_t, 4> edge;  ///< edge i: from edge[i] to edge[i + 1]
  std::vector<Gap> gaps;
  std::uint32_t object = 0;            ///< unit ID
  std::vector<EdgeVisit> visits;       ///< of texels on the map, in the outline's order
  std::vector<Emptied> emptied;
  std::vector<Hiding> hiding;          ///< in the spans' order

  void clear() {
    flat = true;
    outline.clear();
    gaps.clear();
    visits.clear();
    emptied.clear();
    hiding.clear();
  }
};

}  // namespace kagesen::unit
