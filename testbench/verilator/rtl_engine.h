#pragma once
/// The Verilated unit as an engine.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/engine.h"
#include "testbench/verilator/build.h"

namespace kagesen {

struct RtlOptions {
  BuildKind kind = BuildKind::kFast;
  /// How memories and streams behave; empty: as the configuration says.
  std::optional<Timing> timing;
  bool keep_cycles = false;  ///< of every fragment
  Timeline* timeline = nullptr;  ///< takes what the unit does in its pass
  std::vector<SourceText>
      replaced;  ///< sources of the bench, instead of the program's own or beside
};

/// Frames follow each other without a reset. The bench is built when a frame needs it, and goes
/// back to a pool with the engine.
class RtlEngine : public Engine {
 public:
  explicit RtlEngine(RtlOptions options) : options_(std::move(options)) {}
  ~RtlEngine() override;

  std::string name() const override { return "rtl"; }
  void begin(const UnitConfig& config, const FrameSetup& setup) override;
  void announce(const Fragment* fragments, std::size_t count) override;
  void draw(const Caster* casters, std::size_t count) override;
  void decide(const Fragment* fragments, std::size_t count, Verdict* verdicts) override;
  MapContents contents() const override;
  UnitCounters counters() const override;
  std::optional<CycleReport> cycles() const override;
  const std::vector<FragmentCycles>& fragment_cycles() const override { return fragment_cycles_; }

  /// When each triangle was taken, pass 1's first cycle being 0; empty where cycles are not kept.
  const std::vector<std::uint64_t>& triangle_cycles() const { return triangle_cycles_; }

  /// For frames to come.
  void set_timing(const Timing& timing) { options_.timing = timing; }
  /// Gets the bench ready before a frame begins.
  bench::Bench& prepare(const UnitConfig& config);
  /// @pre prepare() or begin() was called
  bench::Bench& bench() const { return *bench_; }
  /// Was a pass of this frame cut short? Then the frame has to begin again.
  bool cut() const { return cut_; }
  /// Cycles of pass 2 before the last decide().
  std::uint64_t decided_before() const { return decided_before_; }
  /// Ends pass 1, as decide() and contents() do.
  void settle() const;

 private:
  void release();
  void write_settings(const UnitConfig& config, const FrameSetup& setup);
  std::uint32_t unit_id(std::uint32_t object) const;
  std::vector<bench::Fragment> beats_of(const Fragment* fragments, std::size_t count) const;

  RtlOptions options_;
  std::string built_;  ///< what the bench is a build of
  std::unique_ptr<bench::Bench> bench_;
  UnitConfig config_;
  FrameSetup setup_;
  std::uint64_t drawn_ = 0, decided_ = 0;
  std::uint64_t decided_before_ = 0;
  mutable bool settled_ = true, cut_ = false;
  std::vector<FragmentCycles> fragment_cycles_;
  std::vector<std::uint64_t> triangle_cycles_;
};

std::unique_ptr<Engine> make_rtl_engine(RtlOptions options = {});

}  // namespace kagesen
