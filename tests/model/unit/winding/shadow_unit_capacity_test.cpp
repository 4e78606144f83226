// Where capacities run out: counted, marked, and nothing else is touched.
#include <gtest/gtest.h>

#include <numeric>

#include "tests/model/unit/winding/soups.h"

namespace kagesen {
namespace {

struct Limit {
  const char* name;
  std::int64_t UnitConfig::*field;
  std::int64_t value;
};
const Limit kLimits[] = {{"cluster_records", &UnitConfig::cluster_records, 30},
                         {"cluster_records", &UnitConfig::cluster_records, 300},
                         {"chain_records", &UnitConfig::chain_records, 1},
                         {"chain_records", &UnitConfig::chain_records, 4},
                         {"corner_bits", &UnitConfig::corner_bits, 2}};

std::size_t texel(const Fragment& f, const Trace& trace) {
  const int bits = int(trace.header.fraction_bits), side = int(trace.header.map_width);
  return std::size_t((f.position.y >> bits) + side / 2) * std::size_t(side) +
         std::size_t((f.position.x >> bits) + side / 2);
}

/// One plane many times over a corner, so that its count overflows.
void pile_up(Trace& trace) {
  const std::int32_t t = 1 << trace.header.fraction_bits;
  for (int i = 0; i < 6; ++i) {
    trace.all_casters.push_back(
        {{{-2 * t, -2 * t, 900}, {2 * t + i, -2 * t, 900}, {-2 * t, 2 * t + i, 900}}, 1, 0});
  }
}

TEST(WindingCapacity, OverflowIsCountedAndMarkedAndTouchesNothingElse) {
  for (const Limit& limit : kLimits) {
    std::uint64_t overflowed = 0, changed = 0;
    for (unsigned seed = 0; seed < 24; ++seed) {
      RandomTrace random(kScenes[seed % 4], 16 + int(seed) % 4, 8, 900 + seed);
      pile_up(random.trace);
      const Trace& trace = random.trace;
      UnitConfig config =
          random.fit(winding_config(seed / 4 % 2 ? Semantics::kPaper : Semantics::kPhysical));
      config.skip_tiles = seed % 3 != 0;
      const Outcome whole = run_winding(trace, config);
      ASSERT_EQ(whole.counters.overflow_texels, 0u);
      config.*limit.field = limit.value;
      const Outcome got = run_winding(trace, config);
      const auto& marks = got.contents.overflowed;
      const auto marked = std::uint64_t(std::accumulate(marks.begin(), marks.end(), 0));
      ASSERT_EQ(marked, got.counters.overflow_texels) << limit.name;
      ASSERT_EQ(marked != 0, got.counters.overflow_lines != 0);
      overflowed += marked;
      if (limit.field == &UnitConfig::cluster_records) {
        ASSERT_LE(got.counters.peak_entries, std::uint64_t(limit.value));
      }
      if (limit.field == &UnitConfig::chain_records) {
        ASSERT_LE(got.counters.max_chain, std::uint64_t(limit.value));
      }
      for (const TexelCluster& c : got.contents.clusters) {
        ASSERT_FALSE(marks[c.texel_y * std::size_t(config.map_width) + c.texel_x]);
      }
      for (std::size_t i = 0; i < got.verdicts.size(); ++i) {
        if (got.verdicts[i] == whole.verdicts[i]) continue;
        ++changed;
        ASSERT_TRUE(marks[texel(trace.all_fragments[i], trace)])
            << limit.name << ", seed " << seed << ", fragment " << i;
      }
    }
    EXPECT_GT(overflowed, 10u) << limit.name << ' ' << limit.value;
    EXPECT_GT(changed, 0u) << limit.name << ' ' << limit.value;
  }
}

/// The verdict of a plain map: the nearest threshold at the texel's centre, for the whole texel.
TEST(WindingCapacity, AnOverflowedTexelIsAPlainMapOfItsNearestThreshold) {
  constexpr std::int32_t t = kTexel;
  Trace trace;
  trace.header.objects.resize(2);
  trace.all_casters = {{{{0, 0, 5000}, {t / 2, 0, 5000}, {0, t / 2, 5000}}, 0, 0},
                       {{{t / 2, t / 2, 3000}, {t, t / 2, 3000}, {t / 2, t, 3000}}, 0, 1}};
  UnitConfig config = winding_config(Semantics::kPhysical);
  config.map_width = config.map_height = 4;
  config.chain_records = 1;
  for (const std::uint32_t z : {2900u, 3200u, 9000u}) {
    for (const std::int32_t x : {t / 8, t * 7 / 8}) {
      for (const bool nearer_first : {false, true}) {
        Trace one = trace;
        if (nearer_first) std::swap(one.all_casters[0], one.all_casters[1]);
        one.all_fragments = {fragment_at(x, t / 16, z, 1)};
        const Outcome got = run_winding(one, config);
        EXPECT_EQ(got.counters.overflow_texels, z > 2900 ? 1u : got.counters.overflow_texels);
        EXPECT_EQ(got.verdicts[0], z > 3000 ? Verdict::kDark : Verdict::kLit) << x << ' ' << z;
      }
    }
  }
}

}  // namespace
}  // namespace kagesen
