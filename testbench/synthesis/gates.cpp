#include "testbench/synthesis/gates.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "testbench/synthesis/cell_library.h"
#include "testbench/synthesis/fanout.h"
#include "testbench/synthesis/gates_text.h"
#include "testbench/synthesis/mapping.h"
#include "testbench/synthesis/netlist_areas.h"
#include "testbench/synthesis/timing.h"
#include "testbench/tools/cache.h"
#include "testbench/tools/process.h"
#include "testbench/tools/rtl_sources.h"
#include "testbench/verilator/package.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

struct Inputs {
  CellLibrary library;
  std::vector<std::string> sources;  ///< files, but for the package
  std::string package, netlist, timing, sta;
  MappingInputs mapping;

  std::string script_hash() const {
    return ContentKey()
        .add("mapping", mapping.scripts())
        .add("netlist", netlist)
        .add("timing", timing)
        .hex()
        .substr(0, 12);
  }
  std::string key() const {
    ContentKey key;
    key.add("version", "4").add("package", package).add("scripts", script_hash());
    key.add("top", mapping.top).add("parameters", mapping.parameters).add("tools", mapping.tools);
    key.add("liberty", read_file(library.liberty)).add("ram", read_file(ram_file()));
    key.add("assumed", fmt::format("{} {} {}", kRamAccessNs, kRamSetupNs, kTargetMhz));
    key.add("fanout", fmt::format("{} {} {}", kMostReaders, kMostBuffered, kMostBuffers));
    for (const std::string& file : sources) key.add("source", read_file(file));
    return key.hex();
  }
};

Inputs inputs_of(const UnitConfig& config, const GateOptions& options) {
  const std::string scripts = source_folder() + "/testbench/synthesis/";
  Inputs in;
  in.library = find_cell_library(options.library);
  in.sta = find_tool("sta", "opensta");
  in.netlist = read_file(scripts + "netlist.ys");
  in.timing = read_file(scripts + "timing.tcl.in");
  in.sources = options.sources;
  if (in.sources.empty()) {
    in.package = with_package_sets(shadow_package(config), options.package_sets);
    in.sources = RtlSources(config.profile).of(options.top);
  }
  MappingInputs& mapping = in.mapping;
  mapping.top = options.top;
  mapping.liberty = in.library.liberty;
  mapping.flatten = options.flatten;
  mapping.sources =
      fmt::format("{} {}", in.package.empty() ? "" : "shadow_pkg.sv", fmt::join(in.sources, " "));
  for (const auto& [name, value] : options.parameters) {
    mapping.parameters += fmt::format(" -chparam {} {}", name, value);
  }
  mapping.abc = read_file(options.abc.empty() ? scripts + "abc.script" : options.abc);
  mapping.yosys = find_tool("yosys", "yosys");
  find_tool("berkeley-abc", "berkeley-abc");
  mapping.tools = fmt::format("{}; OpenSTA {}", tool_version(mapping.yosys, {"-V"}),
                              tool_version(in.sta, {"-version"}));
  return in;
}

/// Leaves netlist.v, and ports_split.v for OpenSTA. Returns how many buffers it has put in.
std::size_t write_netlist(const Inputs& in, const std::filesystem::path& folder) {
  std::string design = read_file(folder / "flat.json");
  const std::size_t buffers = buffer_fanout(in.mapping.top, design);
  write_file(folder / "buffered.json", design);
  run_yosys(in.mapping.yosys, in.mapping.top, in.netlist, "netlist", folder);
  for (const char* name : {"flat.json", "buffered.json"}) std::filesystem::remove(folder / name);
  return buffers;
}

GateReport read_report(const CacheEntry& entry, const UnitConfig& config) {
  const std::string text = read_file(entry.folder() / "report.json");
  GateReport report = gates_from_json(nlohmann::ordered_json::parse(text));
  report.folder = entry.folder().string();
  report.profile = get_field(config, "profile");
  return report;
}

}  // namespace

GateReport measure_gates(const UnitConfig& config, const GateOptions& options,
                         const std::function<void(const std::string&)>& progress) {
  const Inputs in = inputs_of(config, options);
  CacheEntry entry("gates", in.key());
  if (!entry.complete()) {
    entry.keep_unfinished();  // for whoever has to read the tools' words
    write_file(entry.folder() / "shadow_pkg.sv", in.package);
    map_to_cells(in.mapping, entry.folder(), progress);
    GateReport report;
    report.top = options.top;
    report.library = options.library;
    report.nand2_area = in.library.nand2_area;
    report.tools = in.mapping.tools;
    report.scripts = in.script_hash();
    report.flattened = options.flatten;
    add_areas(read_file(entry.folder() / "netlist.json"), options.top, in.library, report);
    std::filesystem::remove(entry.folder() / "netlist.json");
    report.buffers = write_netlist(in, entry.folder());
    report.buffer_ge = static_cast<double>(report.buffers) * in.library.areas.at(kFanoutBuffer) /
                       in.library.nand2_area;
    report.total_ge += report.buffer_ge;
    report.cells += report.buffers;
    if (report.unmapped.empty()) {
      if (progress) progress("OpenSTA times " + options.top);
      const Timing timing = measure_timing(entry.folder(), options.top, in.library, in.sta);
      report.fmax_mhz = timing.fmax_mhz;
      report.critical_path = timing.from + " -> " + timing.to;
      report.paths = timing.paths;
    }
    write_file(entry.folder() / "report.json", gates_json(report).dump(1));
    entry.commit();
  }
  return read_report(entry, config);
}

std::optional<GateReport> kept_gates(const UnitConfig& config, const GateOptions& options) {
  try {
    const CacheEntry entry("gates", inputs_of(config, options).key());
    if (entry.complete()) return read_report(entry, config);
  } catch (const UserError&) {
    // no tools, no sources, no place to keep anything: then nothing was kept
  }
  return std::nullopt;
}

}  // namespace kagesen
