#include "testbench/synthesis/gates.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <regex>

#include "testbench/synthesis/cell_library.h"
#include "testbench/synthesis/fanout.h"
#include "testbench/synthesis/gates_text.h"
#include "testbench/synthesis/netlist_areas.h"
#include "testbench/synthesis/timing.h"
#include "testbench/tools/cache.h"
#include "testbench/tools/process.h"
#include "testbench/tools/rtl_sources.h"
#include "testbench/tools/template.h"
#include "testbench/verilator/package.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

constexpr double kYosysLimitS = 3600;

struct Inputs {
  CellLibrary library;
  std::vector<std::string> sources;
  std::string package, parameters, flow, abc, netlist, timing, yosys, sta, tools;
  std::string key() const;
  std::string script_hash() const {
    return ContentKey()
        .add("flow", flow)
        .add("abc", abc)
        .add("netlist", netlist)
        .add("timing", timing)
        .hex()
        .substr(0, 12);
  }
};

std::string Inputs::key() const {
  ContentKey key;
  key.add("version", "2").add("package", package).add("scripts", script_hash()).add("tools", tools);
  key.add("parameters", parameters);
  key.add("liberty", read_file(library.liberty)).add("ram", read_file(ram_file()));
  key.add("assumed", fmt::format("{} {} {}", kRamAccessNs, kRamSetupNs, kTargetMhz));
  key.add("fanout", fmt::format("{} {} {}", kMostReaders, kMostBuffered, kMostBuffers));
  for (const std::string& file : sources) key.add("source", read_file(file));
  return key.hex();
}

Inputs inputs_of(const UnitConfig& config, const GateOptions& options) {
  const std::string scripts = source_folder() + "/testbench/synthesis/";
  Inputs in;
  in.library = find_cell_library(options.library);
  in.yosys = find_tool("yosys", "yosys");
  in.sta = find_tool("sta", "opensta");
  find_tool("berkeley-abc", "berkeley-abc");
  in.tools = fmt::format("{}; OpenSTA {}", tool_version(in.yosys, {"-V"}),
                         tool_version(in.sta, {"-version"}));
  in.sources = options.sources;
  if (in.sources.empty()) {
    in.package = with_package_sets(shadow_package(config), options.package_sets);
    in.sources = RtlSources(config.profile).of(options.top);
  }
  for (const auto& [name, value] : options.parameters) {
    in.parameters += fmt::format(" -chparam {} {}", name, value);
  }
  in.flow = fmt::format("# {}\n", options.top) + read_file(scripts + "synthesis.ys.in") +
            (options.flatten ? "# flattened\n" : "");
  in.abc = read_file(options.abc.empty() ? scripts + "abc.script" : options.abc);
  in.netlist = read_file(scripts + "netlist.ys");
  in.timing = read_file(scripts + "timing.tcl.in");
  return in;
}

/// The lines of a log that say what went wrong.
std::string errors_of(const std::string& log) {
  std::string found;
  static const std::regex line("\n((?:Warning: .*|.*ERROR.*))");
  const std::string text = read_file(log);
  for (std::sregex_iterator at(text.begin(), text.end(), line), end; at != end; ++at) {
    if ((*at)[1].str().find("ERROR") != std::string::npos || found.empty()) found = (*at)[1];
  }
  return found.empty() ? "it stopped without a word" : found;
}

void run_yosys(const Inputs& in, const GateOptions& options, const std::string& name,
               const std::string& script, CacheEntry& entry) {
  const auto folder = entry.folder();
  write_file(folder / (name + ".ys"), script);
  const std::string log = (folder / (name + ".log")).string();
  const ProcessResult result =
      run_process({in.yosys, name + ".ys"}, folder.string(), log, kYosysLimitS);
  if (result.status == 0) return;
  entry.keep_unfinished();
  throw UserError("Yosys on " + options.top, result.timed_out ? "took too long" : errors_of(log),
                  "see " + log);
}

/// Leaves netlist.json, with the hierarchy, and flat.json.
void map_to_cells(const Inputs& in, const GateOptions& options, CacheEntry& entry) {
  write_file(entry.folder() / "shadow_pkg.sv", in.package);
  write_file(entry.folder() / "abc.script", in.abc);
  const std::string sources =
      fmt::format("{} {}", in.package.empty() ? "" : "shadow_pkg.sv", fmt::join(in.sources, " "));
  run_yosys(in, options, "synthesis",
            fill_template(in.flow, {{"TOP", options.top},
                                    {"LIBERTY", in.library.liberty},
                                    {"INCLUDE", common_folder()},
                                    {"RAM", ram_file()},
                                    {"SOURCES", sources},
                                    {"FLATTEN", options.flatten ? "flatten" : ""},
                                    {"PARAMETERS", in.parameters},
                                    {"ABC", "abc.script"},
                                    {"PERIOD_PS", fmt::format("{:.0f}", 1e6 / kTargetMhz)}}),
            entry);
}

/// Leaves netlist.v, and ports_split.v for OpenSTA. Returns how many buffers it has put in.
std::size_t write_netlist(const Inputs& in, const GateOptions& options, CacheEntry& entry) {
  std::string design = read_file(entry.folder() / "flat.json");
  const std::size_t buffers = buffer_fanout(options.top, design);
  write_file(entry.folder() / "buffered.json", design);
  run_yosys(in, options, "netlist", in.netlist, entry);
  for (const char* name : {"flat.json", "buffered.json"}) {
    std::filesystem::remove(entry.folder() / name);
  }
  return buffers;
}

}  // namespace

GateReport measure_gates(const UnitConfig& config, const GateOptions& options,
                         const std::function<void(const std::string&)>& progress) {
  const Inputs in = inputs_of(config, options);
  CacheEntry entry("gates", in.key());
  const auto report_file = [&] { return entry.folder() / "report.json"; };
  if (!entry.complete()) {
    if (progress) progress("Yosys maps " + options.top);
    map_to_cells(in, options, entry);
    GateReport report;
    report.top = options.top;
    report.library = options.library;
    report.nand2_area = in.library.nand2_area;
    report.tools = in.tools;
    report.scripts = in.script_hash();
    report.flattened = options.flatten;
    add_areas(read_file(entry.folder() / "netlist.json"), options.top, in.library, report);
    std::filesystem::remove(entry.folder() / "netlist.json");
    report.buffers = write_netlist(in, options, entry);
    report.buffer_ge = static_cast<double>(report.buffers) * in.library.areas.at(kFanoutBuffer) /
                       in.library.nand2_area;
    report.total_ge += report.buffer_ge;
    report.cells += report.buffers;
    entry.keep_unfinished();  // for whoever has to read OpenSTA's words
    if (report.unmapped.empty()) {
      if (progress) progress("OpenSTA times " + options.top);
      const Timing timing = measure_timing(entry.folder(), options.top, in.library, in.sta);
      report.fmax_mhz = timing.fmax_mhz;
      report.critical_path = timing.from + " -> " + timing.to;
    }
    write_file(report_file(), gates_json(report).dump(1));
    entry.commit();
  }
  GateReport report = gates_from_json(nlohmann::ordered_json::parse(read_file(report_file())));
  report.folder = entry.folder().string();
  report.profile = get_field(config, "profile");
  return report;
}

}  // namespace kagesen
