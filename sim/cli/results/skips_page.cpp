#include <fmt/format.h>

#include <string>

#include "sim/cli/results/winding_page.h"
#include "sim/report/rows.h"
#include "sim/report/table.h"

namespace kagesen {
namespace {

constexpr double kSlowest = 1.05;  // with all skips, times the run time with none

std::string heads(const SkipUse& any) {
  std::string head = "| scene |", rule = "|:--|";
  for (const SkipShare& share : skip_shares(any.counters, any.map_texels)) {
    head += fmt::format(" {} |", share.skip);
    rule += "--:|";
  }
  return head + " compared | differ | all on, ms | all off, ms | on / off |\n" + rule +
         "--:|--:|--:|--:|--:|\n";
}

std::string row(const std::string& scene, const SkipUse& use) {
  std::string text = fmt::format("| {} |", scene);
  for (const SkipShare& share : skip_shares(use.counters, use.map_texels)) {
    text += fmt::format(" {} |", percent(share.skipped, share.all));
  }
  const double ratio = use.on_s / use.off_s;
  return text + fmt::format(" {} | {} | {:.1f} | {:.1f} | {:.2f}{} |\n", grouped(use.compared),
                            grouped(use.differing), 1000 * use.on_s, 1000 * use.off_s, ratio,
                            ratio > kSlowest ? " **(slower)**" : "");
}

std::string skip_table(const std::vector<SceneResults>& results, Semantics semantics) {
  std::string text;
  std::string slower;
  std::uint64_t compared = 0, differing = 0;
  for (const SceneResults& scene : results) {
    if (!scene.winding.skips) continue;
    const SkipUse& use = scene.winding.skips->in(semantics);
    if (text.empty()) text = heads(use);
    text += row(scene.name, use);
    compared += use.compared;
    differing += use.differing;
    if (use.on_s > kSlowest * use.off_s) slower += (slower.empty() ? "" : ", ") + scene.name;
  }
  return text + fmt::format(
                    "\nOf {} verdicts {} differ. Slower with the skips than {} times "
                    "without: {}.\n",
                    grouped(compared), differing ? grouped(differing) : "none", kSlowest,
                    slower.empty() ? "no scene" : slower);
}

std::string rate(const ReductionRates& rates, const ReductionRate& rate) {
  return fmt::format("{:.2f} %", 100 * rates.share(rate));
}

}  // namespace

std::string skips_section(const std::vector<SceneResults>& results) {
  std::string text = fmt::format(
      "\n### Skips\n\n"
      "At scale 1: the share of the work that each skip avoided ([guide.md](guide.md) says of what "
      "it is a share), and, *hidden*, what covers of texels refused, which is no skip. "
      "*Compared*: verdicts with all skips off, and with each alone off, held against those with "
      "all on; how many *differ*. The times are of clearing, announcing the fragments and both "
      "passes with all skips on and all off, the best of five each, taken by turns on the machine "
      "that made this page; what the host prepares of a frame (stage *setup*) is left out. The "
      "target "
      "is no scene above {}. Again: section *Skipped* and the "
      "times of `./kagesen run SCENE --set profile=winding`, with `--set skip_...=false`.\n",
      kSlowest);
  text += "\n**Physical semantics**\n\n" + skip_table(results, Semantics::kPhysical);
  text += "\n**Paper semantics**\n\n" + skip_table(results, Semantics::kPaper);
  return text;
}

std::string first_test_section(const std::vector<SceneResults>& results) {
  std::string text =
      "\n### Conservative first test\n\n"
      "The share of judged fragments that a conservative shadow map decides (*reduction rate*): "
      "they lie behind a triangle that covers their whole texel, beyond its farthest corner there. "
      "By Hertel's test a triangle covers a texel where its edges leave the texel's circumscribed "
      "circle alone, by the exact one where it holds all four corners. Scale 1, physical "
      "semantics; "
      "*generation* is the time to clear the map and draw it, the best of three on the machine "
      "that "
      "made this page. Above stand the two scenes in Table 3 of Mizokuchi and Tokuyoshi (IIEEJ "
      "2018), on their GPU, and their exact test. Only this command measures it.\n\n"
      "| scene | map | Hertel: rate | exact: rate | Hertel: generation, ms | exact: generation, ms "
      "|\n|:--|--:|--:|--:|--:|--:|\n"
      "| *their Fig 6 (b)* | 2048 x 2048 | 55.5 % | 56.0 % | 0.48 | 0.47 |\n"
      "| *their Fig 6 (e)* | 2048 x 2048 | 35.8 % | 37.4 % | 4.75 | 4.72 |\n";
  for (const SceneResults& scene : results) {
    for (const FirstTest& test : scene.winding.first_test) {
      const ReductionRates& r = test.rates;
      text += fmt::format("| {0} | {1} x {1} | {2} | {3} | {4:.1f} | {5:.1f} |\n", scene.name,
                          test.side, rate(r, r.circle), rate(r, r.corners),
                          1000 * r.circle.generation_s, 1000 * r.corners.generation_s);
    }
  }
  return text;
}

}  // namespace kagesen
