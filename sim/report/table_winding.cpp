#include "sim/report/rows.h"
#include "sim/report/table.h"

namespace kagesen {
namespace {

/// Broken ones in texels that had no room; of all others the cause is kOther.
std::uint64_t for_want_of_room(const ErrorFigures& e) {
  return e.beyond_bound - e.causes[static_cast<std::size_t>(Cause::kOther)];
}

}  // namespace

void contract_rows(Rows& rows, const RunResult& result) {
  const ErrorFigures& paper = result.judgement->paper;
  const ErrorFigures& physical = result.judgement->physical;
  const std::uint64_t broken = paper.beyond_bound + physical.beyond_bound;
  if (broken == 0) {
    rows.add("contract", fmt::format("held: no fragment beyond 2^-{} texel and clear of contact",
                                     result.config.fraction_bits));
    return;
  }
  rows.add("contract", fmt::format("BROKEN: {}, {} in paper and {} in physical semantics",
                                   counted(broken, "fragment"), grouped(paper.beyond_bound),
                                   grouped(physical.beyond_bound)));
  const std::uint64_t room = for_want_of_room(paper) + for_want_of_room(physical);
  if (room > 0) rows.add("", fmt::format("{} of them in texels that overflowed", grouped(room)));
}

std::vector<SkipShare> skip_shares(const UnitCounters& c, std::uint64_t map_texels) {
  const SkipCounters& s = c.skips;
  return {
      {"receiver mask", s.masked_visits, s.texel_visits, "texel visit"},
      {"hidden", s.hidden_visits, s.texel_visits, "texel visit"},
      {"edges", s.inner_edge_texels, s.inner_edge_texels + c.edge_texels, "edge texel"},
      {"clearing", map_texels - s.cleared_texels, map_texels, "texel"},
      {"fragments", s.known_fragments, c.fragments, "fragment"},
      {"tiles", s.tile_lit + s.tile_dark, c.fragments - s.known_fragments, "fragment"},
      {"first test", s.first_test_dark, s.texel_lookups, "lookup"},
  };
}

void skip_rows(Rows& rows, const RunResult& result) {
  rows.heading("Skipped");
  const std::uint64_t texels = std::uint64_t{result.contents.width} * result.contents.height;
  for (const SkipShare& s : skip_shares(result.counters, texels)) {
    rows.add(s.skip, fmt::format("{:>8}  {} of {}", percent(s.skipped, s.all), grouped(s.skipped),
                                 counted(s.all, s.unit)));
  }
}

}  // namespace kagesen
