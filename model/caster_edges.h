#pragma once
/// Which casters share which edges.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "traces/format/records.h"

namespace kagesen {

/// A number for every distinct edge, from 0. Edges of the same object with the same two ends,
/// depths included, are one, in whichever direction they run. Numbers depend on the casters' order.
struct EdgeNumbers {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> of;  ///< [3 x caster + i]: edge from vertex i to i + 1, or kNone
  std::uint32_t count = 0;

  std::uint32_t at(std::size_t caster, std::size_t edge) const { return of[3 * caster + edge]; }
};

/// @param takes_part  a caster each; edges of those with a 0 get no number
EdgeNumbers number_edges(const std::vector<Caster>& casters,
                         const std::vector<std::uint8_t>& takes_part);

/// On which side of its edge from vertex i to i + 1 does a caster of some area lie? The side is
/// that of the edge walked from its lesser end, so casters that share the edge can be compared.
bool lies_left_of_edge(const Caster& caster, std::size_t edge);

/// Order of points by x, then y, then z.
inline bool point_less(const LightPoint& a, const LightPoint& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}
inline bool same_point(const LightPoint& a, const LightPoint& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

}  // namespace kagesen
