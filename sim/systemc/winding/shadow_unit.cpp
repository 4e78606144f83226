#include "sim/systemc/winding/shadow_unit.h"

#include "model/golden.h"

namespace kagesen::tlm_model::winding {

WindingUnit::WindingUnit(const sc_core::sc_module_name& name, unsigned lanes)
    : ShadowUnit(name),
      unit_(std::make_shared<unit::winding::ShadowUnit>()),
      golden_(make_golden_winding_engine(unit_)),
      lanes_(lanes) {}

void WindingUnit::begin(const UnitConfig& config, const FrameSetup& setup, const Timing& timing) {
  config_ = config;
  golden_->begin(config, setup);
  lanes_.begin_frame(timing);
}

void WindingUnit::announce(const Fragment* fragments, std::size_t count) {
  golden_->announce(fragments, count);
}
void WindingUnit::draw(const Caster* casters, std::size_t count) { golden_->draw(casters, count); }

void WindingUnit::decide(const Fragment* fragments, std::size_t count, Verdict* verdicts,
                         FragmentCycles* cycles) {
  unit_->settle();
  ShadowLane::Pass pass{};
  pass.slots = static_cast<std::uint32_t>(config_.fragment_slots);
  pass.texel_bytes = pass.slb_bytes = 32;
  pass.map_bits = static_cast<unsigned>(map_bits(config_));
  lanes_.run(pass, fragments, count, verdicts, cycles,
             [this](const Fragment& fragment, ShadowLane::Trail& trail) {
               return unit_->decide(fragment, trail);
             });
}

CycleReport WindingUnit::cycles() const {
  CycleReport report;
  report.pass2 = lanes_.cycles();
  return report;
}

}  // namespace kagesen::tlm_model::winding
