#pragma once
/// The unit's event outputs, counted. Fields of shadow_pkg's structs, last first.
#include "testbench/verilator/bench_top.h"

namespace kagesen::bench {

class EventCounter {
 public:
  Events events{};

  /// A cycle of pass 1.
  void add_store(const Vshadow_bench& top) {
    if (top.front_events_o != 0) count_front(top.front_events_o);
    if (top.store_events_o != 0) count_store(top.store_events_o);
  }
  /// A cycle of pass 2.
  void add_lanes(const Vshadow_bench& top) {
    if (top.lane_events_o != 0) count_lanes(top);
  }
  void note_records(std::uint64_t records, bool wiping) {
    if (wiping) {
      events.peak_records = 0;
    } else if (records > events.peak_records) {
      events.peak_records = records;
    }
  }

 private:
  void count_front(unsigned e) {
    events.span_texels += e & 7;
    e >>= 3;
    if (kWinding) {
      events.inner_texels += e & 1;
      e >>= 1;
    }
    events.edge_texels += e & 1;
    events.edges += e >> 1 & 1;
    events.casters += e >> 2 & 1;
  }

  void count_store(std::uint64_t e) {
    const auto next = [&](unsigned bits) {
      const std::uint64_t value = e & low_bits(bits);
      e >>= bits;
      return value;
    };
    events.overflow_texels += next(1);
    events.overflow_lines += next(16);
    events.lines_hidden += next(16);
    if (kWinding) {
      events.tiles_touched += next(1);
      events.hidden_visits += next(3);
      events.masked_visits += next(3);
      events.texel_visits += next(3);
    }
    events.emptied_covered += next(1);
    events.lines_cancelled += next(1);
    events.lines_stored += next(1);
  }

  void count_lanes(const Vshadow_bench& top) {
    constexpr unsigned kBits = widths::lane_events_o / kLanes;
    for (unsigned l = 0; l < kLanes; ++l) {
      auto e = static_cast<unsigned>(field(top.lane_events_o, kBits * l, kBits));
      events.lines_read += e & low_bits(kLineCountBits);
      e >>= kLineCountBits;
      events.entries_read += e & 1;
      events.slb_lookups += e >> 1 & 1;
      if (!kWinding) continue;
      events.first_test += e >> 2 & 1;
      events.texel_lookups += e >> 3 & 1;
      events.tile_dark += e >> 4 & 1;
      events.tile_lit += e >> 5 & 1;
      events.known += e >> 6 & 1;
    }
  }
};

}  // namespace kagesen::bench
