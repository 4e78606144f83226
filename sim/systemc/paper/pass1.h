#pragma once
/// Pass 1 of the paper profile: front and store with their memories, a triangle after the other.
/// Twin: "Pass 1" in rtl/common/shadow_unit.sv; pass_control.sv.
///
/// Timing: a pass's first cycle is 0; its last is the first one in which everything is done.
#include <systemc>

#include "model/engine.h"
#include "model/unit/shadow_unit.h"
#include "sim/systemc/common/pass_reads.h"
#include "sim/systemc/memory/memory.h"
#include "sim/systemc/paper/front.h"
#include "sim/systemc/paper/store.h"

namespace kagesen::tlm_model::paper {

class Pass1 : public sc_core::sc_module {
 public:
  explicit Pass1(const sc_core::sc_module_name& name);

  /// A frame begins: the memories are wiped.
  /// @param texel_bytes, record_bytes  of the memories' words
  void begin_frame(const UnitConfig& config, const FrameSetup& setup, const Timing& timing,
                   unsigned texel_bytes, unsigned record_bytes);
  /// Golden draws, and says what is to be timed.
  void draw(unit::ShadowUnit& golden, const Caster* casters, std::size_t count);
  /// Fills in what is of pass 1.
  void report(CycleReport& report, const UnitCounters& counters) const;
  /// @param timeline  takes what happens in pass 1, its first cycle being 0; or null
  void trace(Timeline* timeline) {
    timeline_ = timeline;
    store_.trace(timeline);
  }
  /// Where the records stand that a fragment reads.
  void locate(unit::FragmentTrail& trail) const { store_.locate(trail); }
  /// Cycles of draw passes.
  Cycle drawn() const { return total_; }
  /// When each triangle of the last draw() was taken.
  const std::vector<Cycle>& taken() const { return taken_; }

 private:
  void begin_pass(PassNumber number);

  Front front_;
  Store store_;
  Memory texel_memory_, slb_memory_;
  UnitConfig config_;
  Timing timing_;
  unsigned texel_bits_ = 0, texel_bytes_ = 4, record_bytes_ = 4;
  std::uint32_t draws_ = 0;  // of this frame
  Cycle wipe_ = 0, total_ = 0;
  PassReads reads_;
  Timeline* timeline_ = nullptr;
  std::vector<Cycle> taken_;
};

}  // namespace kagesen::tlm_model::paper
