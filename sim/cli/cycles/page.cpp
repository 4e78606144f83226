#include <fmt/format.h>

#include <algorithm>

#include "sim/cli/cycles/rows.h"
#include "traces/format/words.h"

namespace kagesen {
namespace {

/// "slb 8.9 %, decision 1.2 %": the causes of lost cycles, largest first.
std::string lost(const PassCycles& pass, const std::vector<std::string>& work) {
  auto causes = pass.causes;
  std::stable_sort(causes.begin(), causes.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (const auto& [name, cycles] : causes) {
    const double share = 100.0 * double(cycles) / double(std::max<std::uint64_t>(pass.total, 1));
    if (share < 0.5 || std::find(work.begin(), work.end(), name) != work.end()) continue;
    text += fmt::format("{}{} {:.0f} %", text.empty() ? "" : ", ", name, share);
  }
  return text;
}

std::string ratio(double value, std::uint64_t of) {
  return of == 0 ? "" : fmt::format("{:.2f}", value);
}

void add_profile(const std::string& profile, const std::vector<CyclesRow>& rows,
                 std::string& page) {
  page += fmt::format(
      "\n## {} profile\n\n"
      "| scene | scale | clocks a fragment | lost to | clocks an edge texel | clocks a span texel | "
      "lost to | wipe and receiver mask, clocks |\n"
      "|---|--:|--:|---|--:|--:|---|--:|\n",
      profile == "paper" ? "Paper" : "Winding");
  double per_fragment = 0, per_edge_texel = 0;
  std::uint64_t fragments = 0, pass2 = 0, count = 0;
  for (const CyclesRow& r : rows) {
    if (r.profile != profile) continue;
    const CycleReport& c = r.cycles;
    page += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", r.scene, r.scale,
                        ratio(c.pass2->per_item(), c.pass2->items), lost(*c.pass2, {"fragment"}),
                        ratio(c.per_edge_texel(), c.edge_texels),
                        ratio(c.per_span_texel(), c.span_texels),
                        lost(*c.pass1, {"edge", "span"}), grouped(*c.clear + *c.announce));
    per_fragment += c.pass2->per_item();
    per_edge_texel += c.per_edge_texel();
    fragments += r.fragments;
    pass2 += c.pass2->total;
    ++count;
  }
  if (count == 0) return;
  page += fmt::format(
      "\nMean of the rows: {:.2f} clocks a fragment, {:.2f} an edge texel. Of all fragments together: "
      "{:.2f} clocks each.\n",
      per_fragment / double(count), per_edge_texel / double(count),
      fragments ? double(pass2) / double(fragments) : 0);
}

}  // namespace

std::string cycles_page(const std::vector<CyclesRow>& rows) {
  const bool verilog = !rows.empty() && rows.front().engine == "rtl";
  std::string page = fmt::format(
      "# Clock cycles\n\nWritten by `kagesen cycles{}` from runs of {}.\n\n",
      verilog ? " --engine rtl" : "",
      verilog ? "the Verilated RTL"
              : "the SystemC model, whose cycles `kagesen check` holds\nequal to the Verilog's");
  page +=
      "Built-in scenes at 1920 x 1080, a 1024 x 1024 map, one lane, memories that answer after 20 "
      "cycles and take a\nrequest every cycle. [rtl.md](rtl.md) says what each cause of a lost cycle "
      "is; shares below half a per cent are left\nout. An edge texel's clocks are all of pass 1 but "
      "those that carried out spans. The paper states about 4 clocks a\npixel for a first-level "
      "SLB.\n";
  for (const char* profile : {"paper", "winding"}) add_profile(profile, rows, page);
  std::uint64_t cycles = 0;
  double seconds = 0;
  for (const CyclesRow& r : rows) {
    const CycleReport& c = r.cycles;
    cycles += c.total();
    seconds += r.seconds;
  }
  page += fmt::format("\nSimulated: {} cycles in {:.0f} s.\n", grouped(cycles), seconds);
  return page;
}

}  // namespace kagesen
