#include "sim/cli/results/winding_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/report/table.h"

namespace kagesen {
namespace {

constexpr std::uint64_t kWantedTimes = 256;  // of the map's side: 65,536 times its texels

std::uint64_t map_side() { return static_cast<std::uint64_t>(UnitConfig{}.map_width); }

/// What may break the contract without a fault of the arithmetic: texels without room.
std::uint64_t in_overflowed(const ErrorFigures& e) {
  return e.beyond_bound - e.causes[static_cast<std::size_t>(Cause::kOther)];
}

std::string beyond_text(const ErrorFigures& e) {
  if (e.beyond_bound == 0) return "0";
  return fmt::format("{} ({} for want of room)", grouped(e.beyond_bound),
                     grouped(in_overflowed(e)));
}

void add_to(ErrorFigures& sum, const ErrorFigures& e) {
  sum.judged += e.judged;
  sum.wrong += e.wrong;
  sum.beyond_bound += e.beyond_bound;
  for (std::size_t i = 0; i < kCauseCount; ++i) sum.causes[i] += e.causes[i];
}

std::string accuracy_section(const std::vector<SceneResults>& results) {
  std::string text =
      "\n### Accuracy\n\n"
      "Wrong fragments of the winding profile, set to each semantics in turn and held against it, "
      "and how many of them break its contract ([unit.md](unit.md)): farther than 2^-8 texel from "
      "every exact edge, and clear of contact. Beside them stand the paper profile with 8 bits and "
      "a plain map of the same side, in paper semantics. One line again: `./kagesen run SCENE "
      "--scale S --set profile=winding`.\n\n"
      "| scene | scale | judged | paper semantics: wrong | beyond the bound | paper profile: wrong "
      "| plain map: wrong | physical semantics: wrong | beyond the bound |\n"
      "|:--|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  ErrorFigures paper, physical;
  std::uint64_t profile = 0, plain = 0;
  for (const SceneResults& scene : results) {
    for (const WindingAccuracy& a : scene.winding.accuracy) {
      const Measurement& m = scene.at(a.scale, 8);
      text += fmt::format("| {0} | {1} x {1} | {2} | {3} | {4} | {5} | {6} | {7} | {8} |\n",
                          scene.name, a.scale, grouped(a.errors.paper.judged),
                          grouped(a.errors.paper.wrong), beyond_text(a.errors.paper),
                          grouped(m.paper.wrong), grouped(m.plain_same_side.wrong),
                          grouped(a.errors.physical.wrong), beyond_text(a.errors.physical));
      add_to(paper, a.errors.paper);
      add_to(physical, a.errors.physical);
      profile += m.paper.wrong;
      plain += m.plain_same_side.wrong;
    }
  }
  text += fmt::format("| **all** | | {} | {} | {} | {} | {} | {} | {} |\n", grouped(paper.judged),
                      grouped(paper.wrong), beyond_text(paper), grouped(profile), grouped(plain),
                      grouped(physical.wrong), beyond_text(physical));
  const std::uint64_t broken = paper.beyond_bound + physical.beyond_bound;
  const std::uint64_t room = in_overflowed(paper) + in_overflowed(physical);
  text += broken == 0 ? "\nThe contract held everywhere.\n"
                      : fmt::format(
                            "\n{} {} broke the contract: {} in texels that found no room and "
                            "answered as a plain map does (cause `capacity`), {} elsewhere.\n",
                            grouped(broken), broken == 1 ? "verdict" : "verdicts", grouped(room),
                            grouped(broken - room));
  return text;
}

/// How an equivalent side stands to the target.
struct Standing {
  std::uint64_t met = 0, no_error = 0, short_of = 0;
  double least = 0;  ///< multiple of the map's side, of those that fall short
  std::string place;
};

/// Four cells: wrong in the band, side, times, how it stands.
std::string standing_cells(const EquivalentResolution& e, const ErrorFigures& errors,
                           const std::string& place, Standing& standing) {
  const double times = double(e.side) / double(map_side());
  const bool passes = e.side >= kWantedTimes * map_side(), no_error = errors.band_wrong == 0;
  const std::string word = e.at_least || (no_error && !passes) ? "at least " : "";
  const std::string text = fmt::format("{} | {}{} | {}{:.3g} | ", grouped(errors.band_wrong), word,
                                       grouped(e.side), word, times);
  if (passes) {
    ++standing.met;
    return text + "passes";
  }
  if (no_error) {
    ++standing.no_error;
    return text + "no error";
  }
  if (standing.short_of++ == 0 || times < standing.least) {
    standing.least = times;
    standing.place = place;
  }
  return text + "**falls short**";
}

std::string standing_sentence(const char* semantics, const Standing& s) {
  std::string text = fmt::format("- {} semantics: {} of {} pass", semantics, s.met,
                                 s.met + s.no_error + s.short_of);
  if (s.no_error > 0) text += fmt::format(", {} have no error to compare", s.no_error);
  if (s.short_of > 0) {
    text += fmt::format(", {} fall short; the least is {:.3g} times the side ({})", s.short_of,
                        s.least, s.place);
  }
  return text + ".\n";
}

std::string resolution_section(const std::vector<SceneResults>& results) {
  std::string text = fmt::format(
      "\n### Effective resolution\n\n"
      "The side of the smallest plain map that errs no more in the band than the winding profile "
      "with 8 bits does on a map of {0} x {0}, and that side as a multiple of the map's; *at "
      "least* where {1}, the largest that was tried, still erred more. In physical semantics every "
      "plain map has the constant bias with which it errs least on the frame. The target is {2} "
      "times the side, {3} times the texels. *No error*: the unit made "
      "none in the whole band; the side is the least at which a plain map made none either in the "
      "sample that the search takes of it (at most 100,000 fragments). Again: the line *as good "
      "as* of `./kagesen run SCENE --scale S --set profile=winding --set "
      "semantics=paper|physical`.\n\n"
      "| scene | scale | paper semantics: wrong in the band | side | times | | physical semantics: "
      "wrong in the band | side | times | |\n"
      "|:--|--:|--:|--:|--:|:--|--:|--:|--:|:--|\n",
      grouped(map_side()), grouped(JudgeOptions{}.largest_plain_side), kWantedTimes,
      grouped(kWantedTimes * kWantedTimes));
  Standing paper, physical;
  for (const SceneResults& scene : results) {
    for (const WindingAccuracy& a : scene.winding.accuracy) {
      const std::string place = fmt::format("{}, {} x {}", scene.name, a.scale, a.scale);
      const std::string in_paper = standing_cells(a.equivalent.paper, a.errors.paper, place, paper);
      const std::string in_physical =
          standing_cells(a.equivalent.physical, a.errors.physical, place, physical);
      text += fmt::format("| {0} | {1} x {1} | {2} | {3} |\n", scene.name, a.scale, in_paper,
                          in_physical);
    }
  }
  return text + "\n" + standing_sentence("Paper", paper) + standing_sentence("Physical", physical);
}

}  // namespace

std::string winding_section(const std::vector<SceneResults>& results) {
  return "\n## The winding profile\n\n"
         "Our second profile ([unit.md](unit.md)), with its defaults: Fraction of 8 bits, all "
         "skips "
         "on.\n" +
         accuracy_section(results) + resolution_section(results) + memory_section(results) +
         skips_section(results) + first_test_section(results);
}

}  // namespace kagesen
