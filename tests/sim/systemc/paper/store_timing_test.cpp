/// The store's model against the Verilated store: the cycle in which each visit is taken, and where
/// cycles go. One store carries out all frames: none may hang on what was before.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "Vstore_test_dut.h"
#include "tests/rtl/paper/store_bench.h"
// Verilator's headers come before SystemC's.
#include "model/frame_setup.h"
#include "model/unit/shadow_unit.h"
#include "sim/systemc/memory/memory.h"
#include "sim/systemc/paper/front.h"
#include "sim/systemc/paper/store.h"
#include "tests/sim/systemc/paper/random_frame.h"

namespace kagesen::tlm_model::paper {
namespace {

constexpr PassNumber kWipe{1, 0}, kDraw{3, 0};

struct StoreTimeline {
  std::vector<Cycle> taken;  ///< visits
  Cycle wipe = 0, draw = 0;  ///< cycles
  std::array<std::uint64_t, std::size(kStoreCauses)> causes{};
};

class Verilog : public rtl::StoreBench<Vstore_test_dut> {
 public:
  Verilog() : StoreBench(UnitConfig{}, rtl::PaperWidths{}, {}) {
    for (const int reset : {1, 0, 1}) {
      dut_.rst_ni = static_cast<std::uint8_t>(reset);
      dut_.eval();
    }
  }

  StoreTimeline frame(const std::vector<rtl::GoldenVisit>& visits, const UnitConfig& config,
                      std::uint32_t texel_bits, const Timing& timing, const Stalls& offers) {
    StoreTimeline line;
    config_ = config;
    layout_ = rtl::PaperLayout(config, rtl::PaperWidths{});
    rtl::to_port(dut_.settings_i, layout_.make_settings(config, texel_bits));
    begin_pass(timing, kWipe);
    dut_.wipe_i = 1;
    for (bool wiped = false; !wiped; ++line.wipe) {
      low(line.wipe);
      wiped = dut_.wiped_o;
      high(line.wipe);
    }
    dut_.wipe_i = 0;
    begin_pass(timing, kDraw);
    bool offered = false;
    for (bool over = false; !over; ++line.draw) {
      const std::size_t next = line.taken.size();
      if (!offered && next < visits.size() && !offers.at(line.draw)) {
        offered = true;
        offer(visits[next]);
      }
      dut_.visit_valid_i = offered;
      low(line.draw);
      over = next == visits.size() && dut_.idle_o;
      if (offered && dut_.visit_ready_o) {
        line.taken.push_back(line.draw);
        offered = false;
      }
      ++line.causes[dut_.cause_o];
      high(line.draw);
    }
    dut_.visit_valid_i = 0;
    return line;
  }

 private:
  struct Response {
    Cycle due;
    unsigned tag;
    rtl::Word data;
  };
  struct Port {
    ReadTiming reads;
    Stalls writes;
    std::vector<Response> due;

    void begin_pass(const Timing& timing, PassNumber number, Channel read, Channel write) {
      reads.configure(timing);
      reads.begin_pass(number, read, 0);
      writes = Stalls(timing.memory_stall, Chance(timing.seed, number, write, 0));
      due.clear();
    }
    const Response* response(Cycle now) const {
      const auto found = std::find_if(due.begin(), due.end(),
                                      [&](const Response& r) { return r.due == now; });
      return found == due.end() ? nullptr : &*found;
    }
  };

  void begin_pass(const Timing& timing, PassNumber number) {
    texel_port_.begin_pass(timing, number, Channel::kTexelReads, Channel::kTexelWrites);
    record_port_.begin_pass(timing, number, Channel::kSlbReads, Channel::kSlbWrites);
  }
  void low(Cycle now) {
    const Response *texel = texel_port_.response(now), *record = record_port_.response(now);
    dut_.texel_rd_ready_i = texel_port_.reads.ready(now);
    dut_.slb_rd_ready_i = record_port_.reads.ready(now);
    dut_.texel_wr_ready_i = !texel_port_.writes.at(now);
    dut_.slb_wr_ready_i = !record_port_.writes.at(now);
    dut_.texel_rsp_valid_i = texel != nullptr;
    dut_.slb_rsp_valid_i = record != nullptr;
    if (texel != nullptr) {
      dut_.texel_rsp_tag_i = static_cast<std::uint8_t>(texel->tag);
      rtl::to_port(dut_.texel_rsp_data_i, texel->data);
    }
    if (record != nullptr) {
      dut_.slb_rsp_tag_i = static_cast<std::uint8_t>(record->tag);
      rtl::to_port(dut_.slb_rsp_data_i, record->data);
    }
    dut_.eval();
  }
  void high(Cycle now) {
    if (dut_.texel_rd_valid_o && dut_.texel_rd_ready_i) {
      const Cycle due = texel_port_.reads.accept(now, dut_.texel_rd_addr_o);
      texel_port_.due.push_back({due, dut_.texel_rd_tag_o, texels_.peek(dut_.texel_rd_addr_o)});
    }
    if (dut_.slb_rd_valid_o && dut_.slb_rd_ready_i) {
      const Cycle due = record_port_.reads.accept(now, dut_.slb_rd_addr_o);
      record_port_.due.push_back({due, dut_.slb_rd_tag_o, records_.peek(dut_.slb_rd_addr_o)});
    }
    if (dut_.texel_wr_valid_o && dut_.texel_wr_ready_i) {
      texels_.poke(dut_.texel_wr_addr_o, rtl::from_port(dut_.texel_wr_data_o));
    }
    if (dut_.slb_wr_valid_o && dut_.slb_wr_ready_i) {
      records_.poke(dut_.slb_wr_addr_o, rtl::from_port(dut_.slb_wr_data_o));
    }
    for (Port* port : {&texel_port_, &record_port_}) {
      const auto over = [&](const Response& r) { return r.due <= now; };
      port->due.erase(std::remove_if(port->due.begin(), port->due.end(), over), port->due.end());
    }
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
    dut_.eval();
  }

  Port texel_port_, record_port_;
};

/// The front's visits, untimed.
struct Visits : VisitTaker {
  std::vector<Visit> all;
  Cycle take(const Visit& visit, Cycle offered) override {
    all.push_back(visit);
    return offered;
  }
  bool ready(Cycle) override { return true; }
};

class Model {
 public:
  Model() : store_("store"), texels_("texel_memory"), records_("slb_memory"), front_("front") {
    store_.texels.port.socket.bind(texels_.socket);
    store_.records.port.socket.bind(records_.socket);
  }

  StoreTimeline frame(const Trace& trace, const FrameSetup& setup, const UnitConfig& config,
                      const Timing& timing, const Stalls& offers) {
    StoreTimeline line;
    texels_.configure(timing);
    records_.configure(timing);
    store_.reset(config);
    begin_pass(timing, kWipe);
    line.wipe = store_.wipe();
    begin_pass(timing, kDraw);
    unit::ShadowUnit golden;
    golden.begin(config, setup);
    unit::TriangleTrail trail;
    Visits visits;
    Cycle free = 0;
    for (const Caster& caster : trace.all_casters) {
      golden.draw(caster, trail);
      visits.all.clear();
      front_.begin_pass(config, setup.fraction_bits, visits);
      front_.draw(trail, 0);
      store_.begin(trail);
      for (const Visit& visit : visits.all) {
        line.taken.push_back(store_.take(visit, offers.next(free)));
        free = line.taken.back() + 1;
      }
    }
    line.draw = store_.finish(free);
    FrontCauses none;
    none.none(0, kNever);
    store_.tell(none, kNever);
    for (std::size_t c = 0; c < line.causes.size(); ++c) {
      line.causes[c] = store_.causes().of(static_cast<StoreCause>(c));
    }
    return line;
  }

 private:
  void begin_pass(const Timing& timing, PassNumber number) {
    texels_.begin_pass(number, Channel::kTexelReads, 0, 32);
    records_.begin_pass(number, Channel::kSlbReads, 0, 64);
    const auto writes = [&](Channel channel) {
      return Stalls(timing.memory_stall, Chance(timing.seed, number, channel, 0));
    };
    store_.begin_pass(32, writes(Channel::kTexelWrites), 64, writes(Channel::kSlbWrites));
  }

  Store store_;
  Memory texels_, records_;
  Front front_;
};

TEST(PaperStoreTiming, StressCasesWithRandomConfigurations) {
  Verilated::randReset(2);
  Verilog verilog;
  Model model;
  for (std::uint64_t number = 0; number < random_frames(); ++number) {
    const RandomFrame f(number);
    SCOPED_TRACE(f.text);
    const Stalls offers(f.timing.stream_stall,
                        Chance(f.timing.seed, kDraw, Channel::kTriangles, 0));
    std::vector<Caster> numbered = f.trace.all_casters;
    for (Caster& c : numbered) {
      if (c.object < f.setup.unit_ids.size()) c.object = f.setup.unit_ids[c.object];
    }
    const auto visits = rtl::golden_visits(numbered, f.config, static_cast<int>(f.setup.fraction_bits));
    const StoreTimeline expected =
        verilog.frame(visits, f.config, f.setup.fraction_bits, f.timing, offers);
    const StoreTimeline got = model.frame(f.trace, f.setup, f.config, f.timing, offers);
    EXPECT_EQ(got.wipe, expected.wipe);
    for (std::size_t i = 0; i < expected.taken.size(); ++i) {
      ASSERT_EQ(got.taken[i], expected.taken[i]) << "visit " << i << " of " << expected.taken.size();
    }
    EXPECT_EQ(got.draw, expected.draw);
    EXPECT_EQ(got.causes, expected.causes);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace kagesen::tlm_model::paper
