#pragma once
/// The winding profile's unit. Pass 1 is golden's alone: its cycles are not modelled. Nor are pass 2's
/// where a memory's time depends on addresses and records have been given out again, to whom we do not know.
/// Twin: rtl/common/shadow_unit.sv with rtl/winding.
#include <memory>

#include "model/unit/winding/shadow_unit.h"
#include "sim/systemc/common/lanes.h"
#include "sim/systemc/common/shadow_unit.h"
#include "sim/systemc/winding/shadow_lane.h"

namespace kagesen::tlm_model::winding {

class WindingUnit : public ShadowUnit {
 public:
  WindingUnit(const sc_core::sc_module_name& name, unsigned lanes);

  void begin(const UnitConfig& config, const FrameSetup& setup, const Timing& timing) override;
  void announce(const Fragment* fragments, std::size_t count) override;
  void draw(const Caster* casters, std::size_t count) override;
  void decide(const Fragment* fragments, std::size_t count, Verdict* verdicts,
              FragmentCycles* cycles) override;
  void trace(Timeline* timeline) override { lanes_.trace(timeline); }
  CycleReport cycles() const override;
  const Engine& golden() const override { return *golden_; }

 private:
  std::shared_ptr<unit::winding::ShadowUnit> unit_;
  std::unique_ptr<Engine> golden_;
  Lanes<ShadowLane> lanes_;
  UnitConfig config_;
  Timing timing_;
  bool timed_ = true;  // pass 2 of this frame
};

}  // namespace kagesen::tlm_model::winding
