#pragma once
/// What `kagesen check` and `kagesen soak` have in common: how the unit is built and run.
#include <CLI/CLI.hpp>
#include <string>

#include "testbench/verilator/build.h"

namespace kagesen {

/// As typed; empty where the option was not given.
struct BenchOptions {
  std::string latency, stalls, stream_stalls, seed, build = "fast";
};
void add_bench_options(CLI::App& command, BenchOptions& options);

BuildKind build_kind(const BenchOptions& options);
/// The configuration's memory, as far as the options do not say otherwise.
Timing timing_of(const BenchOptions& options, const UnitConfig& config);
/// A whole number in a range.
std::uint64_t parse_count(const std::string& option, const std::string& text, double least,
                          double most);

}  // namespace kagesen
