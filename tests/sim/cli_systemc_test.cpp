/// What the program tells of the SystemC model: report, heat map, timeline, explanation.
#include <nlohmann/json.hpp>

#include "tests/sim/program.h"

namespace kagesen {
namespace {

using Json = nlohmann::json;

class CliSystemc : public ProgramTest {
 protected:
  Json json_of(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = run(small(arguments));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out, nullptr, false);
  }
};

TEST_F(CliSystemc, VerdictsAreGoldensAndCyclesAddUp) {
  const std::vector<std::string> arguments{"run", "glyphs", "--no-reference", "--no-images"};
  const Json golden = json_of(arguments);
  std::vector<std::string> with_engine = arguments;
  with_engine.insert(with_engine.end(), {"--engine", "systemc"});
  const Json model = json_of(with_engine);
  for (const char* part : {"verdict", "slb", "map", "counters"}) {
    EXPECT_EQ(model.at(part), golden.at(part)) << part;
  }
  EXPECT_FALSE(golden.contains("cycles"));
  const Json& pass2 = model.at("cycles").at("pass2");
  std::uint64_t causes = 0;
  for (const auto& [name, cycles] : pass2.at("causes").items()) causes += cycles.get<std::uint64_t>();
  EXPECT_EQ(pass2.at("total"), causes);
  EXPECT_EQ(pass2.at("items"), model.at("verdict").at("fragments"));
  const Json& fragment = pass2.at("fragment");
  EXPECT_LE(fragment.at("p50"), fragment.at("p99"));
  EXPECT_LE(fragment.at("p99"), fragment.at("most"));
  EXPECT_GE(fragment.at("worst_tile").at("mean"), fragment.at("mean"));
  EXPECT_GT(fragment.at("latency_mean"), 20);
  const Json& traffic = pass2.at("traffic");
  EXPECT_GE(traffic.at("slb_reads"), model.at("counters").at("slb_lookups"));
}

TEST_F(CliSystemc, SlowerMemoryCostsMore) {
  const auto total = [&](const char* setting) {
    return json_of({"run", "glyphs", "--engine", "systemc", "--no-reference", "--no-images", "--set",
                    "fragment_slots=8", "--set", setting})
        .at("cycles").at("pass2").at("total").get<std::uint64_t>();
  };
  const std::uint64_t base = total("memory_latency=20");
  EXPECT_LT(total("memory_latency=2"), base);
  for (const char* setting : {"memory_latency=100", "memory_spread=50", "memory_stall=50",
                              "memory_interval=8", "memory_outstanding=2"}) {
    EXPECT_GT(total(setting), base) << setting;
  }
}

TEST_F(CliSystemc, TimelineHoldsItsWindowAlone) {
  expect_refusal({"run", "glyphs", "--timeline", "t.json", "--out", "o"}, {"--timeline", "systemc"});
  const Outcome outcome = run(small({"run", "glyphs", "--engine", "systemc", "--no-reference",
                                     "--timeline", "t.json", "--timeline-cycles", "100-200"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(path("out/cycles.png")));
  const Json timeline = Json::parse(read_file(path("t.json")));
  std::size_t fragments = 0, reads = 0;
  for (const Json& event : timeline.at("traceEvents")) {
    if (event.at("ph") == "b") {
      EXPECT_LE(event.at("ts"), 200);
      fragments += event.at("cat") == "fragment";
      reads += event.at("cat") == "read";
    }
    if (event.at("ph") == "e") {
      EXPECT_GE(event.at("ts"), 100);
    }
  }
  EXPECT_GT(fragments, 50u);
  EXPECT_GT(reads, 50u);
}

TEST_F(CliSystemc, ExplainsInFiveLines) {
  const std::vector<std::string> arguments{"explain", "glyphs", "--set", "fragment_slots=8"};
  const Outcome outcome = run(small(arguments));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 5) << outcome.out;
  const Json json = json_of(arguments);
  // Eight slots cannot hide twenty cycles: either end of that helps most.
  const std::string most = json.at("without").at(0).at("bottleneck");
  EXPECT_TRUE(most == "fragment_slots" || most == "memory_latency") << most;
  EXPECT_GT(json.at("without").at(0).at("saved"), 0);
  const Json cycles = json_of({"run", "glyphs", "--engine", "systemc", "--no-reference", "--no-images",
                               "--set", "fragment_slots=8"})
                          .at("cycles");
  EXPECT_EQ(json.at("cycles").get<std::uint64_t>(),  // wiping is no bottleneck
            cycles.at("pass1").at("total").get<std::uint64_t>() +
                cycles.at("settle").get<std::uint64_t>() +
                cycles.at("pass2").at("total").get<std::uint64_t>());
}

}  // namespace
}  // namespace kagesen
