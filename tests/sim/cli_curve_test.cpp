/// The curve command: its table, going on with it, and being called wrongly.
#include <chrono>

#include "tests/sim/program.h"

namespace kagesen {
namespace {

class CliCurve : public ProgramTest {
 protected:
  std::vector<std::string> lines(const std::string& name) const {
    std::istringstream in(read_file(path(name)));
    std::vector<std::string> out;
    for (std::string line; std::getline(in, line);) out.push_back(line);
    return out;
  }
  /// The cell of a column that the first line names.
  std::string cell(const std::vector<std::string>& table, std::size_t row,
                   const std::string& column) const {
    std::istringstream names(table[0]), values(table[row]);
    for (std::string name, value; std::getline(names, name, ',');) {
      std::getline(values, value, ',');
      if (name == column) return value;
    }
    return {};
  }
  const std::vector<std::string> quick_{"curve", "--quick", "--out", "t/c.csv"};
};

TEST_F(CliCurve, WritesARowASettingAndAPlot) {
  const Outcome outcome = run(quick_);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("16 rows measured, 0 kept"), std::string::npos) << outcome.out;
  const auto table = lines("t/c.csv");
  ASSERT_EQ(table.size(), 17u);
  EXPECT_EQ(table[0].rfind("scene,profile,semantics,fraction_bits,slope_bits,map,scale,", 0), 0u);
  for (std::size_t i = 1; i < table.size(); ++i) {
    EXPECT_EQ(std::count(table[i].begin(), table[i].end(), ','),
              std::count(table[0].begin(), table[0].end(), ','));
    EXPECT_GT(std::stod(cell(table, i, "judged")), 1000);
    EXPECT_GT(std::stod(cell(table, i, "total_ratio")), 0);
    EXPECT_EQ(std::stoll(cell(table, i, "map_bytes")) + std::stoll(cell(table, i, "slb_bytes")),
              std::stoll(cell(table, i, "total_bytes")));
    // A plain map of the same side is no match for the unit on this scene.
    EXPECT_GT(std::stoll(cell(table, i, "plain_same_side_wrong")),
              std::stoll(cell(table, i, "wrong")));
  }
  EXPECT_EQ(read_file(path("t/images/c.png")).substr(1, 3), "PNG");
  EXPECT_EQ(left_behind(), std::vector<std::string>{"c.png"});
}

TEST_F(CliCurve, GoesOnWithWhatIsThere) {
  ASSERT_EQ(run(quick_).status, 0);
  const auto whole = lines("t/c.csv");
  // A row that cannot have been measured tells whether it was kept; another one is missing.
  auto part = whole;
  ASSERT_EQ(cell(part, 3, "judged"), cell(part, 4, "judged"));
  const std::string judged = "," + cell(part, 3, "judged") + ",";
  part[3].replace(part[3].find(judged), judged.size(), ",7,");
  part.pop_back();
  std::string text;
  for (const std::string& line : part) text += line + "\n";
  write_file(path("t/c.csv"), text);

  const Outcome again = run(quick_);
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.out.find("1 row measured, 15 kept"), std::string::npos) << again.out;
  const auto table = lines("t/c.csv");
  ASSERT_EQ(table.size(), 17u);
  EXPECT_EQ(table[3], part[3]);
  for (const char* column : {"scene", "profile", "fraction_bits", "map", "scale", "wrong"}) {
    EXPECT_EQ(cell(table, 16, column), cell(whole, 16, column)) << column;
  }

  auto fresh = quick_;
  fresh.push_back("--fresh");
  const Outcome all = run(fresh);
  EXPECT_NE(all.out.find("16 rows measured, 0 kept"), std::string::npos) << all.out;
  EXPECT_EQ(cell(lines("t/c.csv"), 3, "judged"), cell(whole, 3, "judged"));
}

TEST_F(CliCurve, AnInterruptionKeepsTheRowsThatAreDone) {
  Limits limits;
  limits.meanwhile = [&](pid_t child) {
    for (int i = 0; i < 4000 && lines("c.csv").size() < 3; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    kill(child, SIGINT);
  };
  const Outcome outcome = run({"curve", "--out", "c.csv"}, limits);
  EXPECT_EQ(outcome.status, 128 + SIGINT);
  const auto table = lines("c.csv");
  ASSERT_GE(table.size(), 3u);
  EXPECT_EQ(std::count(table.back().begin(), table.back().end(), ','),
            std::count(table[0].begin(), table[0].end(), ','));
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
}

TEST_F(CliCurve, WrongCalls) {
  expect_refusal({"curve", "--scenes", "solid"}, {"--scenes", "'solids'"});
  expect_refusal({"curve", "--semantics", "phisical"}, {"--semantics", "'physical'"});
  expect_refusal({"curve", "--qick"}, {"did you mean '--quick'?"});
  expect_refusal({"curve", "--out", "."}, {"folder"});
  expect_refusal({"curve", "--out", "/proc/none/c.csv"}, {"/proc/none"});
  write_file(path("other.csv"), "a,b\n1,2\n");
  expect_refusal({"curve", "--out", "other.csv"}, {"other.csv:1", "columns"});
  EXPECT_EQ(read_file(path("other.csv")), "a,b\n1,2\n");
  ASSERT_EQ(run(quick_).status, 0);
  std::filesystem::remove_all(path("t/images"));
  for (const char* line : {"nonsense\n", "solids,paper,paper,4,4,128,1,320x180,many\n"}) {
    const std::string text = lines("t/c.csv")[0] + "\n" + line;
    write_file(path("bad.csv"), text);
    expect_refusal({"curve", "--quick", "--out", "bad.csv"}, {"bad.csv:2"});
    EXPECT_EQ(read_file(path("bad.csv")), text);
  }
  const std::string good = lines("t/c.csv")[0] + "\n" + lines("t/c.csv")[1] + "\n";
  for (const std::string& more : {std::string(",5"), std::string(",")}) {
    write_file(path("bad.csv"), good.substr(0, good.size() - 1) + more + "\n");
    expect_refusal({"curve", "--quick", "--out", "bad.csv"}, {"bad.csv:2"});
  }
}

}  // namespace
}  // namespace kagesen
