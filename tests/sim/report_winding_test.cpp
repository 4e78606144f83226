/// What a report says of the winding profile, on hand-made results.
#include <gtest/gtest.h>

#include "sim/report/json.h"
#include "sim/report/pictures.h"
#include "sim/report/table.h"
#include "tests/sim/tiny_run.h"

namespace kagesen {
namespace {

/// Physical semantics; the map holds a depth without an object, and one cluster of three segments.
struct WindingRun : Tiny {
  WindingRun() {
    result.config.profile = Profile::kWinding;
    result.contents.entries.clear();
    result.contents.object.assign(4, kNoObject);
    TexelCluster cluster;
    cluster.texel_x = 1;
    cluster.segments.resize(3);
    result.contents.clusters = {cluster};
    UnitCounters& c = result.counters;
    c.fragments = 7;
    c.edge_texels = 60;
    SkipCounters& s = c.skips;
    s.texel_visits = 1000;
    s.masked_visits = 250;
    s.hidden_visits = 125;
    s.inner_edge_texels = 20;
    s.cleared_texels = 3;
    s.known_fragments = 2;
    s.tile_lit = 1;
    s.tile_dark = 2;
    s.texel_lookups = 2;
    s.first_test_dark = 1;
    judge();
  }
  std::string table() const { return report_table(trace, result, {}); }
  bool says(const std::string& text) const { return table().find(text) != std::string::npos; }
};

TEST(WindingReport, ContractHeld) {
  const WindingRun run;
  EXPECT_TRUE(
      run.says("  contract          held: no fragment beyond 2^-8 texel and clear of contact\n"))
      << run.table();
  EXPECT_TRUE(run.says("the unit set to each semantics"));
  EXPECT_TRUE(run.says("plain shadow map (physical semantics)"));
}

TEST(WindingReport, ContractBroken) {
  WindingRun run;
  run.result.judgement->physical.beyond_bound = 1200;
  run.result.judgement->physical.causes[std::size_t(Cause::kOther)] = 1200;
  EXPECT_TRUE(run.says(
      "  contract          BROKEN: 1,200 fragments, 0 in paper and 1,200 in physical semantics\n"))
      << run.table();
  EXPECT_FALSE(run.says("overflowed"));
  run.result.judgement->paper.beyond_bound = 3;
  EXPECT_TRUE(run.says("BROKEN: 1,203 fragments, 3 in paper")) << run.table();
  EXPECT_TRUE(run.says("3 of them in texels that overflowed")) << run.table();
}

TEST(WindingReport, SharesOfWorkSkipped) {
  const WindingRun run;
  for (const char* row :
       {"receiver mask       25.0 %  250 of 1,000 texel visits",
        "hidden              12.5 %  125 of 1,000 texel visits",
        "edges               25.0 %  20 of 80 edge texels",
        "clearing            25.0 %  1 of 4 texels", "fragments           28.6 %  2 of 7 fragments",
        "tiles               60.0 %  3 of 5 fragments",
        "first test          50.0 %  1 of 2 lookups"}) {
    EXPECT_TRUE(run.says(std::string("\n  ") + row + "\n")) << row << "\n" << run.table();
  }
}

TEST(WindingReport, SaysNothingOfThatInThePaperProfile) {
  WindingRun run;
  run.result.config.profile = Profile::kPaper;
  EXPECT_FALSE(run.says("Skipped"));
  EXPECT_FALSE(run.says("contract"));
  EXPECT_TRUE(run.says("the same verdicts against both"));
  EXPECT_TRUE(run.says("plain shadow map (paper semantics)"));
  EXPECT_FALSE(report_json(run.trace, run.result).contains("skips"));
}

TEST(WindingReport, SaysWhatOfEachKindOfObjectIsDrawn) {
  WindingRun run;
  run.trace.header.objects.push_back({"leaf", 3, false, true});
  EXPECT_TRUE(
      run.says("  drawn             1 closed (light-facing side), 1 open (every triangle), "
               "1 receiver (nothing)\n"))
      << run.table();
  EXPECT_EQ(report_json(run.trace, run.result)["input"]["objects_drawn"]["all"], 1);
}

TEST(WindingReport, EverySkipCounterIsInTheJson) {
  const WindingRun run;
  const auto json = report_json(run.trace, run.result);
  EXPECT_EQ(json["skips"].dump(),
            R"({"texel_visits":1000,"masked_visits":250,"hidden_visits":125,)"
            R"("inner_edge_texels":20,"cleared_texels":3,"known_fragments":2,"tile_lit":1,)"
            R"("tile_dark":2,"texel_lookups":2,"first_test_dark":1})");
  EXPECT_EQ(json["config"]["profile"], "winding");
}

TEST(WindingReport, TheMapShowsSegmentsAndDepthsWithoutObjects) {
  const WindingRun run;
  const Canvas lines = lines_picture(run.result);
  const Rgb segments = lines.get(300, 10), depth = lines.get(10, 10), nothing = lines.get(10, 300);
  EXPECT_GT(segments.r, segments.b);
  EXPECT_GT(depth.g, 60);
  EXPECT_LT(nothing.g, 60);
}

// The picture is of the verdicts that were asked for.
TEST(WindingReport, ErrorsAreThoseOfTheRunsOwnSemantics) {
  WindingRun run;
  const auto coloured = [&] {
    const Rgb pixel = error_picture(run.trace, run.result, /*legend=*/false).get(3, 1);
    return pixel.r != pixel.b;
  };
  EXPECT_FALSE(coloured());
  run.result.config.semantics = Semantics::kPaper;
  EXPECT_TRUE(coloured());
}

}  // namespace
}  // namespace kagesen
