#pragma once
/// What `kagesen coverage` tells: as a table, a page and JSON.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "testbench/coverage/bins.h"
#include "testbench/coverage/coverage.h"

namespace kagesen {

struct ProfileCoverage {
  std::string profile;
  std::uint64_t frames = 0, cut = 0, fragments = 0, cycles = 0, differences = 0;
  double seconds = 0;
  CoverageSummary code;
  std::vector<Bin> bins;
  std::vector<std::string> excluded_bins;  ///< full names, not met and left out

  bool is_excluded(const Bin& bin) const;
  std::vector<std::string> missed_bins() const;
  /// Are all goals met: every line, branch and bit of a port, every bin, no difference?
  bool reached() const;
};

/// A module's points that were not met, in one line of text each: bits of one signal together.
std::vector<std::string> missed_lines(const std::vector<CoverPoint>& missed, CoverKind kind);

std::string coverage_table(const std::vector<ProfileCoverage>& runs);
std::string coverage_page(const std::vector<ProfileCoverage>& runs,
                          const std::vector<Exclusion>& exclusions, const std::string& command);
nlohmann::ordered_json coverage_json(const std::vector<ProfileCoverage>& runs,
                                     const std::vector<Exclusion>& exclusions);

}  // namespace kagesen
