#include "sim/report/json.h"

#include "sim/report/fragment_figures.h"

namespace kagesen {
namespace {

using Json = nlohmann::ordered_json;

Json input_json(const Trace& trace, const RunResult& result) {
  const TraceHeader& header = trace.header;
  const Summary summary = summarise(trace, result);
  return {{"name", header.source},
          {"sha256", header.source_sha256},
          {"triangles", summary.triangles},
          {"fragments", summary.fragments},
          {"objects", summary.objects},
          {"closed_objects", summary.closed_objects},
          {"receivers", summary.receivers},
          {"objects_drawn",
           {{"light_facing", summary.drawn_light_facing},
            {"all", summary.drawn_all},
            {"receivers", summary.receivers}}},
          {"casters", summary.casters},
          {"light", header.light},
          {"scale", {header.scale_x, header.scale_y}},
          {"fraction_bits", header.fraction_bits},
          {"image", {{"width", header.image_width}, {"height", header.image_height}}}};
}

Json error_json(const ErrorFigures& figures) {
  Json causes = Json::object();
  for (std::size_t i = 1; i < kCauseCount; ++i) {
    causes[cause_name(static_cast<Cause>(i))] = figures.causes[i];
  }
  Json json = {{"judged", figures.judged},         {"wrong", figures.wrong},
               {"false_lit", figures.false_lit},   {"false_dark", figures.false_dark},
               {"rate", figures.rate()},           {"band", figures.band},
               {"band_wrong", figures.band_wrong}, {"band_rate", figures.band_rate()}};
  json["displacement_texels"] = {{"mean", figures.displacement_mean},
                                 {"p99", figures.displacement_p99},
                                 {"max", figures.displacement_max},
                                 {"capped", figures.displacement_capped}};
  json["beyond_bound"] = figures.beyond_bound;
  json["causes"] = causes;
  return json;
}

Json plain_json(const PlainFigures& plain) {
  return {{"side", plain.side},
          {"bytes", plain.bytes},
          {"bias", plain.bias},
          {"wrong", plain.wrong},
          {"band_wrong", plain.band_wrong}};
}

Json judgement_json(const Judgement& judgement) {
  Json json = {{"paper", error_json(judgement.paper)},
               {"physical", error_json(judgement.physical)}};
  const EquivalentResolution& equivalent = judgement.equivalent_resolution;
  if (equivalent.side > 0) {
    json["equivalent_resolution"] = {{"side", equivalent.side}, {"at_least", equivalent.at_least}};
  }
  if (judgement.plain_same_side.side > 0) {
    json["plain"] = {{"same_side", plain_json(judgement.plain_same_side)},
                     {"equal_bytes", plain_json(judgement.plain_equal_bytes)}};
  }
  return json;
}

Json scene_exact_json(const SceneExactReport& report) {
  const auto figures = [](const SceneExactFigures& f) -> Json {
    return {{"wrong", f.wrong()}, {"false_lit", f.false_lit}, {"false_dark", f.false_dark}};
  };
  return {{"judged", report.judged},
          {"skipped", report.skipped},
          {"ignored", report.ignored},
          {"paper", figures(report.paper)},
          {"physical", figures(report.physical)}};
}

Json scene_exact_json(const SceneExact& exact) {
  Json json = {{"unit", scene_exact_json(exact.unit)}};
  if (exact.trace) json["trace"] = scene_exact_json(*exact.trace);
  return json;
}

Json slb_json(const UnitCounters& counters) {
  return {{"texels", counters.slb_texels},
          {"lines", counters.slb_lines},
          {"payload_bytes", counters.payload_bytes},
          {"allocated_bytes", counters.allocated_bytes},
          {"entries", counters.slb_entries},
          {"peak_entries", counters.peak_entries},
          {"max_chain", counters.max_chain},
          {"chain_histogram", counters.chain_histogram},
          {"overflow", {{"lines", counters.overflow_lines}, {"texels", counters.overflow_texels}}}};
}

Json counters_json(const UnitCounters& c) {
  return {{"casters", c.casters},
          {"edges", c.edges},
          {"edge_texels", c.edge_texels},
          {"span_texels", c.span_texels},
          {"lines_stored", c.lines_stored},
          {"lines_cancelled", c.lines_cancelled},
          {"lines_hidden", c.lines_hidden},
          {"emptied_covered", c.emptied_covered},
          {"collisions", c.collisions},
          {"fragments", c.fragments},
          {"averted", c.averted},
          {"outside", c.outside},
          {"dark_by_buffer", c.dark_by_buffer},
          {"dark_by_lines", c.dark_by_lines},
          {"lit", c.lit},
          {"slb_lookups", c.slb_lookups},
          {"entries_read", c.entries_read},
          {"lines_read", c.lines_read},
          {"aliased_objects", c.aliased_objects}};
}

Json skips_json(const SkipCounters& s) {
  return {{"texel_visits", s.texel_visits},
          {"masked_visits", s.masked_visits},
          {"hidden_visits", s.hidden_visits},
          {"inner_edge_texels", s.inner_edge_texels},
          {"cleared_texels", s.cleared_texels},
          {"known_fragments", s.known_fragments},
          {"tile_lit", s.tile_lit},
          {"tile_dark", s.tile_dark},
          {"texel_lookups", s.texel_lookups},
          {"first_test_dark", s.first_test_dark}};
}

Json traffic_json(const MemoryTraffic& t, std::uint64_t items) {
  return {{"texel_reads", t.texel_reads},
          {"texel_bytes", t.texel_bytes},
          {"slb_reads", t.slb_reads},
          {"slb_bytes", t.slb_bytes},
          {"bytes_per_item", items ? double(t.texel_bytes + t.slb_bytes) / double(items) : 0}};
}

Json pass_json(const PassCycles& pass) {
  Json causes = Json::object(), queues = Json::object(), caches = Json::object();
  for (const auto& [name, cycles] : pass.causes) causes[name] = cycles;
  for (const QueueCycles& q : pass.queues) {
    queues[q.name] = {{"mean", q.mean()}, {"most", q.most()}, {"cycles", q.cycles}};
  }
  for (const CacheCounts& c : pass.caches) {
    caches[c.name] = {{"lookups", c.lookups}, {"misses", c.misses}, {"hit_rate", c.hit_rate()}};
  }
  Json json = {{"total", pass.total},
               {"items", pass.items},
               {"per_item", pass.per_item()},
               {"causes", causes}};
  if (!queues.empty()) json["queues"] = queues;
  if (!caches.empty()) json["caches"] = caches;
  if (pass.traffic) json["traffic"] = traffic_json(*pass.traffic, pass.items);
  return json;
}

Json fragment_json(const FragmentFigures& f) {
  return {{"mean", f.mean},
          {"p50", f.p50},
          {"p99", f.p99},
          {"most", f.most},
          {"worst_tile",
           {{"x", f.tile_x},
            {"y", f.tile_y},
            {"pixels", FragmentFigures::kTile},
            {"mean", f.tile_mean},
            {"fragments", f.tile_fragments}}},
          {"latency_mean", f.latency_mean},
          {"latency_most", f.latency_most},
          {"in_flight", f.in_flight}};
}

Json cycles_json(const Trace& trace, const RunResult& result) {
  const CycleReport& cycles = *result.cycles;
  Json json = Json::object();
  if (cycles.clear) json["clear"] = *cycles.clear;
  if (cycles.announce) json["announce"] = *cycles.announce;
  if (cycles.pass1) {
    Json& pass1 = json["pass1"] = pass_json(*cycles.pass1);
    pass1["edge_texels"] = cycles.edge_texels;
    pass1["span_texels"] = cycles.span_texels;
    pass1["per_edge_texel"] = cycles.per_edge_texel();
    pass1["per_span_texel"] = cycles.per_span_texel();
  }
  if (cycles.settle) json["settle"] = *cycles.settle;
  if (cycles.pass2) {
    Json& pass2 = json["pass2"] = pass_json(*cycles.pass2);
    if (!result.fragment_cycles.empty()) {
      pass2["fragment"] =
          fragment_json(fragment_figures(trace, result.fragment_cycles, cycles.pass2->total));
    }
  }
  if (const std::optional<double> frames = result.frames_per_s()) {
    json["clock"] = {{"fmax_mhz", result.clock->mhz},
                     {"source", result.clock->source},
                     {"frames_per_s", *frames}};
  }
  return json;
}

}  // namespace

nlohmann::ordered_json config_json(const UnitConfig& config) {
  Json json = Json::object();
  for (const ConfigField& field : config_fields()) {
    const std::string value = get_field(config, field.key);
    if (field.choices.empty()) {
      json[field.key] = std::stoll(value);
    } else if (value == "true" || value == "false") {
      json[field.key] = value == "true";
    } else {
      json[field.key] = value;
    }
  }
  return json;
}

nlohmann::ordered_json report_json(const Trace& trace, const RunResult& result) {
  const Summary summary = summarise(trace, result);
  Json json = {{"schema_version", kReportSchemaVersion},
               {"input", input_json(trace, result)},
               {"seeds", {{"scene", trace.header.seed}}},
               {"config", config_json(result.config)},
               {"engine", result.engine},
               {"verdict",
                {{"fragments", summary.fragments}, {"dark", summary.dark}, {"lit", summary.lit}}}};
  if (result.judgement) json["error"] = judgement_json(*result.judgement);
  if (result.scene_exact) json["scene_exact"] = scene_exact_json(*result.scene_exact);
  json["slb"] = slb_json(result.counters);
  json["map"] = {{"width", result.contents.width},
                 {"height", result.contents.height},
                 {"bytes", result.counters.map_bytes}};
  json["counters"] = counters_json(result.counters);
  if (result.config.profile == Profile::kWinding) json["skips"] = skips_json(result.counters.skips);
  if (result.cycles) json["cycles"] = cycles_json(trace, result);
  json["warnings"] = result.warnings;
  json["time_s"] = result.time_s();
  Json stages = Json::object();
  for (const auto& [name, seconds] : result.stages_s) stages[name] = seconds;
  json["stages_s"] = stages;
  return json;
}

}  // namespace kagesen
