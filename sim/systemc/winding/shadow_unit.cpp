#include "sim/systemc/winding/shadow_unit.h"

#include <algorithm>

#include "model/golden.h"
#include "model/unit/winding/plane.h"

namespace kagesen::tlm_model::winding {
namespace {

/// Of shadow_pkg.sv's words, as bytes.
struct Words {
  explicit Words(const UnitConfig& c) {
    const unit::winding::Widths w(c, kMaxFractionBits);
    const std::int64_t threshold = w.base_bits() + 2 * w.gradient_code_bits();
    const std::int64_t list = 2 + 32 + record_addr_bits(c);
    const std::int64_t tile = 3 + (2 * map_bits(c) - 6) + c.id_bits + 25 + 25 + 24 + 64;
    const std::int64_t segment = 3 + 4 * (w.end_bits + 1);
    texel = bytes_of(std::max(4 * (2 + c.id_bits + std::max(threshold, list)), tile));
    record = bytes_of(threshold + c.id_bits + c.corner_bits + 3 + 4 + record_addr_bits(c) +
                      c.segments_per_record * segment);
  }
  unsigned texel, record;

 private:
  static unsigned bytes_of(std::int64_t bits) { return static_cast<unsigned>((bits + 7) / 8); }
};

}  // namespace

WindingUnit::WindingUnit(const sc_core::sc_module_name& name, unsigned lanes)
    : ShadowUnit(name),
      unit_(std::make_shared<unit::winding::ShadowUnit>()),
      golden_(make_golden_winding_engine(unit_)),
      pass1_(std::make_unique<Pass1>("pass1")),
      lanes_(lanes) {}

void WindingUnit::begin(const UnitConfig& config, const FrameSetup& setup, const Timing& timing) {
  config_ = config;
  golden_->begin(config, setup);
  const Words words(config);
  pass1_->begin_frame(config, setup, timing, words.texel, words.record);
  lanes_.begin_frame(timing);
}

void WindingUnit::announce(const Fragment* fragments, std::size_t count) {
  pass1_->announce(*unit_, fragments, count);
}
void WindingUnit::draw(const Caster* casters, std::size_t count) {
  pass1_->draw(*unit_, casters, count);
}

void WindingUnit::decide(const Fragment* fragments, std::size_t count, Verdict* verdicts,
                         FragmentCycles* cycles) {
  settle();
  ShadowLane::Pass pass{};
  pass.slots = static_cast<std::uint32_t>(config_.fragment_slots);
  const Words words(config_);
  pass.texel_bytes = words.texel;
  pass.slb_bytes = words.record;
  pass.map_bits = static_cast<unsigned>(map_bits(config_));
  unit::winding::ShadowUnit::Tally tally;
  lanes_.run(pass, fragments, count, verdicts, cycles,
             [&](const Fragment& fragment, ShadowLane::Trail& trail) {
               const Verdict verdict = unit_->decide(fragment, trail, tally);
               for (auto& record : trail.records) record.address = pass1_->record_address(record.address);
               return verdict;
             });
  unit_->count(tally, count);
}

CycleReport WindingUnit::cycles() const {
  settle();
  CycleReport report;
  pass1_->report(report, unit_->counters());
  report.pass2 = lanes_.cycles();
  return report;
}

}  // namespace kagesen::tlm_model::winding
