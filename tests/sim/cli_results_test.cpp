/// The page that `kagesen results` writes, from small frames.
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/sim/program.h"

namespace kagesen {
namespace {

using CliResults = ProgramTest;

/// The cells of the first table row of `page` after `heading` that starts with these cells.
std::vector<std::string> row_of(const std::string& page, const std::string& heading,
                                const std::string& start) {
  const std::size_t at = page.find("\n| " + start + " |", page.find(heading));
  if (at == std::string::npos) return {};
  std::vector<std::string> cells;
  std::istringstream line(page.substr(at + 3, page.find('\n', at + 1) - at - 3));
  for (std::string cell; std::getline(line, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

TEST_F(CliResults, ResultsPage) {
  std::filesystem::create_directory(path("d"));
  write_file(path("d/stress.json"),
             R"({"seed": 7, "next_case": 9, "seconds": 600, "families": {}, "failures": [], "total":
             {"cases": 9, "fragments": 123456789, "verdicts_judged": 5000, "verdicts_compared": 60,
              "violations": 0}})");
  const Outcome outcome =
      run({"results", "--quick", "--scenes", "solids,torus", "--out", "d/results.md"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string page = read_file(path("d/results.md"));
  for (const char* words : {"Table 8", "3,272", "235.3", "## solids", "## torus",
                            "(images/torus.png)", "quantisation"}) {
    EXPECT_NE(page.find(words), std::string::npos) << words;
  }
  EXPECT_GT(std::filesystem::file_size(path("d/images/solids.png")), 0u);
  EXPECT_LT(std::filesystem::file_size(path("d/images/torus.png")), 100u * 1024);

  // The winding profile: no fragment breaks its contract, and no skip changes a verdict.
  const auto all = row_of(page, "### Accuracy", "**all**");
  ASSERT_EQ(all.size(), 9u);
  EXPECT_GT(all[2].size(), 3u);  // judged: thousands at least
  EXPECT_EQ(all[4], "0");
  EXPECT_EQ(all[8], "0");
  EXPECT_EQ(row_of(page, "### Effective resolution", "torus | 16 x 16").size(), 10u);
  EXPECT_EQ(row_of(page, "### Memory", "solids | 1 x 1").size(), 7u);
  for (const char* heading : {"**Physical semantics**", "**Paper semantics**"}) {
    const auto skips = row_of(page, heading, "torus");
    ASSERT_EQ(skips.size(), 13u) << heading;
    EXPECT_GT(skips[8].size(), 3u);
    EXPECT_EQ(skips[9], "0");
    EXPECT_GT(std::stod(skips[12]), 0);
  }
  const auto coarse = row_of(page, "### Conservative first test", "solids | 1024 x 1024");
  const auto fine = row_of(page, "### Conservative first test", "solids | 2048 x 2048");
  ASSERT_EQ(coarse.size(), 6u);
  ASSERT_EQ(fine.size(), 6u);
  EXPECT_GE(std::stod(coarse[3]), std::stod(coarse[2]));  // the exact test misses nothing
  EXPECT_GT(std::stod(fine[3]), std::stod(coarse[3]));
  EXPECT_NE(page.find("Seed 7: 9 cases and 123,456,789 fragments in 10.0 minutes"),
            std::string::npos);
  EXPECT_NE(page.find("0 violations. The target is none in 100,000,000 fragments: reached"),
            std::string::npos);
}

TEST_F(CliResults, ResultsRefuseAStressFileOfAnotherKind) {
  write_file(path("stress.json"), "{}");
  expect_refusal({"results", "--quick", "--out", "results.md"},
                 {"stress.json", "kagesen stress --json"});
}

TEST_F(CliResults, ResultsWithoutAStressFileHaveNoSuchSection) {
  const Outcome outcome = run({"results", "--quick", "--scenes", "solids", "--out", "results.md"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(read_file(path("results.md")).find("## Stress"), std::string::npos);
}

}  // namespace
}  // namespace kagesen
