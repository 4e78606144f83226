#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sim/cli/results/winding_page.h"
#include "traces/format/error.h"
#include "traces/format/words.h"

namespace kagesen {
namespace {

constexpr std::uint64_t kWantedFragments = 100'000'000;

}  // namespace

std::string stress_section(const std::string& path) {
  if (!std::filesystem::exists(path)) return "";
  try {
    std::ifstream in(path);
    const nlohmann::json run = nlohmann::json::parse(in);
    const nlohmann::json& total = run.at("total");
    const auto count = [&](const char* key) { return total.at(key).get<std::uint64_t>(); };
    const std::uint64_t fragments = count("fragments"), violations = count("violations");
    const bool reached = fragments >= kWantedFragments && violations == 0;
    return fmt::format(
        "\n## Stress\n\n"
        "Random and adversarial geometry in both profiles, held against the exact reference and "
        "against itself moved, turned, refined and shuffled: `./kagesen stress --seed {0} "
        "--minutes "
        "N --json {7}`.\n\n"
        "Seed {0}: {1} and {2} in {3:.0f} minutes; {4} verdicts judged, {5} compared with each "
        "other, {6}. The target is none in {8} fragments: {9}.\n",
        run.at("seed").get<std::uint64_t>(), counted(count("cases"), "case"),
        counted(fragments, "fragment"), run.at("seconds").get<double>() / 60,
        grouped(count("verdicts_judged")), grouped(count("verdicts_compared")),
        counted(violations, "violation"), std::filesystem::path(path).filename().string(),
        grouped(kWantedFragments), reached ? "reached" : "**not reached**");
  } catch (const nlohmann::json::exception&) {
    throw UserError(path, "is not what 'kagesen stress --json' writes",
                    "make it again, or remove it");
  }
}

}  // namespace kagesen
