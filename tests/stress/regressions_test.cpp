// The smallest cases of what the suite found, each with the widths at which it failed.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/stress/contract.h"
#include "tests/stress/subject.h"
#include "traces/format/trace_file.h"

namespace kagesen::stress {
namespace {

struct Case {
  std::string name;
  std::vector<std::pair<std::string, std::string>> sets;
};

class Regression : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    const std::string path = std::string(KAGESEN_TEST_DATA "/stress/") + GetParam().name + ".txt";
    std::ifstream in(path);
    ASSERT_TRUE(in) << path;
    read_trace_text(in, path, trace_);
    setting_.config.profile = Profile::kWinding;
    for (const auto& [key, value] : GetParam().sets) set_field(setting_.config, key, value);
  }
  template <typename Check>
  void for_all(Check check) {
    for (const Semantics semantics : {Semantics::kPaper, Semantics::kPhysical}) {
      for (const bool hints : {true, false}) {
        setting_.config.semantics = semantics;
        setting_.facet_hints = hints;
        check();
      }
    }
  }
  Trace trace_;
  Setting setting_;
};

TEST_P(Regression, KeepsTheContract) {
  for_all([&] {
    const UnitConfig config = config_for(trace_, setting_);
    const Subject subject(trace_);
    const Answer answer = ask(trace_, setting_, make_golden_engine);
    for (std::size_t i = 0; i < trace_.all_fragments.size(); ++i) {
      const Fragment& f = trace_.all_fragments[i];
      const bool dark = answer.verdicts[i] == Verdict::kDark;
      if (!is_judged(trace_, f) || dark == (subject.exact(config.semantics)[i] != 0)) continue;
      EXPECT_FALSE(breaks_contract(trace_, config, subject.reference(), f, dark)) << i;
    }
  });
}

TEST_P(Regression, IsTheSameInEveryOrder) {
  for_all([&] {
    const Answer before = ask(trace_, setting_, make_golden_engine);
    Trace changed = trace_;
    std::reverse(changed.all_casters.begin(), changed.all_casters.end());
    for (int turn = 0; turn < 6; ++turn) {
      for (Caster& c : changed.all_casters) {
        if (turn == 3) std::swap(c.vertex[0], c.vertex[1]);
        std::rotate(c.vertex, c.vertex + 1, c.vertex + 3);
      }
      EXPECT_TRUE(ask(changed, setting_, make_golden_engine).verdicts == before.verdicts) << turn;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(
    Found, Regression,
    testing::Values(Case{"corners-order", {{"fraction_bits", "10"}}}, Case{"slopes-order", {}},
                    Case{"specks-order", {}}, Case{"slopes-contract", {}},
                    Case{"fan-vanish", {{"fraction_bits", "6"}, {"end_guard_bits", "2"}}},
                    Case{"dense-vanish", {{"fraction_bits", "10"}, {"end_guard_bits", "4"}}},
                    Case{"border-touch",
                         {{"fraction_bits", "12"},
                          {"end_guard_bits", "4"},
                          {"gradient_bits", "10"},
                          {"plane_step_bits", "8"},
                          {"plane_tolerance", "2575"}}}),
    [](const auto& info) {
      std::string name = info.param.name;
      name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
      return name;
    });

}  // namespace
}  // namespace kagesen::stress
