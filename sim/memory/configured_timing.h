#pragma once
/// The configuration's memories, for whoever has them: the Verilated bench and SystemC.
#include <type_traits>

#include "model/unit/config.h"
#include "sim/memory/timing.h"

namespace kagesen {

inline Timing configured_timing(const UnitConfig& config) {
  Timing timing;
  const auto set = [](auto& field, std::int64_t value) {
    field = static_cast<std::remove_reference_t<decltype(field)>>(value);
  };
  set(timing.latency, config.memory_latency);
  set(timing.spread, config.memory_spread);
  set(timing.memory_stall, config.memory_stall);
  set(timing.interval, config.memory_interval);
  set(timing.outstanding, config.memory_outstanding);
  set(timing.banks, config.memory_banks);
  set(timing.bank_busy, config.memory_bank_busy);
  set(timing.row_words, config.memory_row_words);
  set(timing.row_miss, config.memory_row_miss);
  set(timing.texel_cache.lines, config.texel_cache_lines);
  set(timing.texel_cache.ways, config.texel_cache_ways);
  set(timing.texel_cache.line_words, config.texel_cache_line_words);
  set(timing.slb_cache.lines, config.slb_cache_lines);
  set(timing.slb_cache.ways, config.slb_cache_ways);
  set(timing.slb_cache.line_words, config.slb_cache_line_words);
  set(timing.cache_latency, config.cache_latency);
  set(timing.seed, config.memory_seed);
  return timing;
}

}  // namespace kagesen
