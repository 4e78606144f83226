#include <fmt/format.h>

#include <filesystem>

#include "testbench/mutation/mutation.h"
#include "testbench/tools/cache.h"
#include "testbench/tools/process.h"
#include "testbench/tools/rtl_sources.h"
#include "testbench/tools/template.h"

namespace kagesen {
namespace {

/// "good_o equals bad_o where it means something."
std::string alike(const Recording& recording, const Qualifiers& qualifiers) {
  std::string text = "1'b1";
  for (const CareField& field : care_fields(recording, qualifiers)) {
    const auto slice = [&](const char* copy) {
      return fmt::format("{}_o[{} +: {}]", copy, field.low, field.width);
    };
    std::string same = fmt::format("{} == {}", slice("good"), slice("bad"));
    if (field.valid_width > 0) {
      same += fmt::format(" || good_o[{} +: {}] != {}", field.valid_low, field.valid_width,
                          field.valid_value);
    }
    text += fmt::format("\n      && ({})", same);
  }
  return text;
}

std::string miter(const Recording& recording, const Qualifiers& qualifiers, unsigned mutant) {
  const auto copy = [&](const char* name, unsigned selector) {
    return fmt::format("  {} {} (\n{}    .mutsel(16'd{}),\n{});\n", recording.top, name,
                       recording.clocked ? "    .clk_i(clk_i),\n" : "", selector,
                       pin_connections(recording, "pins_i", std::string(name) + "_o", ""));
  };
  const unsigned out = total_width(recording.outputs);
  return fmt::format(
      "module miter (input clk_i, input [{}:0] pins_i);\n  wire [{}:0] good_o, bad_o;\n{}{}"
      "  always @* assert ({});\nendmodule\n",
      total_width(recording.inputs) - 1, out - 1, copy("good", 0), copy("bad", mutant),
      alike(recording, qualifiers));
}

}  // namespace

bool proven_equivalent(const Recording& recording, const Qualifiers& qualifiers,
                       const std::string& folder, unsigned mutant, double limit_s) {
  const std::filesystem::path place(folder);
  write_file(place / "miter.sv", miter(recording, qualifiers, mutant));
  const std::string script = read_file(source_folder() + "/testbench/mutation/equivalent.ys.in");
  write_file(place / "equivalent.ys", fill_template(script, {{"RAM", ram_file()}}));
  const std::string log = (place / "equivalent.log").string();
  const auto made = run_process({find_tool("yosys", "yosys"), "-q", "equivalent.ys"}, folder, log,
                                10 * limit_s + 60);
  if (made.status != 0) return false;
  const std::string commands = fmt::format(
      "read_aiger miter.aig; fold; orpos; strash; lcorr; scorr; pdr -T {:.0f}", limit_s);
  run_process({find_tool("berkeley-abc", "berkeley-abc"), "-c", commands}, folder, log,
              10 * limit_s + 60);  // of the clock on the wall: the search counts its own time
  return read_file(log).find("Property proved") != std::string::npos;
}

}  // namespace kagesen
