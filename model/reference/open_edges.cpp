#include "model/reference/open_edges.h"

#include <tuple>
#include <utility>

#include "model/reference/triangle.h"

namespace kagesen {
namespace {

constexpr std::uint32_t kEmpty = 0xffffffffu;

bool same_point(const LightPoint& a, const LightPoint& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// An edge from its lower to its upper end, in any fixed order of points.
struct Edge {
  LightPoint low, high;
  std::uint32_t object;

  Edge(const Caster& c, int i) : low(c.vertex[i]), high(c.vertex[(i + 1) % 3]), object(c.object) {
    if (std::tie(high.x, high.y, high.z) < std::tie(low.x, low.y, low.z)) std::swap(low, high);
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

}  // namespace

std::vector<std::uint8_t> find_open_edges(const std::vector<Caster>& casters) {
  enum Side : std::uint8_t { kLeft = 1, kRight = 2 };
  std::vector<std::uint8_t> open(casters.size(), 0);
  std::size_t capacity = 16;
  while (capacity < casters.size() * 4) capacity *= 2;
  std::vector<std::uint32_t> table(capacity, kEmpty);  // of edges: 4 x caster + edge number
  std::vector<std::uint8_t> sides(capacity, 0);
  auto slot_of = [&](const Edge& edge) {
    std::size_t slot = edge.hash() & (capacity - 1);
    while (table[slot] != kEmpty && !(Edge(casters[table[slot] / 4], table[slot] % 4) == edge)) {
      slot = (slot + 1) & (capacity - 1);
    }
    return slot;
  };
  std::vector<std::uint32_t> slots(casters.size() * 3);
  for (std::uint32_t i = 0; i < casters.size(); ++i) {
    const Caster& c = casters[i];
    if (doubled_area(c) == 0) continue;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Edge edge(c, int(k));
      const std::size_t slot = slot_of(edge);
      if (table[slot] == kEmpty) table[slot] = 4 * i + k;
      const LightPoint& third = c.vertex[(k + 2) % 3];
      sides[slot] |= edge_function(edge.low, edge.high, third.x, third.y) > 0 ? kLeft : kRight;
      slots[std::size_t{i} * 3 + k] = std::uint32_t(slot);
    }
  }
  for (std::size_t i = 0; i < casters.size(); ++i) {
    if (doubled_area(casters[i]) == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (sides[slots[i * 3 + k]] != (kLeft | kRight)) open[i] |= std::uint8_t(1u << k);
    }
  }
  return open;
}

}  // namespace kagesen
