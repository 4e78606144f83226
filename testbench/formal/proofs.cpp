#include "testbench/formal/proofs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <regex>
#include <sstream>

#include "testbench/tools/cache.h"
#include "testbench/tools/process.h"
#include "testbench/tools/rtl_sources.h"
#include "testbench/tools/template.h"
#include "testbench/verilator/package.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

Proof read_proof(const fs::path& file) {
  static const std::regex line("// (profile|package|pipeline|broken): (.*)");
  static const std::regex broken("(\\S+): `([^`]*)` => `([^`]*)`");
  Proof proof;
  proof.file = file.string();
  proof.name = file.stem().string();
  proof.name.resize(proof.name.size() - std::string("_proof").size());
  const std::string whole = read_file(file);
  static const std::regex parameter("parameter int unsigned (\\w+) = (\\d+)");
  for (std::sregex_iterator at(whole.begin(), whole.end(), parameter), end; at != end; ++at) {
    proof.parameters.push_back((*at)[1].str() + "=" + (*at)[2].str());
  }
  std::istringstream text(whole);
  bool stated = false;
  for (std::string words; std::getline(text, words);) {
    stated = stated || words == "//";
    if (!stated) proof.statement += (proof.statement.empty() ? "" : " ") + words.substr(3);
    std::smatch found, parts;
    if (!std::regex_match(words, found, line)) continue;
    const std::string value = found[2];
    if (found[1] == "profile") {
      proof.profile = value;
    } else if (found[1] == "pipeline") {
      proof.pipeline = static_cast<unsigned>(std::stoul(value));
    } else if (found[1] == "package") {
      std::istringstream sets(value);
      proof.packages.emplace_back(std::istream_iterator<std::string>(sets),
                                  std::istream_iterator<std::string>());
    } else if (std::regex_match(value, parts, broken)) {
      proof.broken.push_back({parts[1], parts[2], parts[3]});
    } else {
      throw UserError(proof.file, "cannot be read: " + words, "write FILE: `old` => `new`");
    }
  }
  if (proof.packages.empty()) proof.packages.emplace_back();
  return proof;
}

/// A copy of the file with the fault in it. Throws UserError where it does not apply: the RTL was
/// changed and the fault must follow.
void write_broken(const std::string& file, const BrokenCopy& broken, const fs::path& copy) {
  std::string text = read_file(file);
  const std::size_t at = text.find(broken.old_text);
  if (at == std::string::npos) {
    throw UserError(file, "does not hold `" + broken.old_text + "`",
                    "adapt the proof's broken copies");
  }
  write_file(copy, text.replace(at, broken.old_text.size(), broken.new_text));
}

std::vector<std::string> sources_of(const Proof& proof, const std::vector<std::string>& package,
                                    const BrokenCopy* broken, const fs::path& folder) {
  UnitConfig config;
  config.profile = proof.profile == "winding" ? Profile::kWinding : Profile::kPaper;
  write_file(folder / "shadow_pkg.sv", with_package_sets(shadow_package(config), package));
  RtlSources rtl(config.profile);
  rtl.add_file(source_folder() + "/testbench/formal/line_spec.sv");
  rtl.add_file(proof.file);
  std::vector<std::string> files = rtl.of(proof.name + "_proof");
  files.insert(files.begin(), ram_file());
  bool applied = false;
  for (std::string& file : files) {
    if (!broken || fs::path(file).filename() != broken->file) continue;
    write_broken(file, *broken, folder / "broken.sv");
    file = "broken.sv";
    applied = true;
  }
  if (broken && !applied) {
    throw UserError(proof.file, "takes no " + broken->file, "name a file that the block takes");
  }
  return files;
}

Verdict run_proof(const Proof& proof, std::size_t package, const BrokenCopy* broken,
                  double limit_s) {
  const std::string yosys = find_tool("yosys", "yosys");
  const std::string abc = find_tool("berkeley-abc", "berkeley-abc");
  // Nothing is taken from an earlier run; the folder keeps what the last one said.
  const std::string variant =
      broken ? ContentKey().add(broken->file, broken->new_text).hex() : "rtl";
  const fs::path folder = cache_folder() / "proofs" /
                          fmt::format("{}_{}_{}", proof.name, package, variant.substr(0, 8));
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::vector<std::string> files = sources_of(proof, proof.packages[package], broken, folder);
  const std::string script = read_file(source_folder() + "/testbench/formal/prove.ys.in");
  write_file(
      folder / "prove.ys",
      fill_template(script, {{"INCLUDE", common_folder()},
                             {"SOURCES", fmt::format("shadow_pkg.sv {}", fmt::join(files, " "))},
                             {"TOP", proof.name + "_proof"}}));
  Verdict verdict;
  verdict.log = (folder / "abc.log").string();
  const std::string yosys_log = (folder / "yosys.log").string();
  const ProcessResult made =
      run_process({yosys, "-q", "prove.ys"}, folder.string(), yosys_log, 10 * limit_s);
  if (made.status != 0) {
    throw UserError("Yosys on " + proof.name + "_proof",
                    made.timed_out ? "took too long" : read_file(yosys_log), "see " + yosys_log);
  }
  const std::string search = proof.pipeline
                                 ? fmt::format("bmc3 -F {} -T {:.0f}", proof.pipeline + 1, limit_s)
                                 : fmt::format("pdr -T {:.0f}", limit_s);
  const std::string commands = "read_aiger proof.aig; fold; orpos; strash; " + search;
  const ProcessResult searched =
      run_process({abc, "-c", commands}, folder.string(), verdict.log, 10 * limit_s);
  verdict.seconds = made.seconds + searched.seconds;
  const std::string words = read_file(verdict.log);
  const std::string all_frames = fmt::format("No output asserted in {} frames", proof.pipeline + 1);
  const std::string proved = proof.pipeline ? all_frames : "Property proved";
  if (words.find(proved) != std::string::npos) verdict.outcome = Outcome::kProved;
  if (words.find("was asserted in frame") != std::string::npos) verdict.outcome = Outcome::kRefuted;
  return verdict;
}

}  // namespace

std::vector<Proof> find_proofs() {
  std::vector<Proof> proofs;
  for (const auto& entry : fs::directory_iterator(source_folder() + "/testbench/formal")) {
    const std::string stem = entry.path().stem().string();
    const bool harness = entry.path().extension() == ".sv" && stem.size() > 6 &&
                         stem.compare(stem.size() - 6, 6, "_proof") == 0;
    if (harness) proofs.push_back(read_proof(entry.path()));
  }
  std::sort(proofs.begin(), proofs.end(),
            [](const Proof& a, const Proof& b) { return a.name < b.name; });
  return proofs;
}

Verdict run_proof(const Proof& proof, const BrokenCopy* broken, double limit_s) {
  Verdict all{Outcome::kProved, 0, ""};
  for (std::size_t package = 0; package < proof.packages.size(); ++package) {
    const Verdict one = run_proof(proof, package, broken, limit_s);
    all.seconds += one.seconds;
    if (one.outcome == Outcome::kProved) continue;
    all.outcome = one.outcome;
    all.log = one.log;
    if (one.outcome == Outcome::kRefuted) break;
  }
  return all;
}

}  // namespace kagesen
