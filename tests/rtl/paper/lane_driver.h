#pragma once
/// Pass 2 of a trace through the Verilated lane, with memories beside it.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <vector>

#include "Vshadow_lane_test_dut.h"
#include "model/engine.h"
#include "model/frame_setup.h"
#include "testbench/verilator/bits.h"
#include "testbench/verilator/memory.h"
#include "tests/rtl/paper/encode_contents.h"

namespace kagesen::rtl {

struct LaneRun {
  MemorySettings texel_memory, slb_memory;
  unsigned fragment_percent = 100, verdict_percent = 100;  ///< cycles in which one is offered, taken
  unsigned buckets_log2 = 14;
  unsigned seed = 1;
};

struct LaneResult {
  std::vector<Verdict> verdicts;
  UnitCounters counters;  ///< those of pass 2
  std::uint64_t cycles = 0, causes[16] = {}, texel_reads = 0, slb_reads = 0;
};

class LaneDriver {
 public:
  LaneDriver() {
    dut_.clk_i = 0;
    dut_.rst_ni = 0;
    dut_.clear_i = 0;
    idle_inputs();
    dut_.eval();
    tick();
    dut_.rst_ni = 1;
  }

  LaneResult decide(const std::vector<Fragment>& fragments, const MapContents& contents,
                    const UnitConfig& config, const FrameSetup& setup, const LaneRun& run) {
    const PaperLayout layout;
    unsigned pitch_log2 = 0;
    while ((4u << pitch_log2) < contents.width) ++pitch_log2;
    Memory texels(4 * layout.texel_bits(), run.texel_memory);
    Memory records(layout.record_bits(), run.slb_memory);
    encode_contents(contents, layout, pitch_log2, run.buckets_log2, run.seed, texels, records);
    set_settings(config, setup, pitch_log2, run.buckets_log2);

    std::mt19937 random(run.seed);
    LaneResult result;
    std::size_t sent = 0;
    bool offered = false, held_texel = false, held_slb = false, held_verdict = false;
    std::uint64_t texel_read = 0, slb_read = 0;
    unsigned verdict = 0, still = 0;
    while (result.verdicts.size() < fragments.size()) {
      texels.start();
      records.start();
      offered = sent < fragments.size() && (offered || random() % 100 < run.fragment_percent);
      dut_.frag_valid_i = offered;
      if (offered) set_fragment(fragments[sent], setup);
      dut_.verdict_ready_i = random() % 100 < run.verdict_percent;
      dut_.texel_rd_ready_i = texels.read_ready();
      dut_.slb_rd_ready_i = records.read_ready();
      dut_.texel_rsp_valid_i = texels.response().valid;
      to_port(dut_.texel_rsp_tag_i, Word{texels.response().tag});
      to_port(dut_.texel_rsp_data_i, texels.response().data);
      dut_.slb_rsp_valid_i = records.response().valid;
      to_port(dut_.slb_rsp_tag_i, Word{records.response().tag});
      to_port(dut_.slb_rsp_data_i, records.response().data);
      dut_.eval();

      const std::uint64_t texel_now = std::uint64_t{dut_.texel_rd_addr_o} << 16 | dut_.texel_rd_tag_o;
      const std::uint64_t slb_now = std::uint64_t{dut_.slb_rd_addr_o} << 16 | dut_.slb_rd_tag_o;
      if ((held_texel && !(dut_.texel_rd_valid_o && texel_now == texel_read)) ||
          (held_slb && !(dut_.slb_rd_valid_o && slb_now == slb_read)) ||
          (held_verdict && !(dut_.verdict_valid_o && dut_.verdict_o == verdict))) {
        throw std::logic_error("a beat that waited has changed");
      }
      held_texel = dut_.texel_rd_valid_o && !dut_.texel_rd_ready_i;
      held_slb = dut_.slb_rd_valid_o && !dut_.slb_rd_ready_i;
      held_verdict = dut_.verdict_valid_o && !dut_.verdict_ready_i;
      texel_read = texel_now;
      slb_read = slb_now;
      verdict = dut_.verdict_o;

      const bool taken = offered && dut_.frag_ready_o;
      EXPECT_EQ(dut_.cause_o == 0, taken) << "cause " << int(dut_.cause_o);
      ++result.causes[dut_.cause_o];
      if (dut_.texel_rd_valid_o) texels.read(dut_.texel_rd_addr_o, dut_.texel_rd_tag_o);
      if (dut_.slb_rd_valid_o) records.read(dut_.slb_rd_addr_o, dut_.slb_rd_tag_o);
      if (dut_.verdict_valid_o && dut_.verdict_ready_i) count_verdict(dut_.verdict_o, result);
      count_events(result.counters);
      sent += taken;
      offered = offered && !taken;
      still = taken || dut_.verdict_valid_o || texels.response().valid || records.response().valid
                  ? 0
                  : still + 1;
      if (still > 5000) throw std::logic_error("the lane stands still");
      ++result.cycles;
      tick();
    }
    idle_inputs();
    dut_.eval();
    EXPECT_TRUE(dut_.idle_o);
    result.texel_reads = texels.reads();
    result.slb_reads = records.reads();
    return result;
  }

  /// Sends fragments and drops them in mid-flight.
  void abort_after(const std::vector<Fragment>& fragments, const FrameSetup& setup, int cycles) {
    for (int i = 0; i < cycles; ++i) {
      dut_.frag_valid_i = 1;
      set_fragment(fragments[static_cast<std::size_t>(i) % fragments.size()], setup);
      dut_.texel_rd_ready_i = i % 3 != 0;
      dut_.eval();
      tick();
    }
    dut_.clear_i = 1;
    dut_.eval();
    tick();
    dut_.clear_i = 0;
    idle_inputs();
    dut_.eval();
    EXPECT_TRUE(dut_.idle_o);
    EXPECT_FALSE(dut_.texel_rd_valid_o || dut_.slb_rd_valid_o || dut_.verdict_valid_o);
  }

 private:
  void tick() {
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
    dut_.eval();
  }
  void idle_inputs() {
    dut_.frag_valid_i = dut_.verdict_ready_i = dut_.texel_rd_ready_i = dut_.slb_rd_ready_i = 0;
    dut_.texel_rsp_valid_i = dut_.slb_rsp_valid_i = 0;
  }

  void set_settings(const UnitConfig& config, const FrameSetup& setup, unsigned pitch_log2,
                    unsigned buckets_log2) {
    Layout layout(93);
    const auto put = [&](std::size_t width, std::uint64_t value) {
      layout.field(width).set(dut_.settings_i, value);
    };
    put(5, setup.fraction_bits);
    put(11, static_cast<std::uint64_t>(config.map_width));
    put(11, static_cast<std::uint64_t>(config.map_height));
    put(4, pitch_log2);
    put(5, buckets_log2);
    put(25, 0);
    put(25, 0);
    put(1, config.own_id_rule == OwnIdRule::kLiteral);
    put(1, config.vertex_rule == VertexRule::kPerEntry);
    put(1, config.table7 == Table7::kPrinted);
    put(4, 0);
  }

  void set_fragment(const Fragment& f, const FrameSetup& setup) {
    Layout layout(107);
    const auto put = [&](std::size_t width, std::uint64_t value) {
      layout.field(width).set(dut_.frag_i, value);
    };
    put(1, 0);
    put(1, (f.flags & Fragment::kOutside) != 0);
    put(1, (f.flags & Fragment::kAverted) != 0);
    put(24, f.object < setup.unit_ids.size() ? setup.unit_ids[f.object] : f.object);
    put(28, static_cast<std::uint32_t>(f.position.x));
    put(28, static_cast<std::uint32_t>(f.position.y));
    put(24, f.position.z);
  }

  static void count_verdict(unsigned word, LaneResult& result) {
    const bool dark = (word & 1) != 0;
    UnitCounters& counters = result.counters;
    result.verdicts.push_back(dark ? Verdict::kDark : Verdict::kLit);
    ++counters.fragments;
    switch (word >> 1) {
      case 0: ++counters.averted; break;
      case 1: ++counters.outside; break;
      case 2: ++counters.lit; break;
      case 3: ++counters.dark_by_buffer; break;
      case 4: ++counters.dark_by_lines; break;
      default: ADD_FAILURE() << "verdict by " << (word >> 1);
    }
    const bool known_dark = (word >> 1) != 1 && (word >> 1) != 2;
    EXPECT_EQ(dark, known_dark);
  }
  void count_events(UnitCounters& counters) {
    const unsigned events = dut_.events_o;
    counters.slb_lookups += events >> 5 & 1;
    counters.entries_read += events >> 4 & 1;
    counters.lines_read += events & 15;
  }

  Vshadow_lane_test_dut dut_;
};

}  // namespace kagesen::rtl
