#include "sim/systemc/paper/shadow_unit.h"

#include <algorithm>
#include <string>

#include "model/golden.h"

namespace kagesen::tlm_model::paper {
namespace {

constexpr std::uint32_t kDecide = 5;  // shadow_pkg::PassDecide

std::string numbered(const char* name, unsigned number) { return name + std::to_string(number); }

}  // namespace

PaperUnit::Lane::Lane(unsigned number)
    : lane(numbered("shadow_lane", number).c_str()),
      texel_memory(numbered("texel_memory", number).c_str()),
      slb_memory(numbered("slb_memory", number).c_str()) {
  lane.texels.port.socket.bind(texel_memory.socket);
  lane.slb.port.socket.bind(slb_memory.socket);
}

PaperUnit::PaperUnit(const sc_core::sc_module_name& name, unsigned lanes)
    : ShadowUnit(name),
      unit_(std::make_shared<unit::ShadowUnit>()),
      golden_(make_golden_paper_engine(unit_)) {
  for (unsigned l = 0; l < lanes; ++l) lanes_.push_back(std::make_unique<Lane>(l));
}

void PaperUnit::begin(const UnitConfig& config, const FrameSetup& setup, const Timing& timing) {
  config_ = config;
  timing_ = timing;
  golden_->begin(config, setup);
  for (auto& l : lanes_) {
    l->texel_memory.configure(timing);
    l->slb_memory.configure(timing);
    l->lane.clear();
  }
  passes_ = 0;
  total_ = fragments_ = 0;
}

void PaperUnit::announce(const Fragment* fragments, std::size_t count) {
  golden_->announce(fragments, count);
}
void PaperUnit::draw(const Caster* casters, std::size_t count) { golden_->draw(casters, count); }

void PaperUnit::decide(const Fragment* fragments, std::size_t count, Verdict* verdicts,
                       FragmentCycles* cycles) {
  const PassNumber number{kDecide, passes_++};
  ShadowLane::Pass pass{};
  pass.slots = static_cast<std::uint32_t>(config_.fragment_slots);
  pass.texel_bytes = pass.slb_bytes = 32;
  pass.pitch_log2 =
      static_cast<unsigned>(bits_for(static_cast<std::uint64_t>((config_.map_width + 3) / 4)));
  pass.stride = lanes_.size();
  for (unsigned l = 0; l < lanes_.size(); ++l) {
    Lane& lane = *lanes_[l];
    lane.texel_memory.begin_pass(number, Channel::kTexelReads, l, pass.texel_bytes);
    lane.slb_memory.begin_pass(number, Channel::kSlbReads, l, pass.slb_bytes);
    const auto stalls = [&](Channel channel) {
      return Stalls(timing_.stream_stall, Chance(timing_.seed, number, channel, l));
    };
    pass.offers = stalls(Channel::kFragments);
    pass.verdicts = stalls(Channel::kVerdicts);
    pass.cycles = cycles ? cycles + l : nullptr;
    lane.lane.begin_pass(pass);
  }
  std::size_t turn = 0;
  for (std::size_t i = 0; i < count; ++i) {
    ShadowLane& lane = lanes_[turn]->lane;
    verdicts[i] = unit_->decide(fragments[i], lane.open());
    lane.take();
    if (++turn == lanes_.size()) turn = 0;
  }
  Cycle taken = 0, total = 1;
  for (auto& l : lanes_) {
    if (l->lane.fragments() == 0) continue;
    l->lane.drain();
    taken = std::max(taken, l->lane.last_accepted() + 1);
    total = std::max(total, l->lane.last_retired() + 2);
  }
  for (auto& l : lanes_) l->lane.end_pass(taken, total);
  total_ += total;
  fragments_ += count;
}

CycleReport PaperUnit::cycles() const {
  CycleReport report;
  PassCycles& pass2 = report.pass2.emplace();
  pass2.total = total_;
  pass2.items = fragments_;
  const ShadowLane::Causes& causes = lanes_[0]->lane.causes();
  for (std::size_t c = 0; c < causes.size(); ++c) pass2.causes.emplace_back(kLaneCauses[c], causes[c]);
  return report;
}

}  // namespace kagesen::tlm_model::paper
