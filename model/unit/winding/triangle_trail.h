#pragma once
/// What pass 1 does with one facet, in the unit's order: what a model of its time needs.
#include <array>
#include <cstdint>
#include <vector>

#include "model/unit/winding/edge_walker.h"
#include "model/unit/winding/plane.h"
#include "model/unit/winding/store_trail.h"

namespace kagesen::unit::winding {

struct TriangleTrail {
  /// A texel, from the map's corner.
  struct Texel {
    std::int32_t x, y;
  };
  /// An edge's texels in a row, for an edge that is passed, not walked.
  struct Row {
    std::int32_t y;
    std::int32_t low, high;  ///< along x
    bool counts;             ///< the corner of one of them is counted
    std::uint32_t corners;   ///< where in `corners` those are that lie on the map
  };
  /// A run of texels on the map between outlines.
  struct Gap {
    std::int32_t y, from, to;
  };
  struct Edge {
    unsigned from, to;  ///< vertices, in the direction of travel
    bool passed;        ///< an inner edge that is not walked
    bool rightward;     ///< it runs to +x, or not along x
    EdgeWalker::Figures figures;
    std::uint32_t begin;       ///< in `outline`; of a passed one in `rows`
  };

  bool flat = true;    ///< without area: nothing else below
  bool shares = false;  ///< another triangle's plane
  std::int64_t twice_area = 0;
  FacetPlane::Figures plane;
  Texel low{};                 ///< of the lowest vertex
  std::array<Edge, 3> edges;   ///< in the order in which they are walked
  unsigned edge_count = 0;     ///< 3 in the end
  std::vector<Texel> outline;  ///< off the map too
  std::vector<Row> rows;
  std::vector<std::uint8_t> corners;  ///< 1: the corner of this texel is counted
  std::vector<Gap> gaps;
  std::uint32_t object = 0;            ///< unit ID
  std::vector<TexelVisit> visits;      ///< of texels on the map, outlines first
  std::vector<std::uint32_t> dropped;  ///< clusters that visits hide, by their first records

  void begin_edge(Edge edge) {
    edge.begin = static_cast<std::uint32_t>(edge.passed ? rows.size() : outline.size());
    edges[edge_count++] = edge;
  }
  void add_row(const EdgeWalker& walker, std::int32_t centre_x, std::int32_t y) {
    Row row{y, 0, 0, false, static_cast<std::uint32_t>(corners.size())};
    walker.row(row.low, row.high);
    row.low += centre_x;
    row.high += centre_x;
    rows.push_back(row);
  }
  void add_corner(bool counted) {
    rows.back().counts = rows.back().counts || counted;
    corners.push_back(counted);
  }
  /// Where an edge ends in `outline`; a passed one in `rows`.
  std::uint32_t end(unsigned edge) const {
    if (edge + 1 < edge_count && edges[edge + 1].passed == edges[edge].passed) {
      return edges[edge + 1].begin;
    }
    return static_cast<std::uint32_t>(edges[edge].passed ? rows.size() : outline.size());
  }
  void clear() {
    flat = true;
    edge_count = 0;
    outline.clear();
    rows.clear();
    corners.clear();
    gaps.clear();
    visits.clear();
    dropped.clear();
  }
};

}  // namespace kagesen::unit::winding
