#pragma once
/// Cycles that a store spends on the texels of each tile, for PassCycles::tiles.
#include <vector>

#include "model/cycle_report.h"
#include "model/unit/config.h"
#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model {

class TileMeter {
 public:
  void reset(const UnitConfig& config) {
    constexpr std::int64_t kTile = PassCycles::kTile;
    columns_ = static_cast<std::uint32_t>((config.map_width + kTile - 1) / kTile);
    const auto rows = static_cast<std::uint32_t>((config.map_height + kTile - 1) / kTile);
    cycles_.assign(std::size_t{columns_} * rows, 0);
  }
  /// @param column, row  of the tile
  void add(std::uint32_t column, std::uint32_t row, Cycle cycles) {
    cycles_[std::size_t{row} * columns_ + column] += cycles;
  }
  const std::vector<std::uint64_t>& cycles() const { return cycles_; }

 private:
  std::uint32_t columns_ = 0;
  std::vector<std::uint64_t> cycles_;
};

}  // namespace kagesen::tlm_model
