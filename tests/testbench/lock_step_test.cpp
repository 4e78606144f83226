/// What lock step says when the two disagree: golden's side is changed, as broken RTL would differ.
#include "testbench/verilator/lock_step.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "model/frame_setup.h"
#include "model/stored_figures.h"
#include "testbench/verilator/compare.h"
#include "traces/raster/capture.h"
#include "traces/scene/scene.h"

namespace kagesen {
namespace {

class LockStep : public testing::TestWithParam<Profile> {
 protected:
  static Trace small_trace() {
    CaptureOptions capture;
    capture.map_width = capture.map_height = 64;
    capture.image_width = 64;
    capture.image_height = 36;
    Trace trace;
    kagesen::capture(make_builtin("solids"), capture, trace);
    return trace;
  }
  LockStep() {
    config_.profile = GetParam();
    config_.map_width = config_.map_height = 64;
  }
  Frame frame() const { return {trace_, config_, make_frame_setup(trace_, config_)}; }

  static bool says(const FirstDifference& first, const std::string& words) {
    for (const std::string& line : first.lines) {
      if (line.find(words) != std::string::npos) return true;
    }
    return false;
  }

  const Trace trace_ = small_trace();
  UnitConfig config_;
  RtlEngine engine_{{}};
};

TEST_P(LockStep, EqualSidesAreEqual) {
  const LockStepResult result = lock_step(frame(), expect(frame()), engine_);
  EXPECT_TRUE(result.equal());
  EXPECT_FALSE(result.first);
  ASSERT_TRUE(result.cycles);
  EXPECT_GT(result.cycles->pass2->total, trace_.all_fragments.size());
}

TEST_P(LockStep, NamesTheFirstWrongVerdict) {
  Expected expected = expect(frame());
  for (const std::size_t at : {700u, 900u}) {
    Verdict& v = expected.verdicts[at];
    v = v == Verdict::kDark ? Verdict::kLit : Verdict::kDark;
  }
  const LockStepResult result = lock_step(frame(), expected, engine_);
  EXPECT_EQ(result.verdict_differences, 2u);
  EXPECT_EQ(result.wrong_fragments, (std::vector<std::uint32_t>{700, 900}));
  ASSERT_TRUE(result.first);
  EXPECT_EQ(result.first->kind, "verdict");
  EXPECT_TRUE(says(*result.first, "fragment 700"));
  EXPECT_TRUE(says(*result.first, "golden"));
  EXPECT_TRUE(says(*result.first, "rtl"));
}

TEST_P(LockStep, NamesTheFirstWrongTexel) {
  Expected expected = expect(frame());
  const auto change = [](auto& stored) { ++stored.object; };
  std::uint32_t x, y;
  if (GetParam() == Profile::kPaper) {
    TexelEntry& entry = expected.contents.entries.at(5);
    x = entry.texel_x, y = entry.texel_y;
    change(entry);
  } else {
    TexelCluster& cluster = expected.contents.clusters.at(5);
    x = cluster.texel_x, y = cluster.texel_y;
    change(cluster);
  }
  const LockStepResult result = lock_step(frame(), expected, engine_);
  EXPECT_EQ(result.buffer_differences, 1u);
  EXPECT_EQ(result.verdict_differences, 0u);
  ASSERT_TRUE(result.first);
  EXPECT_EQ(result.first->kind, "buffer");
  EXPECT_EQ(result.first->x, x);
  EXPECT_EQ(result.first->y, y);
}

TEST_P(LockStep, NamesACounter) {
  Expected expected = expect(frame());
  ++expected.counters.lines_read;
  const LockStepResult result = lock_step(frame(), expected, engine_);
  EXPECT_EQ(result.counter_differences, 1u);
  ASSERT_TRUE(result.first);
  EXPECT_TRUE(says(*result.first, "lines_read"));
}

TEST_P(LockStep, ReadBackContentsGiveGoldensFigures) {
  const Expected expected = expect(frame());
  UnitCounters counters;
  add_stored_figures(config_, expected.contents, counters);
  EXPECT_EQ(counters.slb_texels, expected.counters.slb_texels);
  EXPECT_EQ(counters.slb_entries, expected.counters.slb_entries);
  EXPECT_EQ(counters.slb_lines, expected.counters.slb_lines);
  EXPECT_EQ(counters.collisions, expected.counters.collisions);
  EXPECT_EQ(counters.max_chain, expected.counters.max_chain);
  EXPECT_EQ(counters.chain_histogram, expected.counters.chain_histogram);
}

TEST_P(LockStep, AFrameCutShortLeavesNothingBehind) {
  const Expected expected = expect(frame());
  const LockStepResult whole = lock_step(frame(), expected, engine_);
  ASSERT_TRUE(whole.cycles);
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    cut_frame(frame(), engine_, seed % 2 ? bench::Bench::Cut::kReset : bench::Bench::Cut::kAbort,
              seed, *whole.cycles);
    EXPECT_TRUE(engine_.cut()) << seed;
    const LockStepResult after = lock_step(frame(), expected, engine_);
    EXPECT_TRUE(after.equal()) << seed;
    ASSERT_TRUE(after.cycles);
    EXPECT_EQ(after.cycles->pass1->total, whole.cycles->pass1->total) << seed;
    EXPECT_EQ(after.cycles->pass2->total, whole.cycles->pass2->total) << seed;
  }
}

/// Far ends that never move, whatever the unit does: the bench gives up soon, and tells every channel.
TEST_P(LockStep, AStuckUnitTellsItsChannels) {
  config_.slb_buckets = 16;  // soon wiped, even by a slow memory
  const auto words_of = [&](std::uint32_t memory_stall, std::uint32_t stream_stall) -> std::string {
    Timing timing;
    timing.memory_stall = memory_stall;
    timing.stream_stall = stream_stall;
    engine_.set_timing(timing);
    try {
      run_frame(frame(), engine_);
    } catch (const bench::Failure& failure) {
      engine_.bench().reset();
      return failure.what();
    }
    return "it was not stuck";
  };
  const std::string memory = words_of(100, 0);
  EXPECT_NE(memory.find("stuck in pass 1"), std::string::npos) << memory;
  EXPECT_NE(memory.find("texel writes: valid 1 ready 0"), std::string::npos) << memory;
  EXPECT_NE(memory.find("lane0.slots 0"), std::string::npos) << memory;
  EXPECT_EQ(words_of(80, 0), "it was not stuck");
  const std::string streams = words_of(0, 100);
  EXPECT_NE(streams.find("valid 0 ready"), std::string::npos) << streams;
  for (const std::string& words : {memory, streams}) {
    const std::string before = "nothing moved for ";
    const std::size_t at = words.find(before);
    ASSERT_NE(at, std::string::npos) << words;
    EXPECT_LT(std::stoul(words.substr(at + before.size())), 9'000u) << words;
  }
}

INSTANTIATE_TEST_SUITE_P(, LockStep, testing::Values(Profile::kPaper, Profile::kWinding),
                         [](const auto& info) {
                           return info.param == Profile::kPaper ? "Paper" : "Winding";
                         });

TEST(Wave, ShowsTheCyclesBeforeTheDifference) {
  CaptureOptions capture;
  capture.map_width = capture.map_height = 64;
  capture.image_width = 32;
  capture.image_height = 18;
  Trace trace;
  kagesen::capture(make_builtin("boxes"), capture, trace);
  UnitConfig config;
  config.map_width = config.map_height = 64;
  const Frame frame{trace, config, make_frame_setup(trace, config)};
  Expected expected = expect(frame);
  expected.verdicts[100] = Verdict::kDark;
  expected.verdicts[101] = Verdict::kLit;
  RtlEngine engine{{}};
  const LockStepResult result = lock_step(frame, expected, engine);
  ASSERT_TRUE(result.first);
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("kagesen_wave." + std::to_string(getpid()) + ".fst"))
                               .string();
  const std::vector<std::string> lines =
      write_wave(frame, expected, *result.first, std::nullopt, path);
  ASSERT_TRUE(std::filesystem::exists(path));
  EXPECT_GT(std::filesystem::file_size(path), 10'000u);
  std::filesystem::remove(path);
  ASSERT_GE(lines.size(), 2u);
  EXPECT_NE(lines[0].find("cycle "), std::string::npos) << lines[0];
}

}  // namespace
}  // namespace kagesen
