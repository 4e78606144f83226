#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/cli/results/page.h"
#include "sim/report/table.h"

namespace kagesen {
namespace {

/// One column of the paper's Table 8, and the built-in scene of the same kind.
struct Table8Column {
  const char* figure;
  unsigned scale;
  std::uint64_t texels, lines;
  double kilobytes;
  const char* ours;
};

// The printed table names two scales for the three columns of Fig 10; the text and the falling
// number of texels make the third 16 x 16.
constexpr std::array<Table8Column, 11> kTable8{{
    {"Fig 8", 1, 3272, 3324, 31.4, "solids"},
    {"Fig 8", 4, 1104, 1154, 10.7, "solids"},
    {"Fig 8", 16, 274, 342, 2.9, "solids"},
    {"Fig 8", 64, 68, 154, 1.0, "solids"},
    {"Fig 8", 256, 14, 106, 0.5, "solids"},
    {"Fig 8", 1024, 4, 96, 0.4, "solids"},
    {"Fig 9", 1, 23606, 24882, 235.3, "boxes"},
    {"Fig 9", 16, 1159, 2421, 20.1, "boxes"},
    {"Fig 10", 1, 4503, 4733, 44.2, "avenue"},
    {"Fig 10", 4, 3112, 3620, 31.9, "avenue"},
    {"Fig 10", 16, 2145, 3753, 27.3, "avenue"},
}};

const Measurement* find(const std::vector<SceneResults>& results, const Table8Column& column) {
  for (const SceneResults& scene : results) {
    if (scene.name != column.ours) continue;
    for (const Measurement& m : scene.runs) {
      if (m.scale == column.scale && m.bits == 8) return &m;
    }
  }
  return nullptr;
}

}  // namespace

std::string paper_section(const std::vector<SceneResults>& results) {
  std::string text =
      "\n## Table 8 of the paper\n\n"
      "The paper gives silhouette texels, lines and KiB (its \"KB\"), and a shadow buffer of 4096 "
      "KiB. Its bytes "
      "follow from 42 bits a silhouette texel and 36 bits a line (column *formula*): payload only, "
      "without links or hash tags. Beside it stands our scene of the same kind, not the same "
      "scene: "
      "the paper does not publish its own. *Lines a texel* is what can be compared.\n\n"
      "| paper | scale | texels | lines | KiB | formula | lines a texel | our scene | texels | "
      "lines "
      "| payload KiB | formula | allocated KiB | lines a texel |\n"
      "|:--|--:|--:|--:|--:|--:|--:|:--|--:|--:|--:|--:|--:|--:|\n";
  double worst_alone = 0, worst_crowd = 0;
  for (const Table8Column& column : kTable8) {
    const double formula = payload_kb(column.texels, column.lines);
    double& worst = column.figure == std::string("Fig 9") ? worst_crowd : worst_alone;
    worst = std::max(worst, std::abs(formula - column.kilobytes));
    text += fmt::format("| {0} | {1} x {1} | {2} | {3} | {4:.1f} | {5:.1f} | {6:.2f} |",
                        column.figure, column.scale, grouped(column.texels), grouped(column.lines),
                        column.kilobytes, formula, double(column.lines) / double(column.texels));
    if (const Measurement* m = find(results, column)) {
      text += fmt::format(" {} | {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.2f} |\n", column.ours,
                          grouped(m->texels), grouped(m->lines), double(m->payload_bytes) / 1024,
                          payload_kb(m->texels, m->lines), double(m->allocated_bytes) / 1024,
                          m->texels ? double(m->lines) / double(m->texels) : 0.0);
    } else {
      text += " - | - | - | - | - | - | - |\n";
    }
  }
  text += fmt::format(
      "\nThe formula gives the paper's KiB within {:.1f} KiB for one object (Fig 8) and for a long "
      "row "
      "of them (Fig 10). With many objects (Fig 9) the paper needs up to {:.1f} KiB more: where "
      "objects meet in a texel, each has 42 bits of its own. Ours counts 42 bits for every entry "
      "of up "
      "to three lines, continuations included: what a buffer has to hold.\n",
      worst_alone, worst_crowd);
  return text;
}

}  // namespace kagesen
