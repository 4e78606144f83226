#pragma once
/// Functional bins: what a run has to meet besides the lines of the RTL.
#include <cstdint>
#include <string>
#include <vector>

#include "testbench/verilator/lock_step.h"

namespace kagesen {

struct Bin {
  std::string group, name;
  std::uint64_t count = 0;
  /// As exclusions and pages name it: "chain: 3 records".
  std::string full_name() const { return group + ": " + name; }
};

/// All bins of a profile, counted over frames.
class Bins {
 public:
  explicit Bins(Profile profile);
  /// A whole frame that the unit ran.
  void add(const Frame& frame, const Expected& expected, const CycleReport& cycles,
           const bench::Events& events);
  void add_cut(bench::Bench::Cut how);
  const std::vector<Bin>& all() const { return bins_; }

 private:
  void declare(const std::string& group, const std::vector<std::string>& names);
  void hit(const std::string& group, const std::string& name, std::uint64_t count = 1);
  void declare_paper();
  void declare_winding();
  void add_cycles(const CycleReport& cycles);
  void add_events(const bench::Events& events);
  void add_counters(const Frame& frame, const UnitCounters& counters);
  void add_policies(const UnitConfig& config);
  void add_lines(const Frame& frame, const MapContents& contents);
  void add_sources(const Frame& frame, const MapContents& contents);
  void add_clusters(const Frame& frame, const MapContents& contents);

  const Profile profile_;
  std::vector<Bin> bins_;
};

}  // namespace kagesen
