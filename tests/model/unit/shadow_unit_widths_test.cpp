// Narrow positions, depths and IDs, finer traces and other hashes, on random closed solids.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/model/unit/frame.h"

namespace kagesen {
namespace {

constexpr int kSide = 24;
constexpr unsigned kSeeds = 40;

const UnitConfig kConfig = small_config(kSide);

TEST(UnitWidths, PositionBitsDropTheLowBitsOfMxAndMy) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    Frame frame = RandomScene(seed, kSide).frame;
    UnitConfig narrow = kConfig;
    narrow.position_bits = 9;
    const std::vector<Verdict> verdicts = run(frame, narrow).verdicts;
    for (Fragment& f : frame.fragments) {
      f.position.x &= ~((1 << 7) - 1);
      f.position.y &= ~((1 << 7) - 1);
    }
    ASSERT_EQ(run(frame, kConfig).verdicts, verdicts) << seed;
    // Fewer than Fraction has: as many as it has.
    narrow.position_bits = 1;
    UnitConfig eight = kConfig;
    eight.position_bits = 8;
    ASSERT_EQ(run(frame, narrow).verdicts, run(frame, eight).verdicts) << seed;
  }
}

TEST(UnitWidths, NarrowDepthsAreTheHighBits) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    Frame frame = RandomScene(seed, kSide).frame;
    UnitConfig narrow = kConfig;
    narrow.depth_bits = 10;
    const Outcome low = run(frame, narrow);
    for (Caster& c : frame.casters) {
      for (LightPoint& v : c.vertex) v.z >>= 14;
    }
    for (Fragment& f : frame.fragments) f.position.z >>= 14;
    const Outcome high = run(frame, kConfig);
    ASSERT_EQ(low.verdicts, high.verdicts) << seed;
    ASSERT_TRUE(low.contents.entries == high.contents.entries) << seed;
    for (std::size_t i = 0; i < low.contents.depth.size(); ++i)
      ASSERT_EQ(low.contents.depth[i], std::min(high.contents.depth[i], 1023u));
  }
}

TEST(UnitWidths, NarrowIdsAreTheLowBitsUnlessTheFrameNamesThem) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const Frame frame = RandomScene(seed, kSide).frame;
    UnitConfig narrow = kConfig;
    narrow.id_bits = 1;
    const Outcome wrapped = run(frame, narrow);
    Frame renamed = frame;
    for (Caster& c : renamed.casters) c.object %= 2;
    for (Fragment& f : renamed.fragments) f.object %= 2;
    const Outcome plain = run(renamed, kConfig);
    ASSERT_EQ(wrapped.verdicts, plain.verdicts) << seed;
    ASSERT_TRUE(wrapped.contents == plain.contents) << seed;
    FrameSetup setup;
    for (std::uint32_t object = 0; object <= 12; ++object) setup.unit_ids.push_back(object % 2);
    ASSERT_EQ(run(frame, kConfig, setup).verdicts, plain.verdicts) << seed;
  }
}

TEST(UnitWidths, AFinerTraceOfTheSameGeometryHasTheSameLines) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    Frame frame = RandomScene(seed, kSide).frame;
    const Outcome before = run(frame, kConfig);
    for (Caster& c : frame.casters) {
      for (LightPoint& v : c.vertex) v = {v.x * 8, v.y * 8, v.z};
    }
    for (Fragment& f : frame.fragments)
      f.position = {f.position.x * 8, f.position.y * 8, f.position.z};
    FrameSetup setup;
    setup.fraction_bits = kMinFractionBits + 3;
    const Outcome after = run(frame, kConfig, setup);
    ASSERT_EQ(after.verdicts, before.verdicts) << seed;
    ASSERT_TRUE(after.contents == before.contents) << seed;
  }
}

TEST(UnitWidths, TheHashAndTheRecordsShapeChangeNoContents) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const Frame frame = RandomScene(seed, kSide).frame;
    const Outcome before = run(frame, kConfig);
    for (const std::int64_t lines : {1, 2, 15}) {
      UnitConfig config = kConfig;
      config.slb_buckets = lines == 2 ? 1 : 64;
      config.lines_per_entry = lines;
      const Outcome after = run(frame, config);
      ASSERT_EQ(after.verdicts, before.verdicts) << seed;
      ASSERT_TRUE(after.contents == before.contents) << seed;
      ASSERT_EQ(after.counters.lines_read, before.counters.lines_read) << seed;
    }
  }
}

}  // namespace
}  // namespace kagesen
