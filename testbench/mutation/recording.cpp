#include "testbench/mutation/recording.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <filesystem>
#include <sstream>

#include "testbench/tools/cache.h"
#include "testbench/tools/process.h"
#include "testbench/tools/rtl_sources.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

namespace fs = std::filesystem;

void run_or_throw(const std::string& what, const std::vector<std::string>& command,
                  const fs::path& folder, const fs::path& log) {
  if (run_process(command, folder.string(), log.string()).status == 0) return;
  throw UserError(what, "failed", "see " + log.string());
}

}  // namespace

Recording read_manifest(const fs::path& file) {
  Recording recording;
  std::istringstream text(read_file(file));
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string key, a, b;
    words >> key >> a >> b;
    if (key == "top") recording.top = a;
    if (key == "package") recording.package = a;
    if (key == "source") recording.sources.push_back(a);
    if (key == "parameter") recording.parameters.emplace_back(a, b);
    if (key == "input") recording.inputs.push_back({a, unsigned(std::stoul(b))});
    if (key == "output") recording.outputs.push_back({a, unsigned(std::stoul(b))});
    if (key == "clocked") recording.clocked = a == "TRUE";
  }
  return recording;
}

Recording record(const MutationBlock& block) {
  const fs::path build = cache_folder() / "recording";
  const fs::path pins = build / "pins";
  fs::create_directories(pins);
  const std::string cmake = find_tool("cmake", "cmake");
  static bool configured = false;  // by this process
  if (!configured) {
    run_or_throw("configuring with recorders",
                 {cmake, "-S", source_folder(), "-B", build.string(), "-G", "Ninja",
                  "-DCMAKE_BUILD_TYPE=Release", "-DKAGESEN_RECORD=ON"},
                 build, build / "configure.log");
    configured = true;
  }
  run_or_throw("building " + block.test,
               {cmake, "--build", build.string(), "--target", block.test, "-j", "2"}, build,
               build / (block.test + ".build.log"));
  for (const auto& file : fs::recursive_directory_iterator(build / "tests" / "rtl")) {
    if (file.path().filename() != block.test || !file.is_regular_file()) continue;
    fs::remove(pins / (block.dut + ".pins"));
    setenv("KAGESEN_RECORD", pins.c_str(), 1);
    setenv("KAGESEN_RECORD_BEATS", std::to_string(block.beats).c_str(), 1);
    run_or_throw(block.test, {file.path().string()}, build, build / (block.test + ".log"));
    unsetenv("KAGESEN_RECORD");
    unsetenv("KAGESEN_RECORD_BEATS");
    Recording recording = read_manifest(build / "recorders" / (block.dut + ".manifest"));
    recording.pins = (pins / (block.dut + ".pins")).string();
    return recording;
  }
  throw UserError(block.test, "is no test of tests/rtl", "adapt testbench/mutation/blocks.cpp");
}

unsigned total_width(const std::vector<Recording::Pin>& pins) {
  unsigned width = 0;
  for (const Recording::Pin& pin : pins) width += pin.width;
  return width;
}

std::string pin_connections(const Recording& recording, const std::string& in,
                            const std::string& out, const std::string& reset) {
  std::string text;
  const auto add = [&](const std::vector<Recording::Pin>& pins, const std::string& vector) {
    unsigned high = total_width(pins);
    for (const Recording::Pin& pin : pins) {
      high -= pin.width;
      const std::string slice = fmt::format("{}[{} +: {}]", vector, high, pin.width);
      text += fmt::format("    .{}({}),\n", pin.name,
                          pin.name == "rst_ni" && !reset.empty() ? slice + " && " + reset : slice);
    }
  };
  add(recording.inputs, in);
  add(recording.outputs, out);
  text.resize(text.size() - 2);
  return text;
}

}  // namespace kagesen
