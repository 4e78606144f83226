#pragma once
/// One run of an engine over a trace, judged.
#include <functional>
#include <memory>
#include <string>

#include "model/engine.h"
#include "sim/report/run_result.h"

namespace kagesen {

struct SimulateOptions {
  std::string engine = "golden";
  bool reference = true;
  bool equivalent_resolution = true;
  std::function<void(const std::string& stage, double done)> progress;  ///< may be empty
};

/// Throws UserError with the nearest name when there is no such engine.
std::unique_ptr<Engine> make_engine(const std::string& name);

/// Both passes, the buffers, the counters and, unless switched off, the judgement.
RunResult simulate(const Trace& trace, const UnitConfig& config, const SimulateOptions& options);

}  // namespace kagesen
