// What happens when the SLB, or a texel's chain, is full.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/model/unit/frame.h"

namespace kagesen {
namespace {

constexpr int kSide = 16;

struct Limits {
  std::int64_t entries, depth, lines, buckets;
};

UnitConfig limited(const Limits& limits) {
  UnitConfig config = small_config(kSide);
  config.slb_entries = limits.entries;
  config.link_depth = limits.depth;
  config.lines_per_entry = limits.lines;
  config.slb_buckets = limits.buckets;
  // Hidden lines come and go with what is stored: without removal each texel stands for itself.
  config.hidden_removal = HiddenRemoval::kOff;
  return config;
}

const Limits kTight[] = {{1, 64, 3, 64},     {20, 64, 3, 64},    {60, 64, 1, 1}, {100000, 1, 3, 64},
                         {100000, 1, 1, 64}, {100000, 2, 1, 16}, {40, 2, 2, 4},  {100000, 3, 1, 1}};
const Limits kAmple{100000, 4096, 3, 64};

TEST(Capacity, OverflowIsCountedAndMarkedAndNeverSilent) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const RandomScene scene(seed, kSide);
    for (const Limits& limits : kTight) {
      const Outcome out = run(scene.frame, limited(limits));
      const UnitCounters& c = out.counters;
      const auto& marks = out.contents.overflowed;
      const auto marked = static_cast<std::uint64_t>(std::count(marks.begin(), marks.end(), 1));
      ASSERT_EQ(c.overflow_texels, marked) << seed;
      ASSERT_GT(marked, 0u) << seed << ": the limits are not tight";
      // Every line that arrived is stored, has cancelled another, or is counted as lost.
      ASSERT_EQ(c.slb_lines + 2 * c.lines_cancelled + c.overflow_lines, c.edge_texels)
          << seed << ": entries " << limits.entries << " depth " << limits.depth << " lines "
          << limits.lines;
      ASSERT_LE(c.peak_entries, static_cast<std::uint64_t>(limits.entries));
      ASSERT_LE(c.max_chain, static_cast<std::uint64_t>(limits.depth));
      for (const TexelEntry& e : out.contents.entries)
        ASSERT_EQ(marks[e.texel_y * kSide + e.texel_x], 0) << "lines left in a marked texel";
    }
  }
}

TEST(Capacity, TexelsThatDidNotOverflowAreUntouched) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const RandomScene scene(seed, kSide);
    const Outcome ample = run(scene.frame, limited(kAmple));
    ASSERT_EQ(ample.counters.overflow_texels, 0u);
    for (const Limits& limits : kTight) {
      const Outcome tight = run(scene.frame, limited(limits));
      std::vector<TexelEntry> untouched;
      for (const TexelEntry& e : ample.contents.entries) {
        if (!tight.contents.overflowed[e.texel_y * kSide + e.texel_x]) untouched.push_back(e);
      }
      ASSERT_TRUE(untouched == tight.contents.entries) << seed;
      for (std::size_t i = 0; i < scene.frame.fragments.size(); ++i) {
        if (tight.contents.overflowed[texel_of(scene.frame.fragments[i], kSide)]) continue;
        ASSERT_EQ(tight.verdicts[i], ample.verdicts[i]) << seed << ' ' << i;
      }
    }
  }
}

/// The verdict of a plain map, and never lit where the lines would have said dark, but where the
/// nearest depth is the fragment's own object's, which the paper passes over.
TEST(Capacity, OverflowedTexelsAreAPlainMapAndConservative) {
  std::size_t tested = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const RandomScene scene(seed, kSide);
    const Outcome ample = run(scene.frame, limited(kAmple));
    for (const Limits& limits : kTight) {
      const Outcome tight = run(scene.frame, limited(limits));
      for (std::size_t i = 0; i < scene.frame.fragments.size(); ++i) {
        const Fragment& f = scene.frame.fragments[i];
        const std::size_t texel = texel_of(f, kSide);
        if (!tight.contents.overflowed[texel]) continue;
        const std::uint32_t id = tight.contents.object[texel];
        const std::uint32_t depth = tight.contents.depth[texel];
        const bool dark = id != f.object && f.position.z > depth;
        ASSERT_EQ(tight.verdicts[i] == Verdict::kDark, dark) << seed << ' ' << i;
        // Where ample capacity covers the texel, its depth is the covering plane's, not a line's.
        const bool by_buffer =
            ample.contents.object[texel] != f.object && f.position.z > ample.contents.depth[texel];
        if (id == f.object || by_buffer) continue;
        ++tested;
        ASSERT_LE(ample.verdicts[i], tight.verdicts[i]) << seed << ' ' << i;
      }
    }
  }
  EXPECT_GT(tested, 1000u);
}

TEST(Capacity, AnOverflowedTexelKeepsTheNearestDepthWithItsId) {
  // Four objects in one texel, in a chain that holds two records.
  const auto corner = [](std::uint32_t z, std::uint32_t object) {
    return triangle({9, 9, z}, {30000, 9, z}, {9, 30000, z}, object);
  };
  UnitConfig config = small_config(4);
  config.link_depth = 2;
  const std::size_t texel = 2 * 4 + 2;
  const Fragment f = fragment_at(60000, 60000, 1000, 9);  // outside every outline
  for (const auto& depths : {std::vector<std::uint32_t>{400, 300, 200, 500},
                             std::vector<std::uint32_t>{200, 300, 400, 500},
                             std::vector<std::uint32_t>{500, 400, 300, 200}}) {
    Frame frame{{}, {f}};
    for (std::uint32_t i = 0; i < 4; ++i) frame.casters.push_back(corner(depths[i], i));
    const Outcome out = run(frame, config);
    const auto nearest = std::min_element(depths.begin(), depths.end());
    EXPECT_EQ(out.contents.depth[texel], 200u);
    EXPECT_EQ(out.contents.object[texel], static_cast<std::uint32_t>(nearest - depths.begin()));
    EXPECT_EQ(out.contents.overflowed[texel], 1);
    EXPECT_EQ(out.verdicts[0], Verdict::kDark);
    EXPECT_EQ(out.counters.overflow_texels, 1u);
    EXPECT_EQ(out.counters.overflow_lines, 12u);  // 4 triangles of 3 edges, none left
  }
}

TEST(Capacity, LinkDepthCountsContinuationRecords) {
  // Three lines of one object take three records of one line each.
  const Caster c = triangle({9, 9, 5}, {30000, 9, 5}, {9, 30000, 5}, 1);
  UnitConfig config = small_config(4);
  config.lines_per_entry = 1;
  config.link_depth = 3;
  EXPECT_EQ(run({{c}, {}}, config).counters.overflow_texels, 0u);
  EXPECT_EQ(run({{c}, {}}, config).counters.max_chain, 3u);
  config.link_depth = 2;
  const UnitCounters full = run({{c}, {}}, config).counters;
  EXPECT_EQ(full.overflow_texels, 1u);
  EXPECT_EQ(full.overflow_lines, 3u);
  config.link_depth = 1;
  EXPECT_EQ(run({{c}, {}}, config).counters.overflow_lines, 3u);
}

TEST(Capacity, CancelledLinesGiveTheirRoomBack) {
  // Two triangles of a square, again and again: their diagonal cancels, and what remains is hidden
  // by a nearer square. Ever new texels never fill the SLB.
  UnitConfig config = small_config(kSide);
  config.slb_entries = 4 * kSide + 4 * 5;
  Frame frame;
  for (std::uint32_t n = 0; n < 50; ++n) {
    const std::int32_t low = -5 * kTexel - 99, high = 5 * kTexel + 99;
    const std::uint32_t z = 1000 - n;
    frame.casters.push_back(triangle({low, low, z}, {high, low, z}, {high, high, z}, 1, 2 * n));
    frame.casters.push_back(triangle({low, low, z}, {high, high, z}, {low, high, z}, 1, 2 * n + 1));
    frame.casters.push_back(triangle({-99 * kTexel, -50 * kTexel, z - 1},
                                     {99 * kTexel, -50 * kTexel, z - 1}, {0, 200 * kTexel, z - 1},
                                     2, 1000 + n));
  }
  const UnitCounters c = run(frame, config).counters;
  EXPECT_EQ(c.overflow_lines, 0u);
  EXPECT_GT(c.lines_cancelled, 0u);
  EXPECT_EQ(c.slb_lines, 0u);
}

TEST(Capacity, HistogramAndCollisionsDescribeTheChains) {
  const RandomScene scene(3, kSide);
  for (const std::int64_t buckets : {1, 8, 1024}) {
    UnitConfig config = limited(kAmple);
    config.slb_buckets = buckets;
    const Outcome out = run(scene.frame, config);
    const UnitCounters& c = out.counters;
    const auto texels =
        std::accumulate(c.chain_histogram.begin(), c.chain_histogram.end(), std::uint64_t{0});
    EXPECT_EQ(texels, c.slb_texels);
    EXPECT_EQ(c.slb_entries, out.contents.entries.size());
    EXPECT_EQ(c.chain_histogram.size(), c.max_chain + 1);
    // In one bucket all but one collide; with 4 buckets a texel none does.
    if (buckets != 8) {
      EXPECT_EQ(c.collisions, buckets == 1 ? c.slb_texels - 1 : 0u);
    }
  }
}

}  // namespace
}  // namespace kagesen
