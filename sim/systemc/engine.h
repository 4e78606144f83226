#pragma once
/// The SystemC model as an engine. Golden's verdicts, buffers and counters; the Verilog's cycles.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/engine.h"
#include "sim/memory/timing.h"
#include "sim/common/timeline.h"

namespace kagesen {

namespace tlm_model {
class ShadowUnit;
}

struct SystemcOptions {
  /// How memories and streams behave; empty: as the configuration says.
  std::optional<Timing> timing;
  bool keep_cycles = false;  ///< of every fragment
  Timeline* timeline = nullptr;  ///< takes what pass 2 does
};

/// The modules are made when a frame needs them. The kernel never runs: time is what transactions
/// carry (docs/systemc.md).
class SystemcEngine : public Engine {
 public:
  explicit SystemcEngine(SystemcOptions options = {});
  ~SystemcEngine() override;

  std::string name() const override { return "systemc"; }
  void begin(const UnitConfig& config, const FrameSetup& setup) override;
  void announce(const Fragment* fragments, std::size_t count) override;
  void draw(const Caster* casters, std::size_t count) override;
  void decide(const Fragment* fragments, std::size_t count, Verdict* verdicts) override;
  MapContents contents() const override;
  UnitCounters counters() const override;
  std::optional<CycleReport> cycles() const override;
  /// Empty where pass 2 is not timed, too.
  const std::vector<FragmentCycles>& fragment_cycles() const override { return fragment_cycles_; }

  /// When each triangle was taken, pass 1's first cycle being 0; empty where cycles are not kept.
  const std::vector<std::uint64_t>& triangle_cycles() const { return triangle_cycles_; }

  /// For frames to come.
  void set_timing(const Timing& timing) { options_.timing = timing; }
 private:
  void release();

  SystemcOptions options_;
  Profile profile_ = Profile::kPaper;
  std::int64_t lanes_ = 0;
  std::unique_ptr<tlm_model::ShadowUnit> unit_;
  std::vector<FragmentCycles> fragment_cycles_;
  std::vector<std::uint64_t> triangle_cycles_;
};

std::unique_ptr<Engine> make_systemc_engine(SystemcOptions options = {});

}  // namespace kagesen
