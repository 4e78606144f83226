#include "sim/cli/check_options.h"

#include "sim/cli/nearest.h"
#include "sim/cli/parse.h"
#include "sim/memory/configured_timing.h"
#include "traces/format/error.h"

namespace kagesen {

void add_bench_options(CLI::App& command, BenchOptions& options) {
  const auto add = [&](const char* name, std::string& value, const char* type, const char* help) {
    return command.add_option(name, value, help)->type_name(type)->group("Bench");
  };
  add("--latency", options.latency, "N|N-M",
      "Cycles from a memory request to its response; a range: random, out of order");
  add("--stalls", options.stalls, "PERCENT", "Cycles in which a memory port takes nothing");
  add("--stream-stalls", options.stream_stalls, "PERCENT",
      "Cycles in which no triangle or fragment is offered, or no verdict taken");
  add("--seed", options.seed, "N", "Of latencies, stalls and aborts (1)");
  add("--build", options.build, "KIND",
      "fast, check (assertions; what is undefined is random), trace or coverage")
      ->capture_default_str();
}

BuildKind build_kind(const BenchOptions& options) {
  if (options.build == "fast") return BuildKind::kFast;
  if (options.build == "check") return BuildKind::kCheck;
  if (options.build == "trace") return BuildKind::kTrace;
  if (options.build == "coverage") return BuildKind::kCoverage;
  throw UserError("--build", "there is no '" + options.build + "'",
                  suggestion(options.build, {"fast", "check", "trace", "coverage"}));
}

std::uint64_t parse_count(const std::string& option, const std::string& text, double least,
                          double most) {
  const double value = parse_number(option, text, least, most);
  if (value != static_cast<double>(static_cast<std::uint64_t>(value))) {
    throw UserError(option, "'" + text + "' is not a whole number", "give one without a fraction");
  }
  return static_cast<std::uint64_t>(value);
}

Timing timing_of(const BenchOptions& options, const UnitConfig& config) {
  Timing timing = configured_timing(config);
  const auto count = [](const char* option, const std::string& text, double least, double most) {
    return static_cast<std::uint32_t>(parse_count(option, text, least, most));
  };
  if (!options.latency.empty()) {
    const std::size_t dash = options.latency.find('-', 1);
    timing.latency = count("--latency", options.latency.substr(0, dash), 1, 1000);
    if (dash != std::string::npos) {
      timing.spread = count("--latency", options.latency.substr(dash + 1), timing.latency, 2000) -
                      timing.latency;
    }
  }
  if (!options.stalls.empty()) timing.memory_stall = count("--stalls", options.stalls, 0, 99);
  if (!options.stream_stalls.empty()) {
    timing.stream_stall = count("--stream-stalls", options.stream_stalls, 0, 99);
  }
  if (!options.seed.empty()) timing.seed = parse_count("--seed", options.seed, 0, 0x1p53);
  return timing;
}

}  // namespace kagesen
