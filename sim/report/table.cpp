#include "sim/report/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace kagesen {
namespace {

/// Rows "label  text"; the label is empty where a row continues the one above.
class Rows {
 public:
  void add(const std::string& label, const std::string& text) {
    out_ += fmt::format("  {:<18}{}\n", label, text);
  }
  void heading(const std::string& text) { out_ += fmt::format("\n{}\n", text); }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

std::string displacement(const ErrorFigures& e) {
  if (e.wrong == 0) return "-";
  // The largest of capped figures is as far as the search went; all that equal it lie farther.
  const auto text = [&](double texels) {
    const bool farther = e.displacement_capped && texels >= e.displacement_max;
    return fmt::format("{}{:.4f}", farther ? ">" : "", texels);
  };
  return text(e.displacement_mean) + " / " + text(e.displacement_p99) + " / " +
         text(e.displacement_max);
}

void error_rows(Rows& rows, const Judgement& judgement) {
  const ErrorFigures& paper = judgement.paper;
  const ErrorFigures& physical = judgement.physical;
  const auto row = [&](const std::string& label, const std::string& a, const std::string& b) {
    rows.add(label, fmt::format("{:>28}{:>28}", a, b));
  };
  const auto count = [&](const std::string& label, std::uint64_t ErrorFigures::*field) {
    row(label, grouped(paper.*field), grouped(physical.*field));
  };
  rows.heading("Error against the exact reference");
  row("", "paper (own ID lit)", "physical");
  count("judged", &ErrorFigures::judged);
  count("wrong", &ErrorFigures::wrong);
  count("  false lit", &ErrorFigures::false_lit);
  count("  false dark", &ErrorFigures::false_dark);
  row("wrong of judged", one_in(paper.wrong, paper.judged),
      one_in(physical.wrong, physical.judged));
  row("wrong in the band", one_in(paper.band_wrong, paper.band),
      one_in(physical.band_wrong, physical.band));
  row("mean/p99/max texel", displacement(paper), displacement(physical));
  count("beyond the bound", &ErrorFigures::beyond_bound);
  for (std::size_t i = 1; i < kCauseCount; ++i) {
    if (paper.causes[i] == 0 && physical.causes[i] == 0) continue;
    row(fmt::format("  {}", cause_name(static_cast<Cause>(i))), grouped(paper.causes[i]),
        grouped(physical.causes[i]));
  }
}

void plain_rows(Rows& rows, const Judgement& judgement) {
  const EquivalentResolution& equivalent = judgement.equivalent_resolution;
  rows.heading("Beside a plain shadow map (paper semantics)");
  if (equivalent.side > 0) {
    rows.add("as good as", fmt::format("{}{} x {} texels", equivalent.at_least ? "at least " : "",
                                       grouped(equivalent.side), grouped(equivalent.side)));
  }
  const auto plain = [&](const std::string& label, const PlainFigures& p) {
    if (p.side == 0) return;
    rows.add(label, fmt::format("{} x {}, {}: {} wrong, {} of them in the band", grouped(p.side),
                                grouped(p.side), bytes_text(p.bytes), grouped(p.wrong),
                                grouped(p.band_wrong)));
  };
  plain("of the same side", judgement.plain_same_side);
  plain("of equal bytes", judgement.plain_equal_bytes);
}

void scene_exact_rows(Rows& rows, const SceneExact& exact) {
  rows.heading("Against rays on the meshes before snapping");
  const auto row = [&](const std::string& label, const std::string& a, const std::string& b) {
    rows.add(label, fmt::format("{:>28}{:>28}", a, b));
  };
  row("", "paper (own ID lit)", "physical");
  row("judged", grouped(exact.unit.judged), grouped(exact.unit.judged));
  row("unit differs", grouped(exact.unit.paper.wrong()), grouped(exact.unit.physical.wrong()));
  if (exact.trace) {
    row("trace differs", grouped(exact.trace->paper.wrong()),
        grouped(exact.trace->physical.wrong()));
  }
}

std::string chain_text(const UnitCounters& counters) {
  std::string text;
  for (std::size_t n = 1; n < counters.chain_histogram.size(); ++n) {
    if (counters.chain_histogram[n] == 0) continue;
    if (text.size() > 60) return text + ", ...";
    text +=
        fmt::format("{}{}: {}", text.empty() ? "" : ", ", n, grouped(counters.chain_histogram[n]));
  }
  return text.empty() ? "none" : text;
}

std::string percent(std::uint64_t part, std::uint64_t whole) {
  return whole ? fmt::format("{:.1f} %", 100.0 * double(part) / double(whole)) : "-";
}

}  // namespace

std::string bytes_text(std::uint64_t bytes) {
  if (bytes < 1024) return fmt::format("{} B", bytes);
  if (bytes < 1024 * 1024) return fmt::format("{:.1f} KiB", double(bytes) / 1024);
  return fmt::format("{:.1f} MiB", double(bytes) / (1024 * 1024));
}

std::string one_in(std::uint64_t part, std::uint64_t whole) {
  if (part == 0) return "none";
  if (part > whole / 20) return percent(part, whole);
  return fmt::format("1 in {}", grouped(std::max<std::uint64_t>(1, (whole + part / 2) / part)));
}

std::string report_table(const Trace& trace, const RunResult& result,
                         const std::vector<std::string>& files) {
  const TraceHeader& header = trace.header;
  const UnitCounters& counters = result.counters;
  const Summary s = summarise(trace, result);
  Rows rows;
  rows.heading("Input");
  rows.add("scene", fmt::format("{}, {} light", header.source, header.light));
  rows.add("", fmt::format("{} in {}, {} of them closed", counted(s.triangles, "triangle"),
                           counted(s.objects, "object"), grouped(s.closed_objects)));
  rows.add("image", fmt::format("{} x {}, {}", header.image_width, header.image_height,
                                counted(s.fragments, "fragment")));
  rows.add("map", fmt::format("{} x {} texels, scale {:g} x {:g}, {}", result.contents.width,
                              result.contents.height, header.scale_x, header.scale_y,
                              bytes_text(counters.map_bytes)));
  rows.add("engine", fmt::format("{}, fraction {}, slope {}", result.engine,
                                 counted(std::uint64_t(result.config.fraction_bits), "bit"),
                                 counted(std::uint64_t(result.config.slope_bits), "bit")));

  rows.heading("Silhouette line buffer");
  rows.add("texels",
           fmt::format("{} of {} ({})", grouped(counters.slb_texels),
                       grouped(std::uint64_t(result.contents.width) * result.contents.height),
                       percent(counters.slb_texels,
                               std::uint64_t(result.contents.width) * result.contents.height)));
  rows.add("lines", fmt::format("{} in {}", grouped(counters.slb_lines),
                                grouped(counters.slb_entries) +
                                    (counters.slb_entries == 1 ? " entry" : " entries")));
  rows.add("memory", fmt::format("{} payload, {} allocated", bytes_text(counters.payload_bytes),
                                 bytes_text(counters.allocated_bytes)));
  rows.add("entries a texel",
           fmt::format("{} (longest {})", chain_text(counters), counters.max_chain));
  if (counters.overflow_texels > 0) {
    rows.add("overflow", fmt::format("{} in {}", counted(counters.overflow_lines, "line"),
                                     counted(counters.overflow_texels, "texel")));
  }

  rows.heading("Verdicts");
  rows.add("dark", fmt::format("{} ({})", grouped(s.dark), percent(s.dark, s.fragments)));
  rows.add("lit", fmt::format("{} ({})", grouped(s.lit), percent(s.lit, s.fragments)));
  rows.add("by definition", fmt::format("{} averted (dark), {} outside the light (lit)",
                                        grouped(counters.averted), grouped(counters.outside)));
  if (result.judgement) {
    error_rows(rows, *result.judgement);
    plain_rows(rows, *result.judgement);
  }
  if (result.scene_exact) scene_exact_rows(rows, *result.scene_exact);

  rows.heading("Time");
  for (const auto& [name, seconds] : result.stages_s) {
    rows.add(name, fmt::format("{:8.3f} s", seconds));
  }
  rows.add("total", fmt::format("{:8.3f} s", result.time_s()));
  if (!result.warnings.empty()) {
    rows.heading("Warnings");
    for (const std::string& warning : result.warnings) rows.add("", warning);
  }
  if (!files.empty()) {
    rows.heading("Written");
    for (const std::string& file : files) rows.add("", file);
  }
  return rows.take().substr(1);
}

}  // namespace kagesen
