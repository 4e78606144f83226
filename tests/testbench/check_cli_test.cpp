/// The Verilog behind the program: check, run and stress with --engine rtl, soak.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/sim/program.h"

namespace kagesen {
namespace {

using Json = nlohmann::json;

class CheckCli : public ProgramTest {
 protected:
  Json json_of(const std::vector<std::string>& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    return Json::parse(outcome.out, nullptr, false);
  }
  static void expect_equal(const Json& json) {
    for (const char* kind : {"verdict_differences", "buffer_differences", "cycle_differences",
                             "counter_differences", "failures"}) {
      EXPECT_EQ(json.at(kind), 0) << kind;
    }
  }
};

TEST_F(CheckCli, BothProfilesAgreeWithGolden) {
  for (const std::string profile : {"paper", "winding"}) {
    const Json json =
        json_of({"check", "solids", "boxes", "--image", "64x36", "--map", "64", "--scale", "1,16",
                 "--set", "profile=" + profile, "--frames", "2", "--json", "-"});
    expect_equal(json);
    EXPECT_EQ(json.at("inputs").size(), 4u);
    EXPECT_EQ(json.at("frames"), 8);
    EXPECT_GT(json.at("fragments"), 4 * 1000);
    EXPECT_GT(json.at("cycles"), json.at("fragments"));
  }
}

TEST_F(CheckCli, AgreesUnderStallsAndAfterFramesCutShort) {
  for (const std::string profile : {"paper", "winding"}) {
    const Json json = json_of({"check",           "solids", "--image",  "32x18",
                               "--map",           "64",     "--set",    "profile=" + profile,
                               "--frames",        "4",      "--abort",  "3",
                               "--latency",       "1-60",   "--stalls", "30",
                               "--stream-stalls", "30",     "--json",   "-"});
    expect_equal(json);
    EXPECT_EQ(json.at("cut_frames"), 12);
  }
}

/// One build with assertions a profile: few slots and visits ahead, lanes, narrow fields, caches.
std::vector<std::string> with_assertions(const std::string& profile) {
  return {"--set", "profile=" + profile, "--set", "lanes=2", "--set", "fraction_bits=4",
          "--set", "fragment_slots=2",   "--set", "visit_fifo_depth=1"};
}

TEST_F(CheckCli, AgreesWithTwoLanesFewSlotsAndCaches) {
  for (const std::string profile : {"paper", "winding"}) {
    std::vector<std::string> arguments{
        "check",    "glyphs", "--image",         "64x36", "--map",   "64",    "--frames", "2",
        "--abort",  "2",      "--latency",       "1-60",  "--build", "check", "--stalls", "30",
        "--set",    "texel_cache_lines=8",       "--set", "slb_cache_lines=3", "--json",  "-",
        "--set",    "slb_cache_line_words=2",    "--stream-stalls", "30"};
    for (const std::string& word : with_assertions(profile)) arguments.push_back(word);
    const Json json = json_of(arguments);
    expect_equal(json);
    EXPECT_EQ(json.at("frames"), 2);
  }
}

/// The same tracks, and on each the same events in the same cycles.
TEST_F(CheckCli, TimelinesOfBothEnginesAreTheSame) {
  for (const std::string profile : {"paper", "winding"}) {
    for (const std::string pass : {"1", "2"}) {
      std::string timelines[2];
      for (const std::string engine : {"systemc", "rtl"}) {
        const Outcome outcome =
            run({"run", "solids", "--engine", engine, "--image", "64x36", "--map", "64",
                 "--no-images", "--no-reference", "--set", "profile=" + profile, "--timeline",
                 "t.json", "--window-pass", pass, "--window", "500-2500"});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        timelines[engine == "rtl"] = read_file(path("t.json"));
      }
      EXPECT_GT(timelines[0].size(), 10'000u);
      EXPECT_EQ(timelines[0] == timelines[1], true) << profile << ", pass " << pass;
    }
  }
}

TEST_F(CheckCli, TheReportSaysWhereTheCyclesWent) {
  for (const std::string profile : {"paper", "winding"}) {
    const Json json =
        json_of({"run", "solids", "--engine", "rtl", "--image", "64x36", "--map", "64",
                 "--no-images", "--no-reference", "--set", "profile=" + profile, "--json", "-"});
    EXPECT_EQ(json.at("engine"), "rtl");
    const Json& cycles = json.at("cycles");
    EXPECT_GT(cycles.at("clear"), 0);
    for (const char* pass : {"pass1", "pass2"}) {
      std::uint64_t sum = 0;
      for (const auto& [name, count] : cycles.at(pass).at("causes").items()) {
        EXPECT_NE(name, "unknown");
        sum += count.get<std::uint64_t>();
      }
      EXPECT_EQ(cycles.at(pass).at("total"), sum);
      const double per_item = cycles.at(pass).at("per_item");
      EXPECT_NEAR(per_item * cycles.at(pass).at("items").get<double>(), double(sum), 0.5);
    }
    EXPECT_EQ(cycles.at("pass2").at("items"), json.at("verdict").at("fragments"));
    EXPECT_EQ(cycles.at("pass2").at("causes").at("fragment"), json.at("verdict").at("fragments"));
  }
}

TEST_F(CheckCli, StressAndSoakFindNothing) {
  // The profile is theirs to draw.
  std::vector<std::string> build = with_assertions("paper");
  build.erase(build.begin(), build.begin() + 2);
  const auto with_build = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), build.begin(), build.end());
    return arguments;
  };
  const Json stress =
      json_of(with_build({"stress", "--engine", "rtl", "--cases", "2", "--json", "-"}));
  EXPECT_EQ(stress.at("total").at("violations"), 0);
  EXPECT_GT(stress.at("total").at("verdicts_compared"), 0);

  const Json soak = json_of(with_build(
      {"soak", "--fragments", "3000", "--image", "32x18", "--seed", "3", "--json", "-"}));
  EXPECT_EQ(soak.at("total").at("violations"), 0);
  EXPECT_GE(soak.at("total").at("verdicts_compared"), 3000);
  const Json more = json_of(with_build(
      {"soak", "--hours", "0.0002", "--image", "32x18", "--resume", "--json", "-"}));
  EXPECT_GT(more.at("next_case"), soak.at("next_case"));
  EXPECT_EQ(more.at("seed"), 3);
}

TEST_F(CheckCli, RefusesWhatItCannotRun) {
  expect_refusal({"check", "solids", "--build", "quick"}, {"--build", "quick", "fast"});
  expect_refusal({"check", "solids", "--latency", "0"}, {"--latency"});
  expect_refusal({"check", "nothing"}, {"nothing"});
  expect_refusal({"run", "--engine", "verilog"}, {"--engine", "rtl"});
  expect_refusal({"check", "solids", "--set", "lanes=5"}, {"lanes", "4"});
}

}  // namespace
}  // namespace kagesen
