#include <algorithm>
#include <limits>

#include "model/frame_setup.h"
#include "sim/cli/results/winding.h"
#include "sim/cli/simulate.h"
#include "sim/cli/stopwatch.h"

namespace kagesen {
namespace {

constexpr int kTimedRuns = 5;
constexpr std::array kBothSemantics{Semantics::kPaper, Semantics::kPhysical};
constexpr std::uint32_t kFirstTestSides[] = {1024, 2048};  // as in Mizokuchi and Tokuyoshi

std::vector<std::string> skip_keys() {
  std::vector<std::string> keys;
  for (const ConfigField& field : config_fields()) {
    if (field.key.rfind("skip_", 0) == 0) keys.push_back(field.key);
  }
  return keys;
}

/// The unit alone, frame after frame, as a renderer would have it run: its engine is kept.
class UnitAlone {
 public:
  UnitAlone(const Trace& trace, const UnitConfig& config)
      : trace_(trace), config_(config), setup_(make_frame_setup(trace, config)) {}

  /// Seconds of clearing, announcing and both passes.
  double run() {
    const std::vector<Fragment>& fragments = trace_.all_fragments;
    verdicts_.resize(fragments.size());
    Stopwatch watch;
    engine_->begin(config_, setup_);
    engine_->announce(fragments.data(), fragments.size());
    engine_->draw(trace_.all_casters.data(), trace_.all_casters.size());
    engine_->decide(fragments.data(), fragments.size(), verdicts_.data());
    return watch.lap();
  }
  const std::vector<Verdict>& verdicts() const { return verdicts_; }
  UnitCounters counters() const { return engine_->counters(); }

 private:
  const Trace& trace_;
  const UnitConfig config_;
  const FrameSetup setup_;
  const std::unique_ptr<Engine> engine_ = make_golden_engine();
  std::vector<Verdict> verdicts_;
};

std::uint64_t total_bytes(const Trace& trace, const UnitConfig& config) {
  UnitAlone unit(trace, config);
  unit.run();
  const UnitCounters counters = unit.counters();
  return counters.map_bytes + counters.allocated_bytes;
}

class SkipMeasurement {
 public:
  SkipMeasurement(const Trace& trace, Semantics semantics, const Report& report)
      : trace_(trace), config_(winding_unit(semantics)), report_(report) {}

  SkipUse run() {
    time_all_and_none();
    for (const std::string& key : keys_) {
      show("one skip off");
      UnitConfig config = config_;
      set_field(config, key, "false");
      UnitAlone unit(trace_, config);
      unit.run();
      compare(unit);
    }
    return out_;
  }

 private:
  void time_all_and_none() {
    UnitConfig none = config_;
    for (const std::string& key : keys_) set_field(none, key, "false");
    UnitAlone with(trace_, config_), without(trace_, none);
    out_.on_s = out_.off_s = std::numeric_limits<double>::infinity();
    // By turns, so that what else the machine does falls on both.
    for (int i = 0; i < kTimedRuns; ++i) {
      show("all skips and none");
      out_.on_s = std::min(out_.on_s, with.run());
      out_.off_s = std::min(out_.off_s, without.run());
    }
    expected_ = with.verdicts();
    compare(without);
    out_.counters = with.counters();
    out_.map_texels = static_cast<std::uint64_t>(config_.map_width * config_.map_height);
  }

  void compare(const UnitAlone& unit) {
    out_.compared += expected_.size();
    for (std::size_t i = 0; i < expected_.size(); ++i) {
      out_.differing += unit.verdicts()[i] != expected_[i];
    }
  }

  void show(const char* stage) {
    if (report_) report_(stage, double(done_) / double(kTimedRuns + keys_.size()));
    ++done_;
  }

  const Trace& trace_;
  const UnitConfig config_;
  const Report& report_;
  const std::vector<std::string> keys_ = skip_keys();
  std::vector<Verdict> expected_;
  std::size_t done_ = 0;
  SkipUse out_;
};

}  // namespace

UnitConfig winding_unit(Semantics semantics) {
  UnitConfig config;
  config.profile = Profile::kWinding;
  config.semantics = semantics;
  return config;
}

WindingAccuracy winding_accuracy(const Trace& trace, unsigned scale,
                                 const std::shared_ptr<ExactFrame>& exact, const Report& report) {
  SimulateOptions options;
  options.other_equivalent_resolution = true;
  options.exact = exact;
  options.progress = report;
  const RunResult result = simulate(trace, winding_unit(Semantics::kPhysical), options);
  const Judgement& judgement = *result.judgement;
  WindingAccuracy out;
  out.scale = scale;
  out.errors = {judgement.paper, judgement.physical};
  out.equivalent = {judgement.other_equivalent_resolution, judgement.equivalent_resolution};
  return out;
}

WindingMemory winding_memory(const Trace& trace, unsigned scale, const Report& report) {
  WindingMemory out;
  out.scale = scale;
  for (const Semantics semantics : kBothSemantics) {
    if (report) report("memory", semantics == Semantics::kPaper ? 0 : 0.5);
    UnitConfig config = winding_unit(semantics);
    WindingMemory::Bytes& bytes = out.bytes.in(semantics);
    bytes.with_mask = total_bytes(trace, config);
    config.skip_receiver_mask = false;
    bytes.without_mask = total_bytes(trace, config);
  }
  return out;
}

InBoth<SkipUse> winding_skips(const Trace& trace, const Report& report) {
  InBoth<SkipUse> out;
  for (const Semantics semantics : kBothSemantics) {
    out.in(semantics) = SkipMeasurement(trace, semantics, report).run();
  }
  return out;
}

std::vector<FirstTest> first_tests(const Scene& scene, CaptureOptions capturing,
                                   const Report& report) {
  std::vector<FirstTest> tests;
  for (const std::uint32_t side : kFirstTestSides) {
    if (report) report("conservative first test", double(tests.size()) / 2);
    capturing.map_width = capturing.map_height = side;
    Trace trace;
    capture(scene, capturing, trace);
    UnitConfig config;
    config.map_width = config.map_height = side;
    tests.push_back({side, reduction_rates(trace, config, Semantics::kPhysical)});
  }
  return tests;
}

}  // namespace kagesen
