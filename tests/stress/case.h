#pragma once
/// One case of the suite: a pure function of the seed and the case's number.
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tests/stress/checks.h"
#include "tests/stress/families.h"

namespace kagesen::stress {

/// What the person fixed; the rest is drawn.
struct CaseOptions {
  std::optional<Profile> profile;  ///< this one alone
  UnitConfig config;               ///< values of the keys in `given`
  std::set<std::string> given;     ///< keys of the configuration that do not vary
};

struct PlannedCheck {
  const Check* check;
  Setting setting;
  std::uint64_t seed;
};

struct StressCase {
  std::uint64_t number = 0;
  const Family* family = nullptr;
  Trace trace;
  std::vector<PlannedCheck> plan;
};

/// Case n belongs to family n modulo the number of families.
const Family& family_of(std::uint64_t number);
StressCase make_case(std::uint64_t seed, std::uint64_t number, const CaseOptions& options);

}  // namespace kagesen::stress
