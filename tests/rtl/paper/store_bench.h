#pragma once
/// The Verilated store with its memories, driven by the golden front's visits.
#include <array>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <vector>

#include "model/engine.h"
#include "testbench/verilator/memory.h"
#include "testbench/verilator/paper_contents.h"
#include "tests/rtl/paper/golden_visits.h"

namespace kagesen::rtl {

/// What the store counted of one pass.
struct StoreCounts {
  std::uint64_t cycles = 0, visits = 0, edge_visits = 0, span_visits = 0;
  std::uint64_t stored = 0, cancelled = 0, emptied_covered = 0, hidden = 0, overflow_lines = 0,
                overflow_texels = 0, peak = 0;
  std::array<std::uint64_t, 16> causes{};
};

using EntryName = std::array<std::uint64_t, 3>;  ///< x, y, object

template <typename Dut>
class StoreBench {
 public:
  StoreBench(const UnitConfig& config, const PaperWidths& widths, const MemorySettings& settings)
      : config_(config),
        layout_(config, widths),
        texels_(layout_.texel.word_bits, settings),
        records_(layout_.record.bits, settings),
        random_(settings.seed * 77 + 1) {
    dut_.clk_i = 0;
    dut_.rst_ni = 0;
    dut_.clear_i = dut_.wipe_i = dut_.settle_i = dut_.visit_valid_i = dut_.frag_valid_i = 0;
    dut_.texel_rsp_valid_i = dut_.slb_rsp_valid_i = 0;
    dut_.eval();
    dut_.rst_ni = 1;
  }

  ~StoreBench() { dut_.final(); }
  StoreBench(const StoreBench&) = delete;
  StoreBench& operator=(const StoreBench&) = delete;

  /// A frame from wiping on. @param offer_percent  how often a visit is offered
  StoreCounts run(const std::vector<GoldenVisit>& visits, std::uint32_t texel_bits,
                  unsigned offer_percent) {
    StoreCounts counts;
    to_port(dut_.settings_i, layout_.make_settings(config_, texel_bits));
    wipe();
    std::size_t next = 0;
    bool offered = false;
    for (std::uint64_t quiet = 0;;) {
      start();
      if (!offered && next < visits.size() && random_() % 100 < offer_percent) {
        offered = true;
        offer(visits[next]);
      }
      dut_.visit_valid_i = offered;
      dut_.eval();
      const bool over = next == visits.size() && dut_.idle_o;
      if (offered && dut_.visit_ready_o) {
        count_visit(visits[next++], counts);
        offered = false;
        quiet = 0;
      }
      observe(counts);
      finish();
      ++counts.cycles;
      if (over) break;
      if (++quiet > 2'000'000) throw std::runtime_error("the store stands still");
    }
    dut_.visit_valid_i = 0;
    return counts;
  }

  /// Some cycles of a frame, then an abort.
  void run_and_clear(const std::vector<GoldenVisit>& visits, std::uint32_t texel_bits,
                     std::uint64_t cycles) {
    to_port(dut_.settings_i, layout_.make_settings(config_, texel_bits));
    wipe();
    std::size_t next = 0;
    for (std::uint64_t cycle = 0; cycle < cycles; ++cycle) {
      start();
      dut_.visit_valid_i = next < visits.size();
      if (dut_.visit_valid_i) offer(visits[next]);
      dut_.eval();
      next += dut_.visit_valid_i && dut_.visit_ready_o;
      finish();
    }
    start();
    dut_.visit_valid_i = 0;
    dut_.clear_i = 1;
    dut_.eval();
    finish();
    dut_.clear_i = 0;
  }

  MapContents contents() const {
    return paper_contents(
        config_, layout_, [this](std::uint64_t a) { return texels_.peek(a); },
        [this](std::uint64_t a) { return records_.peek(a); });
  }
  std::uint64_t linked_records() const {
    return paper_records(config_, layout_, [this](std::uint64_t a) { return records_.peek(a); });
  }
  /// A bucket's entries in the order in which they are linked.
  std::vector<EntryName> chain(std::uint64_t bucket) const {
    const PaperLayout::Record& r = layout_.record;
    const unsigned map_bits = layout_.widths.map_bits;
    std::vector<EntryName> out;
    Word word = records_.peek(bucket);
    for (bool more = r.used.get(word) != 0; more;) {
      const std::uint64_t texel = r.texel.get(word);
      out.push_back({texel & ((1u << map_bits) - 1), texel >> map_bits, r.object.get(word)});
      more = r.has_next.get(word) != 0;
      if (more) word = records_.peek(r.next.get(word));
    }
    return out;
  }
  std::uint64_t records() const { return dut_.records_o; }

 protected:
  void wipe() {
    dut_.wipe_i = 1;
    for (bool wiped = false; !wiped;) {
      start();
      dut_.eval();
      wiped = dut_.wiped_o;
      finish();
    }
    dut_.wipe_i = 0;
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
  void finish() {
    if (dut_.texel_rd_valid_o) texels_.read(dut_.texel_rd_addr_o, dut_.texel_rd_tag_o);
    if (dut_.slb_rd_valid_o) records_.read(dut_.slb_rd_addr_o, dut_.slb_rd_tag_o);
    if (dut_.texel_wr_valid_o) {
      texels_.write(dut_.texel_wr_addr_o, from_port(dut_.texel_wr_data_o), dut_.texel_wr_mask_o,
                    layout_.texel.bits);
    }
    if (dut_.slb_wr_valid_o) records_.write(dut_.slb_wr_addr_o, from_port(dut_.slb_wr_data_o));
    dut_.clk_i = 1;
    dut_.eval();
  }
  void offer(const GoldenVisit& visit) {
    const PaperLayout::Visit& v = layout_.visit;
    const PaperLayout::Line& l = layout_.line;
    Word word = make_word(v.bits);
    v.kind.set(word, visit.kind);
    v.x.set(word, static_cast<std::uint64_t>(visit.x));
    v.y.set(word, static_cast<std::uint64_t>(visit.y));
    const unit::Line& line = visit.line;
    using unit::Line;
    l.left.set(word, line.has(Line::kLeft), v.line_low);
    l.cross.set(word, line.has(Line::kCross), v.line_low);
    l.x_major.set(word, line.has(Line::kXMajor), v.line_low);
    l.x_positive.set(word, line.has(Line::kXPositive), v.line_low);
    l.start_here.set(word, line.has(Line::kStartHere), v.line_low);
    l.end_here.set(word, line.has(Line::kEndHere), v.line_low);
    l.polygon.set(word, line.polygon, v.line_low);
    l.slope.set(word, line.slope, v.line_low);
    l.fraction.set(word, line.fraction, v.line_low);
    v.nearest.set(word, visit.nearest);
    v.corner.set(word, visit.corner);
    for (int i = 0; i < 4; ++i) v.depth[i].set(word, visit.depth[i]);
    v.mask.set(word, visit.mask);
    to_port(dut_.visit_i, word);
    Word tri = make_word(layout_.visit_tri.bits);
    layout_.visit_tri.object.set(tri, visit.object);
    layout_.visit_tri.most.set(tri, visit.most);
    layout_.visit_tri.rise.set(tri, visit.rise);
    to_port(dut_.visit_tri_i, tri);
  }
  static void count_visit(const GoldenVisit& visit, StoreCounts& counts) {
    ++counts.visits;
    counts.edge_visits += visit.kind == GoldenVisit::kEdge;
    counts.span_visits += visit.kind == GoldenVisit::kSpan;
  }
  void observe(StoreCounts& counts) {
    const PaperLayout::Events& e = layout_.events;
    const Word events = from_port(dut_.events_o);
    counts.stored += e.line_stored.get(events);
    counts.cancelled += e.line_cancelled.get(events);
    counts.emptied_covered += e.emptied_covered.get(events);
    counts.hidden += e.lines_hidden.get(events);
    counts.overflow_lines += e.overflow_lines.get(events);
    counts.overflow_texels += e.overflow_texel.get(events);
    counts.peak = std::max<std::uint64_t>(counts.peak, dut_.records_o);
    ++counts.causes[dut_.cause_o];
  }

  UnitConfig config_;
  PaperLayout layout_;
  Memory texels_, records_;
  std::mt19937_64 random_;
  Dut dut_;
};

}  // namespace kagesen::rtl
