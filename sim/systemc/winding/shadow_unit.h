#pragma once
/// The winding profile's unit: all its passes.
/// Twin: rtl/common/shadow_unit.sv with rtl/winding.
#include <memory>

#include "model/unit/winding/shadow_unit.h"
#include "sim/systemc/common/lanes.h"
#include "sim/systemc/common/shadow_unit.h"
#include "sim/systemc/winding/pass1.h"
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
  Cycle drawn() const override { return pass1_->drawn(); }
  const std::vector<Cycle>& taken() const override { return pass1_->taken(); }
  void trace(Timeline* timeline) override {
    pass1_->trace(timeline);
    lanes_.trace(timeline);
  }
  CycleReport cycles() const override;
  const Engine& golden() const override {
    settle();
    return *golden_;
  }

 private:
  /// Ends pass 1, as whoever looks at the buffers does.
  void settle() const { pass1_->settle(*unit_); }

  std::shared_ptr<unit::winding::ShadowUnit> unit_;
  std::unique_ptr<Engine> golden_;
  std::unique_ptr<Pass1> pass1_;
  Lanes<ShadowLane> lanes_;
  UnitConfig config_;
};

}  // namespace kagesen::tlm_model::winding
