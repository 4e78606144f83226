// What must not change a verdict, on random closed solids through the Engine interface.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "tests/model/unit/frame.h"

namespace kagesen {
namespace {

constexpr int kSide = 24;
constexpr unsigned kSeeds = 40;

const UnitConfig kConfig = small_config(kSide);

TEST(UnitProperties, TheScenesAreWorthTheirTests) {
  std::uint64_t by_lines = 0, by_buffer = 0, cancelled = 0, hidden = 0;
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const UnitCounters c = run(RandomScene(seed, kSide).frame, kConfig).counters;
    by_lines += c.dark_by_lines;
    by_buffer += c.dark_by_buffer;
    cancelled += c.lines_cancelled;
    hidden += c.lines_hidden;
  }
  EXPECT_GT(by_lines, 20 * kSeeds);
  EXPECT_GT(by_buffer, 20 * kSeeds);
  EXPECT_GT(cancelled, 20 * kSeeds);
  EXPECT_GT(hidden, kSeeds);
}

TEST(UnitProperties, RunsAreEqualAndSoAreRunsInPortions) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const Frame frame = RandomScene(seed, kSide).frame;
    const Outcome once = run(frame, kConfig);
    const std::unique_ptr<Engine> engine = make_golden_engine();
    // An earlier frame must leave nothing behind.
    engine->begin(small_config(5), {});
    engine->draw(frame.casters.data(), frame.casters.size());
    engine->begin(kConfig, {});
    for (std::size_t i = 0; i < frame.casters.size();) {
      const std::size_t count = std::min<std::size_t>(1 + i % 3, frame.casters.size() - i);
      engine->draw(frame.casters.data() + i, count);
      engine->draw(nullptr, 0);
      i += count;
    }
    std::vector<Verdict> verdicts(frame.fragments.size());
    for (std::size_t i = 0; i < verdicts.size();) {
      const std::size_t count = std::min<std::size_t>(1 + i % 7, verdicts.size() - i);
      engine->decide(frame.fragments.data() + i, count, verdicts.data() + i);
      i += count;
    }
    ASSERT_EQ(verdicts, once.verdicts) << seed;
    ASSERT_TRUE(engine->contents() == once.contents) << seed;
    ASSERT_EQ(engine->counters().lit, once.counters.lit);
    ASSERT_EQ(engine->counters().lines_stored, once.counters.lines_stored);
    ASSERT_EQ(engine->counters().peak_entries, once.counters.peak_entries);
  }
}

TEST(UnitProperties, MovingAllByWholeTexelsMovesTheBuffers) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    Frame frame = RandomScene(seed, kSide - 10).frame;
    const Outcome before = run(frame, kConfig);
    const int dx = static_cast<int>(seed % 5) - 2, dy = static_cast<int>(seed / 5 % 5) - 2;
    const auto move = [&](LightPoint& p) {
      p.x += dx * kTexel;
      p.y += dy * kTexel;
    };
    for (Caster& c : frame.casters) {
      for (LightPoint& v : c.vertex) move(v);
    }
    for (Fragment& f : frame.fragments) move(f.position);
    const Outcome after = run(frame, kConfig);
    ASSERT_EQ(after.verdicts, before.verdicts) << seed;

    MapContents moved = before.contents;
    std::fill(moved.depth.begin(), moved.depth.end(), kDepthMax);
    std::fill(moved.object.begin(), moved.object.end(), kNoObject);
    const auto side = static_cast<std::size_t>(kSide);
    for (std::size_t i = 0; i < side * side; ++i) {
      if (before.contents.object[i] == kNoObject) continue;
      const std::size_t to = (i / side + dy) * side + i % side + dx;
      moved.depth.at(to) = before.contents.depth[i];
      moved.object.at(to) = before.contents.object[i];
    }
    for (TexelEntry& e : moved.entries) {
      e.texel_x += dx;
      e.texel_y += dy;
    }
    ASSERT_TRUE(after.contents == moved) << seed;
  }
}

/// Texels whose entries have another nearest depth in `b` than in `a`.
std::vector<bool> nearest_differs(const MapContents& a, const MapContents& b) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> nearest;
  for (const TexelEntry& e : a.entries)
    nearest[{e.texel_y * kSide + e.texel_x, e.object}] = e.nearest;
  std::vector<bool> out(kSide * kSide);
  for (const TexelEntry& e : b.entries) {
    const std::uint32_t texel = e.texel_y * kSide + e.texel_x;
    if (nearest[{texel, e.object}] != e.nearest) out[texel] = true;
  }
  return out;
}

TEST(UnitProperties, TheOrderOfATrianglesVerticesIsNothing) {
  constexpr std::array<std::array<int, 3>, 6> kOrders = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    Frame frame = RandomScene(seed, kSide).frame;
    const Outcome before = run(frame, kConfig);
    for (std::size_t i = 0; i < frame.casters.size(); ++i) {
      const Caster c = frame.casters[i];
      for (int v = 0; v < 3; ++v) frame.casters[i].vertex[v] = c.vertex[kOrders[(i + seed) % 6][v]];
    }
    const Outcome after = run(frame, kConfig);
    ASSERT_EQ(after.contents.depth, before.contents.depth) << seed;
    ASSERT_EQ(after.contents.object, before.contents.object) << seed;
    // The lines of a triangle may be stored in another order; whether an entry is empty in between
    // shows in its nearest depth, and so in its place, and in its Vertex Flag.
    const auto sorted = [](std::vector<TexelEntry> entries) {
      for (TexelEntry& e : entries) {
        std::sort(e.lines.begin(), e.lines.end());
        e.nearest = 0;
        e.vertex = false;
      }
      std::sort(entries.begin(), entries.end(), [](const TexelEntry& a, const TexelEntry& b) {
        return std::tie(a.texel_y, a.texel_x, a.object) < std::tie(b.texel_y, b.texel_x, b.object);
      });
      return entries;
    };
    ASSERT_TRUE(sorted(after.contents.entries) == sorted(before.contents.entries)) << seed;
    const auto reordered = nearest_differs(before.contents, after.contents);
    for (std::size_t i = 0; i < frame.fragments.size(); ++i) {
      const std::size_t texel = texel_of(frame.fragments[i], kSide);
      ASSERT_TRUE(after.verdicts[i] == before.verdicts[i] || reordered[texel]) << seed << ' ' << i;
    }
  }
}

TEST(UnitProperties, TrianglesThatCoverNothingChangeNothing) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    Frame frame = RandomScene(seed, kSide).frame;
    const Outcome before = run(frame, kConfig);
    const std::int32_t border = kSide / 2 * kTexel;
    const LightPoint a = frame.casters[0].vertex[0], b = frame.casters[0].vertex[1];
    const LightPoint middle{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, 7};
    std::vector<Caster> extra = {
        triangle({border, 0, 1}, {border + 5 * kTexel, 9, 1}, {border + 9, 5 * kTexel, 1}, 0),
        triangle({-border - 1, 0, 1}, {-border - 9 * kTexel, 9, 1}, {-border - 9, 90000, 1}, 1),
        triangle({3, border, 1}, {9 * kTexel, border + 99, 1}, {-5 * kTexel, 3 * border, 1}, 2),
        triangle({3, -border - 1, 1}, {kTexel, -border - 99, 1}, {-kTexel, -3 * border, 1}, 3),
        // No area: one point, one edge twice, three points of a line.
        triangle(a, a, a, 0), triangle(a, b, a, 1),
        triangle({0, 0, 1}, {kTexel, 2 * kTexel, 1}, {3 * kTexel, 6 * kTexel, 1}, 2),
        triangle(middle, middle, {middle.x, middle.y, 1}, 3)};
    for (std::size_t i = 0; i < extra.size(); ++i) {
      const auto place = static_cast<std::ptrdiff_t>((seed + i) % frame.casters.size());
      frame.casters.insert(frame.casters.begin() + place, extra[i]);
    }
    const Outcome after = run(frame, kConfig);
    ASSERT_EQ(after.verdicts, before.verdicts) << seed;
    ASSERT_TRUE(after.contents == before.contents) << seed;
  }
}

/// A triangle in texels that a nearer one covers wholly is never seen, except by the cover itself,
/// which passes its own source over.
TEST(UnitProperties, WhatACoverHidesChangesNoVerdict) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    Frame frame = RandomScene(seed, kSide).frame;
    constexpr std::uint32_t kCover = 20, kHidden = 21;
    const std::int32_t low = -4 * kTexel - 100, high = 9 * kTexel;
    const Caster cover =
        triangle({low, low, 1000}, {high, low, 1000}, {low, high, 1000}, kCover, 500);
    frame.casters.push_back(cover);
    const Outcome before = run(frame, kConfig);
    for (const bool last : {false, true}) {
      Frame more = frame;
      const Caster hidden =
          triangle({-3 * kTexel - 5, -3 * kTexel - 9, 1001}, {kTexel / 2, -2 * kTexel, 90000},
                   {-2 * kTexel, kTexel / 3, 5000}, kHidden, 501);
      more.casters.insert(last ? more.casters.end() : more.casters.begin(), hidden);
      ASSERT_EQ(run(more, kConfig).verdicts, before.verdicts) << seed << ' ' << last;
    }
  }
}

/// Contents of the map seen in a mirror: x runs the other way.
MapContents mirrored(const MapContents& map) {
  MapContents out = map;
  for (std::size_t i = 0; i < out.depth.size(); ++i) {
    const std::size_t from = i / kSide * kSide + kSide - 1 - i % kSide;
    out.depth[i] = map.depth[from];
    out.object[i] = map.object[from];
  }
  for (TexelEntry& e : out.entries) {
    e.texel_x = kSide - 1 - e.texel_x;
    for (LineRecord& l : e.lines) {
      l.left = !l.left;
      l.x_positive = !l.x_positive;
    }
  }
  std::stable_sort(out.entries.begin(), out.entries.end(),
                   [](const TexelEntry& a, const TexelEntry& b) {
                     return std::tie(a.texel_y, a.texel_x) < std::tie(b.texel_y, b.texel_x);
                   });
  return out;
}

TEST(UnitProperties, AMirroredSceneHasMirroredShadows) {
  for (unsigned seed = 0; seed < 4 * kSeeds; ++seed) {
    Frame frame = RandomScene(seed, kSide).frame;
    UnitConfig config = kConfig;
    config.fraction_bits = config.slope_bits = 12;
    const Outcome before = run(frame, config);
    for (Caster& c : frame.casters) {
      for (LightPoint& v : c.vertex) v.x = -v.x;
    }
    for (Fragment& f : frame.fragments) f.position.x = -f.position.x;
    const Outcome after = run(frame, config);
    ASSERT_TRUE(after.contents == mirrored(before.contents)) << seed;
    ASSERT_EQ(after.verdicts, before.verdicts) << seed;
  }
}

}  // namespace
}  // namespace kagesen
