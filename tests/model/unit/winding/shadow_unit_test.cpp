// The winding unit as a whole: order, skips and what outlives a frame.
#include <gtest/gtest.h>

#include "tests/model/unit/winding/soups.h"

namespace kagesen {
namespace {

constexpr Semantics kBoth[] = {Semantics::kPaper, Semantics::kPhysical};

std::size_t first_difference(const std::vector<Verdict>& a, const std::vector<Verdict>& b) {
  std::size_t i = 0;
  while (i < a.size() && a[i] == b[i]) ++i;
  return i;
}

void expect_same_verdicts(const Outcome& a, const Outcome& b, const Trace& trace) {
  const std::size_t i = first_difference(a.verdicts, b.verdicts);
  if (i == a.verdicts.size()) return;
  const LightPoint& p = trace.all_fragments[i].position;
  FAIL() << "fragment " << i << " at " << p.x << ',' << p.y << ',' << p.z << " is "
         << int(a.verdicts[i]) << " and " << int(b.verdicts[i]);
}

TEST(WindingShadowUnit, OrderAndWritingOfTrianglesDoNotMatter) {
  int same_contents = 0, dropped_some = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const int bits = 16 + int(seed) % 7;
    const RandomTrace random(kScenes[seed % 4], bits, 8, seed);
    for (const Semantics semantics : kBoth) {
      UnitConfig config = random.fit(winding_config(semantics));
      config.skip_edges = seed % 3 != 0;
      config.skip_receiver_mask = seed % 5 == 0;
      const Outcome expected = run_winding(random.trace, config);
      Trace other = random.trace;
      std::vector<Rewritten> how;
      other.all_casters = rewrite(random.trace.all_casters, seed, how);
      const Outcome got = run_winding(other, config);
      expect_same_verdicts(expected, got, random.trace);
      if (HasFatalFailure()) FAIL() << "seed " << seed;
      const auto dropped = [](const Outcome& o) {
        return o.counters.lines_hidden + o.counters.skips.hidden_visits;
      };
      if (dropped(expected) + dropped(got) != 0) {
        ++dropped_some;
        continue;
      }
      ++same_contents;
      ASSERT_TRUE(expected.contents.clusters == got.contents.clusters) << "seed " << seed;
      ASSERT_EQ(expected.counters.slb_lines, got.counters.slb_lines);
    }
  }
  EXPECT_GT(same_contents, 10);
  EXPECT_GT(dropped_some, 10);
}

TEST(WindingShadowUnit, NoSkipChangesAVerdict) {
  bool UnitConfig::*const kSkips[] = {&UnitConfig::skip_receiver_mask, &UnitConfig::skip_first_test,
                                      &UnitConfig::skip_tiles, &UnitConfig::skip_edges,
                                      &UnitConfig::skip_fragments};
  SkipCounters used;
  for (unsigned seed = 100; seed < 140; ++seed) {
    const RandomTrace random(kScenes[seed % 4], 16 + int(seed) % 5, 8, seed);
    for (const Semantics semantics : kBoth) {
      UnitConfig none = random.fit(winding_config(semantics));
      for (const auto skip : kSkips) none.*skip = false;
      const Outcome expected = run_winding(random.trace, none);
      for (unsigned on = 0; on < 7; ++on) {  // each alone, all, and some
        UnitConfig config = none;
        for (unsigned i = 0; i < 5; ++i) {
          config.*kSkips[i] = on < 5 ? on == i : on == 5 || (seed * 7 >> i & 1) != 0;
        }
        const Outcome got = run_winding(random.trace, config);
        expect_same_verdicts(expected, got, random.trace);
        if (HasFatalFailure()) FAIL() << "seed " << seed << ", skips " << on;
        const SkipCounters& s = got.counters.skips;
        used.masked_visits += s.masked_visits;
        used.first_test_dark += s.first_test_dark;
        used.tile_lit += s.tile_lit;
        used.tile_dark += s.tile_dark;
        used.inner_edge_texels += s.inner_edge_texels;
        used.known_fragments += s.known_fragments;
      }
    }
  }
  for (const std::uint64_t count : {used.masked_visits, used.first_test_dark, used.tile_lit,
                                    used.tile_dark, used.inner_edge_texels, used.known_fragments}) {
    EXPECT_GT(count, 500u);
  }
}

TEST(WindingShadowUnit, FramesDoNotTouchEachOther) {
  const std::unique_ptr<Engine> engine = make_golden_engine();
  for (unsigned seed = 0; seed < 24; ++seed) {
    const RandomTrace random(kScenes[seed % 4], 16 + int(seed) % 3, 8, seed);
    UnitConfig config = random.fit(winding_config(kBoth[seed / 4 % 2]));
    if (seed % 5 == 0) config.cluster_records = 40;
    const Outcome expected = run_winding(random.trace, config);
    for (int frame = 0; frame < 2; ++frame) {
      const Outcome got = run_winding(*engine, random.trace, config);
      expect_same_verdicts(expected, got, random.trace);
      ASSERT_TRUE(expected.contents == got.contents);
      ASSERT_TRUE(expected.contents.clusters == got.contents.clusters);
      ASSERT_EQ(expected.counters.peak_entries, got.counters.peak_entries);
      ASSERT_EQ(expected.counters.casters, got.counters.casters);
      ASSERT_EQ(expected.counters.skips.cleared_texels, got.counters.skips.cleared_texels);
      ASSERT_EQ(expected.counters.lines_read, got.counters.lines_read);
    }
  }
}

TEST(WindingShadowUnit, AnEmptyFrameLightsEverything) {
  RandomTrace random(Scene::kSoup, 16, 8, 1);
  random.trace.all_casters.clear();
  for (Fragment& f : random.trace.all_fragments) f.flags = 0;
  for (const Semantics semantics : kBoth) {
    const Outcome got = run_winding(random.trace, random.fit(winding_config(semantics)));
    for (const Verdict v : got.verdicts) ASSERT_EQ(v, Verdict::kLit);
    EXPECT_EQ(got.counters.skips.cleared_texels, 0u);
    EXPECT_TRUE(got.contents.clusters.empty());
  }
}

/// Deciding, and reading the buffers, between draws changes nothing of what comes after.
TEST(WindingShadowUnit, DrawingGoesOnAfterDeciding) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const RandomTrace random(kScenes[seed % 4], 16, 8, 500 + seed);
    const Trace& trace = random.trace;
    const UnitConfig config = random.fit(winding_config(kBoth[seed / 4 % 2]));
    const Outcome expected = run_winding(trace, config);
    const std::unique_ptr<Engine> engine = make_golden_engine();
    engine->begin(config, make_frame_setup(trace, config));
    engine->announce(trace.all_fragments.data(), trace.all_fragments.size());
    const std::size_t count = trace.all_casters.size();
    for (std::size_t from = 0; from < count;) {
      const std::size_t part = std::min(count - from, 1 + count / 5);
      engine->draw(&trace.all_casters[from], part);
      from += part;
      if (from < count) outcome(*engine, trace.all_fragments);
    }
    expect_same_verdicts(expected, outcome(*engine, trace.all_fragments), trace);
    if (HasFatalFailure()) FAIL() << "seed " << seed;
  }
}

}  // namespace
}  // namespace kagesen
