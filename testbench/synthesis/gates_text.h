#pragma once
/// A gate report as JSON and as tables.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "testbench/synthesis/gates.h"

namespace kagesen {

nlohmann::ordered_json gates_json(const GateReport& report);
/// Of what gates_json() wrote; throws what nlohmann::json throws where it did not.
GateReport gates_from_json(const nlohmann::ordered_json& json);
std::string gates_table(const GateReport& report);
/// The longest paths, of each end its own.
std::string paths_table(const GateReport& report, std::size_t most);

/// One value of one parameter.
struct SweepRow {
  std::string key, value;
  bool standard = false;  ///< the configuration's own value
  GateReport report;
};
std::string sweep_table(const std::vector<SweepRow>& rows);
/// docs/gates.md: how it is measured, and the tables.
struct GatesPage {
  std::vector<GateReport> profiles, other_library;
  std::vector<SweepRow> sweep;  ///< may be empty
};
std::string gates_page(const GatesPage& page, const std::string& command);

nlohmann::ordered_json sweep_json(const std::vector<SweepRow>& rows);

}  // namespace kagesen
