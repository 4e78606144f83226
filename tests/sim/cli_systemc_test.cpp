/// What the program tells of the SystemC model: report, heat map, timeline, explanation.
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

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
  const auto report_of = [&](const char* engine) {
    return json_of({"run", "glyphs", "--no-reference", "--no-images", "--engine", engine});
  };
  const Json golden = report_of("golden"), model = report_of("systemc");
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
  expect_refusal({"run", "glyphs", "--engine", "golden", "--timeline", "t.json", "--out", "o"},
                 {"--timeline", "golden"});
  const Outcome outcome = run(small({"run", "glyphs", "--engine", "systemc", "--no-reference",
                                     "--timeline", "t.json", "--waves", "t.vcd", "--window", "100-200"}));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(path("out/cycles.png")));
  EXPECT_TRUE(std::filesystem::exists(path("out/map_cycles.png")));
  const std::string waves = read_file(path("t.vcd"));
  for (const char* words : {"$enddefinitions", "slots", "lane0_state", "#100\n", "sfragment ", "#201\n"}) {
    EXPECT_NE(waves.find(words), std::string::npos) << words;
  }
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

TEST_F(CliSystemc, QueuesAndReadsAddUp) {
  for (const char* profile : {"profile=paper", "profile=winding"}) {
    const Json report = json_of({"run", "glyphs", "--no-reference", "--no-images", "--set", profile});
    EXPECT_EQ(report.at("engine"), "systemc");  // unless something else is asked for
    for (const char* pass : {"pass1", "pass2"}) {
      const Json& cycles = report.at("cycles").at(pass);
      EXPECT_GE(cycles.at("queues").size(), 3u);
      for (const auto& [name, queue] : cycles.at("queues").items()) {
        std::uint64_t sum = 0, words = 0, n = 0;
        for (const Json& count : queue.at("cycles")) {
          sum += count.get<std::uint64_t>();
          words += n++ * count.get<std::uint64_t>();
        }
        EXPECT_EQ(sum, cycles.at("total").get<std::uint64_t>()) << pass << " " << name;
        EXPECT_NEAR(queue.at("mean").get<double>(), double(words) / double(sum), 1e-6) << name;
      }
    }
    // A fragment stays from its acceptance to its verdict.
    const Json& pass2 = report.at("cycles").at("pass2");
    EXPECT_NEAR(pass2.at("queues").at("lane0.slots").at("mean").get<double>(),
                pass2.at("fragment").at("in_flight").get<double>(), 0.1);
    EXPECT_GT(report.at("cycles").at("pass1").at("caches").size(), 0u);
  }
}

TEST_F(CliSystemc, CachesTakeReadsFromTheMemory) {
  const auto pass2 = [&](const char* setting, const char* other) {
    return json_of({"run", "glyphs", "--no-reference", "--no-images", "--set", "memory_latency=100",
                    "--set", "memory_interval=2", "--set", "fragment_slots=16", "--set",
                    "texel_cache_line_words=1", "--set", setting, "--set", other})
        .at("cycles").at("pass2");
  };
  const Json none = pass2("texel_cache_lines=0", "slb_cache_lines=0");
  EXPECT_FALSE(none.contains("caches"));
  std::uint64_t before = none.at("total"), misses = ~std::uint64_t{0};
  for (const char* lines : {"texel_cache_lines=4", "texel_cache_lines=4096"}) {
    const Json cached = pass2(lines, "slb_cache_lines=64");
    const Json& cache = cached.at("caches").at("lane0.texel_cache");
    EXPECT_EQ(cache.at("lookups"), none.at("traffic").at("texel_reads"));
    EXPECT_LT(cache.at("misses").get<std::uint64_t>(), misses);
    misses = cache.at("misses");
    EXPECT_TRUE(cached.at("caches").contains("lane0.slb_cache"));
    EXPECT_LT(cached.at("total").get<std::uint64_t>(), before) << lines;
    before = cached.at("total");
  }
}

/// Names of figures, wherever they stand; what is named by an instance or a cause is not one.
void collect_names(const Json& json, std::set<std::string>& names) {
  for (const auto& [name, value] : json.items()) {
    names.insert(name);
    if (!value.is_object() || name == "causes") continue;
    if (name == "queues" || name == "caches") {
      for (const Json& of : value) collect_names(of, names);
    } else if (name != "worst_tile") {
      collect_names(value, names);
    }
  }
}

TEST_F(CliSystemc, EveryCounterHasItsLineInTheDocs) {
  std::set<std::string> told, known;
  std::istringstream docs(read_file(std::string(KAGESEN_DOCS) + "/counters.md"));
  for (std::string line; std::getline(docs, line);) {
    if (line.rfind("| `", 0) == 0) told.insert(line.substr(3, line.find('`', 3) - 3));
  }
  for (const char* profile : {"profile=paper", "profile=winding"}) {
    const Json report = json_of({"run", "glyphs", "--no-reference", "--no-images", "--set", profile});
    for (const char* part : {"counters", "skips", "cycles"}) {
      if (report.contains(part)) collect_names(report.at(part), known);
    }
  }
  for (const char* name : {"pass1", "pass2"}) known.erase(name);
  for (const char* name : {"clock", "fmax_mhz", "source", "frames_per_s"}) known.insert(name);
  EXPECT_EQ(told, known);
  const std::string schema = read_file(std::string(KAGESEN_DOCS) + "/report.schema.json");
  const Json counters = json_of({"run", "glyphs", "--no-reference", "--no-images"}).at("counters");
  for (const std::string& name : told) {
    if (counters.contains(name)) continue;  // the schema has them without names
    EXPECT_NE(schema.find('"' + name + '"'), std::string::npos) << name;
  }
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
