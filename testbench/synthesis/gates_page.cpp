#include <fmt/format.h>

#include <algorithm>

#include "testbench/synthesis/fanout.h"
#include "testbench/synthesis/gates_text.h"

namespace kagesen {
namespace {

constexpr const char* kHow = R"(# Gates

Written by `{}`.

Yosys maps the unit to the standard cells of Debian's `qflow-tech-osu018` (`--library osu035` for the
other library). A gate equivalent is the area of a NAND2X1. Memories (`ram_1r1w`) are black boxes: their
bits are counted apart. A latch or a cell that stays unmapped fails the run. OpenSTA finds the longest path
of the mapped netlist.

**Assumed**: memories answer {} ns after the clock and take their inputs {} ns before it; ports are
registers; settings stand still while a pass runs; no delay on wires, no skew; typical process, 1.8 V, 25
degrees. Clock and reset trees are not counted.

**The flow** (`testbench/synthesis`: `elaborate.ys.in`, `map.ys.in`, `abc.script`, `join.ys`). Each module is
mapped by itself, so that every block has a figure, and kept under a hash of its text, so that a run maps
what has changed; `--flatten` dissolves the blocks first. ABC gets no `dc2`: it takes the carry chains that
Yosys lays out as prefix trees apart into ripples. Its area mapper `amap`, on the structural choices of `dch`,
gives the smallest netlist, and `upsize` and `dnsize` then size it for its loads. ABC sees neither
what a register, a memory or a port drives nor what lies beyond a module: there trees of BUFX4 go in
(`fanout.h`: more than {} readers; {} a buffer), which the total has and the blocks have not. Other scripts:
`kagesen gates --top NAME --abc FILE`; a parameter's price: `kagesen gates --sweep`. `kagesen netlist unit`
plays the netlist, buffers and all, against the Verilog, with everything unknown at first: every bit
is right, in the winding profile too (`--set profile=winding`).
)";

std::string block_table(const GateReport& report) {
  std::vector<std::pair<std::string, BlockReport>> blocks(report.blocks.begin(),
                                                          report.blocks.end());
  std::stable_sort(blocks.begin(), blocks.end(),
                   [](const auto& a, const auto& b) { return a.second.ge > b.second.ge; });
  std::string text =
      "| block | instances | own GE | with what it holds | memory bits "
      "|\n|---|---:|---:|---:|---:|\n";
  for (const auto& [name, block] : blocks) {
    text += fmt::format("| {} | {} | {:.0f} | {:.0f} | {} |\n", name, block.instances, block.own_ge,
                        block.ge, block.memory_bits);
  }
  return text;
}

std::string library_table(const std::vector<GateReport>& reports) {
  std::string text = "| profile | library | GE | MHz |\n|---|---|---:|---:|\n";
  for (const GateReport& r : reports) {
    text +=
        fmt::format("| {} | {} | {:.0f} | {:.1f} |\n", r.profile, r.library, r.total_ge, r.fmax_mhz);
  }
  return text;
}

std::string sweep_page(const std::vector<SweepRow>& rows) {
  std::string text =
      "| profile | key | value | GE | MHz | memory bits |\n|---|---|---:|---:|---:|---:|\n";
  for (const SweepRow& row : rows) {
    text += fmt::format("| {} | `{}` | {}{} | {:.0f} | {:.1f} | {} |\n", row.report.profile, row.key,
                        row.value, row.standard ? "*" : "", row.report.total_ge,
                        row.report.fmax_mhz, row.report.memory_bits);
  }
  return text;
}

}  // namespace

std::string gates_page(const GatesPage& page, const std::string& command) {
  std::string text =
      fmt::format(kHow, command, kRamAccessNs, kRamSetupNs, kMostReaders, kMostBuffered);
  for (const GateReport& report : page.profiles) {
    text += fmt::format(
        "\n## Profile {}\n\n{:.0f} GE, {:.0f} of it in {} flip-flops, {:.0f} in buffers; {} memory "
        "bits; {:.1f} MHz "
        "(longest path {}).\n{}, {}, scripts {}.\n\n{}",
        report.profile, report.total_ge, report.flop_ge, report.flops, report.buffer_ge,
        report.memory_bits, report.fmax_mhz, report.critical_path, report.library, report.tools,
        report.scripts, block_table(report));
  }
  text += "\n## The other library\n\n" + library_table(page.other_library);
  if (!page.sweep.empty()) {
    text += "\n## What a parameter costs\n\nOne key at a time, all others as configured; * the "
            "configuration's own value.\n\n" +
            sweep_page(page.sweep);
  }
  return text;
}

}  // namespace kagesen
