// The short form of the suite; the long one is `kagesen stress`.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/stress/suite.h"

namespace kagesen::stress {
namespace {

std::string report(const State& state) {
  std::string text;
  for (const Failure& f : state.failures) {
    text += fmt::format("{} {}: {} violations in {} cases; case {} has {} casters, {} fragments\n",
                        f.family, f.check, f.violations, f.cases, f.case_number, f.casters,
                        f.fragments);
  }
  return text;
}

TEST(StressShort, NoViolation) {
  State state;
  state.seed = 1;
  SuiteOptions options;
  options.case_limit = 20 * families().size();
  options.make_engine = make_golden_engine;
  options.shrink_per_kind = 0;
  run_suite(options, state);
  EXPECT_EQ(state.total().violations, 0u) << report(state);
  EXPECT_GT(state.total().judged, 100'000u);
  for (const Family& family : families()) EXPECT_GT(state.families[family.name].cases, 0u);
}

}  // namespace
}  // namespace kagesen::stress
