#pragma once
/// What a store counts, cycle by cycle: causes, how full its queues are, and the tile it works on.
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "model/cycle_report.h"
#include "sim/systemc/common/memory_port.h"
#include "sim/systemc/common/queue_meter.h"
#include "sim/systemc/common/store_causes.h"
#include "sim/systemc/common/tile_meter.h"

namespace kagesen::tlm_model {

constexpr std::size_t kStoreQueues = 5;

class StoreMeter {
 public:
  using Words = std::array<std::size_t, kStoreQueues>;  ///< that stand in each queue
  using Names = std::array<const char*, kStoreQueues>;  ///< by their instances in the Verilog

  StoreCauses causes;
  TileMeter tiles;

  explicit StoreMeter(const Names& queues) : names_(queues) {}

  /// A frame begins.
  void reset(const UnitConfig& config) {
    causes.clear();
    for (QueueMeter& queue : queues_) queue.clear();
    tiles.reset(config);
  }
  void begin_pass() {
    causes.begin_pass();
    for (QueueMeter& queue : queues_) queue.begin_pass();
  }
  /// @param timeline  takes what the store does; or null
  void trace(Timeline* timeline, MemoryPort& texels, MemoryPort& records) {
    causes.trace(timeline);
    texels.trace(timeline, "store.texel_port");
    records.trace(timeline, "store.slb_port");
    for (std::size_t q = 0; q < kStoreQueues; ++q) queues_[q].trace(timeline, names_[q]);
  }

  /// So many cycles from `from` on. Calls come in the order of time.
  void count(StoreCause cause, Cycle from, Cycle cycles, const Words& words) {
    causes.add(cause, from, cycles);
    for (std::size_t q = 0; q < kStoreQueues; ++q) queues_[q].stand(words[q], cycles);
  }
  void report(PassCycles& pass) const {
    pass.causes = causes.meter().figures();
    for (std::size_t q = 0; q < kStoreQueues; ++q) {
      pass.queues.push_back(queues_[q].figures(names_[q]));
    }
    pass.tiles = tiles.cycles();
  }
  /// Nothing is under way that could move the store: throws std::logic_error with its state.
  [[noreturn]] void stuck(const std::string& store, Cycle now, StoreCause cause,
                          const Words& words) const {
    std::string text = store + ": stuck in cycle " + std::to_string(now) + ", cause " +
                       kStoreCauses[static_cast<std::size_t>(cause)] + "; words in queues:";
    for (std::size_t q = 0; q < kStoreQueues; ++q) {
      text += std::string(" ") + names_[q] + " " + std::to_string(words[q]);
    }
    throw std::logic_error(text);
  }

 private:
  Names names_;
  std::array<QueueMeter, kStoreQueues> queues_;
};

}  // namespace kagesen::tlm_model
