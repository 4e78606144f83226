#include "testbench/synthesis/gates_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace kagesen {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) {
  return static_cast<double>(static_cast<std::int64_t>(value * 100 + 0.5)) / 100;
}

/// "12,345"
std::string grouped(double value) {
  std::string digits = fmt::format("{:.0f}", value);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3) digits.insert(at, ",");
  return digits;
}

}  // namespace

Json gates_json(const GateReport& report) {
  std::uint64_t unmapped = 0;
  for (const auto& [type, count] : report.unmapped) unmapped += count;
  Json json{{"top", report.top},
            {"total_ge", rounded(report.total_ge)},
            {"fmax_mhz", rounded(report.fmax_mhz)},
            {"memory_bits", report.memory_bits},
            {"unmapped", unmapped},
            {"unmapped_cells", report.unmapped},
            {"cells", report.cells},
            {"flops", report.flops},
            {"flop_ge", rounded(report.flop_ge)},
            {"buffers", report.buffers},
            {"buffer_ge", rounded(report.buffer_ge)}};
  for (const auto& [name, block] : report.blocks) {
    json["blocks"][name] = {{"ge", rounded(block.ge)},
                            {"own_ge", rounded(block.own_ge)},
                            {"instances", block.instances},
                            {"memory_bits", block.memory_bits}};
  }
  json["memories"] = Json::array();
  for (const MemoryReport& memory : report.memories) {
    json["memories"].push_back({{"path", memory.path},
                                {"width", memory.width},
                                {"depth", memory.depth},
                                {"bits", memory.bits()}});
  }
  json["critical_path"] = report.critical_path;
  json["paths"] = Json::array();
  for (const PathReport& path : report.paths) {
    json["paths"].push_back(
        {{"from", path.from}, {"to", path.to}, {"ns", rounded(path.ns)}, {"bits", path.bits}});
  }
  json["library"] = report.library;
  json["nand2_area"] = report.nand2_area;
  json["tools"] = report.tools;
  json["scripts"] = report.scripts;
  json["flattened"] = report.flattened;
  json["ram_access_ns"] = kRamAccessNs;
  json["ram_setup_ns"] = kRamSetupNs;
  json["wire_delay"] = "none";
  json["folder"] = report.folder;
  return json;
}

GateReport gates_from_json(const Json& json) {
  GateReport report;
  report.top = json.at("top");
  report.total_ge = json.at("total_ge");
  report.fmax_mhz = json.at("fmax_mhz");
  report.memory_bits = json.at("memory_bits");
  for (const auto& [type, count] : json.at("unmapped_cells").items()) report.unmapped[type] = count;
  report.cells = json.at("cells");
  report.flops = json.at("flops");
  report.flop_ge = json.at("flop_ge");
  report.buffers = json.at("buffers");
  report.buffer_ge = json.at("buffer_ge");
  for (const auto& [name, block] : json.at("blocks").items()) {
    report.blocks[name] = {block.at("instances"), block.at("own_ge"), block.at("ge"),
                           block.at("memory_bits")};
  }
  for (const auto& memory : json.at("memories")) {
    report.memories.push_back({memory.at("path"), memory.at("width"), memory.at("depth")});
  }
  report.critical_path = json.at("critical_path");
  for (const auto& path : json.at("paths")) {
    report.paths.push_back({path.at("from"), path.at("to"), path.at("ns"), path.at("bits")});
  }
  report.library = json.at("library");
  report.nand2_area = json.at("nand2_area");
  report.tools = json.at("tools");
  report.scripts = json.at("scripts");
  report.flattened = json.at("flattened");
  report.folder = json.at("folder");
  return report;
}

std::string gates_table(const GateReport& report) {
  std::string text = fmt::format("{:<28}{:>6}{:>12}{:>14}{:>14}\n", "block", "count", "own GE",
                                 "with its own", "memory bits");
  std::vector<std::pair<std::string, BlockReport>> blocks(report.blocks.begin(),
                                                          report.blocks.end());
  std::stable_sort(blocks.begin(), blocks.end(),
                   [](const auto& a, const auto& b) { return a.second.ge > b.second.ge; });
  for (const auto& [name, block] : blocks) {
    text += fmt::format("{:<28}{:>6}{:>12}{:>14}{:>14}\n", name, block.instances,
                        grouped(block.own_ge), grouped(block.ge),
                        block.memory_bits ? grouped(static_cast<double>(block.memory_bits)) : "");
  }
  text += fmt::format(
      "\ntotal {} GE ({} of it {} flip-flops, {} buffers of what has many readers), {} memory bits "
      "apart\n",
      grouped(report.total_ge), grouped(report.flop_ge), report.flops, grouped(report.buffer_ge),
      grouped(static_cast<double>(report.memory_bits)));
  text += fmt::format("{:.1f} MHz, longest path {}\n", report.fmax_mhz, report.critical_path);
  for (const auto& [type, count] : report.unmapped) {
    text += fmt::format("UNMAPPED {} x {}\n", count, type);
  }
  text += fmt::format(
      "{}, GE = NAND2X1 (area {:g}); {}; scripts {}; {} before mapping\n"
      "assumed: memories {} ns from clock to data, {} ns setup; no delay on wires, no clock "
      "skew\n{}\n",
      report.library, report.nand2_area, report.tools, report.scripts,
      report.flattened ? "flattened" : "hierarchy kept", kRamAccessNs, kRamSetupNs, report.folder);
  return text;
}

std::string paths_table(const GateReport& report, std::size_t most) {
  std::string text = fmt::format("\n{:>7}{:>6}  {}\n", "ns", "bits", "longest path to, from");
  for (std::size_t i = 0; i < std::min(most, report.paths.size()); ++i) {
    const PathReport& path = report.paths[i];
    text += fmt::format("{:>7.2f}{:>6}  {}, {}\n", path.ns, path.bits, path.to, path.from);
  }
  return text;
}

std::string sweep_table(const std::vector<SweepRow>& rows) {
  std::string text =
      fmt::format("{:<24}{:>10}{:>10}{:>10}{:>14}\n", "key", "value", "GE", "MHz", "memory bits");
  for (const SweepRow& row : rows) {
    text += fmt::format("{:<24}{:>10}{:>10}{:>10.1f}{:>14}\n", row.key,
                        row.value + (row.standard ? "*" : ""), grouped(row.report.total_ge),
                        row.report.fmax_mhz, grouped(static_cast<double>(row.report.memory_bits)));
  }
  return text + "* the configuration's own value\n";
}

Json sweep_json(const std::vector<SweepRow>& rows) {
  Json json = Json::array();
  for (const SweepRow& row : rows) {
    json.push_back({{"key", row.key},
                    {"value", row.value},
                    {"total_ge", rounded(row.report.total_ge)},
                    {"fmax_mhz", rounded(row.report.fmax_mhz)},
                    {"memory_bits", row.report.memory_bits}});
  }
  return json;
}

}  // namespace kagesen
