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

struct Sums {
  std::uint64_t fragments = 0, violations = 0;
};

std::string run_sentence(const nlohmann::json& run, Sums& sums) {
  const nlohmann::json& total = run.at("total");
  const auto count = [&](const char* key) { return total.at(key).get<std::uint64_t>(); };
  sums.fragments += count("fragments");
  sums.violations += count("violations");
  return fmt::format(
      "- Seed {}: {} and {} in {:.1f} minutes; {} verdicts judged, {} compared with each other, "
      "{}.\n",
      run.at("seed").get<std::uint64_t>(), counted(count("cases"), "case"),
      counted(count("fragments"), "fragment"), run.at("seconds").get<double>() / 60,
      grouped(count("verdicts_judged")), grouped(count("verdicts_compared")),
      counted(count("violations"), "violation"));
}

}  // namespace

std::string stress_section(const std::string& path) {
  if (!std::filesystem::exists(path)) return "";
  try {
    std::ifstream in(path);
    nlohmann::json runs = nlohmann::json::parse(in);
    if (!runs.is_array()) runs = nlohmann::json::array({runs});
    std::string text = fmt::format(
        "\n## Stress\n\n"
        "Random and adversarial geometry, held against the exact reference and against itself "
        "moved, turned, refined and shuffled: `./kagesen stress --profile winding --seed N "
        "--minutes M --json FILE`; `{}` holds what it wrote, or a list of that.\n\n",
        std::filesystem::path(path).filename().string());
    Sums sums;
    for (const nlohmann::json& run : runs) text += run_sentence(run, sums);
    const bool reached = sums.fragments >= kWantedFragments && sums.violations == 0;
    return text + fmt::format("\n{} in all, {}. The target is none in {} fragments: {}.\n",
                              counted(sums.fragments, "fragment"),
                              counted(sums.violations, "violation"), grouped(kWantedFragments),
                              reached ? "reached" : "**not reached**");
  } catch (const nlohmann::json::exception&) {
    throw UserError(path, "is not what 'kagesen stress --json' writes",
                    "make it again, or remove it");
  }
}

}  // namespace kagesen
