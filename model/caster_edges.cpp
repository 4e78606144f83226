#include "model/caster_edges.h"

#include <utility>

#include "model/reference/triangle.h"

namespace kagesen {
namespace {

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
  std::uint32_t first = EdgeNumbers::kNone;  ///< 3 x caster + edge where it was first met
};

}  // namespace

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
  // Hashes come first, so that what they lead to can be fetched ahead of its use.
  constexpr std::size_t kAhead = 8;
  std::vector<std::uint64_t> hashes(casters.size() * 3);
  for (std::size_t n = 0; n < hashes.size(); ++n) hashes[n] = Edge(casters[n / 3], n % 3).hash();
  for (std::size_t n = 0; n < hashes.size(); ++n) {
    if (n + 2 * kAhead < hashes.size()) {
      __builtin_prefetch(&table[hashes[n + 2 * kAhead] & (capacity - 1)]);
      const std::uint32_t likely = table[hashes[n + kAhead] & (capacity - 1)].first;
      if (likely != EdgeNumbers::kNone) {
        __builtin_prefetch(&casters[likely / 3]);
        __builtin_prefetch(&out.of[likely]);
      }
    }
    if (!takes_part[n / 3]) continue;
    const Edge edge(casters[n / 3], n % 3);
    const auto tag = std::uint32_t(hashes[n] >> 32);
    std::size_t at = hashes[n] & (capacity - 1);
    while (table[at].first != EdgeNumbers::kNone) {
      const std::uint32_t known = table[at].first;
      if (table[at].tag == tag && Edge(casters[known / 3], known % 3) == edge) break;
      at = (at + 1) & (capacity - 1);
    }
    if (table[at].first == EdgeNumbers::kNone) {
      table[at] = {tag, std::uint32_t(n)};
      out.of[n] = out.count++;
    } else {
      out.of[n] = out.of[table[at].first];
    }
  }
  return out;
}

}  // namespace kagesen
