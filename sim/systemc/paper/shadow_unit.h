#pragma once
/// The paper profile's unit: both passes.
/// Twin: rtl/common/shadow_unit.sv with rtl/paper.
#include <memory>

#include "model/unit/shadow_unit.h"
#include "sim/systemc/common/lanes.h"
#include "sim/systemc/common/shadow_unit.h"
#include "sim/systemc/paper/pass1.h"
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
  Cycle drawn() const override { return pass1_.drawn(); }
  const std::vector<Cycle>& taken() const override { return pass1_.taken(); }
  void trace(Timeline* timeline) override {
    pass1_.trace(timeline);
    lanes_.trace(timeline);
  }
  CycleReport cycles() const override;
  const Engine& golden() const override { return *golden_; }

 private:
  std::shared_ptr<unit::ShadowUnit> unit_;
  std::unique_ptr<Engine> golden_;
  Pass1 pass1_;
  Lanes<ShadowLane> lanes_;
  UnitConfig config_;
  Cycle settle_ = 0;  // cycles: one each time, for the store is idle when a pass ends
  bool unsettled_ = false;
};

}  // namespace kagesen::tlm_model::paper
