#pragma once
/// report.json (docs/report.schema.json). Keys are stable; a figure that was not computed is
/// absent.
#include <nlohmann/json.hpp>

#include "sim/report/run_result.h"

namespace kagesen {

inline constexpr int kReportSchemaVersion = 1;

nlohmann::ordered_json report_json(const Trace& trace, const RunResult& result);

/// Configuration fields with their own types: integers, strings, booleans.
nlohmann::ordered_json config_json(const UnitConfig& config);

}  // namespace kagesen
