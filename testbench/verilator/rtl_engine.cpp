#include "testbench/verilator/rtl_engine.h"

#include <map>
#include <mutex>

#include "model/cycle_causes.h"
#include "model/golden.h"
#include "model/stored_figures.h"
#include "sim/memory/configured_timing.h"
#include "testbench/verilator/package.h"
#include "testbench/verilator/rtl_contents.h"

namespace kagesen {
namespace {

using bench::Pass;
using bench::Register;

/// Benches that no engine uses: making one costs more than many a frame.
class Pool {
 public:
  std::unique_ptr<bench::Bench> take(const UnitConfig& config, const RtlOptions& options,
                                     const std::string& built) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto found = free_.find(built);
      if (found != free_.end()) {
        std::unique_ptr<bench::Bench> bench = std::move(found->second);
        free_.erase(found);
        bench->reset();  // whatever it was left in
        return bench;
      }
    }
    return make_bench(config, options.kind, options.replaced);
  }
  void give(const std::string& built, std::unique_ptr<bench::Bench> bench) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (free_.size() < kMost) free_.emplace(built, std::move(bench));
  }

 private:
  static constexpr std::size_t kMost = 8;
  std::mutex mutex_;
  std::multimap<std::string, std::unique_ptr<bench::Bench>> free_;
};

/// Never destroyed: a model outlives what its shared object keeps for it at the program's end.
Pool& pool() {
  static Pool& pool = *new Pool;
  return pool;
}

std::uint32_t policy_of(const UnitConfig& c) {
  std::uint32_t bits = 0;
  if (c.profile == Profile::kWinding) {
    const bool flags[] = {c.semantics == Semantics::kPaper,
                          c.skip_receiver_mask,
                          c.skip_first_test,
                          c.skip_tiles,
                          c.skip_edges,
                          c.skip_fragments};
    for (unsigned i = 0; i < 6; ++i) bits |= std::uint32_t{flags[i]} << i;
    return bits;
  }
  bits |= std::uint32_t{c.own_id_rule == OwnIdRule::kLiteral} << 0;
  bits |= std::uint32_t{c.vertex_rule == VertexRule::kPerEntry} << 1;
  bits |= std::uint32_t{c.table7 == Table7::kPrinted} << 2;
  bits |= std::uint32_t{c.depth_writes == DepthWrites::kAll} << 3;
  bits |= static_cast<std::uint32_t>(c.hidden_removal) << 4;
  bits |= std::uint32_t{c.match_polygon_id} << 6;
  return bits;
}

bench::Triangle beat_of(const Caster& caster) {
  bench::Triangle beat{};
  for (int i = 0; i < 3; ++i) {
    beat.x[i] = caster.vertex[i].x;
    beat.y[i] = caster.vertex[i].y;
    beat.z[i] = caster.vertex[i].z;
  }
  return beat;
}

std::uint64_t bytes_of(std::uint64_t words, const bench::MemoryWords& memory) {
  return words * ((memory.bits + 7) / 8);
}

template <std::size_t kNames>
PassCycles pass_cycles(bench::Bench& bench, Pass pass, const char* const (&names)[kNames]) {
  const bench::PassCycles& of = bench.cycles(pass);
  PassCycles out;
  out.queues = bench.queues(pass);
  out.caches = bench.caches(pass);
  MemoryTraffic& traffic = out.traffic.emplace();
  traffic.texel_reads = bench.texel_reads(pass);
  traffic.texel_bytes = bytes_of(traffic.texel_reads, bench.texel_memory());
  traffic.slb_reads = bench.slb_reads(pass);
  traffic.slb_bytes = bytes_of(traffic.slb_reads, bench.slb_memory());
  out.total = of.total;
  out.items = of.items;
  std::uint64_t unknown = 0;
  for (std::size_t i = 0; i < bench::kCauses; ++i) {
    if (i < kNames) {
      out.causes.emplace_back(names[i], of.causes[i]);
    } else {
      unknown += of.causes[i];
    }
  }
  if (unknown > 0) out.causes.emplace_back("unknown", unknown);
  return out;
}

}  // namespace

RtlEngine::~RtlEngine() { release(); }

void RtlEngine::release() {
  if (bench_) bench_->record(nullptr);
  if (bench_) pool().give(built_, std::move(bench_));
}

bench::Bench& RtlEngine::prepare(const UnitConfig& config) {
  std::string wanted = shadow_package(config) + std::to_string(static_cast<int>(options_.kind));
  for (const SourceText& source : options_.replaced) wanted += source.text;
  if (!bench_ || wanted != built_) {
    release();
    built_ = wanted;
    bench_ = pool().take(config, options_, built_);
  }
  return *bench_;
}

void RtlEngine::begin(const UnitConfig& config, const FrameSetup& setup) {
  prepare(config);
  config_ = config;
  setup_ = setup;
  drawn_ = decided_ = 0;
  settled_ = true;
  fragment_cycles_.clear();
  triangle_cycles_.clear();
  bench_->set_timing(options_.timing.value_or(configured_timing(config)));
  bench_->clear();
  bench_->record(options_.timeline);
  write_settings(config, setup);
  cut_ = !bench_->wipe();
}

void RtlEngine::write_settings(const UnitConfig& c, const FrameSetup& setup) {
  const bool winding = c.profile == Profile::kWinding;
  const auto put = [&](Register at, std::int64_t value) {
    bench_->write(at, static_cast<std::uint32_t>(value));
  };
  put(Register::kFractionBits, setup.fraction_bits);
  put(Register::kMapWidth, c.map_width);
  put(Register::kMapHeight, c.map_height);
  put(Register::kPitchLog2, bits_for(static_cast<std::uint64_t>((c.map_width + 3) / 4)));
  put(Register::kBucketsLog2, bits_for(static_cast<std::uint64_t>(c.slb_buckets)));
  put(Register::kRecordLimit, winding ? c.cluster_records : c.slb_entries);
  put(Register::kChainLimit, winding ? c.chain_records : c.link_depth);
  put(Register::kPlaneTolerance, c.plane_tolerance);
  put(Register::kPolicy, policy_of(c));
}

std::uint32_t RtlEngine::unit_id(std::uint32_t object) const {
  if (config_.profile == Profile::kWinding && config_.semantics == Semantics::kPhysical) return 0;
  return object < setup_.unit_ids.size() ? setup_.unit_ids[object]
                                         : object & ((1u << config_.id_bits) - 1);
}

std::vector<bench::Fragment> RtlEngine::beats_of(const Fragment* fragments,
                                                 std::size_t count) const {
  const bool skips = config_.profile == Profile::kWinding && config_.skip_fragments;
  std::vector<bench::Fragment> beats(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Fragment& f = fragments[i];
    bench::Fragment& beat = beats[i];
    beat.x = f.position.x;
    beat.y = f.position.y;
    beat.z = f.position.z;
    beat.object = unit_id(f.object);
    beat.averted = (f.flags & Fragment::kAverted) != 0;
    beat.outside = (f.flags & Fragment::kOutside) != 0;
    beat.unshadowable =
        skips && f.object < setup_.unshadowable.size() && setup_.unshadowable[f.object] != 0;
  }
  return beats;
}

void RtlEngine::announce(const Fragment* fragments, std::size_t count) {
  if (cut_ || config_.profile != Profile::kWinding || !config_.skip_receiver_mask) return;
  const std::vector<bench::Fragment> beats = beats_of(fragments, count);
  cut_ = !bench_->announce(beats.data(), beats.size());
}

void RtlEngine::draw(const Caster* casters, std::size_t count) {
  if (cut_) return;
  settled_ = false;
  std::vector<bench::Triangle> beats;
  beats.reserve(count);
  for (std::size_t i = 0; i < count; ++i, ++drawn_) {
    const Facet hint = drawn_ < setup_.facets.size() ? setup_.facets[drawn_] : Facet{};
    const bool shares = hint.plane != Facet::kOwnPlane;
    if (shares) {
      beats.push_back(beat_of(setup_.planes[hint.plane]));
      beats.back().is_plane = true;
    }
    bench::Triangle beat = beat_of(casters[i]);
    beat.object = unit_id(casters[i].object);
    beat.polygon = casters[i].polygon;
    beat.inner = hint.inner_edges;
    beat.shares = shares;
    beats.push_back(beat);
  }
  std::uint64_t* taken = nullptr;
  if (options_.keep_cycles) {
    triangle_cycles_.resize(drawn_);
    taken = triangle_cycles_.data() + drawn_ - count;
  }
  const std::uint64_t before = bench_->cycles(Pass::kDraw).total;
  cut_ = !bench_->draw(beats.data(), beats.size(), taken);
  for (std::size_t i = 0; taken && i < count; ++i) taken[i] += before;
}

void RtlEngine::settle() const {
  if (settled_ || cut_) return;
  settled_ = true;
  cut_ = !bench_->settle();
}

void RtlEngine::decide(const Fragment* fragments, std::size_t count, Verdict* verdicts) {
  settle();
  if (cut_) return;
  const std::vector<bench::Fragment> beats = beats_of(fragments, count);
  std::vector<bench::Verdict> answers(count);
  FragmentCycles* cycles = nullptr;
  if (options_.keep_cycles) {
    fragment_cycles_.resize(decided_ + count);
    cycles = fragment_cycles_.data() + decided_;
  }
  decided_before_ = bench_->cycles(Pass::kDecide).total;
  cut_ = !bench_->decide(beats.data(), beats.size(), answers.data(), cycles);
  for (std::size_t i = 0; cycles && i < count; ++i) {
    cycles[i].accepted += decided_before_;
    cycles[i].retired += decided_before_;
  }
  decided_ += count;
  for (std::size_t i = 0; i < count; ++i) {
    verdicts[i] = answers[i].dark ? Verdict::kDark : Verdict::kLit;
  }
}

MapContents RtlEngine::contents() const {
  settle();
  return rtl_contents(config_, bench_->texel_memory(), bench_->slb_memory());
}

UnitCounters RtlEngine::counters() const {
  settle();
  const bench::Events& e = bench_->events();
  UnitCounters c;
  c.casters = e.casters;
  c.edges = e.edges;
  c.edge_texels = e.edge_texels;
  c.span_texels = e.span_texels;
  c.lines_stored = e.lines_stored;
  c.lines_cancelled = e.lines_cancelled;
  c.lines_hidden = e.lines_hidden;
  c.emptied_covered = e.emptied_covered;
  c.peak_entries = e.peak_records;
  c.overflow_lines = e.overflow_lines;
  c.overflow_texels = e.overflow_texels;
  for (const auto& of : e.verdicts) {
    for (const std::uint64_t count : of) c.fragments += count;
  }
  c.averted = e.verdicts[1][bench::kByDefinition];
  c.outside = e.verdicts[0][bench::kByOutside];
  c.dark_by_lines = e.verdicts[1][bench::kByLines];
  c.dark_by_buffer = e.verdicts[1][bench::kByBuffer] + e.verdicts[1][bench::kByTile];
  c.lit = c.fragments - c.averted - c.outside - c.dark_by_lines - c.dark_by_buffer;
  c.slb_lookups = e.slb_lookups;
  c.entries_read = e.entries_read;
  c.lines_read = e.lines_read;
  c.skips.texel_visits = e.texel_visits;
  c.skips.masked_visits = e.masked_visits;
  c.skips.hidden_visits = e.hidden_visits;
  c.skips.inner_edge_texels = e.inner_texels;
  c.skips.cleared_texels = 64 * e.tiles_touched;
  c.skips.known_fragments = e.known;
  c.skips.tile_lit = e.tile_lit;
  c.skips.tile_dark = e.tile_dark;
  c.skips.texel_lookups = e.texel_lookups;
  c.skips.first_test_dark = e.first_test;
  add_stored_figures(config_, contents(), c);
  if (config_.profile == Profile::kPaper) {
    add_paper_bytes(config_, c);
  } else {
    add_winding_bytes(config_, setup_.fraction_bits, c);
  }
  return c;
}

std::optional<CycleReport> RtlEngine::cycles() const {
  settle();
  CycleReport report;
  report.clear = bench_->cycles(Pass::kWipe).total;
  report.announce = bench_->cycles(Pass::kAnnounce).total;
  report.settle = bench_->cycles(Pass::kSettle).total;
  report.pass1 = pass_cycles(*bench_, Pass::kDraw, kStoreCauses);
  report.edge_texels = bench_->events().edge_texels;
  report.span_texels = bench_->events().span_texels;
  report.pass1->items = report.edge_texels + report.span_texels;
  report.pass2 = pass_cycles(*bench_, Pass::kDecide, kLaneCauses);
  return report;
}

std::unique_ptr<Engine> make_rtl_engine(RtlOptions options) {
  return std::make_unique<RtlEngine>(std::move(options));
}

}  // namespace kagesen
