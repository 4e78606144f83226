// Drives a Verilated shadow_bench: registers, streams, memories, counters. Compiled together with
// the model by build.cpp, which also writes port_widths.h.
#include "testbench/verilator/bench.h"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

#include "Vshadow_bench.h"
#include "port_widths.h"
#include "testbench/verilator/bench_memory.h"
#include "testbench/verilator/ports.h"
#include "verilated.h"
#if KAGESEN_TRACE
#include "verilated_fst_c.h"
#endif
#if KAGESEN_COVERAGE
#include "verilated_cov.h"
#endif

namespace {

std::string last_message;  // what an assertion printed
std::string failure;       // where one failed; empty: nowhere

}  // namespace

// Verilator's runtime calls these (VL_PRINTF, VL_USER_STOP, VL_USER_FATAL).
int kagesen_print(const char* format, ...) {
  char text[1024];
  va_list arguments;
  va_start(arguments, format);
  const int length = std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  last_message = text;
  return length;
}
void vl_stop(const char* file, int line, const char*) {
  if (!failure.empty()) return;
  failure = std::string(file) + ":" + std::to_string(line) + ": " + last_message;
}
void vl_fatal(const char* file, int line, const char* hierarchy, const char* message) {
  last_message = message;
  vl_stop(file, line, hierarchy);
}

namespace kagesen::bench {
namespace {

constexpr unsigned kLanes = widths::frag_valid_i;
constexpr unsigned kTexelBits = KAGESEN_TEXEL_BITS;
constexpr unsigned kTexelsPerWord = 4;
constexpr bool kWinding = KAGESEN_WINDING;

// Fields of the event structs of shadow_pkg, last first.
constexpr unsigned kLines = 4;  // LineCountBits, SegmentCountBits
static_assert(widths::front_events_o == (kWinding ? 7 : 6));
static_assert(widths::store_events_o == (kWinding ? 46 : 36));
static_assert(widths::lane_events_o == kLanes * (kWinding ? 7 + kLines : 2 + kLines));
static_assert(kTexelsPerWord * kTexelBits <= widths::texel_wr_data_o);

using TexelMemory = WordMemory<widths::texel_wr_data_o, widths::texel_wr_addr_o>;
using SlbMemory = WordMemory<widths::slb_wr_data_o, widths::slb_wr_addr_o>;

/// Cycles without any handshake after which the unit counts as stuck.
constexpr std::uint64_t kStuck = 1u << 17;

class VerilatedBench final : public Bench {
 public:
  VerilatedBench() {
    context_.randReset(2);
    context_.randSeed(1);
#if KAGESEN_TRACE
    context_.traceEverOn(true);
#endif
    top_ = std::make_unique<Vshadow_bench>(&context_);
    top_->s_bready_i = 1;
    top_->s_rready_i = 1;
    top_->rst_ni = 1;
    make_masks();
    set_timing({});
    reset();
    clear();
  }
  ~VerilatedBench() override { top_->final(); }

  void reset() override {
    close_streams();
    top_->s_awvalid_i = top_->s_wvalid_i = top_->s_arvalid_i = 0;
    top_->rst_ni = 0;
    for (std::uint64_t i = 1; i < kResetCycles; ++i) cycle();
    for (unsigned l = 0; l < kLanes; ++l) {
      texel_ports_[l].drop();
      slb_ports_[l].drop();
    }
    top_->rst_ni = 1;
    cycle();
  }

  void clear() override {
    events_ = Events{};
    for (PassCycles& c : cycles_) c = PassCycles{};
  }

  void set_timing(const Timing& timing) override {
    timing_ = timing;
    passes_.fill(0);
    try {
      for (unsigned l = 0; l < kLanes; ++l) {
        texel_ports_[l].configure(timing);
        slb_ports_[l].configure(timing);
      }
    } catch (const std::invalid_argument& error) {
      throw Failure(error.what());
    }
  }

  void write(Register at, std::uint32_t value) override {
    offer_write(at, value);
    while (top_->s_awvalid_i) cycle();
  }

  std::uint32_t read(Register at) override {
    top_->s_araddr_i = static_cast<std::uint8_t>(at);
    top_->s_arvalid_i = 1;
    for (bool taken = false; !taken;) {
      low();
      taken = top_->s_arready_o;
      high();
    }
    top_->s_arvalid_i = 0;
    for (;;) {
      low();
      const bool valid = top_->s_rvalid_o && top_->s_rready_i;
      const std::uint32_t value = top_->s_rdata_o;
      high();
      if (valid) return value;
    }
  }

  bool wipe() override {
    Nothing feed;
    return run(Pass::kWipe, 0, feed);
  }
  bool settle() override {
    Nothing feed;
    return run(Pass::kSettle, 0, feed);
  }
  bool draw(const Triangle* beats, std::size_t count) override {
    std::uint32_t items = 0;
    for (std::size_t i = 0; i < count; ++i) items += !beats[i].is_plane;
    Triangles feed{*this, beats, count};
    return run(Pass::kDraw, items, feed);
  }
  bool announce(const Fragment* fragments, std::size_t count) override {
    Fragments feed{*this, fragments, count, 1, nullptr, nullptr};
    return run(Pass::kAnnounce, static_cast<std::uint32_t>(count), feed);
  }
  bool decide(const Fragment* fragments, std::size_t count, Verdict* verdicts,
              FragmentCycles* cycles) override {
    Fragments feed{*this, fragments, count, kLanes, verdicts, cycles};
    return run(Pass::kDecide, static_cast<std::uint32_t>(count), feed);
  }
  void cut_next_pass(Cut how, std::uint64_t after_cycles) override {
    cut_ = true;
    cut_how_ = how;
    cut_after_ = after_cycles;
  }

  const Events& events() const override { return events_; }
  const PassCycles& cycles(Pass pass) const override {
    return cycles_[static_cast<std::size_t>(pass)];
  }
  std::uint64_t now() const override { return now_; }
  std::uint64_t pass_began() const override { return pass_first_; }
  MemoryWords texel_memory() const override {
    return {texels_.words(), TexelMemory::kStride, widths::texel_wr_data_o, TexelMemory::kCount};
  }
  MemoryWords slb_memory() const override {
    return {slb_.words(), SlbMemory::kStride, widths::slb_wr_data_o, SlbMemory::kCount};
  }

  void trace(const char* path, std::uint64_t first, std::uint64_t last) override {
#if KAGESEN_TRACE
    if (fst_.isOpen()) fst_.close();
    trace_path_ = path ? path : "";
    trace_first_ = first;
    trace_last_ = last;
#else
    (void)path, (void)first, (void)last;
    throw Failure("this build of the bench writes no waves");
#endif
  }

  void write_coverage(const char* path) override {
#if KAGESEN_COVERAGE
    context_.coveragep()->write(path);
#else
    (void)path;
    throw Failure("this build of the bench counts no coverage");
#endif
  }

 private:
  // ---- What enters and leaves during a pass: offer() before a cycle's outputs settle, take()
  // after.
  struct Nothing {
    void offer() {}
    void take() {}
  };

  struct Triangles {
    VerilatedBench& bench;
    const Triangle* beats;
    std::size_t count, next = 0;

    void offer() {
      Vshadow_bench& top = *bench.top_;
      if (top.tri_valid_i || next == count || bench.stalls(Channel::kTriangles)) return;
      const Triangle& t = beats[next];
      top.tri_valid_i = 1;
      top.tri_kind_i = static_cast<std::uint8_t>(t.is_plane << 4 | t.shares << 3 | t.inner);
      top.tri_polygon_i = t.polygon & 0xffffff;
      top.tri_object_i = t.object;
      top.tri_x0_i = t.x[0] & 0xfffffff;
      top.tri_y0_i = t.y[0] & 0xfffffff;
      top.tri_z0_i = t.z[0];
      top.tri_x1_i = t.x[1] & 0xfffffff;
      top.tri_y1_i = t.y[1] & 0xfffffff;
      top.tri_z1_i = t.z[1];
      top.tri_x2_i = t.x[2] & 0xfffffff;
      top.tri_y2_i = t.y[2] & 0xfffffff;
      top.tri_z2_i = t.z[2];
    }
    void take() {
      if (!bench.top_->tri_valid_i || !bench.top_->tri_ready_o) return;
      bench.beat_taken_ = true;
      if (!beats[next].is_plane) ++bench.cycles_[int(Pass::kDraw)].items;
      ++next;
      ++bench.progress_;
    }
  };

  struct Fragments {
    VerilatedBench& bench;
    const Fragment* fragments;
    std::size_t count;
    unsigned lanes;
    Verdict* verdicts;      // null: an announcement
    FragmentCycles* cycles;  // may be null
    std::array<std::size_t, kLanes> sent{}, answered{};

    void offer() {
      Vshadow_bench& top = *bench.top_;
      for (unsigned l = 0; l < lanes; ++l) {
        const std::size_t next = sent[l] * lanes + l;
        if ((top.frag_valid_i >> l & 1) != 0 || next >= count ||
            bench.stalls(Channel::kFragments, l)) {
          continue;
        }
        const Fragment& f = fragments[next];
        top.frag_valid_i |= static_cast<std::uint8_t>(1u << l);
        set_field(top.frag_flags_i, 3 * l, 3, f.unshadowable << 2 | f.outside << 1 | f.averted);
        set_field(top.frag_object_i, 24 * l, 24, f.object);
        set_field(top.frag_x_i, 28 * l, 28, static_cast<std::uint32_t>(f.x));
        set_field(top.frag_y_i, 28 * l, 28, static_cast<std::uint32_t>(f.y));
        set_field(top.frag_z_i, 24 * l, 24, f.z);
      }
      unsigned ready = (1u << kLanes) - 1;
      if (bench.timing_.stream_stall != 0) {
        for (unsigned l = 0; l < kLanes; ++l) {
          ready &= ~(unsigned{bench.stalls(Channel::kVerdicts, l)} << l);
        }
      }
      top.verdict_ready_i = static_cast<std::uint8_t>(ready);
    }
    void take() {
      Vshadow_bench& top = *bench.top_;
      const unsigned taken = top.frag_valid_i & top.frag_ready_o;
      if (taken != 0) {
        bench.lanes_taken_ = taken;
        for (unsigned l = 0; l < lanes; ++l) {
          if ((taken >> l & 1) == 0) continue;
          const std::size_t at = sent[l]++ * lanes + l;
          if (cycles != nullptr) cycles[at].accepted = bench.now_ - bench.pass_first_;
        }
        const auto beats = static_cast<unsigned>(__builtin_popcount(taken));
        bench.cycles_[int(verdicts ? Pass::kDecide : Pass::kAnnounce)].items += beats;
        ++bench.progress_;
      }
      const unsigned given = top.verdict_valid_o & top.verdict_ready_i;
      for (unsigned l = 0; given >> l != 0; ++l) {
        if ((given >> l & 1) != 0) answer(l);
      }
    }
    void answer(unsigned lane) {
      Vshadow_bench& top = *bench.top_;
      const std::size_t at = answered[lane]++ * lanes + lane;
      if (verdicts == nullptr || at >= count) {
        throw Failure("the unit gave a verdict that nobody asked for");
      }
      const unsigned dark = top.verdict_dark_o >> lane & 1;
      const auto by = static_cast<unsigned>(field(top.verdict_by_o, 3 * lane, 3));
      verdicts[at] = {static_cast<std::uint8_t>(dark), static_cast<std::uint8_t>(by & 7)};
      ++bench.events_.verdicts[dark][by];
      if (cycles != nullptr) cycles[at].retired = bench.now_ - bench.pass_first_;
      ++bench.progress_;
    }
  };

  template <typename Feed>
  bool run(Pass pass, std::uint32_t count, Feed& feed) {
    write(Register::kCount, count);
    done_ = false;
    write(Register::kControl, static_cast<std::uint32_t>(pass));
    begin_timing(pass);
    const std::uint64_t cut_at = cut_ ? now_ + cut_after_ : ~std::uint64_t{0};
    cut_ = false;
    bool cutting = false;
    while (!done_) {
      if (now_ >= cut_at && !cutting) {
        if (cut_how_ == Cut::kReset) {
          reset();
          return false;
        }
        offer_write(Register::kControl, 0x80);
        cutting = true;
      }
      feed.offer();
      low();
      feed.take();
      high();
      if (now_ % kStuck == 0) check_progress();
    }
    close_streams();
    return !cutting;
  }

  /// The pass's first cycle is the second from now; what happens from it on is the pass's.
  void begin_timing(Pass pass) {
    pass_first_ = now_ + 1;
    const PassNumber number{static_cast<std::uint32_t>(pass), passes_[std::size_t(pass)]++};
    for (unsigned l = 0; l < kLanes; ++l) {
      texel_ports_[l].begin_pass(number, Channel::kTexelReads, l, pass_first_);
      slb_ports_[l].begin_pass(number, Channel::kSlbReads, l, pass_first_);
      for (const Channel c : {Channel::kFragments, Channel::kVerdicts}) {
        stalls_[l][std::size_t(c)] =
            Stalls(timing_.stream_stall, Chance(timing_.seed, number, c, l));
      }
    }
    const auto set = [&](Channel c, std::uint32_t per_cent) {
      stalls_[0][std::size_t(c)] = Stalls(per_cent, Chance(timing_.seed, number, c, 0));
    };
    set(Channel::kTriangles, timing_.stream_stall);
    set(Channel::kTexelWrites, timing_.memory_stall);
    set(Channel::kSlbWrites, timing_.memory_stall);
  }

  void offer_write(Register at, std::uint32_t value) {
    top_->s_awaddr_i = static_cast<std::uint8_t>(at);
    top_->s_wdata_i = value;
    top_->s_awvalid_i = top_->s_wvalid_i = 1;
  }
  void close_streams() {
    top_->tri_valid_i = 0;
    top_->frag_valid_i = 0;
    top_->verdict_ready_i = static_cast<std::uint8_t>((1u << kLanes) - 1);
  }
  bool stalls(Channel channel, unsigned lane = 0) const {
    return stalls_[lane][std::size_t(channel)].at(now_ - pass_first_);
  }
  void check_progress() {
    if (progress_ == progress_seen_) {
      throw Failure("the unit is stuck in pass " + std::to_string(top_->pass_o) +
                    ": nothing moved for " + std::to_string(kStuck) + " cycles up to cycle " +
                    std::to_string(now_));
    }
    progress_seen_ = progress_;
  }

  // ---- A clock cycle ----------------------------------------------------------------------------
  void cycle() {
    low();
    high();
  }

  /// Gives the unit the cycle's inputs and lets its outputs settle.
  void low() {
    Vshadow_bench& top = *top_;
    top.clk_i = 0;
    unsigned texel_valid = 0, slb_valid = 0;
    for (unsigned l = 0; l < kLanes; ++l) {
      if (const auto* r = texel_ports_[l].take(now_)) {
        texel_valid |= 1u << l;
        set_field(top.texel_rsp_tag_i, 8 * l, 8, r->tag);
        constexpr unsigned kBits = widths::texel_wr_data_o;
        set_words<kBits, (kLanes > 1)>(top.texel_rsp_data_i, kBits * l, r->words);
      }
      if (const auto* r = slb_ports_[l].take(now_)) {
        slb_valid |= 1u << l;
        set_field(top.slb_rsp_tag_i, 8 * l, 8, r->tag);
        constexpr unsigned kBits = widths::slb_wr_data_o;
        set_words<kBits, (kLanes > 1)>(top.slb_rsp_data_i, kBits * l, r->words);
      }
    }
    top.texel_rsp_valid_i = static_cast<std::uint8_t>(texel_valid);
    top.slb_rsp_valid_i = static_cast<std::uint8_t>(slb_valid);
    top.texel_rd_ready_i = static_cast<std::uint8_t>(ready(texel_ports_));
    top.slb_rd_ready_i = static_cast<std::uint8_t>(ready(slb_ports_));
    top.texel_wr_ready_i = !stalls(Channel::kTexelWrites);
    top.slb_wr_ready_i = !stalls(Channel::kSlbWrites);
    // Answers of registers. Not before a pass: when it begins must not depend on them.
    const std::uint32_t wait = timing_.stream_stall;
    top.s_bready_i = top.pass_o == 0 || answers_.below(100, 2 * now_) >= wait;
    top.s_rready_i = answers_.below(100, 2 * now_ + 1) >= wait;
    top.eval();
    dump(0);
  }

  /// Takes what the unit gives, and the clock edge.
  void high() {
    Vshadow_bench& top = *top_;
    serve_reads();
    serve_writes();
    account();
    const bool write_taken = top.s_awvalid_i && top.s_awready_o;
    top.clk_i = 1;
    top.eval();
    dump(1);
    ++now_;
    if (write_taken) top.s_awvalid_i = top.s_wvalid_i = 0;
    if (beat_taken_) {
      beat_taken_ = false;
      top.tri_valid_i = 0;
    }
    if (lanes_taken_ != 0) {
      top.frag_valid_i &= static_cast<std::uint8_t>(~lanes_taken_);
      lanes_taken_ = 0;
    }
    if (!failure.empty()) {
      const std::string text = std::exchange(failure, {});
      throw Failure("cycle " + std::to_string(now_ - 1) + ": " + text);
    }
  }

  template <typename Ports>
  unsigned ready(Ports& ports) {
    unsigned bits = 0;
    for (unsigned l = 0; l < kLanes; ++l) bits |= unsigned{ports[l].ready(now_)} << l;
    return bits;
  }

  // A read that is accepted with a write of the same word has the old one: reads come first.
  void serve_reads() {
    Vshadow_bench& top = *top_;
    const unsigned texels = top.texel_rd_valid_o & top.texel_rd_ready_i;
    const unsigned records = top.slb_rd_valid_o & top.slb_rd_ready_i;
    if ((texels | records) == 0) return;
    ++progress_;
    for (unsigned l = 0; l < kLanes; ++l) {
      if ((texels >> l & 1) != 0) {
        constexpr unsigned kBits = widths::texel_wr_addr_o;
        const std::uint64_t address = field(top.texel_rd_addr_o, kBits * l, kBits);
        texel_ports_[l].accept(now_, std::uint8_t(field(top.texel_rd_tag_o, 8 * l, 8)), address,
                               texels_.at(address));
      }
      if ((records >> l & 1) != 0) {
        constexpr unsigned kBits = widths::slb_wr_addr_o;
        const std::uint64_t address = field(top.slb_rd_addr_o, kBits * l, kBits);
        slb_ports_[l].accept(now_, std::uint8_t(field(top.slb_rd_tag_o, 8 * l, 8)), address,
                             slb_.at(address));
      }
    }
  }

  void serve_writes() {
    Vshadow_bench& top = *top_;
    if (top.texel_wr_valid_o && top.texel_wr_ready_i) {
      ++progress_;
      std::uint32_t* word = texels_.at(top.texel_wr_addr_o);
      constexpr unsigned kBits = widths::texel_wr_data_o;
      if (top.texel_wr_mask_o == (1u << kTexelsPerWord) - 1) {
        get_words<kBits>(top.texel_wr_data_o, 0, word);
      } else {
        std::uint32_t data[TexelMemory::kStride];
        get_words<kBits>(top.texel_wr_data_o, 0, data);
        const auto& mask = masks_[top.texel_wr_mask_o];
        for (unsigned i = 0; i < TexelMemory::kStride; ++i) {
          word[i] = (word[i] & ~mask[i]) | (data[i] & mask[i]);
        }
      }
    }
    if (top.slb_wr_valid_o && top.slb_wr_ready_i) {
      ++progress_;
      get_words<widths::slb_wr_data_o>(top.slb_wr_data_o, 0, slb_.at(top.slb_wr_addr_o));
    }
  }

  void account() {
    Vshadow_bench& top = *top_;
    if (top.irq_o) done_ = true;
    const unsigned pass = top.pass_o;
    if (pass == static_cast<unsigned>(Pass::kWipe)) {
      events_.peak_records = 0;
    } else if (top.records_o > events_.peak_records) {
      events_.peak_records = top.records_o;
    }
    if (pass == 0 || !top.rst_ni) return;
    PassCycles& cycles = cycles_[pass];
    ++cycles.total;
    if (pass == static_cast<unsigned>(Pass::kDecide)) {
      ++cycles.causes[field(top.cause2_o, 0, 4)];
      if (top.lane_events_o != 0) count_lanes();
      return;
    }
    ++cycles.causes[top.cause1_o];
    if (top.front_events_o != 0) count_front(top.front_events_o);
    if (top.store_events_o != 0) count_store(top.store_events_o);
  }

  void count_front(unsigned e) {
    events_.span_texels += e & 7;
    e >>= 3;
    if (kWinding) {
      events_.inner_texels += e & 1;
      e >>= 1;
    }
    events_.edge_texels += e & 1;
    events_.edges += e >> 1 & 1;
    events_.casters += e >> 2 & 1;
  }

  void count_store(std::uint64_t e) {
    const auto next = [&](unsigned bits) {
      const std::uint64_t value = e & low_bits(bits);
      e >>= bits;
      return value;
    };
    events_.overflow_texels += next(1);
    events_.overflow_lines += next(16);
    events_.lines_hidden += next(16);
    if (kWinding) {
      events_.tiles_touched += next(1);
      events_.hidden_visits += next(3);
      events_.masked_visits += next(3);
      events_.texel_visits += next(3);
    }
    events_.emptied_covered += next(1);
    events_.lines_cancelled += next(1);
    events_.lines_stored += next(1);
  }

  void count_lanes() {
    constexpr unsigned kBits = widths::lane_events_o / kLanes;
    for (unsigned l = 0; l < kLanes; ++l) {
      auto e = static_cast<unsigned>(field(top_->lane_events_o, kBits * l, kBits));
      events_.lines_read += e & low_bits(kLines);
      e >>= kLines;
      events_.entries_read += e & 1;
      events_.slb_lookups += e >> 1 & 1;
      if (!kWinding) continue;
      events_.first_test += e >> 2 & 1;
      events_.texel_lookups += e >> 3 & 1;
      events_.tile_dark += e >> 4 & 1;
      events_.tile_lit += e >> 5 & 1;
      events_.known += e >> 6 & 1;
    }
  }

  void make_masks() {
    for (unsigned mask = 0; mask < masks_.size(); ++mask) {
      masks_[mask].fill(0);
      for (unsigned bit = 0; bit < kTexelsPerWord * kTexelBits; ++bit) {
        if ((mask >> (bit / kTexelBits) & 1) != 0) masks_[mask][bit / 32] |= 1u << (bit % 32);
      }
    }
  }

  void dump(unsigned phase) {
#if KAGESEN_TRACE
    if (now_ < trace_first_ || trace_path_.empty()) return;
    if (now_ > trace_last_) {
      fst_.close();
      trace_path_.clear();
      return;
    }
    if (!fst_.isOpen()) {
      top_->trace(&fst_, 99);
      fst_.open(trace_path_.c_str());
    }
    fst_.dump(2 * now_ + phase);
#else
    (void)phase;
#endif
  }

  VerilatedContext context_;
  std::unique_ptr<Vshadow_bench> top_;
  TexelMemory texels_;
  SlbMemory slb_;
  std::array<ReadPort<TexelMemory::kStride>, kLanes> texel_ports_;
  std::array<ReadPort<SlbMemory::kStride>, kLanes> slb_ports_;
  std::array<std::array<std::uint32_t, TexelMemory::kStride>, 1u << kTexelsPerWord> masks_;
  Timing timing_;
  std::array<std::uint32_t, kPasses> passes_{};        // of each kind, since set_timing()
  std::array<std::array<Stalls, kChannels>, kLanes> stalls_{};  // by channel
  Chance answers_;
  Cycle pass_first_ = 0;

  std::uint64_t now_ = 0, progress_ = 0, progress_seen_ = ~std::uint64_t{0};
  bool done_ = false;
  bool beat_taken_ = false;   // in this cycle
  unsigned lanes_taken_ = 0;  // in this cycle
  bool cut_ = false;
  Cut cut_how_ = Cut::kAbort;
  std::uint64_t cut_after_ = 0;
  Events events_;
  PassCycles cycles_[kPasses];
#if KAGESEN_TRACE
  VerilatedFstC fst_;
  std::string trace_path_;
  std::uint64_t trace_first_ = 0, trace_last_ = 0;
#endif
};

}  // namespace
}  // namespace kagesen::bench

extern "C" __attribute__((visibility("default"))) kagesen::bench::Bench* kagesen_make_bench() {
  return new kagesen::bench::VerilatedBench();
}
