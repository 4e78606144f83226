#pragma once
/// All before pass 2: front and store with their memories; wiping, announcing, drawing, settling.
/// Twin: "Pass 1" in rtl/common/shadow_unit.sv; pass_control.sv.
///
/// Timing: a pass's first cycle is 0; its last is the first one in which everything is done.
#include <systemc>

#include "model/engine.h"
#include "model/unit/winding/shadow_unit.h"
#include "sim/systemc/common/pass_reads.h"
#include "sim/systemc/memory/memory.h"
#include "sim/systemc/winding/front.h"
#include "sim/systemc/winding/store.h"

namespace kagesen::tlm_model::winding {

class Pass1 : public sc_core::sc_module {
 public:
  explicit Pass1(const sc_core::sc_module_name& name);

  /// A frame begins: the memories are wiped.
  /// @param texel_bytes, record_bytes  of the memories' words
  void begin_frame(const UnitConfig& config, const FrameSetup& setup, const Timing& timing,
                   unsigned texel_bytes, unsigned record_bytes);
  // Golden does it, and says what is to be timed.
  void announce(unit::winding::ShadowUnit& golden, const Fragment* fragments, std::size_t count);
  void draw(unit::winding::ShadowUnit& golden, const Caster* casters, std::size_t count);
  /// If something was drawn since.
  void settle(unit::winding::ShadowUnit& golden);
  /// Fills in what is of pass 1.
  void report(CycleReport& report, const UnitCounters& counters) const;
  /// @param timeline  takes what happens in pass 1, its first cycle being 0; or null
  void trace(Timeline* timeline) {
    timeline_ = timeline;
    store_.trace(timeline);
  }
  /// Cycles of draw passes.
  Cycle drawn() const { return draw_.total; }
  /// When each triangle of the last draw() was taken.
  const std::vector<Cycle>& taken() const { return taken_; }
  /// Where a record is that golden gave out under this number.
  std::uint32_t record_address(std::uint32_t number) const {
    return store_.texels.silhouettes.pool.address_of(number);
  }

 private:
  struct Pass {
    std::uint32_t number;      // shadow_pkg's Pass*
    std::uint32_t before = 0;  // of this frame
    Cycle total = 0;
  };
  PassNumber begin_pass(Pass& pass);

  Front front_;
  Store store_;
  Memory texel_memory_, slb_memory_;
  UnitConfig config_;
  FrameSetup setup_;
  Timing timing_;
  unsigned texel_bytes_ = 4, record_bytes_ = 4;
  Pass wipe_{1}, announce_{2}, draw_{3}, settle_{4};
  std::size_t drawn_ = 0;  // triangles
  bool settled_ = true;
  PassReads reads_;  // of draw passes
  Timeline* timeline_ = nullptr;
  std::vector<Cycle> taken_;
};

}  // namespace kagesen::tlm_model::winding
