/// Which engines a run makes, and what it asks of them in which order.
#include "sim/cli/simulate.h"

#include <gtest/gtest.h>

#include "tests/model/fake_engine.h"

namespace kagesen {
namespace {

using Calls = std::vector<std::string>;

struct Simulation {
  Trace trace;
  UnitConfig config;
  SimulateOptions options;
  std::vector<Calls> engines;  ///< what each was asked, in the order they were made

  Simulation() {
    config.profile = Profile::kWinding;
    config.map_width = config.map_height = 8;
    trace.header.map_width = trace.header.map_height = 8;
    trace.header.objects.resize(1);
    // Covers the map; the fragments lie behind it, on its own object.
    constexpr std::int32_t kFar = 20 << 16;
    trace.all_casters.push_back({{{-kFar, -kFar, 5}, {kFar, -kFar, 5}, {0, kFar, 5}}, 0, 0});
    for (int i = 0; i < 3; ++i) {
      trace.all_fragments.emplace_back();
      trace.all_fragments.back().position.z = 9000;
    }
    engines.reserve(4);
    options.equivalent_resolution = false;
    options.make = [this](const std::string&) {
      engines.emplace_back();
      auto engine = std::make_unique<FakeEngine>();
      engine->calls = &engines.back();
      return engine;
    };
  }
  RunResult run() {
    engines.clear();
    return simulate(trace, config, options);
  }
};

Calls winding_calls(const std::string& semantics) {
  return {"begin " + semantics, "announce 3 " + semantics, "draw 1 " + semantics,
          "decide 3 " + semantics};
}

std::vector<std::string> stages(const RunResult& result) {
  std::vector<std::string> names;
  for (const auto& stage : result.stages_s) names.push_back(stage.first);
  return names;
}

TEST(Simulate, WindingRunsInBothSemanticsAndIsJudgedInEach) {
  Simulation s;
  const RunResult result = s.run();
  ASSERT_EQ(s.engines.size(), 2u);
  EXPECT_EQ(s.engines[0], winding_calls("physical"));
  EXPECT_EQ(s.engines[1], winding_calls("paper"));
  EXPECT_EQ(stages(result), (Calls{"setup", "announce", "pass1", "pass2", "contents",
                                   "other_semantics", "reference"}));
  EXPECT_EQ(result.verdicts, std::vector<Verdict>(3, Verdict::kDark));
  EXPECT_EQ(result.verdicts_in(Semantics::kPhysical), result.verdicts);
  EXPECT_EQ(result.verdicts_in(Semantics::kPaper), std::vector<Verdict>(3, Verdict::kLit));
  EXPECT_EQ(result.judgement->paper.wrong, 0u);
  EXPECT_EQ(result.judgement->physical.wrong, 0u);
}

TEST(Simulate, TheSemanticsAskedForIsTheMainRun) {
  Simulation s;
  s.config.semantics = Semantics::kPaper;
  const RunResult result = s.run();
  ASSERT_EQ(s.engines.size(), 2u);
  EXPECT_EQ(s.engines[0], winding_calls("paper"));
  EXPECT_EQ(result.verdicts, std::vector<Verdict>(3, Verdict::kLit));
  EXPECT_EQ(result.judgement->paper.wrong, 0u);
  EXPECT_EQ(result.judgement->physical.wrong, 0u);
}

TEST(Simulate, TheOtherSemanticsIsForTheJudgementAlone) {
  Simulation s;
  s.options.reference = false;
  EXPECT_EQ(stages(s.run()), (Calls{"setup", "announce", "pass1", "pass2", "contents"}));
  EXPECT_EQ(s.engines.size(), 1u);
  s.options.both_semantics = true;
  EXPECT_EQ(s.run().other_verdicts.size(), 3u);
}

TEST(Simulate, ThePaperProfileRunsOnceAndAnnouncesNothing) {
  Simulation s;
  s.config.profile = Profile::kPaper;
  const RunResult result = s.run();
  ASSERT_EQ(s.engines.size(), 1u);
  EXPECT_EQ(s.engines[0], (Calls{"begin physical", "draw 1 physical", "decide 3 physical"}));
  EXPECT_EQ(stages(result), (Calls{"pass1", "pass2", "contents", "reference"}));
  EXPECT_EQ(result.judgement->paper.wrong, 3u);  // the same verdicts are held against both
  EXPECT_EQ(result.judgement->physical.wrong, 0u);
}

}  // namespace
}  // namespace kagesen
