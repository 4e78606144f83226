// Drives a Verilated shadow_bench: registers, passes, clock, counters. Compiled together with the
// model by build.cpp, which also writes port_widths.h.
#include "testbench/verilator/bench.h"

#include <memory>
#include <string>

#include "testbench/verilator/bench_causes.h"
#include "testbench/verilator/bench_events.h"
#include "testbench/verilator/bench_ports.h"
#include "testbench/verilator/bench_probes.h"
#include "testbench/verilator/bench_streams.h"
#include "testbench/verilator/bench_waves.h"
#include "verilated.h"
#if KAGESEN_COVERAGE
#include "verilated_cov.h"
#endif

namespace kagesen::bench {
namespace {

/// Cycles without any movement, beyond a memory's longest delay, after which the unit counts as stuck.
/// A triangle's walk along the rows of the largest map without a visit takes half of them.
constexpr Cycle kStuck = 1u << 13;

class VerilatedBench final : public Bench {
 public:
  VerilatedBench() {
    context_.randReset(2);
    context_.randSeed(1);
#if KAGESEN_TRACE
    context_.traceEverOn(true);
#endif
    top_ = std::make_unique<Vshadow_bench>(&context_);
    probes_.find(context_);
    top_->s_bready_i = 1;
    top_->s_rready_i = 1;
    top_->rst_ni = 1;
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
    memories_.texels.drop();
    memories_.records.drop();
    top_->rst_ni = 1;
    cycle();
  }

  void clear() override {
    counter_.events = Events{};
    for (PassCycles& c : cycles_) c = PassCycles{};
    memories_.texels.clear();
    memories_.records.clear();
    probes_.clear();
  }
  void set_timing(const Timing& timing) override {
    timing_ = timing;
    stuck_after_ = kStuck + ReadTiming::longest_delay(timing);
    passes_.fill(0);
    memories_.configure(timing);
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

  bool wipe() override { return run(Pass::kWipe, 0, Nothing{}); }
  bool settle() override { return run(Pass::kSettle, 0, Nothing{}); }
  bool draw(const Triangle* beats, std::size_t count, std::uint64_t* taken) override {
    std::uint32_t items = 0;
    for (std::size_t i = 0; i < count; ++i) items += !beats[i].is_plane;
    return run(Pass::kDraw, items, Triangles{beats, count, taken});
  }
  bool announce(const Fragment* fragments, std::size_t count) override {
    return run(Pass::kAnnounce, static_cast<std::uint32_t>(count),
               Fragments{fragments, count, 1, nullptr, nullptr});
  }
  bool decide(const Fragment* fragments, std::size_t count, Verdict* verdicts,
              FragmentCycles* cycles) override {
    return run(Pass::kDecide, static_cast<std::uint32_t>(count),
               Fragments{fragments, count, kLanes, verdicts, cycles});
  }
  void cut_next_pass(Cut how, std::uint64_t after_cycles) override {
    cut_ = true;
    cut_how_ = how;
    cut_after_ = after_cycles;
  }

  const Events& events() const override { return counter_.events; }
  const PassCycles& cycles(Pass pass) const override { return cycles_[std::size_t(pass)]; }
  std::vector<QueueCycles> queues(Pass pass) const override { return probes_.queues(pass); }
  std::vector<CacheCounts> caches(Pass pass) override {
    return memories_.caches(pass, probes_.lookups(pass));
  }
  std::uint64_t texel_reads(Pass pass) const override { return memories_.texels.reads(pass); }
  std::uint64_t slb_reads(Pass pass) const override { return memories_.records.reads(pass); }
  std::uint64_t now() const override { return now_; }
  std::uint64_t pass_began() const override { return pass_first_; }
  MemoryWords texel_memory() const override {
    return {memories_.texels.memory.words(), TexelMemory::kStride, widths::texel_wr_data_o,
            TexelMemory::kCount};
  }
  MemoryWords slb_memory() const override {
    return {memories_.records.memory.words(), SlbMemory::kStride, widths::slb_wr_data_o,
            SlbMemory::kCount};
  }
  void record(Timeline* timeline) override {
    timeline_ = timeline;
    memories_.texels.trace(timeline);
    memories_.records.trace(timeline);
    probes_.trace(timeline);
  }
  void trace(const char* path, std::uint64_t first, std::uint64_t last) override {
    waves_.open(path, first, last);
  }
  void trace_pass(const char* path, Pass pass, std::uint64_t first, std::uint64_t last) override {
    waves_.open_in_pass(path, pass, first, last);
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
  template <typename Feed>
  bool run(Pass pass, std::uint32_t count, Feed feed) {
    write(Register::kCount, count);
    done_ = false;
    write(Register::kControl, static_cast<std::uint32_t>(pass));
    begin_timing(pass);
    Stage stage{*top_, stalls_, counter_.events, cycles_[std::size_t(pass)].items};
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
      stage.now = now_ - pass_first_;
      feed.offer(stage);
      low();
      if (feed.take(stage)) moved_ = now_;
      high();
      feed.edge(stage);
      check_progress();
    }
    close_streams();
    return !cutting;
  }

  /// The pass's first cycle is the second from now; what happens from it on is the pass's.
  void begin_timing(Pass pass) {
    pass_first_ = now_ + 1;
    moved_ = now_;
    const PassNumber number{static_cast<std::uint32_t>(pass), passes_[std::size_t(pass)]++};
    memories_.texels.begin_pass(pass, number, pass_first_);
    memories_.records.begin_pass(pass, number, pass_first_);
    stalls_.begin_pass(timing_, number);
    waves_.begin_pass(pass, cycles_[std::size_t(pass)].total, pass_first_);
    if (timeline_ == nullptr) return;
    const unsigned which = pass == Pass::kDraw ? 1 : pass == Pass::kDecide ? 2 : 0;
    timeline_->begin(which, cycles_[std::size_t(pass)].total);
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
  void check_progress() const {
    if (now_ - moved_ <= stuck_after_) return;
    throw Failure("the unit is stuck in pass " + std::to_string(top_->pass_o) +
                  ": nothing moved for " + std::to_string(stuck_after_) + " cycles up to cycle " +
                  std::to_string(now_) + "; " + channels_text(*top_, memories_, probes_));
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
    memories_.offer(now_, top);
    top.texel_wr_ready_i = !stalls_.at(now_ - pass_first_, Channel::kTexelWrites);
    top.slb_wr_ready_i = !stalls_.at(now_ - pass_first_, Channel::kSlbWrites);
    // Answers of registers. Not before a pass: when it begins must not depend on them.
    const std::uint32_t wait = timing_.stream_stall;
    top.s_bready_i = top.pass_o == 0 || answers_.below(100, 2 * now_) >= wait;
    top.s_rready_i = answers_.below(100, 2 * now_ + 1) >= wait;
    top.eval();
    waves_.dump(top, now_, 0);
  }

  /// Takes what the unit gives, and the clock edge.
  void high() {
    Vshadow_bench& top = *top_;
    if (memories_.take(now_, top)) moved_ = now_;
    account();
    const bool write_taken = top.s_awvalid_i && top.s_awready_o;
    top.clk_i = 1;
    top.eval();
    waves_.dump(top, now_, 1);
    ++now_;
    if (write_taken) top.s_awvalid_i = top.s_wvalid_i = 0;
    const std::string failure = take_failure();
    if (!failure.empty()) throw Failure("cycle " + std::to_string(now_ - 1) + ": " + failure);
  }

  void account() {
    Vshadow_bench& top = *top_;
    if (top.irq_o) done_ = true;
    const auto pass = static_cast<Pass>(top.pass_o);
    counter_.note_records(top.records_o, pass == Pass::kWipe);
    if (pass == Pass::kIdle || !top.rst_ni) return;
    PassCycles& cycles = cycles_[std::size_t(pass)];
    ++cycles.total;
    const Cycle at = now_ - pass_first_;
    probes_.sample(pass, at);
    if (pass == Pass::kDecide) {
      ++cycles.causes[field(top.cause2_o, 0, 4)];
      counter_.add_lanes(top);
    } else {
      ++cycles.causes[top.cause1_o];
      counter_.add_store(top);
    }
    if ((top.front_events_o | top.store_events_o) != 0) moved_ = now_;
    if (timeline_ != nullptr) note_causes(top, pass, at, *timeline_);
  }

  VerilatedContext context_;
  std::unique_ptr<Vshadow_bench> top_;
  Memories memories_;
  Probes probes_;
  EventCounter counter_;
  Waves waves_;
  Timing timing_;
  std::array<std::uint32_t, kPasses> passes_{};  // of each kind, since set_timing()
  StreamStalls stalls_;
  Chance answers_;

  Cycle now_ = 0, pass_first_ = 0;
  Cycle moved_ = 0;  // when anything did last
  Cycle stuck_after_ = kStuck;
  bool done_ = false, cut_ = false;
  Cut cut_how_ = Cut::kAbort;
  std::uint64_t cut_after_ = 0;
  PassCycles cycles_[kPasses];
  Timeline* timeline_ = nullptr;
};

}  // namespace
}  // namespace kagesen::bench

extern "C" __attribute__((visibility("default"))) kagesen::bench::Bench* kagesen_make_bench() {
  return new kagesen::bench::VerilatedBench();
}
