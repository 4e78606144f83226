#pragma once
/// The subcommands: each adds itself, its options and what it does.
#include <CLI/CLI.hpp>

namespace kagesen {

void add_run(CLI::App& app);
void add_scenes(CLI::App& app);
void add_config(CLI::App& app);
void add_trace(CLI::App& app);
void add_gbuffer(CLI::App& app);
void add_results(CLI::App& app);
void add_stress(CLI::App& app);
void add_numerics(CLI::App& app);
void add_curve(CLI::App& app);
void add_cycles(CLI::App& app);
void add_gates(CLI::App& app);
void add_netlist(CLI::App& app);
void add_mutate(CLI::App& app);
void add_prove(CLI::App& app);
void add_coverage(CLI::App& app);
void add_rtl(CLI::App& app);
void add_explain(CLI::App& app);
void add_check(CLI::App& app);
void add_soak(CLI::App& app);

}  // namespace kagesen
