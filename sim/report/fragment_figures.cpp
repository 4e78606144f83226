#include "sim/report/fragment_figures.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace kagesen {

std::vector<std::uint32_t> fragment_costs(const std::vector<FragmentCycles>& cycles) {
  std::vector<std::uint32_t> order(cycles.size());
  std::iota(order.begin(), order.end(), 0u);
  // One lane's are in order already.
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return cycles[a].retired < cycles[b].retired;
  });
  std::vector<std::uint32_t> costs(cycles.size());
  std::uint64_t before = 0;  // the first cycle that no fragment has been given
  for (const std::uint32_t i : order) {
    costs[i] = static_cast<std::uint32_t>(cycles[i].retired + 1 - before);
    before = cycles[i].retired + 1;
  }
  return costs;
}

FragmentFigures fragment_figures(const Trace& trace, const std::vector<FragmentCycles>& cycles,
                                 std::uint64_t total) {
  FragmentFigures out;
  const std::vector<std::uint32_t> costs = fragment_costs(cycles);
  struct Tile {
    std::uint64_t cycles = 0, fragments = 0;
    double mean() const { return double(cycles) / double(fragments); }
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Tile> tiles;  // by row, column
  std::uint64_t latencies = 0;
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const Fragment& f = trace.all_fragments[i];
    Tile& tile = tiles[{f.pixel_y / FragmentFigures::kTile, f.pixel_x / FragmentFigures::kTile}];
    tile.cycles += costs[i];
    ++tile.fragments;
    const std::uint64_t latency = cycles[i].retired - cycles[i].accepted;
    latencies += latency;
    out.latency_most = std::max(out.latency_most, latency);
  }
  const auto worst = std::max_element(tiles.begin(), tiles.end(), [](const auto& a, const auto& b) {
    return a.second.mean() < b.second.mean();
  });
  out.tile_y = worst->first.first * FragmentFigures::kTile;
  out.tile_x = worst->first.second * FragmentFigures::kTile;
  out.tile_mean = worst->second.mean();
  out.tile_fragments = worst->second.fragments;

  std::vector<std::uint32_t> sorted = costs;
  std::sort(sorted.begin(), sorted.end());
  out.p50 = sorted[sorted.size() / 2];
  out.p99 = sorted[sorted.size() * 99 / 100];
  out.most = sorted.back();
  const double count = double(cycles.size());
  out.mean = double(total) / count;
  out.latency_mean = double(latencies) / count;
  out.in_flight = double(latencies) / double(total);
  return out;
}

}  // namespace kagesen
