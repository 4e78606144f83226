#include "testbench/mutation/netlist.h"

#include <fmt/format.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "testbench/mutation/care.h"
#include "testbench/mutation/unit_recording.h"
#include "testbench/synthesis/cell_library.h"
#include "testbench/synthesis/gates.h"
#include "testbench/tools/cache.h"
#include "testbench/tools/process.h"
#include "testbench/tools/rtl_sources.h"
#include "testbench/tools/template.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

using Tell = std::function<void(const std::string&)>;

void run_or_throw(const std::string& what, const std::vector<std::string>& command,
                  const fs::path& folder, const std::string& log_name) {
  const std::string log = (folder / log_name).string();
  if (run_process(command, folder.string(), log, 1800).status != 0)
    throw UserError(what, "failed", "see " + log);
}

/// A constant of Verilog with ones where pin `name` stands in the outputs; none if it is empty.
std::string ones_at(const Recording& recording, const std::string& name) {
  std::string bits;
  for (const Recording::Pin& pin : recording.outputs)
    bits.append(pin.width, pin.name == name ? '1' : '0');
  return fmt::format("{}'b{}", bits.size(), bits);
}

/// Icarus plays the recording to the netlist in `gates.folder`.
/// @param partial  an output that may hold undefined bits; or empty
NetlistRun play(const std::string& name, const Recording& recording, const Qualifiers& qualifiers,
                const std::string& partial, const GateReport& gates, std::size_t beats,
                const Tell& tell) {
  if (!gates.unmapped.empty()) throw UserError(name, "has unmapped cells", "see " + gates.folder);
  const fs::path folder = cache_folder() / "netlist" / name;
  fs::create_directories(folder);
  write_vectors(recording, qualifiers, beats, folder / "vectors.txt");
  const std::string script = read_file(source_folder() + "/testbench/synthesis/player.v.in");
  const std::string connections = (recording.clocked ? "    .clk_i(clk),\n" : "") +
                                  pin_connections(recording, "in", "got", "run");
  write_file(
      folder / "player.v",
      fill_template(script, {{"TOP", recording.top},
                             {"CONNECTIONS", connections},
                             {"PARTIAL", ones_at(recording, partial)},
                             {"IN_HIGH", std::to_string(total_width(recording.inputs) - 1)},
                             {"OUT_HIGH", std::to_string(total_width(recording.outputs) - 1)}}));
  tell("Icarus compiles");
  run_or_throw("Icarus Verilog on " + name,
               {find_tool("iverilog", "iverilog"), "-g2012", "-s", "player", "-o", "player.vvp",
                "player.v", gates.folder + "/netlist.v", find_cell_library(gates.library).models,
                source_folder() + "/testbench/synthesis/ram_1r1w.v"},
               folder, "iverilog.log");
  tell("Icarus plays");
  run_or_throw("Icarus Verilog on " + name, {find_tool("vvp", "iverilog"), "-n", "player.vvp"},
               folder, "player.log");
  NetlistRun run;
  run.log = (folder / "player.log").string();
  const std::string text = read_file(run.log);
  std::smatch found;
  if (!std::regex_search(text, found, std::regex("PLAYED (\\d+) WRONG (\\d+)"))) {
    throw UserError("Icarus Verilog on " + name, "ended early", "see " + run.log);
  }
  run.beats = std::stoul(found[1]);
  run.wrong = std::stoul(found[2]);
  return run;
}

}  // namespace

NetlistRun run_netlist(const MutationBlock& block, const std::string& library, std::size_t beats,
                       const Tell& progress) {
  const auto tell = [&](const std::string& stage) {
    if (progress) progress(block.name + ": " + stage);
  };
  tell("recording " + block.test);
  const Recording recording = record(block);
  GateOptions options;
  options.library = library;
  options.top = recording.top;
  options.parameters = recording.parameters;
  if (!recording.package.empty()) options.sources.push_back(recording.package);
  for (const std::string& file : recording.sources) {
    if (file != ram_file()) options.sources.push_back(file);
  }
  const GateReport gates = measure_gates(UnitConfig{}, options, tell);
  return play(block.name, recording, block.qualifiers, "", gates, beats, tell);
}

NetlistRun run_unit_netlist(const UnitConfig& config, const std::string& library, std::size_t beats,
                            const Tell& progress) {
  const auto tell = [&](const std::string& stage) {
    if (progress) progress("unit: " + stage);
  };
  tell("recording");
  const Recording recording = record_unit(config, beats);
  GateOptions options;
  options.library = library;
  const GateReport gates = measure_gates(config, options, tell);
  // What happens to a cycle of a lane is told of pass 2 alone (docs/rtl.md).
  const Qualifiers qualifiers{{"lane_cause_o", "pass_o=5"}};
  return play("unit_" + get_field(config, "profile"), recording, qualifiers, "slb_wr_data_o", gates,
              beats, tell);  // a record's lines that are not in use
}

}  // namespace kagesen
