#include "sim/systemc/winding/pass1.h"

#include "model/golden.h"
#include "sim/systemc/common/offers.h"

namespace kagesen::tlm_model::winding {

Pass1::Pass1(const sc_core::sc_module_name& name)
    : sc_module(name),
      front_("front"),
      store_("store"),
      texel_memory_("texel_memory"),
      slb_memory_("slb_memory") {
  store_.texel_port.port.socket.bind(texel_memory_.socket);
  store_.record_port().socket.bind(slb_memory_.socket);
}

PassNumber Pass1::begin_pass(Pass& pass) {
  const PassNumber number{pass.number, pass.before++};
  texel_memory_.begin_pass(number, Channel::kTexelReads, 0, texel_bytes_);
  slb_memory_.begin_pass(number, Channel::kSlbReads, 0, record_bytes_);
  const auto writes = [&](Channel channel) {
    return Stalls(timing_.memory_stall, Chance(timing_.seed, number, channel, 0));
  };
  store_.begin_pass(&pass == &draw_, texel_bytes_, writes(Channel::kTexelWrites), record_bytes_,
                    writes(Channel::kSlbWrites));
  return number;
}

void Pass1::begin_frame(const UnitConfig& config, const FrameSetup& setup, const Timing& timing,
                        unsigned texel_bytes, unsigned record_bytes) {
  config_ = config;
  setup_ = setup;
  timing_ = timing;
  texel_bytes_ = texel_bytes;
  record_bytes_ = record_bytes;
  texel_memory_.configure(timing);
  slb_memory_.configure(timing);
  for (Pass* pass : {&wipe_, &announce_, &draw_, &settle_}) {
    pass->before = 0;
    pass->total = 0;
  }
  drawn_ = 0;
  settled_ = true;
  reads_ = {};
  store_.reset(config, static_cast<unsigned>(map_bits(config)));
  begin_pass(wipe_);
  wipe_.total = store_.wipe();
}

void Pass1::announce(unit::winding::ShadowUnit& golden, const Fragment* fragments,
                     std::size_t count) {
  golden.announce(fragments, count);
  if (!config_.skip_receiver_mask) return;
  Offers offers(timing_, begin_pass(announce_), Channel::kFragments);
  Cycle over = 0;
  for (std::size_t i = 0; i < count; ++i) {
    unit::winding::TriangleTrail::Texel texel;
    const bool enters = golden.place(fragments[i], texel);
    const Cycle offered = offers.next();
    over = offers.take(enters ? store_.announce(texel, offered) : offered) + 1;
  }
  announce_.total += store_.finish(over);
}

void Pass1::draw(unit::winding::ShadowUnit& golden, const Caster* casters, std::size_t count) {
  settled_ = false;
  if (timeline_ != nullptr) timeline_->begin(1, draw_.total);
  Offers offers(timing_, begin_pass(draw_), Channel::kTriangles);
  front_.begin_pass(config_, setup_.fraction_bits, store_);
  unit::winding::TriangleTrail trail;
  taken_.clear();
  for (std::size_t i = 0; i < count; ++i, ++drawn_) {
    const bool shares = drawn_ < setup_.facets.size() &&
                        setup_.facets[drawn_].plane != Facet::kOwnPlane;
    golden.draw(casters[i], trail);
    store_.begin(trail);
    if (shares) offers.take(front_.draw_plane(offers.next()));
    store_.tell(front_.causes(), front_.idle());
    taken_.push_back(offers.take(front_.draw(trail, offers.next())));
  }
  draw_.total += store_.finish(front_.idle());
  front_.causes().none(front_.idle(), kNever);
  store_.tell(front_.causes(), kNever);
  if (timeline_ != nullptr) timeline_->begin(0, 0);
  const MemoryPort &texels = store_.texel_port.port, &records = store_.record_port();
  reads_.add(texels, texel_memory_, records, slb_memory_);
  reads_.records.lookups += store_.texels.silhouettes.records.lookups();
  reads_.records.misses += records.reads();
}

void Pass1::settle(unit::winding::ShadowUnit& golden) {
  if (settled_) return;
  settled_ = true;
  unit::winding::SettleTrail trail;
  golden.settle(trail);
  begin_pass(settle_);
  settle_.total += store_.settle(trail);
}

void Pass1::report(CycleReport& report, const UnitCounters& counters) const {
  report.clear = wipe_.total;
  report.announce = announce_.total;
  report.settle = settle_.total;
  report.edge_texels = counters.edge_texels;
  report.span_texels = counters.span_texels;
  PassCycles& pass1 = report.pass1.emplace();
  pass1.total = draw_.total;
  pass1.items = counters.edge_texels + counters.span_texels;
  store_.report(pass1);
  reads_.report("store.records", "", pass1);
}

}  // namespace kagesen::tlm_model::winding
