#include "sim/systemc/paper/shadow_unit.h"

#include "model/golden.h"

namespace kagesen::tlm_model::paper {
namespace {

/// Bytes that hold so many bits.
constexpr unsigned bytes_of(std::int64_t bits) { return static_cast<unsigned>((bits + 7) / 8); }

// Widths of shadow_pkg.sv.
unsigned texel_word_bytes(const UnitConfig& c) { return bytes_of(4 * (3 + c.id_bits + c.depth_bits)); }
unsigned record_bytes(const UnitConfig& c) {
  const std::int64_t line = 6 + c.polygon_id_bits + c.slope_bits + c.fraction_bits;
  return bytes_of(5 + 2 * record_addr_bits(c) + 2 * map_bits(c) + c.id_bits + c.depth_bits + 4 +
                  c.lines_per_entry * line);
}

}  // namespace

PaperUnit::PaperUnit(const sc_core::sc_module_name& name, unsigned lanes)
    : ShadowUnit(name),
      unit_(std::make_shared<unit::ShadowUnit>()),
      golden_(make_golden_paper_engine(unit_)),
      pass1_("pass1"),
      lanes_(lanes) {}

void PaperUnit::begin(const UnitConfig& config, const FrameSetup& setup, const Timing& timing) {
  config_ = config;
  settle_ = 0;
  unsettled_ = false;
  golden_->begin(config, setup);
  pass1_.begin_frame(config, setup, timing, texel_word_bytes(config), record_bytes(config));
  lanes_.begin_frame(timing);
}

void PaperUnit::announce(const Fragment* fragments, std::size_t count) {
  golden_->announce(fragments, count);
}
void PaperUnit::draw(const Caster* casters, std::size_t count) {
  pass1_.draw(*unit_, casters, count);
  unsettled_ = true;
}

void PaperUnit::decide(const Fragment* fragments, std::size_t count, Verdict* verdicts,
                       FragmentCycles* cycles) {
  settle_ += unsettled_;
  unsettled_ = false;
  ShadowLane::Pass pass{};
  pass.slots = static_cast<std::uint32_t>(config_.fragment_slots);
  pass.texel_bytes = texel_word_bytes(config_);
  pass.slb_bytes = record_bytes(config_);
  pass.pitch_log2 =
      static_cast<unsigned>(bits_for(static_cast<std::uint64_t>((config_.map_width + 3) / 4)));
  lanes_.run(pass, fragments, count, verdicts, cycles,
             [this](const Fragment& fragment, unit::FragmentTrail& trail) {
               const Verdict verdict = unit_->decide(fragment, trail);
               pass1_.locate(trail);
               return verdict;
             });
}

CycleReport PaperUnit::cycles() const {
  CycleReport report;
  pass1_.report(report, unit_->counters());
  report.settle = settle_ + unsettled_;
  report.pass2 = lanes_.cycles();
  return report;
}

}  // namespace kagesen::tlm_model::paper
