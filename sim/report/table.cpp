#include "sim/report/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/report/fragment_figures.h"
#include "sim/report/rows.h"

namespace kagesen {
namespace {

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

void error_rows(Rows& rows, const RunResult& result) {
  const ErrorFigures& paper = result.judgement->paper;
  const ErrorFigures& physical = result.judgement->physical;
  const auto count = [&](const std::string& label, std::uint64_t ErrorFigures::*field) {
    rows.pair(label, grouped(paper.*field), grouped(physical.*field));
  };
  const bool winding = result.config.profile == Profile::kWinding;
  rows.heading(winding ? "Error against the exact reference (the unit set to each semantics)"
                       : "Error against the exact reference (the same verdicts against both)");
  if (winding) contract_rows(rows, result);
  rows.pair("", "paper (own ID lit)", "physical");
  count("judged", &ErrorFigures::judged);
  count("wrong", &ErrorFigures::wrong);
  count("  false lit", &ErrorFigures::false_lit);
  count("  false dark", &ErrorFigures::false_dark);
  rows.pair("wrong of judged", one_in(paper.wrong, paper.judged),
            one_in(physical.wrong, physical.judged));
  rows.pair("wrong in the band", one_in(paper.band_wrong, paper.band),
            one_in(physical.band_wrong, physical.band));
  rows.pair("mean/p99/max texel", displacement(paper), displacement(physical));
  count("beyond the bound", &ErrorFigures::beyond_bound);
  for (std::size_t i = 1; i < kCauseCount; ++i) {
    if (paper.causes[i] == 0 && physical.causes[i] == 0) continue;
    rows.pair(fmt::format("  {}", cause_name(static_cast<Cause>(i))), grouped(paper.causes[i]),
              grouped(physical.causes[i]));
  }
}

const char* semantics_name(Semantics semantics) {
  return semantics == Semantics::kPaper ? "paper" : "physical";
}

void plain_rows(Rows& rows, const RunResult& result) {
  const Judgement& judgement = *result.judgement;
  const EquivalentResolution& equivalent = judgement.equivalent_resolution;
  const bool physical = main_semantics(result.config) == Semantics::kPhysical;
  rows.heading(fmt::format("Beside a plain shadow map ({} semantics)",
                           semantics_name(main_semantics(result.config))));
  if (equivalent.side > 0) {
    rows.add("as good as", fmt::format("{}{} x {} texels", equivalent.at_least ? "at least " : "",
                                       grouped(equivalent.side), grouped(equivalent.side)));
  }
  const auto plain = [&](const std::string& label, const PlainFigures& p) {
    if (p.side == 0) return;
    rows.add(label, fmt::format("{} x {}, {}{}: {} wrong, {} of them in the band", grouped(p.side),
                                grouped(p.side), bytes_text(p.bytes),
                                physical ? fmt::format(", bias {}", grouped(p.bias)) : "",
                                grouped(p.wrong), grouped(p.band_wrong)));
  };
  plain("of the same side", judgement.plain_same_side);
  plain("of equal bytes", judgement.plain_equal_bytes);
}

void scene_exact_rows(Rows& rows, const SceneExact& exact) {
  rows.heading("Against rays on the meshes before snapping");
  rows.pair("", "paper (own ID lit)", "physical");
  rows.pair("judged", grouped(exact.unit.judged), grouped(exact.unit.judged));
  rows.pair("unit differs", grouped(exact.unit.paper.wrong()),
            grouped(exact.unit.physical.wrong()));
  if (exact.trace) {
    rows.pair("trace differs", grouped(exact.trace->paper.wrong()),
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

/// What of each kind of object is drawn.
std::string drawn_text(const Summary& s) {
  std::string text;
  const auto add = [&](std::uint64_t count, const char* kind, const char* what) {
    if (count == 0) return;
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", grouped(count), kind, what);
  };
  add(s.drawn_light_facing, "closed", " (light-facing side)");
  add(s.drawn_all, "open", " (every triangle)");
  add(s.receivers, s.receivers == 1 ? "receiver" : "receivers", " (nothing)");
  return text.empty() ? "nothing" : text;
}

/// Several to a line of the table, as many as there is room for.
void add_list(Rows& rows, std::string label, const std::vector<std::string>& items) {
  constexpr std::size_t kWidth = 78;
  std::string line;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string item = items[i] + (i + 1 < items.size() ? "," : "");
    if (!line.empty() && line.size() + 1 + item.size() > kWidth) {
      rows.add(label, line);
      label.clear();
      line.clear();
    }
    line += (line.empty() ? "" : " ") + item;
  }
  if (!line.empty()) rows.add(label, line);
}

/// "1.05 a texel: edge 40.0 %, record 3.1 %, ..."; causes in the order of their weight.
void pass_rows(Rows& rows, const char* label, const PassCycles& pass, const char* item) {
  std::vector<std::pair<std::string, std::uint64_t>> causes = pass.causes;
  std::stable_sort(causes.begin(), causes.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  const std::string total = fmt::format("{}, {:.3f} a {}", grouped(pass.total), pass.per_item(), item);
  std::vector<std::string> items;
  for (const auto& [name, cycles] : causes) {
    if (cycles * 1000 < pass.total || cycles == 0) break;
    items.push_back((items.empty() ? total + ": " : "") + name + " " + percent(cycles, pass.total));
  }
  if (items.empty()) items.push_back(total);
  add_list(rows, label, items);
}

void fragment_rows(Rows& rows, const Trace& trace, const RunResult& result) {
  const FragmentFigures f =
      fragment_figures(trace, result.fragment_cycles, result.cycles->pass2->total);
  rows.add("cycles a fragment", fmt::format("p50 {}, p99 {}, most {}", f.p50, f.p99, f.most));
  rows.add("worst tile", fmt::format("{:.2f} a fragment, {} x {} pixels from ({}, {})", f.tile_mean,
                                     f.kTile, f.kTile, f.tile_x, f.tile_y));
  rows.add("in flight", fmt::format("{:.1f} fragments, {:.1f} cycles each, at most {}", f.in_flight,
                                    f.latency_mean, grouped(f.latency_most)));
}

void traffic_row(Rows& rows, const char* label, const PassCycles& pass, const char* item) {
  if (!pass.traffic || pass.items == 0) return;
  const MemoryTraffic& t = *pass.traffic;
  const auto each = [&](std::uint64_t n) { return double(n) / double(pass.items); };
  rows.add(label, fmt::format("{:.3f} texel words and {:.3f} SLB records a {}, {:.1f} bytes",
                              each(t.texel_reads), each(t.slb_reads), item,
                              each(t.texel_bytes + t.slb_bytes)));
}

/// How full queues were, and how often words were there.
void queue_rows(Rows& rows, const char* label, const PassCycles& pass) {
  std::vector<std::string> items;
  for (const QueueCycles& q : pass.queues) {
    items.push_back(fmt::format("{} {:.1f} (most {})", q.name, q.mean(), q.most()));
  }
  add_list(rows, label, items);
  for (const CacheCounts& c : pass.caches) {
    rows.add("", fmt::format("{}: {:.1f} % of {} there", c.name, 100 * c.hit_rate(),
                             counted(c.lookups, "look-up")));
  }
}

void cycle_rows(Rows& rows, const Trace& trace, const RunResult& result) {
  const CycleReport& cycles = *result.cycles;
  rows.heading("Clock cycles");
  if (cycles.clear) rows.add("clear", grouped(*cycles.clear));
  if (cycles.announce.value_or(0) > 0) rows.add("announce", grouped(*cycles.announce));
  if (cycles.pass1) {
    pass_rows(rows, "pass 1", *cycles.pass1, "texel");
    rows.add("", fmt::format("{:.3f} an edge texel, {:.3f} a span texel", cycles.per_edge_texel(),
                             cycles.per_span_texel()));
    traffic_row(rows, "", *cycles.pass1, "texel");
    queue_rows(rows, "queues of pass 1", *cycles.pass1);
  }
  if (cycles.settle.value_or(0) > 0) rows.add("settle", grouped(*cycles.settle));
  if (const std::optional<double> frames = result.frames_per_s()) {
    rows.add("frames a second", fmt::format("{:.1f} at the {:.1f} MHz that kagesen gates found ({})",
                                            *frames, result.clock->mhz, result.clock->source));
  }
  if (!cycles.pass2) return;
  pass_rows(rows, "pass 2", *cycles.pass2, "fragment");
  if (!result.fragment_cycles.empty()) fragment_rows(rows, trace, result);
  traffic_row(rows, "memory reads", *cycles.pass2, "fragment");
  queue_rows(rows, "queues of pass 2", *cycles.pass2);
}

std::string engine_text(const RunResult& result) {
  const UnitConfig& config = result.config;
  const std::string fraction = counted(std::uint64_t(config.fraction_bits), "bit");
  if (config.profile == Profile::kWinding) {
    return fmt::format("{}, winding profile, {} semantics, fraction {}", result.engine,
                       semantics_name(config.semantics), fraction);
  }
  return fmt::format("{}, fraction {}, slope {}", result.engine, fraction,
                     counted(std::uint64_t(config.slope_bits), "bit"));
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
  const bool winding = result.config.profile == Profile::kWinding;
  Rows rows;
  rows.heading("Input");
  rows.add("scene", fmt::format("{}, {} light", header.source, header.light));
  rows.add("", fmt::format("{} in {}, {} of them closed", counted(s.triangles, "triangle"),
                           counted(s.objects, "object"), grouped(s.closed_objects)));
  rows.add("drawn", drawn_text(s));
  rows.add("image", fmt::format("{} x {}, {}", header.image_width, header.image_height,
                                counted(s.fragments, "fragment")));
  rows.add("map", fmt::format("{} x {} texels, scale {:g} x {:g}, {}", result.contents.width,
                              result.contents.height, header.scale_x, header.scale_y,
                              bytes_text(counters.map_bytes)));
  rows.add("engine", engine_text(result));

  rows.heading("Silhouette line buffer");
  rows.add("texels",
           fmt::format("{} of {} ({})", grouped(counters.slb_texels),
                       grouped(std::uint64_t(result.contents.width) * result.contents.height),
                       percent(counters.slb_texels,
                               std::uint64_t(result.contents.width) * result.contents.height)));
  if (winding) {
    rows.add("segments", fmt::format("{} in {}", grouped(counters.slb_lines),
                                     counted(counters.slb_entries, "cluster")));
  } else {
    rows.add("lines", fmt::format("{} in {}", grouped(counters.slb_lines),
                                  grouped(counters.slb_entries) +
                                      (counters.slb_entries == 1 ? " entry" : " entries")));
  }
  rows.add("memory", fmt::format("{} payload, {} allocated", bytes_text(counters.payload_bytes),
                                 bytes_text(counters.allocated_bytes)));
  rows.add(winding ? "records a texel" : "entries a texel",
           fmt::format("{} (longest {})", chain_text(counters), counters.max_chain));
  if (counters.overflow_texels > 0) {
    rows.add("overflow",
             fmt::format("{} in {}", counted(counters.overflow_lines, winding ? "segment" : "line"),
                         counted(counters.overflow_texels, "texel")));
  }

  rows.heading("Verdicts");
  rows.add("dark", fmt::format("{} ({})", grouped(s.dark), percent(s.dark, s.fragments)));
  rows.add("lit", fmt::format("{} ({})", grouped(s.lit), percent(s.lit, s.fragments)));
  rows.add("by definition", fmt::format("{} averted (dark), {} outside the light (lit)",
                                        grouped(counters.averted), grouped(counters.outside)));
  if (result.judgement) {
    error_rows(rows, result);
    plain_rows(rows, result);
  }
  if (winding) skip_rows(rows, result);
  if (result.scene_exact) scene_exact_rows(rows, *result.scene_exact);

  if (result.cycles) cycle_rows(rows, trace, result);

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
