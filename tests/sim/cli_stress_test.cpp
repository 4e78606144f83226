/// The long form of the stress suite: what it prints, leaves behind and goes on from.
#include <nlohmann/json.hpp>

#include "tests/sim/program.h"

namespace kagesen {
namespace {

using Json = nlohmann::json;

class CliStress : public ProgramTest {
 protected:
  Json totals(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "stress");
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
};

TEST_F(CliStress, SaysWhatItDid) {
  const Outcome outcome = run({"stress", "--cases", "3", "--seed", "9", "--family", "corners"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  for (const char* words : {"seed 9", "corners", "violations", "3"}) {
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words;
  }
  EXPECT_TRUE(std::filesystem::exists(path("out/stress/state.json")));
}

TEST_F(CliStress, GoesOnWhereItStopped) {
  const Json whole = totals({"--cases", "6", "--seed", "4", "--out", "whole"});
  totals({"--cases", "2", "--seed", "4"});
  Json parts = totals({"--cases", "4", "--resume"});
  EXPECT_EQ(parts.at("seed"), 4);
  parts.erase("seconds");
  Json expected = whole;
  expected.erase("seconds");
  EXPECT_EQ(parts, expected);
}

TEST_F(CliStress, LosesAtMostTheCaseInHand) {
  Limits limits;
  limits.meanwhile = [](pid_t child) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
    kill(child, SIGKILL);
  };
  run({"stress", "--minutes", "5", "--seed", "2", "--profile", "winding"}, limits);
  const Json before = Json::parse(read_file(path("out/stress/state.json")));
  const Json after = totals({"--cases", "1", "--resume", "--profile", "winding"});
  EXPECT_EQ(after.at("next_case").get<int>(), before.at("next_case").get<int>() + 1);
}

TEST_F(CliStress, RunsOneCaseWithoutTouchingTheState) {
  totals({"--cases", "2", "--seed", "4"});
  const std::string state = read_file(path("out/stress/state.json"));
  const Json one = totals({"--seed", "4", "--case", "7"});
  EXPECT_EQ(one.at("total").at("cases"), 1);
  EXPECT_EQ(one.at("next_case"), 8);
  EXPECT_EQ(read_file(path("out/stress/state.json")), state);
}

TEST_F(CliStress, RefusesWhatItCannotDo) {
  expect_refusal({"stress", "--family", "cornes"}, {"--family", "cornes", "corners"});
  expect_refusal({"stress", "--profile", "papers"}, {"--profile", "paper"});
  expect_refusal({"stress", "--set", "map_width=4"}, {"map_width", "every case has its own"});
  expect_refusal({"stress", "--cases", "1.5"}, {"--cases", "1.5"});
}

TEST_F(CliStress, NumericsWritesThePage) {
  const Outcome outcome = run({"numerics", "--out", "d/numbers.md", "--seconds", "1"});
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const std::string page = read_file(path("d/numbers.md"));
  for (const char* words : {"--seconds 1", "Fraction", "segment end", "corner count", "83"}) {
    EXPECT_NE(page.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(page.find("**"), std::string::npos) << page;
}

TEST_F(CliStress, ResumeNeedsARun) {
  const Outcome outcome = run({"stress", "--resume"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("--resume"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace kagesen
