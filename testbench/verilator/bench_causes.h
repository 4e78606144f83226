#pragma once
/// What the unit's cause outputs say, in words: for the timeline, and for one that is stuck.
#include <iterator>
#include <string>

#include "model/cycle_causes.h"
#include "sim/common/timeline.h"
#include "testbench/verilator/bench_ports.h"
#include "testbench/verilator/bench_probes.h"

namespace kagesen::bench {

inline const char* store_cause(const Vshadow_bench& top) {
  return top.cause1_o < std::size(kStoreCauses) ? kStoreCauses[top.cause1_o] : "unknown";
}
inline const char* lane_cause(const Vshadow_bench& top, unsigned lane) {
  const std::uint64_t cause = field(top.cause2_o, 4 * lane, 4);
  return cause < kLaneCauseCount ? kLaneCauses[cause] : "unknown";
}

/// A cycle, `at` from its pass's first one.
inline void note_causes(const Vshadow_bench& top, Pass pass, Cycle at, Timeline& timeline) {
  if (!timeline.open(at)) return;
  if (pass == Pass::kDraw) {
    timeline.state(timeline.track("store", Timeline::Kind::kState), store_cause(top), at, at + 1);
  }
  for (unsigned l = 0; pass == Pass::kDecide && l < kLanes; ++l) {
    timeline.state(timeline.track("lane" + std::to_string(l), Timeline::Kind::kState),
                   lane_cause(top, l), at, at + 1);
  }
}

/// The state of every channel and queue; bits are lanes.
inline std::string channels_text(const Vshadow_bench& top, const Memories& memories,
                                 const Probes& probes) {
  const auto stream = [](const char* name, unsigned valid, unsigned ready) {
    return std::string(name) + ": valid " + std::to_string(valid) + " ready " +
           std::to_string(ready) + "; ";
  };
  const bool decides = top.pass_o == static_cast<unsigned>(Pass::kDecide);
  return std::string("cause ") + (decides ? lane_cause(top, 0) : store_cause(top)) + "; " +
         stream("triangles", top.tri_valid_i, top.tri_ready_o) +
         stream("fragments", top.frag_valid_i, top.frag_ready_o) +
         stream("verdicts", top.verdict_valid_o, top.verdict_ready_i) +
         memories.texels.text(top.texel_rd_valid_o, top.texel_rd_ready_i) +
         memories.records.text(top.slb_rd_valid_o, top.slb_rd_ready_i) +
         stream("texel writes", top.texel_wr_valid_o, top.texel_wr_ready_i) +
         stream("slb writes", top.slb_wr_valid_o, top.slb_wr_ready_i) +
         "words in queues: " + probes.text();
}

}  // namespace kagesen::bench
