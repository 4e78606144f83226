#include "testbench/synthesis/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>
#include <vector>

#include "testbench/synthesis/gates.h"
#include "testbench/tools/cache.h"
#include "testbench/tools/process.h"
#include "testbench/tools/rtl_sources.h"
#include "testbench/tools/template.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

/// The bits of "{ a, b, 2'b01 }" or "a", first the highest.
std::vector<std::string> bits_of(std::string side) {
  std::vector<std::string> bits;
  if (side.front() == '{') side = side.substr(1, side.rfind('}') - 1);
  std::istringstream words(side);
  for (std::string word; std::getline(words, word, ',');) {
    word.erase(0, word.find_first_not_of(' '));
    word.erase(word.find_last_not_of(' ') + 1);
    const std::size_t digits = word.find("'b");
    if (digits == std::string::npos) {
      bits.push_back(word + " ");  // an escaped name ends with a space
    } else {
      for (const char digit : word.substr(digits + 2)) bits.push_back(std::string("1'b") + digit);
    }
  }
  return bits;
}

/// OpenSTA's reader takes no concatenation on the left: one assignment a bit. Nets are single bits
/// already.
std::string with_single_assigns(const std::string& netlist) {
  std::string text;
  std::istringstream lines(netlist);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find(" = ");
    if (line.rfind("  assign {", 0) != 0 || equals == std::string::npos) {
      text += line + "\n";
      continue;
    }
    const std::vector<std::string> left = bits_of(line.substr(9, equals - 9));
    const std::vector<std::string> right =
        bits_of(line.substr(equals + 3, line.rfind(';') - equals - 3));
    for (std::size_t bit = 0; bit < std::min(left.size(), right.size()); ++bit) {
      text += fmt::format("  assign {} = {};\n", left[bit], right[bit]);
    }
  }
  return text;
}

using Sizes = std::set<std::pair<unsigned, unsigned>>;  ///< width, depth

/// OpenSTA takes no parameters: each size of ram_1r1w becomes a cell of its own.
std::string with_sized_rams(const std::string& netlist, Sizes& sizes) {
  static const std::regex ram(
      R"(ram_1r1w #\(\s*\.Depth\(32's?d(\d+)\),\s*\.Width\(32's?d(\d+)\)\s*\))");
  std::string text;
  auto last = netlist.begin();
  for (std::sregex_iterator found(netlist.begin(), netlist.end(), ram), end; found != end;
       ++found) {
    const std::string depth = (*found)[1], width = (*found)[2];
    sizes.insert({std::stoul(width), std::stoul(depth)});
    text.append(last, (*found)[0].first);
    text += fmt::format("ram_1r1w_{}x{}", width, depth);
    last = (*found)[0].second;
  }
  return text.append(last, netlist.end());
}

unsigned bits_for(unsigned depth) {
  unsigned bits = 1;
  while ((1u << bits) < depth) ++bits;
  return bits;
}

std::string ram_cell(unsigned width, unsigned depth) {
  const std::string setup = fmt::format(
      "timing () {{ related_pin : \"clk_i\"; timing_type : setup_rising; rise_constraint (scalar) "
      "{{ values (\"{0}\"); }} fall_constraint (scalar) {{ values (\"{0}\"); }} }}",
      kRamSetupNs);
  const std::string access = fmt::format(
      "timing () {{ related_pin : \"clk_i\"; timing_type : rising_edge; cell_rise (delay) {{ "
      "values "
      "(\"{0}, {1}\"); }} rise_transition (delay) {{ values (\"0.1, 1.1\"); }} cell_fall (delay) "
      "{{ "
      "values (\"{0}, {1}\"); }} fall_transition (delay) {{ values (\"0.1, 1.1\"); }} }}",
      kRamAccessNs, kRamAccessNs + 1);
  const unsigned address = bits_for(depth);
  std::string text = fmt::format(
      "  type (a{0}x{1}) {{ base_type : array; data_type : bit; bit_width "
      ": {2}; bit_from : {3}; bit_to : 0; }}\n  type (d{0}x{1}) {{ base_type : array; "
      "data_type : bit; bit_width : {0}; bit_from : {4}; bit_to : 0; }}\n",
      width, depth, address, address - 1, width - 1);
  text += fmt::format(
      "  cell (ram_1r1w_{}x{}) {{\n    area : 0;\n    pin (clk_i) {{ direction : input; "
      "capacitance : 0.02; clock : true; }}\n",
      width, depth);
  for (const char* pin : {"write_i", "read_i"}) {
    text +=
        fmt::format("    pin ({}) {{ direction : input; capacitance : 0.02; {} }}\n", pin, setup);
  }
  const auto bus = [&](const char* name, char type, unsigned bits, const std::string& rest) {
    text += fmt::format(
        "    bus ({0}) {{ bus_type : {1}{2}x{3}; {4} pin ({0}[{5}:0]) {{ {4} {6} }} }}\n", name,
        type, width, depth, type == 'q' ? "direction : output;" : "direction : input;", bits - 1,
        rest);
  };
  const std::string input = "capacitance : 0.02; " + setup;
  bus("write_addr_i", 'a', address, input);
  bus("read_addr_i", 'a', address, input);
  bus("write_data_i", 'd', width, input);
  text += fmt::format(
      "    bus (read_data_o) {{ bus_type : d{0}x{1}; direction : output; pin "
      "(read_data_o[{2}:0]) {{ direction : output; {3} }} }}\n  }}\n",
      width, depth, width - 1, access);
  return text;
}

std::string ram_library(const Sizes& sizes) {
  std::string text = R"(library (rams) {
  delay_model : table_lookup;
  time_unit : "1ns"; voltage_unit : "1V"; current_unit : "1uA";
  pulling_resistance_unit : "1kohm"; leakage_power_unit : "1nW"; capacitive_load_unit (1, pf);
  slew_upper_threshold_pct_rise : 80; slew_lower_threshold_pct_rise : 20;
  slew_upper_threshold_pct_fall : 80; slew_lower_threshold_pct_fall : 20;
  input_threshold_pct_rise : 50; input_threshold_pct_fall : 50;
  output_threshold_pct_rise : 50; output_threshold_pct_fall : 50;
  lu_table_template (delay) { variable_1 : total_output_net_capacitance; index_1 ("0.0, 1.0"); }
)";
  for (const auto& [width, depth] : sizes) text += ram_cell(width, depth);
  return text + "}\n";
}

std::string match(const std::string& text, const std::string& pattern) {
  std::smatch found;
  return std::regex_search(text, found, std::regex(pattern)) ? found[1].str() : std::string();
}

/// "store.cache.lookup_q[5]_cell/D" is a bit of "store.cache.lookup_q"; pins of memories keep theirs.
std::string without_bit(const std::string& pin) {
  static const std::regex bit(R"(\[\d+\])"), cell("_cell(/.*)?$");
  return std::regex_replace(std::regex_replace(pin, bit, ""), cell, "");
}

/// Of a summary: a line for each end.
std::vector<PathReport> paths_of(const std::string& text, double period) {
  static const std::regex line(R"((\S+) \(\S+\)\s+(\S+) \(\S+\)\s+(-?[\d.]+))");
  std::vector<PathReport> paths;
  std::map<std::string, std::size_t> known;
  std::istringstream lines(text);
  for (std::string one; std::getline(lines, one);) {
    std::smatch found;
    if (!std::regex_match(one, found, line)) continue;
    const std::string to = without_bit(found[2]);
    const auto [at, fresh] = known.insert({to, paths.size()});
    if (fresh) paths.push_back({without_bit(found[1]), to, period - std::stod(found[3]), 0});
    ++paths[at->second].bits;
  }
  return paths;
}

}  // namespace

Timing measure_timing(const std::filesystem::path& folder, const std::string& top,
                      const CellLibrary& library, const std::string& sta) {
  constexpr double kPeriodNs = 1000 / kTargetMhz;
  Sizes sizes;
  write_file(folder / "timing.v",
             with_sized_rams(with_single_assigns(read_file(folder / "ports_split.v")), sizes));
  write_file(folder / "rams.lib", ram_library(sizes));
  const std::string script = read_file(source_folder() + "/testbench/synthesis/timing.tcl.in");
  write_file(folder / "timing.tcl",
             fill_template(script, {{"LIBERTY", library.liberty},
                                    {"RAM_LIBERTY", "rams.lib"},
                                    {"NETLIST", "timing.v"},
                                    {"TOP", top},
                                    {"PERIOD_NS", fmt::format("{:.4f}", kPeriodNs)}}));
  const std::string log = (folder / "timing.txt").string();
  run_process({sta, "-no_splash", "-exit", "timing.tcl"}, folder.string(), log, 600);
  const std::string text = read_file(log);
  for (const char* name : {"timing.v", "ports_split.v"}) std::filesystem::remove(folder / name);
  const std::string slack = match(text, "WORST (-?[0-9.e+-]+)");
  const std::string error = match(text, "(Error[^\n]*)");
  if (slack.empty() || !error.empty()) {
    throw UserError("OpenSTA", error.empty() ? "no slack" : error, "see " + log);
  }
  Timing timing;
  const double longest = kPeriodNs - std::stod(slack);
  timing.fmax_mhz = longest > 0 ? 1000 / longest : 0;
  timing.from = match(text, "Startpoint: (\\S+)");
  timing.to = match(text, "Endpoint: (\\S+)");
  timing.paths = paths_of(text, kPeriodNs);
  return timing;
}

}  // namespace kagesen
