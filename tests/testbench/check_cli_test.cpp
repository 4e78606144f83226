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
                               "--stream-stalls", "30",     "--build",  "check",
                               "--json",          "-"});
    expect_equal(json);
    EXPECT_EQ(json.at("cut_frames"), 12);
  }
}

TEST_F(CheckCli, AgreesWithTwoLanesAndOtherWidths) {
  for (const std::string profile : {"paper", "winding"}) {
    std::vector<std::string> arguments{
        "check",           "glyphs",  "--image",  "64x36",
        "--map",           "64",      "--set",    "profile=" + profile,
        "--set",           "lanes=2", "--set",    "fraction_bits=4",
        "--frames",        "2",       "--abort",  "2",
        "--latency",       "1-60",    "--stalls", "30",
        "--stream-stalls", "30",      "--build",  "check",
        "--json",          "-"};
    const Json json = json_of(arguments);
    expect_equal(json);
    EXPECT_EQ(json.at("frames"), 2);
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
  const Json stress = json_of({"stress", "--engine", "rtl", "--cases", "2", "--json", "-"});
  EXPECT_EQ(stress.at("total").at("violations"), 0);
  EXPECT_GT(stress.at("total").at("verdicts_compared"), 0);

  const Json soak =
      json_of({"soak", "--fragments", "3000", "--image", "32x18", "--seed", "3", "--json", "-"});
  EXPECT_EQ(soak.at("total").at("violations"), 0);
  EXPECT_GE(soak.at("total").at("verdicts_compared"), 3000);
  const Json more =
      json_of({"soak", "--hours", "0.0002", "--image", "32x18", "--resume", "--json", "-"});
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
