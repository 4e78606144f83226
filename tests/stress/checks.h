#pragma once
/// What must hold of every case, whatever its geometry.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/stress/subject.h"

namespace kagesen::stress {

struct CheckInput {
  const Subject& subject;
  const Setting& setting;
  std::uint64_t seed;  ///< of the check's own choices
  const EngineFactory& make_engine;
};

struct CheckResult {
  std::uint64_t judged = 0;    ///< verdicts held against exact ones
  std::uint64_t compared = 0;  ///< verdicts held against another run's
  std::vector<std::uint32_t>
      failed;                    ///< indices of fragments, in the trace that was changed if any
  std::optional<Trace> changed;  ///< the other form of the trace, if something failed on it
  std::optional<Setting> other;  ///< the other setting, if runs of two differ
};

struct Check {
  std::string name;
  std::string what;  ///< that fails, in words
  Profile profile;
  /// Its failures break the contract on `changed` alone: they can be shrunk as those of "contract".
  bool of_contract;
  CheckResult (*run)(const CheckInput&);
};
const std::vector<Check>& checks();
/// nullptr if there is none of that name.
const Check* find_check(const std::string& name);

// Winding profile.
CheckResult check_contract(const CheckInput& in);
CheckResult check_skips(const CheckInput& in);
CheckResult check_order(const CheckInput& in);
CheckResult check_portions(const CheckInput& in);
CheckResult check_translation(const CheckInput& in);
CheckResult check_turn(const CheckInput& in);
CheckResult check_refinement(const CheckInput& in);
CheckResult check_hidden(const CheckInput& in);
// Paper profile.
CheckResult check_causes(const CheckInput& in);

}  // namespace kagesen::stress
