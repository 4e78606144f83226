#pragma once
/// A Verilated lane of the winding profile between a stream of fragments and two memories.
#include <array>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

#include "Vwinding_lane_test_dut.h"
#include "model/frame_setup.h"
#include "testbench/verilator/memory.h"
#include "tests/rtl/winding/encode_contents.h"

namespace kagesen::rtl {

struct LaneCounters {
  std::uint64_t cycles = 0, known = 0, tile_lit = 0, tile_dark = 0, texel_lookups = 0, first_test = 0;
  std::uint64_t slb_lookups = 0, entries_read = 0, lines_read = 0;
  std::array<std::uint64_t, 16> causes{}, by_lit{}, by_dark{};
};

struct LaneStalls {
  unsigned frag_percent = 100, verdict_percent = 100;  ///< of cycles that offer or take one
};

class LaneBench {
 public:
  LaneBench(const UnitConfig& config, const FrameSetup& setup, Memory& texels, Memory& slb)
      : config_(config), setup_(setup), texels_(texels), slb_(slb) {
    dut_.clk_i = 0;
    dut_.rst_ni = 0;
    dut_.clear_i = 0;
    dut_.frag_valid_i = dut_.verdict_ready_i = dut_.texel_rsp_valid_i = dut_.slb_rsp_valid_i = 0;
    put_settings();
    dut_.eval();
    dut_.rst_ni = 1;
    clear();
  }

  /// Drops what is inside, in one cycle.
  void clear() {
    texels_.drop_pending();
    slb_.drop_pending();
    dut_.texel_rsp_valid_i = dut_.slb_rsp_valid_i = dut_.frag_valid_i = 0;
    dut_.clear_i = 1;
    tick();
    dut_.clear_i = 0;
  }

  /// Verdicts of all fragments, or until `cycles` have passed.
  std::vector<Verdict> run(const std::vector<Fragment>& fragments, const LaneStalls& stalls,
                           LaneCounters& n, std::uint64_t seed, std::uint64_t cycles = ~0ull) {
    std::mt19937_64 random(seed);
    std::vector<Verdict> verdicts;
    std::size_t next = 0;
    std::uint64_t waited = 0;
    bool offered = false;
    while ((verdicts.size() < fragments.size() || !dut_.idle_o) && n.cycles < cycles) {
      texels_.start();
      slb_.start();
      offered = next < fragments.size() && (offered || random() % 100 < stalls.frag_percent);
      dut_.frag_valid_i = offered;
      if (offered) put_fragment(fragments[next]);
      dut_.verdict_ready_i = random() % 100 < stalls.verdict_percent;
      dut_.texel_rd_ready_i = texels_.read_ready();
      dut_.slb_rd_ready_i = slb_.read_ready();
      dut_.texel_rsp_valid_i = texels_.response().valid;
      dut_.texel_rsp_tag_i = static_cast<std::uint8_t>(texels_.response().tag);
      if (texels_.response().valid) to_port(dut_.texel_rsp_data_i, texels_.response().data);
      dut_.slb_rsp_valid_i = slb_.response().valid;
      dut_.slb_rsp_tag_i = static_cast<std::uint8_t>(slb_.response().tag);
      if (slb_.response().valid) to_port(dut_.slb_rsp_data_i, slb_.response().data);
      dut_.eval();
      if (dut_.texel_rd_valid_o) texels_.read(dut_.texel_rd_addr_o, dut_.texel_rd_tag_o);
      if (dut_.slb_rd_valid_o) slb_.read(dut_.slb_rd_addr_o, dut_.slb_rd_tag_o);
      const bool taken = dut_.frag_valid_i && dut_.frag_ready_o;
      if (taken != (dut_.cause_o == 0)) throw std::logic_error("cause of a cycle");
      count(n);
      if (taken) ++next, offered = false;
      ++waited;
      if (dut_.verdict_valid_o && dut_.verdict_ready_i) {
        const bool dark = (dut_.verdict_o & 1) != 0;
        verdicts.push_back(dark ? Verdict::kDark : Verdict::kLit);
        ++(dark ? n.by_dark : n.by_lit)[dut_.verdict_o >> 1];
        waited = 0;
      }
      if (waited > 2000000) throw std::logic_error("the lane stands still");
      tick();
    }
    return verdicts;
  }

 private:
  void tick() {
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
    dut_.eval();
  }
  template <typename Port>
  static void put(Port& port, std::size_t& left, unsigned width, std::uint64_t value) {
    left -= width;
    set_bits(port, left, width, width < 64 ? value & ((std::uint64_t{1} << width) - 1) : value);
  }
  void put_fragment(const Fragment& f) {
    std::size_t left = 107;
    auto& port = dut_.frag_i;
    const bool unshadowable =
        f.object < setup_.unshadowable.size() && setup_.unshadowable[f.object] != 0;
    std::uint32_t object = 0;
    if (config_.semantics == Semantics::kPaper) {
      object = f.object < setup_.unit_ids.size()
                   ? setup_.unit_ids[f.object]
                   : f.object & ((1u << static_cast<unsigned>(config_.id_bits)) - 1);
    }
    put(port, left, 1, unshadowable);
    put(port, left, 1, (f.flags & Fragment::kOutside) != 0);
    put(port, left, 1, (f.flags & Fragment::kAverted) != 0);
    put(port, left, 24, object);
    put(port, left, 28, static_cast<std::uint32_t>(f.position.x));
    put(port, left, 28, static_cast<std::uint32_t>(f.position.y));
    put(port, left, 24, f.position.z);
  }
  void put_settings() {
    constexpr unsigned kSide = 11;  // MapBits + 1
    std::size_t left = 5 + 2 * kSide + 2 * 25 + 17 + 6;
    auto& port = dut_.settings_i;
    put(port, left, 5, setup_.fraction_bits);
    put(port, left, kSide, std::uint64_t(config_.map_width));
    put(port, left, kSide, std::uint64_t(config_.map_height));
    put(port, left, 25, std::uint64_t(config_.cluster_records));
    put(port, left, 25, std::uint64_t(config_.chain_records));
    put(port, left, 17, std::uint64_t(config_.plane_tolerance));
    put(port, left, 1, config_.semantics == Semantics::kPaper);
    for (const bool skip : {config_.skip_receiver_mask, config_.skip_first_test, config_.skip_tiles,
                            config_.skip_edges, config_.skip_fragments}) {
      put(port, left, 1, skip);
    }
  }
  void count(LaneCounters& n) {
    ++n.cycles;
    ++n.causes[dut_.cause_o];
    const unsigned events = dut_.events_o;
    n.lines_read += events & 15;
    n.entries_read += events >> 4 & 1;
    n.slb_lookups += events >> 5 & 1;
    n.first_test += events >> 6 & 1;
    n.texel_lookups += events >> 7 & 1;
    n.tile_dark += events >> 8 & 1;
    n.tile_lit += events >> 9 & 1;
    n.known += events >> 10 & 1;
  }

  const UnitConfig& config_;
  const FrameSetup& setup_;
  Memory& texels_;
  Memory& slb_;
  Vwinding_lane_test_dut dut_;
};

}  // namespace kagesen::rtl
