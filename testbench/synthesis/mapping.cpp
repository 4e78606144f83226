#include "testbench/synthesis/mapping.h"

#include <fmt/format.h>

#include <map>
#include <regex>
#include <vector>

#include "testbench/synthesis/gates.h"
#include "testbench/synthesis/netlist_areas.h"
#include "testbench/tools/cache.h"
#include "testbench/tools/process.h"
#include "testbench/tools/rtl_sources.h"
#include "testbench/tools/template.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;
constexpr double kYosysLimitS = 3600;

std::string script(const std::string& name) {
  return read_file(source_folder() + "/testbench/synthesis/" + name);
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

struct Module {
  std::string name, text;
};

/// Nets of a function's calls are named by file, line and a number that counts through the design:
/// numbered through the module instead, its text hangs on itself alone.
std::string with_own_call_numbers(const std::string& text) {
  static const std::regex call(R"(\\\w+\$func\$\S+?:\d+\$\d+)");
  std::map<std::string, std::size_t> numbers;
  std::string out;
  auto last = text.begin();
  for (std::sregex_iterator found(text.begin(), text.end(), call), end; found != end; ++found) {
    const std::size_t number = numbers.insert({found->str(), numbers.size()}).first->second;
    out.append(last, (*found)[0].first);
    out += "$call$" + std::to_string(number);
    last = (*found)[0].second;
  }
  return out.append(last, text.end());
}

/// Modules of RTLIL that are no black boxes. Names that Yosys gave become private again, or it
/// would keep their nets.
std::vector<Module> modules_of(const std::string& rtlil) {
  static const std::regex header("\nmodule (\\S+)"), given(R"(\\_([0-9]+)_(?=\s))");
  std::vector<Module> modules;
  std::size_t begin = rtlil.find("\n\n");
  for (std::size_t end; (end = rtlil.find("\nend\n", begin)) != std::string::npos; begin = end) {
    end += 5;
    const std::string text = rtlil.substr(begin, end - begin);
    std::smatch name;
    const bool blackbox = text.find("\nattribute \\blackbox 1\n") != std::string::npos;
    if (blackbox || !std::regex_search(text, name, header)) continue;
    modules.push_back(
        {name[1], with_own_call_numbers(std::regex_replace(text, given, "$$given$$$1"))});
  }
  return modules;
}

/// The module's mapped RTLIL.
std::string mapped(const MappingInputs& in, const Module& module, const fs::path& stubs) {
  const std::string text = fill_template(
      script("map.ys.in"),
      {{"LIBERTY", in.liberty}, {"PERIOD_PS", fmt::format("{:.0f}", 1e6 / kTargetMhz)}});
  ContentKey key;
  key.add("module", module.text).add("script", text).add("abc", in.abc).add("tools", in.tools);
  key.add("liberty", read_file(in.liberty));
  CacheEntry entry("mapped", key.hex());
  if (!entry.complete()) {
    const fs::path folder = entry.folder();
    fs::copy_file(stubs, folder / "stubs.il");
    write_file(folder / "module.il", module.text);
    write_file(folder / "abc.script", in.abc);
    entry.keep_unfinished();  // for its log, should it fail
    run_yosys(in.yosys, source_name(module.name.substr(module.name[0] == '\\')), text, "map",
              folder);
    fs::remove(folder / "stubs.il");
    entry.commit();
  }
  return read_file(entry.folder() / "mapped.il");
}

}  // namespace

std::string MappingInputs::scripts() const {
  return script("elaborate.ys.in") + script("map.ys.in") + script("join.ys") + abc +
         (flatten ? "flattened" : "");
}

void run_yosys(const std::string& yosys, const std::string& what, const std::string& script,
               const std::string& name, const fs::path& folder) {
  write_file(folder / (name + ".ys"), script);
  const std::string log = (folder / (name + ".log")).string();
  const ProcessResult result =
      run_process({yosys, name + ".ys"}, folder.string(), log, kYosysLimitS);
  if (result.status == 0) return;
  throw UserError("Yosys on " + what, result.timed_out ? "took too long" : errors_of(log),
                  "see " + log);
}

void map_to_cells(const MappingInputs& in, const fs::path& folder,
                  const std::function<void(const std::string&)>& progress) {
  run_yosys(in.yosys, in.top,
            fill_template(script("elaborate.ys.in"), {{"TOP", in.top},
                                                      {"LIBERTY", in.liberty},
                                                      {"INCLUDE", common_folder()},
                                                      {"RAM", ram_file()},
                                                      {"SOURCES", in.sources},
                                                      {"FLATTEN", in.flatten ? "flatten" : ""},
                                                      {"PARAMETERS", in.parameters}}),
            "elaborate", folder);
  const std::vector<Module> modules = modules_of(read_file(folder / "elaborated.il"));
  std::string all;
  for (std::size_t i = 0; i < modules.size(); ++i) {
    if (progress) progress(fmt::format("Yosys maps {}: {} of {}", in.top, i + 1, modules.size()));
    all += mapped(in, modules[i], folder / "stubs.il");
  }
  write_file(folder / "mapped.il", all);
  run_yosys(in.yosys, in.top, script("join.ys"), "join", folder);
  for (const char* name : {"elaborated.il", "stubs.il", "mapped.il"}) fs::remove(folder / name);
}

}  // namespace kagesen
