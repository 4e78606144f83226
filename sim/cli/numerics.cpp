#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "sim/cli/commands.h"
#include "sim/cli/parse.h"
#include "sim/cli/progress.h"
#include "sim/cli/stopwatch.h"
#include "sim/report/outputs.h"
#include "tests/stress/numerics/page.h"

namespace kagesen {
namespace {

struct NumericsArguments {
  std::string page = "docs/numerics.md", seconds, seed = "1";
};

constexpr std::uint64_t kSamples = 20'000;  ///< of each quantity, unless --seconds says otherwise

/// Samples of each quantity that take about this long together.
std::uint64_t samples_for(double seconds, const std::vector<stress::Quantity>& quantities,
                          std::uint64_t seed) {
  Stopwatch watch;
  constexpr std::uint64_t kTrial = 200;
  for (const stress::Quantity& q : quantities) stress::find_worst(q, seed, kTrial);
  return std::max<std::uint64_t>(kTrial,
                                 static_cast<std::uint64_t>(seconds / watch.lap() * kTrial));
}

void write_numerics(const NumericsArguments& arguments) {
  Progress progress(true);
  const auto seed = static_cast<std::uint64_t>(parse_number("--seed", arguments.seed, 0, 0x1p53));
  std::string command = fmt::format("kagesen numerics --seed {}", seed);
  const std::vector<stress::Quantity> quantities = stress::all_quantities();
  std::uint64_t samples = kSamples;
  if (!arguments.seconds.empty()) {
    const double seconds = parse_number("--seconds", arguments.seconds, 0, 1e7);
    samples = samples_for(seconds, quantities, seed);
    command += fmt::format(" --seconds {:g}", seconds);
  }
  Outputs outputs;
  const std::filesystem::path page(arguments.page);
  if (page.has_parent_path()) outputs.make_folder(page.parent_path().string());
  std::ostream& text = outputs.open(arguments.page, "--out");

  std::vector<stress::Measured> measured;
  std::uint64_t exceeded = 0;
  for (const stress::Quantity& q : quantities) {
    progress.update(q.profile + ", " + q.name, double(measured.size()) / double(quantities.size()));
    measured.push_back({q, stress::find_worst(q, seed, samples)});
    exceeded += measured.back().worst.exceeded;
  }
  text << stress::numerics_page(measured, command);
  outputs.commit();
  progress.clear();
  for (const stress::Measured& m : measured) {
    if (m.worst.exceeded == 0) continue;
    std::cout << fmt::format("{}, {}: beyond its bound in {} of {} samples\n", m.quantity.profile,
                             m.quantity.name, m.worst.exceeded, m.worst.samples);
  }
  std::cout << arguments.page << "\n" << std::flush;
  if (exceeded > 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_numerics(CLI::App& app) {
  auto arguments = std::make_shared<NumericsArguments>();
  CLI::App& command = *app.add_subcommand(
      "numerics", "Measures every fixed-point quantity against its bound, into docs/numerics.md");
  command.add_option("--out", arguments->page, "The page")
      ->type_name("FILE")
      ->capture_default_str();
  command
      .add_option("--seconds", arguments->seconds,
                  "About how long; a fixed number of samples if not given")
      ->type_name("N");
  command.add_option("--seed", arguments->seed, "What the inputs are drawn from")
      ->type_name("N")
      ->capture_default_str();
  command.footer("Exit status 1 if a bound was exceeded.");
  command.callback([arguments] { write_numerics(*arguments); });
}

}  // namespace kagesen
