#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "model/frame_setup.h"
#include "sim/cli/commands.h"
#include "sim/cli/input.h"
#include "sim/cli/progress.h"
#include "sim/report/outputs.h"
#include "sim/systemc/engine.h"
#include "traces/format/error.h"
#include "traces/format/words.h"

namespace kagesen {
namespace {

using Json = nlohmann::ordered_json;

struct ExplainOptions {
  InputOptions input;
  SettingsOptions settings;
  std::string json;
};

/// Something that may hold the unit up, and how to take it away.
struct Bottleneck {
  const char* name;
  const char* without;
  std::function<void(UnitConfig&)> remove;
};

/// Some lie beyond what the Verilog can be built with: they ask what is there to be won.
const std::vector<Bottleneck>& bottlenecks() {
  static const std::vector<Bottleneck> all = {
      {"memory_latency", "memory that answers in the next cycle",
       [](UnitConfig& c) { c.memory_latency = 1, c.memory_spread = 0; }},
      {"memory_bandwidth", "memory that takes a request in every cycle",
       [](UnitConfig& c) {
         c.memory_stall = 0, c.memory_interval = 1, c.memory_outstanding = 0;
         c.memory_bank_busy = 1, c.memory_row_miss = 0;
       }},
      {"fragment_slots", "16,384 fragments in flight a lane",
       [](UnitConfig& c) { c.fragment_slots = 1 << 14; }},
      {"lines_per_record", "a record that holds 15 lines of an entry",
       [](UnitConfig& c) { c.lines_per_entry = c.segments_per_record = 15; }},
      {"collisions", "4,194,304 buckets of the address hash",
       [](UnitConfig& c) { c.slb_buckets = 1 << 22; }},
      {"caches", "a cache of 4,096 lines behind each port",
       [](UnitConfig& c) { c.texel_cache_lines = c.slb_cache_lines = 4096; }},
      {"words_on_chip", "256 texel words and records on chip in pass 1",
       [](UnitConfig& c) { c.texel_lines = c.record_lines = 256; }},
      {"lanes", "one more lane",
       [](UnitConfig& c) { c.lanes = std::min<std::int64_t>(c.lanes + 1, 4); }},
  };
  return all;
}

CycleReport run_model(const Trace& trace, const UnitConfig& config) {
  const std::unique_ptr<Engine> engine = make_systemc_engine();
  const std::vector<Fragment>& fragments = trace.all_fragments;
  std::vector<Verdict> verdicts(fragments.size());
  engine->begin(config, make_frame_setup(trace, config));
  engine->announce(fragments.data(), fragments.size());
  engine->draw(trace.all_casters.data(), trace.all_casters.size());
  engine->decide(fragments.data(), fragments.size(), verdicts.data());
  return *engine->cycles();
}

/// Wiping aside, which grows with what some of the settings add.
std::uint64_t worked(const CycleReport& report) {
  return report.total() - report.clear.value_or(0);
}

std::string lost_text(const PassCycles& pass) {
  std::vector<std::pair<std::string, std::uint64_t>> causes;
  for (const auto& cause : pass.causes) {
    const bool carried_out =
        cause.first == "edge" || cause.first == "span" || cause.first == "fragment";
    if (!carried_out && cause.second > 0) causes.push_back(cause);
  }
  std::stable_sort(causes.begin(), causes.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (const auto& [name, cycles] : causes) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, grouped(cycles));
  }
  return text.empty() ? "none" : text;
}

struct Gain {
  const Bottleneck* bottleneck;
  std::uint64_t cycles;  // without it
};

/// "- 12.3 %", or what it costs.
std::string change_text(std::uint64_t before, std::uint64_t after) {
  return fmt::format("{:+.2f} %", 100 * (double(after) - double(before)) / double(before));
}

void explain(ExplainOptions& options) {
  const bool to_stdout = options.json == "-";
  Progress progress(!to_stdout);
  Settings settings = load_settings(options.settings);
  Outputs outputs;
  std::ostream* json =
      options.json.empty() || to_stdout ? nullptr : &outputs.open(options.json, "--json");
  const Trace trace =
      load_trace(resolve_input(options.input), options.input, settings, progress.callback());
  if (trace.all_fragments.empty()) {
    throw UserError(options.input.name, "no fragment to decide", "turn the camera to the scene");
  }
  const auto run = [&](const UnitConfig& config, std::size_t step) {
    progress.update("running the model", double(step) / double(bottlenecks().size() + 1));
    return run_model(trace, config);
  };
  const CycleReport base = run(settings.config, 0);
  const std::uint64_t total = worked(base);
  std::vector<Gain> gains;
  for (const Bottleneck& b : bottlenecks()) {
    UnitConfig config = settings.config;
    b.remove(config);
    gains.push_back({&b, worked(run(config, gains.size() + 1))});
  }
  std::stable_sort(gains.begin(), gains.end(),
                   [](const Gain& a, const Gain& b) { return a.cycles < b.cycles; });
  progress.clear();

  Json out = {{"cycles", total}, {"without", Json::array()}};
  for (const Gain& g : gains) {
    out["without"].push_back({{"bottleneck", g.bottleneck->name},
                              {"with", g.bottleneck->without},
                              {"cycles", g.cycles},
                              {"saved", double(total) - double(g.cycles)}});
  }
  const std::string text = out.dump(2) + "\n";
  if (json) *json << text;
  outputs.commit();
  if (to_stdout) {
    std::cout << text;
    return;
  }
  const PassCycles &pass1 = *base.pass1, &pass2 = *base.pass2;
  std::cout << fmt::format("{} cycles, wiping aside: pass 1 {}, pass 2 {}, {:.3f} a fragment.\n",
                           grouped(total), grouped(pass1.total), grouped(pass2.total),
                           pass2.per_item());
  const bool first_longer = pass1.total > pass2.total;
  std::cout << fmt::format("Pass {} loses cycles to: {}.\n", first_longer ? 1 : 2,
                           lost_text(first_longer ? pass1 : pass2));
  const auto line = [&](const char* words, const Gain& g) {
    std::cout << fmt::format("{} {}: {} cycles, {}.\n", words, g.bottleneck->without,
                             grouped(g.cycles), change_text(total, g.cycles));
  };
  line("Most would bring", gains[0]);
  line("Then", gains[1]);
  std::string rest;
  for (std::size_t i = 2; i < gains.size(); ++i) {
    rest += fmt::format("{}{} {}", rest.empty() ? "" : ", ", gains[i].bottleneck->name,
                        change_text(total, gains[i].cycles));
  }
  std::cout << "The others: " << rest << ".\n";
}

}  // namespace

void add_explain(CLI::App& app) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App& command = *app.add_subcommand(
      "explain",
      "Says in five lines what bounds a frame: runs the SystemC model again without each bottleneck");
  add_input_options(command, options->input, InputUse::kRun);
  add_settings_options(command, options->settings);
  command.add_option("--json", options->json, "The figures here; - prints them and nothing else")
      ->type_name("FILE|-");
  command.callback([options] { explain(*options); });
}

}  // namespace kagesen
