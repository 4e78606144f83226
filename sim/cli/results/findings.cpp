#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sim/cli/results/page.h"
#include "sim/report/table.h"

namespace kagesen {
namespace {

/// The built-in scene of the kind that the paper's Fig 8 shows.
constexpr const char* kLikeFig8 = "solids";

/// All scenes together at one scale and width.
struct Total {
  std::uint64_t judged = 0, wrong = 0, plain = 0, plain_equal = 0, beyond = 0;
  std::uint64_t false_lit = 0, false_dark = 0;
  std::array<std::uint64_t, kCauseCount> causes{};
  std::uint64_t cause(Cause c) const { return causes[static_cast<std::size_t>(c)]; }
};

Total total(const std::vector<SceneResults>& results, unsigned scale, unsigned bits) {
  Total t;
  for (const SceneResults& scene : results) {
    const Measurement& m = scene.at(scale, bits);
    t.judged += m.paper.judged;
    t.wrong += m.paper.wrong;
    t.plain += m.plain_same_side.wrong;
    t.plain_equal += m.plain_equal_bytes.wrong;
    t.beyond += m.paper.beyond_bound;
    t.false_lit += m.paper.false_lit;
    t.false_dark += m.paper.false_dark;
    for (std::size_t i = 0; i < kCauseCount; ++i) t.causes[i] += m.paper.causes[i];
  }
  return t;
}

std::string largest_cause(const Total& t) {
  const auto largest = std::max_element(t.causes.begin() + 1, t.causes.end());
  if (*largest == 0) return "-";
  return fmt::format("{} ({:.0f} %)", cause_name(static_cast<Cause>(largest - t.causes.begin())),
                     100.0 * double(*largest) / double(t.wrong));
}

double ratio(std::uint64_t a, std::uint64_t b) {
  return double(a) / double(std::max<std::uint64_t>(b, 1));
}

std::string totals_table(const std::vector<SceneResults>& results,
                         const std::vector<unsigned>& scales) {
  std::string text =
      "\n| scale | judged | 8 bits: wrong | of them false dark | largest cause | 4 bits: wrong | "
      "largest cause | plain, same side | plain, equal bytes (8 bits) |\n"
      "|--:|--:|--:|--:|:--|--:|:--|--:|--:|\n";
  for (const unsigned scale : scales) {
    const Total eight = total(results, scale, 8), four = total(results, scale, 4);
    text += fmt::format("| {0} x {0} | {1} | {2} | {3} | {4} | {5} | {6} | {7} | {8} |\n", scale,
                        grouped(eight.judged), grouped(eight.wrong), grouped(eight.false_dark),
                        largest_cause(eight), grouped(four.wrong), largest_cause(four),
                        grouped(eight.plain), grouped(eight.plain_equal));
  }
  return text;
}

bool has(const std::vector<unsigned>& scales, std::initializer_list<unsigned> wanted) {
  return std::all_of(wanted.begin(), wanted.end(), [&](unsigned scale) {
    return std::find(scales.begin(), scales.end(), scale) != scales.end();
  });
}

/// One claim on the scene of Fig 8's kind, and the same figures on everything.
struct Evidence {
  std::string text, verdict;
};
std::string judged(bool agrees) { return agrees ? "Agrees" : "Does not agree"; }
using Examine = Evidence (*)(const std::vector<SceneResults>&);

std::string claim(const std::string& words, const std::vector<SceneResults>& results,
                  Examine examine) {
  std::string text = "- *" + words + "*";
  for (const SceneResults& scene : results) {
    if (scene.name != kLikeFig8) continue;
    const Evidence evidence = examine({scene});
    text += fmt::format(" {} on `{}`: {}.", evidence.verdict, scene.name, evidence.text);
  }
  if (results.size() > 1 || results.front().name != kLikeFig8) {
    const Evidence evidence = examine(results);
    text += fmt::format(" {} over all scenes: {}.", evidence.verdict, evidence.text);
  }
  return text + "\n";
}

Evidence chipping(const std::vector<SceneResults>& results) {
  const Total eight = total(results, 16, 8), four = total(results, 16, 4);
  const std::uint64_t chipped = four.cause(Cause::kQuantisation);
  return {
      fmt::format("at 16 x 16, {} wrong fragments with 4 bits and {} with 8; of these {} and {} "
                  "are quantisation, the part that bits mend",
                  grouped(four.wrong), grouped(eight.wrong), grouped(chipped),
                  grouped(eight.cause(Cause::kQuantisation))),
      judged(chipped >= 4 * eight.cause(Cause::kQuantisation) && 2 * chipped >= four.wrong)};
}

Evidence constancy(const std::vector<SceneResults>& results) {
  const Total one = total(results, 1, 8), sixteen = total(results, 16, 8),
              sixty_four = total(results, 64, 8);
  const double share = 100 * ratio(sixty_four.wrong, sixty_four.judged);
  return {fmt::format("{} wrong at 1 x 1, {} at 16 x 16, {} at 64 x 64, which is {:.3f} % of what "
                      "was judged; the largest cause there: {}",
                      grouped(one.wrong), grouped(sixteen.wrong), grouped(sixty_four.wrong), share,
                      largest_cause(sixty_four)),
          judged(share < 0.1)};
}

Evidence dark_lines(const std::vector<SceneResults>& results) {
  const Total before = total(results, 64, 8), at = total(results, 256, 8);
  const std::uint64_t depth = at.cause(Cause::kDepth) + at.cause(Cause::kHiddenRemoval);
  const bool seen = at.false_dark > 2 * before.false_dark;
  return {
      fmt::format("from 64 x 64 to 256 x 256, false dark goes from {} to {} and false lit from "
                  "{} to {}; depth and the removal of hidden lines cause {:.0f} % at 256 x 256, "
                  "the largest cause is {}",
                  grouped(before.false_dark), grouped(at.false_dark), grouped(before.false_lit),
                  grouped(at.false_lit), 100 * ratio(depth, at.wrong), largest_cause(at)),
      seen && 10 * depth < at.wrong ? "Agrees in what is seen, not in its cause," : judged(seen)};
}

/// Where the unit stops being better than a plain map of its own side.
std::string crossing(const std::vector<SceneResults>& results,
                     const std::vector<unsigned>& scales) {
  std::string better, worse;
  for (const unsigned scale : scales) {
    const Total t = total(results, scale, 8);
    std::string& list = t.wrong <= t.plain ? better : worse;
    list += fmt::format("{}{} ({:.2f})", list.empty() ? "" : ", ", scale, ratio(t.wrong, t.plain));
  }
  return fmt::format(
      "- *As good as 65,536 times the texels.* Wrong fragments of 8 bits as a share of those of a "
      "plain map of the same side: {}{}{}. The equivalent side of each scene stands in its "
      "table.\n",
      better.empty() ? "" : "fewer at scale " + better,
      better.empty() || worse.empty() ? "" : "; more at scale ", worse);
}

}  // namespace

std::string findings_section(const std::vector<SceneResults>& results,
                             const std::vector<unsigned>& scales) {
  std::string text =
      "\n## What the paper says of its pictures, and what we measure\n\n"
      "All scenes together:\n";
  text += totals_table(results, scales) + "\n";
  if (has(scales, {16})) {
    text += claim("Edges of 4 bits chip at 16 x 16; more bits mend it.", results, chipping);
  }
  if (has(scales, {1, 16, 64})) {
    text += claim("8 bits look nearly constant up to 64 x 64 (here: less than 1 in 1000 wrong).",
                  results, constancy);
  }
  if (has(scales, {64, 256})) {
    text += claim("Dark lines appear from 256 x 256, because an entry holds one depth.", results,
                  dark_lines);
  }
  text += crossing(results, scales);
  std::uint64_t other = 0;
  for (const unsigned scale : scales) {
    for (const unsigned bits : {4u, 8u}) other += total(results, scale, bits).cause(Cause::kOther);
  }
  text +=
      fmt::format("- Fragments without a known cause, all scenes, scales and widths: {}.\n", other);
  text +=
      "\nWhy *combination* leads: the unit joins the lines of one object in a texel by AND and OR, "
      "pair "
      "by pair. That is right for the outline of a convex object, and for two lines that meet in a "
      "vertex. Where an object overlaps itself as the light sees it, the lines of its nearer part "
      "lie "
      "inside the outline of its farther part, and no choice of AND and OR of pairs says so; the "
      "paper "
      "names the case (4.5: tori, concave objects) and would split such objects into convex ones. "
      "At "
      "large scales a texel holds many vertices and unrelated lines of even a convex object.\n";
  return text;
}

}  // namespace kagesen
