#pragma once
/// The frames of a soak: what is run, how, and what is held against golden.
///
/// Every second round is a frame of the set: each built-in scene at scales 1, 16 and 256 in both
/// profiles, full HD, pass 2 several times over. The others are stress cases and small scenes,
/// with capacities down to one record, passes in portions and frames cut short.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/cli/cycle_check.h"
#include "sim/cli/lock_step_check.h"
#include "testbench/verilator/lock_step.h"

namespace kagesen {

/// A frame to run, and how.
struct Round {
  std::string family;  ///< of the totals
  Trace trace;
  UnitConfig config;
  FrameSetup setup;
  std::size_t portions = 0;
  Timing timing;
  std::uint64_t cuts = 0, cut_seed = 0;  ///< frames cut short before it
  std::vector<Timing> again;             ///< pass 2 once more with each, in an order of its own
  std::uint64_t order_seed = 0;
};

struct RoundPlan {
  UnitConfig config;  ///< widths
  std::optional<Profile> profile;
  std::uint32_t image_width = 1920, image_height = 1080;  ///< of the set's frames
};

/// Everything about a round follows from plan, seed and number.
Round draw_round(const RoundPlan& plan, std::uint64_t seed, std::uint64_t number);

class RoundRunner {
 public:
  explicit RoundRunner(BuildKind kind);
  /// Builds what a profile needs, so that it is not counted as time spent.
  void prepare(const UnitConfig& config) { engine_->prepare(config); }
  /// `fragments` of the result counts every comparison of a verdict.
  LockStepResult run(const Round& round);
  std::vector<std::string> wave(const Round& round, const FirstDifference& first,
                                const std::string& path) const;

 private:
  void decide_again(const Round& round, LockStepResult& result);
  void check_registers(LockStepResult& result);
  void check_model(const Round& round, const Frame& frame, LockStepResult& result);

  std::unique_ptr<RtlEngine> engine_;
  SystemcEngine model_{{{}, true}};
  std::optional<CycleReport> cycles_;  // of the frame before: where cuts may fall
  Expected expected_;
};

std::uint64_t differences(const LockStepResult& result);

}  // namespace kagesen
