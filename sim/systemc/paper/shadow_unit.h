#pragma once
/// The paper profile's unit. Pass 1 is golden's alone: its cycles are not modelled.
/// Twin: rtl/common/shadow_unit.sv with rtl/paper.
///
/// Timing: a pass's first cycle is 0; it ends in the cycle after the one in which the last verdict
///         was taken, that one counted.
#include <memory>
#include <vector>

#include "model/unit/shadow_unit.h"
#include "sim/systemc/common/shadow_unit.h"
#include "sim/systemc/memory/memory.h"
#include "sim/systemc/paper/shadow_lane.h"

namespace kagesen::tlm_model::paper {

class PaperUnit : public ShadowUnit {
 public:
  PaperUnit(const sc_core::sc_module_name& name, unsigned lanes);

  void begin(const UnitConfig& config, const FrameSetup& setup, const Timing& timing) override;
  void announce(const Fragment* fragments, std::size_t count) override;
  void draw(const Caster* casters, std::size_t count) override;
  void decide(const Fragment* fragments, std::size_t count, Verdict* verdicts,
              FragmentCycles* cycles) override;
  CycleReport cycles() const override;
  const Engine& golden() const override { return *golden_; }

 private:
  /// A lane with the memories behind its ports.
  struct Lane {
    ShadowLane lane;
    Memory texel_memory, slb_memory;
    Lane(unsigned number);
  };

  std::shared_ptr<unit::ShadowUnit> unit_;
  std::unique_ptr<Engine> golden_;
  std::vector<std::unique_ptr<Lane>> lanes_;
  UnitConfig config_;
  Timing timing_;
  std::uint32_t passes_ = 0;  // of this frame
  std::uint64_t total_ = 0, fragments_ = 0;
};

}  // namespace kagesen::tlm_model::paper
