#include "testbench/coverage/coverage.h"

#include <gtest/gtest.h>

#include "testbench/coverage/bins.h"
#include "testbench/coverage/page.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

/// A point as VerilatedCov::write() writes it.
std::string point(const std::string& type, const std::string& module, unsigned line,
                  const std::string& what, const std::string& instance, unsigned count) {
  return "C '\001f\002rtl/common/fifo.sv\001l\002" + std::to_string(line) +
         "\001n\0025\001page\002" + type + "/" + module + "\001o\002" + what + "\001h\002" +
         instance + "' " + std::to_string(count) + "\n";
}

const std::string kHead = "# SystemC::Coverage-3\n";

const CoverPoint& of(const std::vector<CoverPoint>& points, const std::string& what) {
  for (const CoverPoint& p : points) {
    if (p.what == what) return p;
  }
  throw std::runtime_error("no point " + what);
}

TEST(Coverage, ReadsKindsPlacesAndCounts) {
  const auto points = read_coverage(kHead + point("v_line", "fifo", 7, "block", "top.a", 3) +
                                        point("v_branch", "fifo", 8, "else", "top.a", 0) +
                                        point("v_toggle", "fifo", 9, "data_i[3]", "top.a", 3) +
                                        point("v_toggle", "fifo", 9, "rst_ni", "top.a", 3) +
                                        point("v_toggle", "fifo", 10, "count_q[1]", "top.a", 2) +
                                        point("v_user", "fifo", 11, "cover", "top.a", 1),
                                    "x.dat");
  ASSERT_EQ(points.size(), 5u);  // cover properties are none of ours
  EXPECT_EQ(of(points, "block").kind, CoverKind::kLine);
  EXPECT_EQ(of(points, "block").line, 7u);
  EXPECT_EQ(of(points, "block").count, 3u);
  EXPECT_EQ(of(points, "else").kind, CoverKind::kBranch);
  EXPECT_FALSE(of(points, "else").covered());
  EXPECT_EQ(of(points, "data_i[3]").kind, CoverKind::kPort);
  EXPECT_EQ(of(points, "rst_ni").kind, CoverKind::kPort);
  EXPECT_TRUE(of(points, "rst_ni").covered());
  EXPECT_EQ(of(points, "count_q[1]").kind, CoverKind::kToggle);
  EXPECT_FALSE(of(points, "count_q[1]").covered());  // two changes may be one direction
}

TEST(Coverage, InstancesAndParametersCountAsOneModule) {
  const auto points =
      read_coverage(kHead + point("v_toggle", "fifo__W8", 9, "data_i[3]", "top.a", 2) +
                        point("v_toggle", "fifo__W9", 9, "data_i[3]", "top.b", 2),
                    "x.dat");
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0].module, "fifo");
  EXPECT_EQ(points[0].count, 2u);  // not 4: no instance went both ways
}

TEST(Coverage, RefusesOtherFiles) {
  EXPECT_THROW(read_coverage("", "x.dat"), UserError);
  EXPECT_THROW(read_coverage("hello\n", "x.dat"), UserError);
  EXPECT_THROW(read_coverage(kHead + "C 'broken\n", "x.dat"), UserError);
}

TEST(Coverage, GlobsMatch) {
  EXPECT_TRUE(matches("fifo.data_o[*]", "fifo.data_o[31]"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("a*b*c", "a--b-b-c"));
  EXPECT_TRUE(matches("a?c", "abc"));
  EXPECT_FALSE(matches("fifo", "fifo2"));
  EXPECT_FALSE(matches("a*b", "abc"));
  EXPECT_FALSE(matches("?", ""));
}

TEST(Coverage, ExclusionsNeedKindAndReason) {
  const auto all = read_exclusions(
      "# comment\n\nfifo.a_o[*] | port | tied off\nwinding: fifo.sv:3 | line | never\n", "e.txt");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].pattern, "fifo.a_o[*]");
  EXPECT_EQ(all[0].reason, "tied off");
  EXPECT_EQ(all[1].profile, "winding");
  EXPECT_EQ(all[1].pattern, "fifo.sv:3");
  for (const char* bad :
       {"fifo | port |", "fifo | port", "fifo", "fifo | ports | why", " | port | x"}) {
    EXPECT_THROW(read_exclusions(bad, "e.txt"), UserError) << bad;
  }
}

TEST(Coverage, ExclusionsLeaveOutWhatIsNotMetAndNothingElse) {
  const auto points = read_coverage(kHead + point("v_branch", "fifo", 2, "if", "top.a", 0) +
                                        point("v_branch", "fifo", 2, "else", "top.a", 4) +
                                        point("v_line", "fifo", 3, "block", "top.a", 0) +
                                        point("v_toggle", "fifo", 1, "a_o[0]", "top.a", 9) +
                                        point("v_toggle", "fifo", 1, "a_o[1]", "top.a", 0),
                                    "x.dat");
  const std::map<std::string, std::string> sources = {
      {"rtl/common/fifo.sv", "output logic [1:0] a_o\ncheck: assert (x);\ny <= z;\n"}};
  auto exclusions = read_exclusions(
      "fifo.sv:`assert (` | branch | stops the run\nfifo.a_o[1] | port | tied\n"
      "paper: fifo.sv:3 | line | other profile\nother | line | another module\n",
      "e.txt");
  const CoverageSummary summary = summarise(points, "winding", sources, exclusions);
  EXPECT_EQ(exclusions[0].used, 1u);
  EXPECT_EQ(exclusions[1].used, 1u);
  EXPECT_EQ(exclusions[2].used, 0u);
  EXPECT_EQ(exclusions[3].used, 0u);
  const Share branch = summary.total.at(CoverKind::kBranch);
  EXPECT_EQ(branch.hit, 1u);
  EXPECT_EQ(branch.all, 1u);
  EXPECT_EQ(branch.excluded, 1u);
  EXPECT_TRUE(summary.modules.at("fifo").at(CoverKind::kPort).full());
  ASSERT_EQ(summary.missed.size(), 1u);
  EXPECT_EQ(summary.missed[0].line, 3u);
}

TEST(Coverage, AMissedPointOrBinIsAMissedGoal) {
  ProfileCoverage run;
  run.bins = {{"chain", "1 records", 2}};
  run.code.total[CoverKind::kToggle] = {0, 5, 0};  // no goal
  EXPECT_TRUE(run.reached());
  run.code.total[CoverKind::kPort] = {4, 5, 0};
  EXPECT_FALSE(run.reached());
  run.code.total[CoverKind::kPort] = {5, 5, 0};
  run.bins.push_back({"chain", "2 records", 0});
  EXPECT_FALSE(run.reached());
  run.excluded_bins = {"chain: 2 records"};
  EXPECT_TRUE(run.reached());
  run.differences = 1;
  EXPECT_FALSE(run.reached());
}

TEST(Coverage, BitsOfASignalAreToldTogether) {
  CoverPoint low, high;
  low.kind = high.kind = CoverKind::kPort;
  low.module = high.module = "fifo";
  low.file = high.file = "rtl/common/fifo.sv";
  low.line = high.line = 4;
  low.what = "a_o[0]";
  high.what = "a_o[7]";
  EXPECT_EQ(missed_lines({low, high}, CoverKind::kPort),
            std::vector<std::string>{"fifo.sv:4 fifo.a_o[0, 7]"});
}

TEST(Coverage, EachProfileHasItsBins) {
  const auto has = [](Profile profile, const std::string& name) {
    const Bins bins(profile);
    for (const Bin& bin : bins.all()) {
      if (bin.full_name() == name) return bin.count == 0;
    }
    return false;
  };
  EXPECT_TRUE(has(Profile::kPaper, "table 7: A x+, B y-, Exp1 equal"));
  EXPECT_TRUE(has(Profile::kPaper, "policy: hidden_removal = farthest"));
  EXPECT_TRUE(has(Profile::kWinding, "skip: tile_dark"));
  EXPECT_FALSE(has(Profile::kWinding, "table 4: buffer nearer"));
  EXPECT_TRUE(has(Profile::kWinding, "fraction bits: 26"));
}

}  // namespace
}  // namespace kagesen
