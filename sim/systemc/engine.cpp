#include "sim/systemc/engine.h"

#include <mutex>

#include "sim/memory/configured_timing.h"
#include "sim/systemc/paper/shadow_unit.h"
#include "sim/systemc/winding/shadow_unit.h"
#include "traces/format/error.h"

/// The library asks for one, and for nothing of it: the kernel never runs.
int sc_main(int, char**) { return 0; }

namespace kagesen {
namespace {

/// SystemC knows one hierarchy a process: one thread at a time may change it.
std::mutex& hierarchy() {
  static std::mutex mutex;
  return mutex;
}

std::unique_ptr<tlm_model::ShadowUnit> make_unit(Profile profile, std::int64_t lanes) {
  const char* name = sc_core::sc_gen_unique_name("shadow_unit");
  if (profile == Profile::kPaper) {
    return std::make_unique<tlm_model::paper::PaperUnit>(name, static_cast<unsigned>(lanes));
  }
  return std::make_unique<tlm_model::winding::WindingUnit>(name, static_cast<unsigned>(lanes));
}

}  // namespace

SystemcEngine::SystemcEngine(SystemcOptions options) : options_(std::move(options)) {}

SystemcEngine::~SystemcEngine() { release(); }

void SystemcEngine::release() {
  const std::lock_guard<std::mutex> lock(hierarchy());
  unit_.reset();
}

void SystemcEngine::begin(const UnitConfig& config, const FrameSetup& setup) {
  if (!unit_ || profile_ != config.profile || lanes_ != config.lanes) {
    release();
    const std::lock_guard<std::mutex> lock(hierarchy());
    unit_ = make_unit(config.profile, config.lanes);
    profile_ = config.profile;
    lanes_ = config.lanes;
    unit_->trace(options_.timeline);
  }
  fragment_cycles_.clear();
  triangle_cycles_.clear();
  unit_->begin(config, setup, options_.timing.value_or(configured_timing(config)));
}

void SystemcEngine::announce(const Fragment* fragments, std::size_t count) {
  unit_->announce(fragments, count);
}
void SystemcEngine::draw(const Caster* casters, std::size_t count) {
  const Cycle before = unit_->drawn();
  unit_->draw(casters, count);
  if (!options_.keep_cycles) return;
  for (const Cycle taken : unit_->taken()) triangle_cycles_.push_back(before + taken);
}

void SystemcEngine::decide(const Fragment* fragments, std::size_t count, Verdict* verdicts) {
  FragmentCycles* cycles = nullptr;
  if (options_.keep_cycles) {
    const std::size_t before = fragment_cycles_.size();
    fragment_cycles_.resize(before + count);
    cycles = fragment_cycles_.data() + before;
  }
  const std::optional<PassCycles> before = unit_->cycles().pass2;
  unit_->decide(fragments, count, verdicts, cycles);
  if (!unit_->cycles().pass2) {
    fragment_cycles_.clear();
    return;
  }
  for (std::size_t i = 0; cycles && i < count; ++i) {
    cycles[i].accepted += before->total;
    cycles[i].retired += before->total;
  }
}

MapContents SystemcEngine::contents() const { return unit_->golden().contents(); }
UnitCounters SystemcEngine::counters() const { return unit_->golden().counters(); }
std::optional<CycleReport> SystemcEngine::cycles() const { return unit_->cycles(); }

std::unique_ptr<Engine> make_systemc_engine(SystemcOptions options) {
  return std::make_unique<SystemcEngine>(std::move(options));
}

}  // namespace kagesen
