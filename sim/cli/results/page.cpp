#include "sim/cli/results/page.h"

#include <fmt/format.h>

#include "sim/cli/results/winding_page.h"
#include "sim/report/table.h"

namespace kagesen {
namespace {

std::string kilobytes(std::uint64_t bytes) { return fmt::format("{:.1f}", double(bytes) / 1024); }

/// A rate that a person can compare: fragments in a million.
std::string per_million(double rate) { return fmt::format("{:.1f}", rate * 1e6); }

std::string equivalent(const EquivalentResolution& e) {
  if (e.side == 0) return "-";
  return fmt::format("{}{}", e.at_least ? "≥ " : "", grouped(e.side));
}

std::string runs_table(const SceneResults& scene, unsigned bits,
                       const std::vector<unsigned>& scales) {
  std::string text = fmt::format(
      "\n**{} bits**\n\n"
      "| scale | silhouette texels | lines | payload KiB | allocated KiB | wrong | per million | "
      "in the band, per million | equivalent side | plain, same side: wrong | plain, equal bytes: "
      "wrong (side) |\n|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n",
      bits);
  for (const unsigned scale : scales) {
    const Measurement& m = scene.at(scale, bits);
    text += fmt::format(
        "| {0} x {0} | {1} | {2} | {3} | {4} | {5} | {6} | {7} | {8} | {9} | {10} ({11}) |\n",
        scale, grouped(m.texels), grouped(m.lines), kilobytes(m.payload_bytes),
        kilobytes(m.allocated_bytes), grouped(m.paper.wrong), per_million(m.paper.rate()),
        per_million(m.paper.band_rate()), equivalent(m.equivalent),
        grouped(m.plain_same_side.wrong), grouped(m.plain_equal_bytes.wrong),
        grouped(m.plain_equal_bytes.side));
  }
  return text;
}

std::string causes_table(const SceneResults& scene, const std::vector<unsigned>& scales) {
  std::string head = "| scale | bits | false lit | false dark |", rule = "|--:|--:|--:|--:|";
  for (std::size_t i = 1; i < kCauseCount; ++i) {
    head += fmt::format(" {} |", cause_name(static_cast<Cause>(i)));
    rule += "--:|";
  }
  std::string text = fmt::format("\n**Causes**\n\n{}\n{}\n", head, rule);
  for (const unsigned bits : {8u, 4u}) {
    for (const unsigned scale : scales) {
      const ErrorFigures& e = scene.at(scale, bits).paper;
      text += fmt::format("| {0} x {0} | {1} | {2} | {3} |", scale, bits, grouped(e.false_lit),
                          grouped(e.false_dark));
      for (std::size_t i = 1; i < kCauseCount; ++i) {
        text += fmt::format(" {} |", grouped(e.causes[i]));
      }
      text += "\n";
    }
  }
  return text;
}

}  // namespace

double payload_kb(std::uint64_t texels, std::uint64_t lines) {
  return (42.0 * double(texels) + 36.0 * double(lines)) / 8 / 1024;
}

std::string results_page(const std::vector<SceneResults>& results, const ResultsOptions& options,
                         const std::string& images, const std::string& stress) {
  std::string text = fmt::format(
      "# Results\n\n"
      "First the paper, reproduced; then our winding profile beside it; then every scene by "
      "itself.\n\n"
      "Made by `./kagesen results`; every figure but the run times is a count on a fixed input, so "
      "every machine gets the same. Frames of {} x {} pixels, a map of 1024 x 1024 texels, each "
      "profile with its defaults (`./kagesen config`); unless the winding profile is named, what "
      "is measured is the paper profile with Fraction and Slope of 8 or 4 bits.\n\n"
      "*Scale* is the paper's virtual projection space: at 16 x 16 the same map covers 16 times "
      "more an axis, and what the camera sees stays the same. *Wrong* counts fragments whose "
      "verdict differs from the exact one in the paper's semantics (an object never shadows "
      "itself); *the band* is every fragment within one texel of a true shadow edge, so it widens "
      "with the scale. *Equivalent side* is the smallest plain shadow map with no more errors in "
      "that band. *Payload* counts entries and lines alone, *allocated* the buckets, links and "
      "tags "
      "too. A plain map holds a depth and an object ID a texel; *equal bytes* gives it all that "
      "the unit allocates.\n",
      options.image_width, options.image_height);
  text += paper_section(results);
  text += findings_section(results, options.scales);
  text += winding_section(results);
  text += stress;
  for (const SceneResults& scene : results) {
    text += fmt::format("\n## {}\n\n{}. {} triangles in {} objects, {} fragments.\n", scene.name,
                        scene.description, grouped(scene.triangles), grouped(scene.objects),
                        grouped(scene.runs.front().fragments));
    text += fmt::format(
        "\n![The same window of {0} at every scale: 8 bits, 4 bits, plain map]({1}/{0}.png)\n",
        scene.name, images);
    text += runs_table(scene, 8, options.scales);
    text += runs_table(scene, 4, options.scales);
    text += causes_table(scene, options.scales);
  }
  return text;
}

}  // namespace kagesen
