#include "model/reference/open_edges.h"

#include "model/caster_edges.h"
#include "model/reference/triangle.h"

namespace kagesen {

std::vector<std::uint8_t> find_open_edges(const std::vector<Caster>& casters) {
  enum Side : std::uint8_t { kLeft = 1, kRight = 2 };
  std::vector<std::uint8_t> has_area(casters.size());
  for (std::size_t i = 0; i < casters.size(); ++i) has_area[i] = doubled_area(casters[i]) != 0;
  const EdgeNumbers edges = number_edges(casters, has_area);
  std::vector<std::uint8_t> sides(edges.count, 0);
  for (std::size_t i = 0; i < casters.size(); ++i) {
    if (!has_area[i]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      sides[edges.at(i, k)] |= lies_left_of_edge(casters[i], k) ? kLeft : kRight;
    }
  }
  std::vector<std::uint8_t> open(casters.size(), 0);
  for (std::size_t i = 0; i < casters.size(); ++i) {
    if (!has_area[i]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      if (sides[edges.at(i, k)] != (kLeft | kRight)) open[i] |= std::uint8_t(1u << k);
    }
  }
  return open;
}

}  // namespace kagesen
