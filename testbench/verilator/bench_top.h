#pragma once
/// The Verilated top: widths of its ports, places of its events, and what its assertions say.
#include <string>

#include "Vshadow_bench.h"
#include "port_widths.h"
#include "testbench/verilator/bench.h"
#include "testbench/verilator/ports.h"

namespace kagesen::bench {

constexpr unsigned kLanes = widths::frag_valid_i;
constexpr unsigned kTexelBits = KAGESEN_TEXEL_BITS;
constexpr unsigned kTexelsPerWord = 4;
constexpr bool kWinding = KAGESEN_WINDING;

// Of the event structs of shadow_pkg.
constexpr unsigned kLineCountBits = 4;  // LineCountBits, SegmentCountBits
static_assert(widths::front_events_o == (kWinding ? 7 : 6));
static_assert(widths::store_events_o == (kWinding ? 46 : 36));
static_assert(widths::lane_events_o ==
              kLanes * (kWinding ? 7 + kLineCountBits : 2 + kLineCountBits));
static_assert(kTexelsPerWord * kTexelBits <= widths::texel_wr_data_o);

/// Where an assertion failed since the last call, and what it said; empty: nowhere.
std::string take_failure();

}  // namespace kagesen::bench
