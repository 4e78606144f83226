#pragma once
/// What pass 2's cycles look like from the image: which fragments they went to.
#include <cstdint>
#include <vector>

#include "model/engine.h"
#include "traces/format/records.h"

namespace kagesen {

/// The cycles that each fragment cost: from the verdict before, of any lane, to its own. All of a
/// pass but the last cycle is so given to some fragment, and a fragment whose wait others hide costs
/// nothing more.
std::vector<std::uint32_t> fragment_costs(const std::vector<FragmentCycles>& cycles);

struct FragmentFigures {
  static constexpr std::uint32_t kTile = 16;  ///< pixels

  double mean = 0;  ///< cycles a fragment
  std::uint32_t p50 = 0, p99 = 0, most = 0;
  // The tile of the image whose fragments cost most on average.
  std::uint32_t tile_x = 0, tile_y = 0;  ///< of its upper left pixel
  double tile_mean = 0;
  std::uint64_t tile_fragments = 0;
  double latency_mean = 0;  ///< cycles from taken to answered
  std::uint64_t latency_most = 0;
  double in_flight = 0;  ///< fragments between the two, on average
};
/// @param total  cycles of pass 2
/// @pre there are fragments
FragmentFigures fragment_figures(const Trace& trace, const std::vector<FragmentCycles>& cycles,
                                 std::uint64_t total);

}  // namespace kagesen
