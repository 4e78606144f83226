#include "model/caster_edges.h"

#include <tuple>
#include <utility>

#include "model/reference/triangle.h"

namespace kagesen {
namespace {

bool same_point(const LightPoint& a, const LightPoint& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// An edge from its lesser to its greater end.
struct Edge {
  LightPoint low, high;
  std::uint32_t object;

  Edge(const Caster& c, std::size_t i)
      : low(c.vertex[i]), high(c.vertex[(i + 1) % 3]), object(c.object) {
    if (point_less(high, low)) std::swap(low, high);
  }
  bool operator==(const Edge& e) const {
    return object == e.object && same_point(low, e.low) && same_point(high, e.high);
  }
  std::uint64_t hash() const {
    std::uint64_t h = object;
    auto mix = [&h](std::uint64_t v) {
      h = (h ^ v) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    };
    mix(std::uint64_t(std::uint32_t(low.x)) << 32 | std::uint32_t(low.y));
    mix(std::uint64_t(std::uint32_t(high.x)) << 32 | std::uint32_t(high.y));
    mix(std::uint64_t{low.z} << 32 | high.z);
    return h;
  }
};

/// A place of the hash table. The tag spares most looks at the edge itself, which are far away.
struct Slot {
  std::uint32_t tag = 0;
  std::uint32_t number = EdgeNumbers::kNone;
};

}  // namespace

bool point_less(const LightPoint& a, const LightPoint& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

bool lies_left_of_edge(const Caster& caster, std::size_t edge) {
  const Edge e(caster, edge);
  const LightPoint& third = caster.vertex[(edge + 2) % 3];
  return edge_function(e.low, e.high, third.x, third.y) > 0;
}

EdgeNumbers number_edges(const std::vector<Caster>& casters,
                         const std::vector<std::uint8_t>& takes_part) {
  EdgeNumbers out;
  out.of.assign(casters.size() * 3, EdgeNumbers::kNone);
  std::size_t capacity = 16;
  while (capacity < casters.size() * 4) capacity *= 2;
  std::vector<Slot> table(capacity);
  std::vector<std::uint32_t> first;  // by number: 3 x caster + edge where it was first met
  first.reserve(casters.size() * 3 / 2);
  for (std::size_t i = 0; i < casters.size(); ++i) {
    if (!takes_part[i]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge(casters[i], k);
      const std::uint64_t hash = edge.hash();
      const auto tag = std::uint32_t(hash >> 32);
      std::size_t at = hash & (capacity - 1);
      while (table[at].number != EdgeNumbers::kNone) {
        const std::uint32_t known = first[table[at].number];
        if (table[at].tag == tag && Edge(casters[known / 3], known % 3) == edge) break;
        at = (at + 1) & (capacity - 1);
      }
      if (table[at].number == EdgeNumbers::kNone) {
        table[at] = {tag, out.count++};
        first.push_back(std::uint32_t(3 * i + k));
      }
      out.of[3 * i + k] = table[at].number;
    }
  }
  return out;
}

}  // namespace kagesen
