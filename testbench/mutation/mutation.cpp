#include "testbench/mutation/mutation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <regex>
#include <sstream>

#include "testbench/mutation/care.h"
#include "testbench/tools/cache.h"
#include "testbench/tools/process.h"
#include "testbench/tools/rtl_sources.h"
#include "testbench/tools/template.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

void run_or_throw(const std::string& what, const std::vector<std::string>& command,
                  const fs::path& folder, const std::string& log_name) {
  const std::string log = (folder / log_name).string();
  if (run_process(command, folder.string(), log, 3600).status == 0) return;
  throw UserError(what, "failed", "see " + log);
}

/// Without the memory, which is no part of what is changed.
std::vector<std::string> sources_of(const Recording& recording) {
  std::vector<std::string> sources;
  if (!recording.package.empty()) sources.push_back(recording.package);
  for (const std::string& file : recording.sources) {
    if (file != ram_file()) sources.push_back(file);
  }
  return sources;
}

void make_mutants(const Recording& recording, unsigned count, const fs::path& folder) {
  std::string parameters;
  for (const auto& [name, value] : recording.parameters) {
    parameters += fmt::format(" -chparam {} {}", name, value);
  }
  const std::string script = read_file(source_folder() + "/testbench/mutation/mutants.ys.in");
  write_file(
      folder / "mutants.ys",
      fill_template(script, {{"INCLUDE", common_folder()},
                             {"RAM", ram_file()},
                             {"SOURCES", fmt::format("{}", fmt::join(sources_of(recording), " "))},
                             {"TOP", recording.top},
                             {"PARAMETERS", parameters},
                             {"COUNT", std::to_string(count)}}));
  run_or_throw("Yosys on " + recording.top, {find_tool("yosys", "yosys"), "mutants.ys"}, folder,
               "yosys.log");
}

std::vector<Mutant> read_mutants(const fs::path& file) {
  static const std::regex mode("-mode (\\S+)"), cell("-cell (\\S+)"), port("-port (\\S+)"),
      bit("-portbit (\\S+)"), src("-src (\\S+)");
  const auto part = [](const std::string& line, const std::regex& what) {
    std::smatch found;
    return std::regex_search(line, found, what) ? found[1].str() : std::string();
  };
  std::vector<Mutant> mutants;
  std::istringstream text(read_file(file));
  for (std::string line; std::getline(text, line);) {
    if (line.find("-mode") == std::string::npos) continue;
    Mutant mutant;
    mutant.number = static_cast<unsigned>(mutants.size() + 1);
    mutant.what = fmt::format("{} {} {}[{}]", part(line, mode), part(line, cell), part(line, port),
                              part(line, bit));
    const std::string place = part(line, src);
    const std::size_t slash = place.find("rtl/");
    mutant.place = slash == std::string::npos ? place : place.substr(slash);
    mutants.push_back(mutant);
  }
  return mutants;
}

void build_player(const Recording& recording, const fs::path& folder) {
  // More than 64 pins on each side, so that the player always sees vectors of words.
  const unsigned in = std::max(65u, total_width(recording.inputs));
  const unsigned out = std::max(65u, total_width(recording.outputs));
  write_file(
      folder / "player_top.sv",
      fmt::format("module player_top (\n  input logic clk_i, input logic run_i, input logic "
                  "[15:0] mutsel,\n  input logic [{}:0] pins_i, output logic [{}:0] pins_o\n);\n"
                  "  {} dut (\n{}    .mutsel(mutsel),\n{});\nendmodule\n",
                  in - 1, out - 1, recording.top, recording.clocked ? "    .clk_i(clk_i),\n" : "",
                  pin_connections(recording, "pins_i", "pins_o", "run_i")));
  run_or_throw("Verilator on the mutants of " + recording.top,
               {find_tool("verilator", "verilator"),
                "--cc",
                "--exe",
                "--build",
                "-Mdir",
                "player",
                "--prefix",
                "Vplayer_top",
                "--top-module",
                "player_top",
                "-Wno-lint",
                "-Wno-fatal",
                "-O3",
                "--x-initial",
                "0",
                "--x-assign",
                "0",
                "--output-split",
                "20000",
                "-CFLAGS",
                fmt::format("-O1 -DPINS_IN={} -DPINS_OUT={}", in, out),
                "player_top.sv",
                "mutants.v",
                ram_file(),
                source_folder() + "/testbench/mutation/player.cpp",
                "-o",
                "player"},
               folder, "verilator.log");
}

void read_kills(const fs::path& file, MutationResult& result) {
  std::istringstream text(read_file(file));
  std::string word;
  text >> word >> result.unlike >> result.beats;
  for (Mutant& mutant : result.mutants) {
    unsigned number = 0;
    std::string beat;
    if (!(text >> number >> beat)) throw UserError(file.string(), "ends early", "run it again");
    if (beat != "-") mutant.killed_at = std::stol(beat);
  }
}

// ---- Results are kept: a run that was stopped goes on with the next block.
// -----------------------

std::string key_of(const Recording& recording, const MutationBlock& block, unsigned count,
                   double limit_s) {
  ContentKey key;
  key.add("count", fmt::format("{} {}", count, limit_s)).add("pins", read_file(recording.pins));
  for (const std::string& source : sources_of(recording)) key.add("source", read_file(source));
  for (const auto& [name, value] : recording.parameters) key.add(name, value);
  for (const auto& [data, valid] : block.qualifiers) key.add(data, valid);
  for (const char* file : {"mutants.ys.in", "equivalent.ys.in", "care.cpp", "player.cpp"}) {
    key.add(file, read_file(source_folder() + "/testbench/mutation/" + file));
  }
  return key.hex();
}

void keep(const MutationResult& result, const std::string& key, const fs::path& file) {
  std::string text =
      fmt::format("{} {} {} {}\n", key, result.mutants.size(), result.beats, result.unlike);
  for (const Mutant& mutant : result.mutants) {
    text += fmt::format("{} {}\n", mutant.killed_at, int(mutant.equivalent));
  }
  write_file(file, text);
}

/// False: there is no result of that key.
bool take_kept(const std::string& key, const fs::path& folder, MutationResult& result) {
  if (!fs::exists(folder / "result.txt")) return false;
  std::istringstream text(read_file(folder / "result.txt"));
  std::string kept_key;
  std::size_t count = 0;
  text >> kept_key >> count >> result.beats >> result.unlike;
  result.mutants = read_mutants(folder / "mutants.txt");
  if (kept_key != key || count != result.mutants.size()) return false;
  for (Mutant& mutant : result.mutants) text >> mutant.killed_at >> mutant.equivalent;
  return bool(text);
}

}  // namespace

std::size_t MutationResult::killed() const {
  return static_cast<std::size_t>(std::count_if(mutants.begin(), mutants.end(),
                                                [](const Mutant& m) { return m.killed_at >= 0; }));
}

std::size_t MutationResult::equivalent() const {
  return static_cast<std::size_t>(
      std::count_if(mutants.begin(), mutants.end(), [](const Mutant& m) { return m.equivalent; }));
}

MutationResult mutate(const MutationBlock& block, unsigned count, double limit_s,
                      const std::function<void(const std::string&)>& progress) {
  const auto tell = [&](const std::string& stage) {
    if (progress) progress(block.name + ": " + stage);
  };
  tell("recording " + block.test);
  const Recording recording = record(block);
  const fs::path folder = cache_folder() / "mutation" / block.name;
  const std::string key = key_of(recording, block, count, limit_s);
  MutationResult kept;
  kept.block = block.name;
  if (take_kept(key, folder, kept)) return kept;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  tell("making mutants");
  make_mutants(recording, count, folder);
  MutationResult result;
  result.block = block.name;
  result.mutants = read_mutants(folder / "mutants.txt");
  tell("building");
  build_player(recording, folder);
  tell("running");
  write_vectors(recording, block.qualifiers, std::numeric_limits<std::size_t>::max(),
                folder / "vectors.txt");
  run_or_throw("the mutants of " + block.name,
               {(folder / "player" / "player").string(), "vectors.txt",
                std::to_string(result.mutants.size())},
               folder, "kills.txt");
  read_kills(folder / "kills.txt", result);
  fs::remove(folder / "vectors.txt");
  if (result.unlike > 0) {
    throw UserError(block.name,
                    fmt::format("{} beats of the replay are not as recorded", result.unlike),
                    "qualify what means nothing in testbench/mutation/blocks.cpp");
  }
  for (Mutant& mutant : result.mutants) {
    if (mutant.killed_at >= 0) continue;
    tell(fmt::format("is mutant {} equivalent?", mutant.number));
    mutant.equivalent =
        proven_equivalent(recording, block.qualifiers, folder.string(), mutant.number, limit_s);
  }
  keep(result, key, folder / "result.txt");
  return result;
}

}  // namespace kagesen
