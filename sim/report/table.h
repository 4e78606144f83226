#pragma once
/// The table a person reads at the end of a run: at most 100 columns of plain text.
#include <string>
#include <vector>

#include "sim/report/run_result.h"
#include "traces/format/words.h"

namespace kagesen {

/// @param files  what was written, named at the end
std::string report_table(const Trace& trace, const RunResult& result,
                         const std::vector<std::string>& files);

/// Bytes with a fitting unit: "812 B", "31.4 KiB", "4.0 MiB".
std::string bytes_text(std::uint64_t bytes);
/// A share of fragments as a person compares them: "1 in 12,345", "none"; where more than
/// 1 in 20 is meant, "37.5 %".
std::string one_in(std::uint64_t part, std::uint64_t whole);

/// How much of one kind of work the winding profile did not do.
struct SkipShare {
  const char* skip;            ///< "receiver mask", "tiles", ...
  std::uint64_t skipped, all;  ///< of `all`, so many were not done
  const char* unit;            ///< what is counted, in the singular: "texel visit"
};
/// @param map_texels  of the whole map
std::vector<SkipShare> skip_shares(const UnitCounters& counters, std::uint64_t map_texels);

}  // namespace kagesen
