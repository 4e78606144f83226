#pragma once
/// Runs case after case, adds up, and keeps the smallest case of every kind of failure.
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/stress/case.h"
#include "tests/stress/shrink.h"

namespace kagesen::stress {

struct Totals {
  std::uint64_t cases = 0, fragments = 0;
  std::uint64_t judged = 0;    ///< verdicts held against exact ones
  std::uint64_t compared = 0;  ///< verdicts held against another run's
  std::uint64_t violations = 0;
  Totals& operator+=(const Totals& o);
};

/// One kind of failure: a check that failed on cases of a family.
struct Failure {
  std::string family, check;
  std::uint64_t cases = 0, violations = 0;
  std::uint64_t case_number = 0;             ///< of the smallest case
  std::uint64_t casters = 0, fragments = 0;  ///< of it, after shrinking
  std::string file;                          ///< the trace; empty if none was written
  std::vector<std::string> replay;           ///< command lines
  std::uint64_t size() const { return casters + fragments; }
};

/// All that a later run needs to go on.
struct State {
  std::uint64_t seed = 0, next_case = 0;
  double seconds = 0;  ///< spent so far
  std::map<std::string, Totals> families;
  std::vector<Failure> failures;
  Totals total() const;
};

struct SuiteOptions {
  CaseOptions cases;
  std::string family;            ///< this one alone; empty: all
  std::uint64_t case_limit = 0;  ///< of this call; 0: none
  double seconds = 0;            ///< of this call; 0: no limit
  EngineFactory make_engine;
  /// May change what is checked of a case; may be empty.
  std::function<void(StressCase&)> prepare;
  ShrinkLimits shrinking;
  std::size_t shrink_per_kind = 3;  ///< failing cases that are shrunk, of each kind of failure
  /// Takes a shrunk trace and its name, and returns the file it was written to; may be empty.
  std::function<std::string(const Trace&, const std::string& name)> write_trace;
  /// Called after every case; false stops the suite. May be empty.
  std::function<bool(const State&)> after_case;
};

/// Goes on from `state` until a limit is reached or after_case() says to stop.
void run_suite(const SuiteOptions& options, State& state);

/// The smallest failing case, nullptr if nothing failed.
const Failure* smallest(const State& state);

}  // namespace kagesen::stress
