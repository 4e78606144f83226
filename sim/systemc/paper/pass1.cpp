#include "sim/systemc/paper/pass1.h"

#include "sim/systemc/common/offers.h"

namespace kagesen::tlm_model::paper {
namespace {

// shadow_pkg's Pass*.
constexpr std::uint32_t kWipe = 1, kDraw = 3;

}  // namespace

Pass1::Pass1(const sc_core::sc_module_name& name)
    : sc_module(name),
      front_("front"),
      store_("store"),
      texel_memory_("texel_memory"),
      slb_memory_("slb_memory") {
  store_.texels.port.socket.bind(texel_memory_.socket);
  store_.records.port.socket.bind(slb_memory_.socket);
}

void Pass1::begin_pass(PassNumber number) {
  texel_memory_.begin_pass(number, Channel::kTexelReads, 0, texel_bytes_);
  slb_memory_.begin_pass(number, Channel::kSlbReads, 0, record_bytes_);
  const auto writes = [&](Channel channel) {
    return Stalls(timing_.memory_stall, Chance(timing_.seed, number, channel, 0));
  };
  store_.begin_pass(texel_bytes_, writes(Channel::kTexelWrites), record_bytes_,
                    writes(Channel::kSlbWrites));
}

void Pass1::begin_frame(const UnitConfig& config, const FrameSetup& setup, const Timing& timing,
                        unsigned texel_bytes, unsigned record_bytes) {
  config_ = config;
  timing_ = timing;
  texel_bits_ = setup.fraction_bits;
  texel_bytes_ = texel_bytes;
  record_bytes_ = record_bytes;
  texel_memory_.configure(timing);
  slb_memory_.configure(timing);
  store_.reset(config);
  begin_pass({kWipe, 0});
  wipe_ = store_.wipe();
  draws_ = 0;
  total_ = 0;
  reads_ = {};
}

void Pass1::draw(unit::ShadowUnit& golden, const Caster* casters, std::size_t count) {
  const PassNumber number{kDraw, draws_++};
  begin_pass(number);
  if (timeline_) timeline_->begin(1, total_);
  store_.texels.cache.forget_lookups();
  store_.records.cache.forget_lookups();
  front_.begin_pass(config_, texel_bits_, store_);
  Offers offers(timing_, number, Channel::kTriangles);
  unit::TriangleTrail trail;
  taken_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    golden.draw(casters[i], trail);
    store_.begin(trail);
    store_.tell(front_.causes(), front_.told());
    taken_.push_back(offers.take(front_.draw(trail, offers.next())));
  }
  total_ += store_.finish(front_.idle());
  front_.causes().none(front_.idle(), kNever);
  store_.tell(front_.causes(), kNever);
  const MemoryPort &texels = store_.texels.port, &records = store_.records.port;
  reads_.add(texels, texel_memory_, records, slb_memory_);
  reads_.texels.lookups += store_.texels.cache.lookups();
  reads_.texels.misses += texels.reads();
  reads_.records.lookups += store_.records.cache.lookups();
  reads_.records.misses += records.reads();
}

void Pass1::report(CycleReport& report, const UnitCounters& counters) const {
  report.clear = wipe_;
  report.edge_texels = counters.edge_texels;
  report.span_texels = counters.span_texels;
  PassCycles& pass1 = report.pass1.emplace();
  pass1.total = total_;
  pass1.items = counters.edge_texels + counters.span_texels;
  store_.report(pass1);
  reads_.report("store.records.records.cache", "store.texels.cache", pass1);
}

}  // namespace kagesen::tlm_model::paper
