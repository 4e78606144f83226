#pragma once
/// The Verilated store with its memories, driven by fragments and the golden front's visits.
#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

#include "model/engine.h"
#include "testbench/verilator/memory.h"
#include "testbench/verilator/winding_contents.h"
#include "tests/rtl/winding/golden_visits.h"

namespace kagesen::rtl {

/// What the store counted of a frame.
struct StoreCounts {
  std::uint64_t announce_cycles = 0, draw_cycles = 0, settle_cycles = 0;
  std::uint64_t visits = 0, edge_visits = 0, span_visits = 0;
  std::uint64_t stored = 0, cancelled = 0, emptied_covered = 0, lines_hidden = 0,
                overflow_lines = 0, overflow_texels = 0, peak = 0;
  std::uint64_t texel_visits = 0, masked = 0, hidden = 0, touched = 0;
  std::array<std::uint64_t, 16> causes{};  ///< of draw_cycles
};

template <typename Dut>
class StoreBench {
 public:
  StoreBench(const UnitConfig& config, const WindingWidths& widths, const MemorySettings& memory)
      : config_(config),
        layout_(config, widths),
        texels_(layout_.texel_data_bits(), memory),
        records_(layout_.record.bits, memory),
        random_(memory.seed * 77 + 1) {
    dut_.clk_i = dut_.rst_ni = dut_.clear_i = dut_.wipe_i = dut_.settle_i = 0;
    dut_.visit_valid_i = dut_.frag_valid_i = 0;
    dut_.texel_rsp_valid_i = dut_.slb_rsp_valid_i = 0;
    dut_.eval();
    dut_.rst_ni = 1;
  }

  /// A frame from wiping on. @param offer_percent  how often something is offered
  StoreCounts run(const std::vector<Fragment>& fragments, const FrameSetup& setup,
                  const std::vector<GoldenVisit>& visits, unsigned offer_percent) {
    StoreCounts counts;
    begin(setup);
    counts.announce_cycles =
        stream(fragments.size(), offer_percent, &counts, dut_.frag_valid_i, dut_.frag_ready_o,
               [&](std::size_t i) { offer(fragments[i], setup); });
    const std::array<std::uint64_t, 16> before = counts.causes;
    counts.draw_cycles =
        stream(visits.size(), offer_percent, &counts, dut_.visit_valid_i, dut_.visit_ready_o,
               [&](std::size_t i) { offer(visits[i]); });
    for (std::size_t i = 0; i < before.size(); ++i) counts.causes[i] -= before[i];
    const std::array<std::uint64_t, 16> drawn = counts.causes;
    for (const GoldenVisit& v : visits) {
      ++counts.visits;
      counts.edge_visits += v.kind == GoldenVisit::kEdge;
      counts.span_visits += v.kind == GoldenVisit::kSpan;
    }
    counts.settle_cycles = command(dut_.settle_i, dut_.settled_o, &counts);
    counts.causes = drawn;
    return counts;
  }

  /// Some cycles of a frame, then an abort.
  void run_and_clear(const FrameSetup& setup, const std::vector<GoldenVisit>& visits,
                     std::uint64_t cycles) {
    begin(setup);
    std::size_t next = 0;
    for (std::uint64_t cycle = 0; cycle < cycles; ++cycle) {
      start();
      dut_.visit_valid_i = next < visits.size();
      if (dut_.visit_valid_i) offer(visits[next]);
      dut_.eval();
      next += dut_.visit_valid_i && dut_.visit_ready_o;
      finish(nullptr);
    }
    dut_.visit_valid_i = 0;
    dut_.clear_i = 1;
    start();
    dut_.eval();
    finish(nullptr);
    dut_.clear_i = 0;
  }

  MapContents contents(std::uint64_t* records = nullptr) const {
    return winding_contents(
        config_, layout_, [this](std::uint64_t a) { return texels_.peek(a); },
        [this](std::uint64_t a) { return records_.peek(a); }, records);
  }
  Word tile(std::uint32_t x, std::uint32_t y) const {
    return texels_.peek(layout_.tile_address(x, y));
  }
  const WindingLayout& layout() const { return layout_; }
  std::uint64_t records() const { return dut_.records_o; }

 private:
  void begin(const FrameSetup& setup) {
    to_port(dut_.settings_i, layout_.make_settings(config_, setup.fraction_bits));
    command(dut_.wipe_i, dut_.wiped_o, nullptr);
  }
  template <typename Port>
  std::uint64_t command(Port& request, const Port& done, StoreCounts* counts) {
    request = 1;
    std::uint64_t cycles = 0;
    for (bool over = false; !over; ++cycles) {
      start();
      dut_.eval();
      over = done;
      finish(counts);
      if (cycles > 5'000'000) throw std::runtime_error("the store does not finish");
    }
    request = 0;
    start();
    dut_.eval();
    finish(nullptr);
    return cycles;
  }
  template <typename Port, typename Offer>
  std::uint64_t stream(std::size_t count, unsigned offer_percent, StoreCounts* counts, Port& valid,
                       const Port& ready, Offer offer) {
    bool offered = false;
    std::uint64_t cycles = 0;
    for (std::size_t next = 0, quiet = 0;; ++cycles) {
      start();
      if (!offered && next < count && random_() % 100 < offer_percent) {
        offered = true;
        offer(next);
      }
      valid = offered;
      dut_.eval();
      const bool over = next == count && dut_.idle_o;
      if (offered && ready) {
        ++next;
        offered = false;
        quiet = 0;
      }
      finish(counts);
      if (over) break;
      if (++quiet > 2'000'000) throw std::runtime_error("the store stands still");
    }
    valid = 0;
    return cycles;
  }
  void start() {
    dut_.clk_i = 0;
    texels_.start();
    records_.start();
    dut_.texel_rd_ready_i = texels_.read_ready();
    dut_.texel_wr_ready_i = texels_.write_ready();
    dut_.slb_rd_ready_i = records_.read_ready();
    dut_.slb_wr_ready_i = records_.write_ready();
    dut_.texel_rsp_valid_i = texels_.response().valid;
    if (texels_.response().valid) {
      dut_.texel_rsp_tag_i = static_cast<std::uint8_t>(texels_.response().tag);
      to_port(dut_.texel_rsp_data_i, texels_.response().data);
    }
    dut_.slb_rsp_valid_i = records_.response().valid;
    if (records_.response().valid) {
      dut_.slb_rsp_tag_i = static_cast<std::uint8_t>(records_.response().tag);
      to_port(dut_.slb_rsp_data_i, records_.response().data);
    }
  }
  void finish(StoreCounts* counts) {
    if (counts != nullptr) observe(*counts);
    if (dut_.texel_rd_valid_o) texels_.read(dut_.texel_rd_addr_o, dut_.texel_rd_tag_o);
    if (dut_.slb_rd_valid_o) records_.read(dut_.slb_rd_addr_o, dut_.slb_rd_tag_o);
    if (dut_.texel_wr_valid_o) {
      const Word data = from_port(dut_.texel_wr_data_o);
      if (dut_.texel_wr_mask_o == 15) {  // a tile word has no texels
        texels_.write(dut_.texel_wr_addr_o, data);
      } else {
        texels_.write(dut_.texel_wr_addr_o, data, dut_.texel_wr_mask_o, layout_.texel.bits);
      }
    }
    if (dut_.slb_wr_valid_o) {
      if (dut_.slb_wr_addr_o >= config_.cluster_records) {
        throw std::runtime_error("a record beyond the capacity");
      }
      records_.write(dut_.slb_wr_addr_o, from_port(dut_.slb_wr_data_o));
    }
    dut_.clk_i = 1;
    dut_.eval();
  }
  void offer(const GoldenVisit& visit) {
    const WindingLayout::Visit& v = layout_.visit;
    const WindingLayout::Segment& s = layout_.segment;
    Word word = make_word(v.bits);
    v.kind.set(word, visit.kind);
    v.x.set(word, static_cast<std::uint64_t>(visit.x));
    v.y.set(word, static_cast<std::uint64_t>(visit.y));
    v.has_segment.set(word, visit.has_segment);
    v.corner.set(word, visit.corner);
    const unit::winding::Segment& segment = visit.segment;
    s.inner.set(word, segment.inner(), v.segment_low);
    s.crosses_left.set(word, segment.crosses_left(), v.segment_low);
    s.positive.set(word, segment.positive(), v.segment_low);
    s.x0.set(word, static_cast<std::uint64_t>(segment.x0), v.segment_low);
    s.y0.set(word, static_cast<std::uint64_t>(segment.y0), v.segment_low);
    s.x1.set(word, static_cast<std::uint64_t>(segment.x1), v.segment_low);
    s.y1.set(word, static_cast<std::uint64_t>(segment.y1), v.segment_low);
    for (std::size_t i = 0; i < 4; ++i) {
      v.base[i].set(word, static_cast<std::uint64_t>(visit.base[i]));
    }
    v.mask.set(word, visit.mask);
    to_port(dut_.visit_i, word);
    Word tri = make_word(layout_.visit_tri.bits);
    layout_.visit_tri.object.set(tri, visit.object);
    layout_.visit_tri.gradient_x.set(tri, visit.gradient_x);
    layout_.visit_tri.gradient_y.set(tri, visit.gradient_y);
    to_port(dut_.visit_tri_i, tri);
  }
  void offer(const Fragment& fragment, const FrameSetup& setup) {
    const WindingLayout::Frag& f = layout_.frag;
    Word word = make_word(f.bits);
    f.unshadowable.set(word, fragment.object < setup.unshadowable.size() &&
                                 setup.unshadowable[fragment.object] != 0);
    f.outside.set(word, (fragment.flags & Fragment::kOutside) != 0);
    f.averted.set(word, (fragment.flags & Fragment::kAverted) != 0);
    f.object.set(word, fragment.object);
    f.x.set(word, static_cast<std::uint64_t>(std::int64_t{fragment.position.x}));
    f.y.set(word, static_cast<std::uint64_t>(std::int64_t{fragment.position.y}));
    f.z.set(word, fragment.position.z);
    to_port(dut_.frag_i, word);
  }
  void observe(StoreCounts& counts) {
    const WindingLayout::Events& e = layout_.events;
    const Word events = from_port(dut_.events_o);
    counts.stored += e.line_stored.get(events);
    counts.cancelled += e.line_cancelled.get(events);
    counts.emptied_covered += e.emptied_covered.get(events);
    counts.texel_visits += e.texel_visits.get(events);
    counts.masked += e.masked_visits.get(events);
    counts.hidden += e.hidden_visits.get(events);
    counts.touched += e.tile_touched.get(events);
    counts.lines_hidden += e.lines_hidden.get(events);
    counts.overflow_lines += e.overflow_lines.get(events);
    counts.overflow_texels += e.overflow_texel.get(events);
    counts.peak = std::max<std::uint64_t>(counts.peak, dut_.records_o);
    ++counts.causes[dut_.cause_o];
  }

  UnitConfig config_;
  WindingLayout layout_;
  Memory texels_, records_;
  std::mt19937_64 random_;
  Dut dut_;
};

}  // namespace kagesen::rtl
