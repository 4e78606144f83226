// The whole unit on frames made by hand: Table 4, and what each switch of the configuration does.
#include <gtest/gtest.h>

#include "tests/model/unit/frame.h"

namespace kagesen {
namespace {

constexpr std::uint32_t kReceiver = 9;

/// A triangle whose inside is x < `edge` in the rows of the texels (-1..2), its other sides far
/// off.
Caster half_plane(std::int32_t edge, std::uint32_t z, std::uint32_t object) {
  return triangle({edge, -3 * kTexel, z}, {edge, 4 * kTexel, z}, {-90 * kTexel, 0, z}, object,
                  object);
}

/// A triangle that covers every texel of the map.
Caster cover(std::uint32_t z, std::uint32_t object) {
  return triangle({-100 * kTexel, -50 * kTexel, z}, {100 * kTexel, -50 * kTexel, z},
                  {0, 200 * kTexel, z}, object, 20 + object);
}

/// Three lines through texel (0, 0): x < 1/4 at depth 100, x < 1/2 at 200, x < 3/4 at 300.
std::vector<Caster> three_entries() {
  return {half_plane(kTexel * 3 / 4, 300, 3), half_plane(kTexel / 4, 100, 1),
          half_plane(kTexel / 2, 200, 2)};
}

struct Row {
  const char* row;
  Fragment fragment;
  Verdict literal, per_source;
  std::uint64_t entries_read;  // by the literal rule
};

const std::int32_t kEighth = kTexel / 8;
constexpr Verdict kLit = Verdict::kLit, kDark = Verdict::kDark;

// Texel (-2, 0) is covered by all three, nearest by object 1 at depth 100.
const Row kTable4[] = {
    {"ID equal", fragment_at(-2 * kTexel, 5, 1000, 1), kLit, kLit, 0},
    {"ID differs, deeper", fragment_at(-2 * kTexel, 5, 101, kReceiver), kDark, kDark, 0},
    {"ID differs, as deep: not deeper", fragment_at(-2 * kTexel, 5, 100, kReceiver), kLit, kLit, 0},
    {"ID differs, nearer, no edge", fragment_at(-2 * kTexel, 5, 99, kReceiver), kLit, kLit, 0},
    {"edge, within the 1st", fragment_at(kEighth, 5, 1000, kReceiver), kDark, kDark, 1},
    {"edge, within the 2nd", fragment_at(3 * kEighth, 5, 1000, kReceiver), kDark, kDark, 2},
    {"edge, within the 3rd", fragment_at(5 * kEighth, 5, 1000, kReceiver), kDark, kDark, 3},
    {"edge, within none", fragment_at(7 * kEighth, 5, 1000, kReceiver), kLit, kLit, 3},
    // What the table omits: the fragment lies before the entry's depth.
    {"within the 2nd, before it", fragment_at(3 * kEighth, 5, 150, kReceiver), kLit, kLit, 1},
    {"within the 2nd, as deep", fragment_at(3 * kEighth, 5, 200, kReceiver), kLit, kLit, 1},
    // An entry of the fragment's own ID does not shadow it; the next does.
    {"own 1st, within the 2nd", fragment_at(kEighth, 5, 1000, 1), kDark, kDark, 2},
    {"own 3rd alone", fragment_at(5 * kEighth, 5, 1000, 3), kLit, kLit, 3},
};

TEST(ShadowUnit, Table4EveryRow) {
  for (const Row& row : kTable4) {
    UnitConfig config = small_config();
    EXPECT_EQ(verdict_of(three_entries(), row.fragment, config), row.per_source) << row.row;
    config.own_id_rule = OwnIdRule::kLiteral;
    const Outcome literal = run({three_entries(), {row.fragment}}, config);
    EXPECT_EQ(literal.verdicts[0], row.literal) << row.row;
    EXPECT_EQ(literal.counters.entries_read, row.entries_read) << row.row;
  }
}

TEST(ShadowUnit, Table4Row1LiteralCutsShortAndPerSourceGoesOn) {
  // Object 4 covers the texel at depth 500; a fragment of its own at 1000, within the 1st entry.
  std::vector<Caster> casters = three_entries();
  casters.push_back(cover(500, 4));
  const Fragment own = fragment_at(kEighth, 5, 1000, 4);
  UnitConfig config = small_config();
  EXPECT_EQ(verdict_of(casters, own, config), kDark);
  config.own_id_rule = OwnIdRule::kLiteral;
  EXPECT_EQ(verdict_of(casters, own, config), kLit);
}

TEST(ShadowUnit, EntriesAreReadFromTheLightOutwards) {
  const Outcome out = run({three_entries(), {}}, small_config());
  std::vector<std::uint32_t> nearest;
  for (const TexelEntry& e : out.contents.entries) {
    if (e.texel_x == 8 && e.texel_y == 8) nearest.push_back(e.nearest);
  }
  EXPECT_EQ(nearest, (std::vector<std::uint32_t>{100, 200, 300}));
}

TEST(ShadowUnit, FlagsDecideAlone) {
  Fragment averted = fragment_at(5, 5, 0, kReceiver), outside = fragment_at(-2 * kTexel, 5, 900, 8);
  averted.flags = Fragment::kAverted;
  outside.flags = Fragment::kOutside;
  const Fragment beyond = fragment_at(8 * kTexel, 5, 900, 8);
  const Fragment before = fragment_at(5, -8 * kTexel - 1, 900, 8);
  const Outcome out = run({three_entries(), {averted, outside, beyond, before}}, small_config());
  EXPECT_EQ(out.verdicts, (std::vector<Verdict>{kDark, kLit, kLit, kLit}));
  EXPECT_EQ(out.counters.averted, 1u);
  EXPECT_EQ(out.counters.outside, 3u);
  EXPECT_EQ(out.counters.fragments, 4u);
}

TEST(ShadowUnit, CountersOfPass2AddUp) {
  Frame frame{three_entries(), {}};
  for (const Row& row : kTable4) frame.fragments.push_back(row.fragment);
  const UnitCounters c = run(frame, small_config()).counters;
  EXPECT_EQ(c.fragments, frame.fragments.size());
  EXPECT_EQ(c.dark_by_buffer, 1u);
  EXPECT_EQ(c.dark_by_lines, 4u);
  EXPECT_EQ(c.lit + c.dark_by_buffer + c.dark_by_lines + c.averted + c.outside, c.fragments);
}

TEST(ShadowUnit, DepthWritesReachOutlineTexelsOnlyWhereAsked) {
  const std::size_t on_the_outline = 8 * 16 + 8, inside = 8 * 16 + 6;
  UnitConfig config = small_config();
  MapContents map = run({{half_plane(kTexel / 4, 100, 1)}, {}}, config).contents;
  EXPECT_EQ(map.depth[on_the_outline], kDepthMax);
  EXPECT_EQ(map.object[on_the_outline], kNoObject);
  EXPECT_EQ(map.depth[inside], 100u);
  EXPECT_EQ(map.object[inside], 1u);
  config.depth_writes = DepthWrites::kAll;
  map = run({{half_plane(kTexel / 4, 100, 1)}, {}}, config).contents;
  EXPECT_EQ(map.depth[on_the_outline], 100u);
  EXPECT_EQ(map.object[on_the_outline], 1u);
}

/// Are there lines in texel (0, 0) after `casters`?
bool lines_left(const std::vector<Caster>& casters, HiddenRemoval removal) {
  UnitConfig config = small_config();
  config.hidden_removal = removal;
  for (const TexelEntry& e : run({casters, {}}, config).contents.entries) {
    if (e.texel_x == 8 && e.texel_y == 8) return true;
  }
  return false;
}

TEST(ShadowUnit, HiddenRemovalByCentreAndByFarthest) {
  const Caster line = half_plane(kTexel / 4, 1000, 1);
  // Depth 900 all over; and depth 990 at the centre of texel (0, 0) that rises by 40 a texel.
  const Caster flat = cover(900, 2);
  const auto z = [](int x) { return static_cast<std::uint32_t>(990 - 20 + 40 * x); };
  const Caster tilted = triangle({-20 * kTexel, -90 * kTexel, z(-20)},
                                 {-20 * kTexel, 90 * kTexel, z(-20)}, {70 * kTexel, 0, z(70)}, 2);
  struct {
    const char* name;
    std::vector<Caster> casters;
    bool off, centre, farthest;
  } const cases[] = {
      {"flat cover, drawn last", {line, flat}, true, false, false},
      {"flat cover, drawn first: centre refuses", {flat, line}, true, false, true},
      {"cover beyond the line", {line, cover(1001, 2)}, true, true, true},
      {"cover as deep", {line, cover(1000, 2)}, true, true, true},
      {"tilted: the centre is nearer, a corner is not", {line, tilted}, true, false, true},
  };
  for (const auto& c : cases) {
    EXPECT_EQ(lines_left(c.casters, HiddenRemoval::kOff), c.off) << c.name;
    EXPECT_EQ(lines_left(c.casters, HiddenRemoval::kCentre), c.centre) << c.name;
    EXPECT_EQ(lines_left(c.casters, HiddenRemoval::kFarthest), c.farthest) << c.name;
  }
}

TEST(ShadowUnit, HiddenLinesAreCounted) {
  UnitConfig config = small_config();
  const Caster line = half_plane(kTexel / 4, 1000, 1), flat = cover(900, 2);
  const UnitCounters last = run({{line, flat}, {}}, config).counters;
  const UnitCounters first = run({{flat, line}, {}}, config).counters;
  EXPECT_GT(last.lines_hidden, 0u);
  EXPECT_EQ(last.lines_hidden, first.lines_hidden);
  EXPECT_EQ(last.slb_lines, 0u);
}

TEST(ShadowUnit, PolygonIdsKeepASliversSidesApart) {
  // Two sides of one sliver, 1/1024 texel apart, have equal words at 4 bits but for L/R.
  const Caster sliver = triangle({kTexel / 2, -2 * kTexel, 100}, {kTexel / 2, 3 * kTexel, 100},
                                 {kTexel / 2 + kTexel / 1024, 3 * kTexel, 100}, 1, 7);
  UnitConfig config = small_config();
  config.fraction_bits = config.slope_bits = 4;
  EXPECT_GT(run({{sliver}, {}}, config).counters.slb_lines, 8u);
  EXPECT_EQ(run({{sliver}, {}}, config).counters.lines_cancelled, 0u);
  config.match_polygon_id = false;
  const Outcome out = run({{sliver}, {}}, config);
  EXPECT_GT(out.counters.lines_cancelled, 2u);
  // A texel that the sliver emptied is not covered by it: the count is 0.
  EXPECT_EQ(out.contents.object[8 * 16 + 8], kNoObject);
}

TEST(ShadowUnit, PolygonIdsWrapAtTheirWidth) {
  UnitConfig config = small_config();
  config.polygon_id_bits = 2;
  Caster one = half_plane(kTexel / 4, 100, 1);
  one.polygon = 7;
  EXPECT_EQ(run({{one}, {}}, config).contents.entries.at(0).lines.at(0).polygon, 3u);
}

TEST(ShadowUnit, AnEntryThatWasEmptyForgetsItsVertexAndNearestDepth) {
  // Three triangles around v; the last one's sides at v cancel before its third side, which runs
  // through the same texel without an end, is stored.
  const LightPoint v{kTexel / 2, kTexel / 2, 100}, a{7 * kTexel, kTexel / 3, 1000},
      b{kTexel / 4, -6 * kTexel, 1000}, c{kTexel / 4, 6 * kTexel, 1000};
  const MapContents map =
      run({{triangle(v, a, b, 0, 1), triangle(v, c, a, 0, 2), triangle(b, v, c, 0, 3)}, {}},
          small_config())
          .contents;
  const auto at = std::find_if(map.entries.begin(), map.entries.end(), [](const TexelEntry& e) {
    return e.texel_x == 8 && e.texel_y == 8;
  });
  ASSERT_NE(at, map.entries.end());
  EXPECT_EQ(at->lines.size(), 1u);
  EXPECT_FALSE(at->vertex);
  EXPECT_EQ(at->nearest, 1000u);
}

TEST(ShadowUnit, EverySingleTexelOfTheMapIsReachable) {
  const Outcome out = run({{cover(100, 2)}, {}}, small_config(5));
  for (std::size_t i = 0; i < 25; ++i) {
    EXPECT_EQ(out.contents.depth[i], 100u) << i;
    EXPECT_EQ(out.contents.object[i], 2u) << i;
  }
  EXPECT_TRUE(out.contents.entries.empty());
}

TEST(ShadowUnit, AnOddMapHasItsOriginAtHalfRoundedDown) {
  UnitConfig config = small_config();
  config.map_width = 5;
  config.map_height = 3;
  // A small triangle within texel (0, 0) of light space.
  const Caster c = triangle({9, 9, 5}, {kTexel / 2, 9, 5}, {9, kTexel / 2, 5}, 0);
  const MapContents map = run({{c}, {}}, config).contents;
  ASSERT_EQ(map.entries.size(), 1u);
  EXPECT_EQ(map.entries[0].texel_x, 2u);
  EXPECT_EQ(map.entries[0].texel_y, 1u);
  EXPECT_TRUE(map.entries[0].vertex);
  EXPECT_EQ(map.entries[0].lines.size(), 3u);
}

}  // namespace
}  // namespace kagesen
