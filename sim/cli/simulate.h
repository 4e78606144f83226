#pragma once
/// One run of an engine over a trace, judged.
#include <functional>
#include <memory>
#include <string>

#include "model/engine.h"
#include "sim/report/run_result.h"

namespace kagesen {

/// Throws UserError with the nearest name when there is no such engine.
std::unique_ptr<Engine> make_engine(const std::string& name);

struct SimulateOptions {
  std::string engine = "golden";
  std::function<std::unique_ptr<Engine>(const std::string& name)> make = make_engine;
  bool reference = true;
  bool both_semantics = false;  ///< winding: verdicts in the other semantics even without reference
  bool equivalent_resolution = true;
  bool other_equivalent_resolution = false;  ///< in the other semantics too
  std::shared_ptr<ExactFrame> exact;         ///< for several runs over one trace; may be empty
  std::function<void(const std::string& stage, double done)> progress;  ///< may be empty
};

/// Both passes, the buffers, the counters and, unless switched off, the judgement. The winding
/// profile learns the fragments first, and is run a second time, in the other semantics, for the
/// judgement alone.
RunResult simulate(const Trace& trace, const UnitConfig& config, const SimulateOptions& options);

}  // namespace kagesen
