// Each cause from a frame that can only go wrong in that way, and the figures of an edge known by
// hand.
#include "model/reference/judge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/rivals/plain_map.h"

namespace kagesen {
namespace {

constexpr std::int32_t kT = 1 << 16;  // units a texel

std::int32_t texels(double t) { return static_cast<std::int32_t>(std::lround(t * kT)); }

LightPoint at(double x, double y, std::uint32_t z) { return {texels(x), texels(y), z}; }

Caster triangle(LightPoint a, LightPoint b, LightPoint c, std::uint32_t object) {
  static std::uint32_t polygon = 0;
  return {{a, b, c}, object, polygon++};
}

/// Everything left of a vertical line, within 50 texels, at one depth.
Caster left_of(double x, std::uint32_t z, std::uint32_t object) {
  return triangle(at(x, -50, z), at(x, 50, z), at(x - 100, 0, z), object);
}
Caster right_of(double x, std::uint32_t z, std::uint32_t object) {
  return triangle(at(x, -50, z), at(x, 50, z), at(x + 100, 0, z), object);
}

Fragment fragment(double x, double y, std::uint32_t z, std::uint32_t object) {
  Fragment f;
  f.position = at(x, y, z);
  f.object = object;
  return f;
}

struct Frame {
  Trace trace;
  UnitConfig config;
  std::vector<Verdict> verdicts;
  Judgement judgement;

  Frame(std::vector<Caster> casters, std::vector<Fragment> fragments, UnitConfig c = {},
        bool flip = false)
      : config(c) {
    trace.header.objects.resize(4);
    trace.all_casters = std::move(casters);
    trace.all_fragments = std::move(fragments);
    const auto engine = make_golden_engine();
    engine->begin(config, FrameSetup{});
    engine->draw(trace.all_casters.data(), trace.all_casters.size());
    verdicts.resize(trace.all_fragments.size());
    engine->decide(trace.all_fragments.data(), verdicts.size(), verdicts.data());
    if (flip) {
      for (Verdict& v : verdicts) v = v == Verdict::kDark ? Verdict::kLit : Verdict::kDark;
    }
    judgement = judge(trace, config, FrameSetup{}, {*engine, verdicts}, {*engine, verdicts});
  }
  std::uint64_t count(Cause cause) const {
    return judgement.paper.causes[static_cast<std::size_t>(cause)];
  }
  /// The one fragment is wrong, and this is why.
  void expect_only(Cause cause) const {
    EXPECT_EQ(judgement.paper.wrong, 1u);
    EXPECT_STREQ(cause_name(judgement.cause_paper.at(0)), cause_name(cause));
  }
};

UnitConfig with_bits(int bits) {
  UnitConfig config;
  config.fraction_bits = config.slope_bits = bits;
  return config;
}

/// Fragments all along a sloping edge, within a texel of it.
std::vector<Fragment> along_edge() {
  std::vector<Fragment> out;
  for (int i = -180; i <= 180; ++i) {
    for (int j = -8; j <= 8; ++j) {
      out.push_back(fragment(0.25 * i + 0.013, 0.0837 * i + 0.117 * j + 0.4, 900, 1));
    }
  }
  return out;
}
Caster above_edge() {
  return triangle(at(-60, -60 * 0.3348, 500), at(60, 60 * 0.3348, 500), at(-40, 70, 500), 0);
}

TEST(Judge, QuantisationMovesTheEdgeByItsFieldsBoundAtMost) {
  const Frame frame({above_edge()}, along_edge(), with_bits(3));
  const ErrorFigures& e = frame.judgement.paper;
  EXPECT_GT(e.wrong, 20u);
  EXPECT_EQ(frame.count(Cause::kQuantisation), e.wrong);
  EXPECT_GT(e.displacement_mean, 0);
  EXPECT_LE(e.displacement_max, 0.125);  // half a unit of Fraction and of Slope
  EXPECT_LE(e.displacement_mean, e.displacement_p99);
  EXPECT_EQ(e.wrong, e.false_lit + e.false_dark);
  EXPECT_EQ(e.band_wrong, e.wrong);
  EXPECT_EQ(e.beyond_bound, 0u);
}

TEST(Judge, FineFieldsMakeNoErrorThere) {
  const Frame frame({above_edge()}, along_edge(), with_bits(15));
  EXPECT_EQ(frame.judgement.paper.wrong, 0u);
  EXPECT_EQ(frame.judgement.paper.displacement_max, 0);
  EXPECT_GT(frame.judgement.paper.band, 1000u);
}

TEST(Judge, Capacity) {
  UnitConfig config;
  config.slb_entries = 1;
  const Frame frame({above_edge()}, along_edge(), config);
  EXPECT_GT(frame.judgement.paper.wrong, 100u);
  EXPECT_EQ(frame.count(Cause::kCapacity), frame.judgement.paper.wrong);
}

// Both cover the texel; the buffers keep only the nearer one, which is the fragment's own.
TEST(Judge, IdRule) {
  Frame({left_of(20, 100, 0), left_of(21, 200, 1)}, {fragment(0.5, 0.5, 300, 0)})
      .expect_only(Cause::kIdRule);
}

// The plane rises by 10,000 a texel: left of the centre it is nearer than the depth kept for the
// texel.
TEST(Judge, Depth) {
  const Caster steep =
      triangle(at(-50, -50, 100'000), at(50, -50, 1'100'000), at(-50, 50, 100'000), 0);
  Frame({steep}, {fragment(-9.9, -9.5, 501'500, 1)}).expect_only(Cause::kDepth);
}

// One object, two layers that overlap between their edges: together they cover all, AND says a
// strip.
TEST(Judge, Combination) {
  Frame({left_of(0.7, 100, 0), right_of(0.3, 200, 0)}, {fragment(0.1, 0.5, 900, 1)})
      .expect_only(Cause::kCombination);
}

// Nested layers of one object are joined: the nearer one's edge does not end the farther one.
TEST(Judge, NestedLayersMakeNoError) {
  EXPECT_EQ(Frame({left_of(0.3, 100, 0), left_of(0.7, 200, 0)}, {fragment(0.5, 0.5, 900, 1)})
                .judgement.paper.wrong,
            0u);
}

// A gap narrower than the rounding of Fraction closes.
TEST(Judge, Cancelling) {
  Frame({left_of(0.40, 100, 0), right_of(0.45, 100, 0)}, {fragment(0.42, 0.5, 900, 1)},
        with_bits(2))
      .expect_only(Cause::kCancelling);
}

// The edge is hidden from the light, but not from a fragment that its cover does not shadow.
TEST(Judge, HiddenRemoval) {
  Frame({left_of(20, 100, 0), left_of(0.5, 200, 1)}, {fragment(0.2, 0.5, 300, 0)})
      .expect_only(Cause::kHiddenRemoval);
  UnitConfig keep;
  keep.hidden_removal = HiddenRemoval::kOff;
  EXPECT_EQ(Frame({left_of(20, 100, 0), left_of(0.5, 200, 1)}, {fragment(0.2, 0.5, 300, 0)}, keep)
                .judgement.paper.wrong,
            0u);
}

TEST(Judge, AVerdictThatTheBuffersDoNotGiveHasNoKnownCause) {
  Frame({left_of(0.5, 100, 0)}, {fragment(5.5, 0.5, 900, 1)}, {}, /*flip=*/true)
      .expect_only(Cause::kOther);
}

TEST(Judge, AveragesNothingThatIsDecidedByDefinition) {
  std::vector<Fragment> all(4, fragment(0.5, 0.5, 900, 1));
  all[1].flags = Fragment::kAverted;
  all[2].flags = Fragment::kOutside;
  all[3].position.x = 600 * kT;  // off the map
  const Frame frame({left_of(20, 100, 0)}, all);
  EXPECT_EQ(frame.judgement.paper.judged, 1u);
  EXPECT_EQ(frame.judgement.paper.wrong, 0u);
  EXPECT_EQ(frame.judgement.exact_paper, (std::vector<std::uint8_t>{1, 1, 0, 0}));
}

TEST(Judge, AnObjectShadowsItselfOnlyPhysically) {
  const Frame frame({left_of(20, 100, 0)}, {fragment(0.5, 0.5, 900, 0)});
  EXPECT_EQ(frame.judgement.paper.wrong, 0u);
  EXPECT_EQ(frame.judgement.physical.wrong, 1u);
  EXPECT_EQ(frame.judgement.physical.false_lit, 1u);
  EXPECT_EQ(frame.judgement.cause_physical[0], Cause::kIdRule);
}

// The side that is reported errs no more, and one a third smaller errs more.
TEST(Judge, EquivalentResolutionIsTheSmallestMapAsGood) {
  const Frame frame({above_edge()}, along_edge(), with_bits(2));
  const EquivalentResolution& found = frame.judgement.equivalent_resolution;
  ASSERT_FALSE(found.at_least);
  ASSERT_GT(found.side, 1024u);
  const auto wrong = [&](std::uint64_t side) {
    const ExactReference reference(frame.trace.all_casters);
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < frame.trace.all_fragments.size(); ++i) {
      const Fragment& f = frame.trace.all_fragments[i];
      const Verdict v = plain_map_verdict(reference, f, Semantics::kPaper, side, 1024, 1024, 16);
      count += (v == Verdict::kDark) != (frame.judgement.exact_paper[i] != 0);
    }
    return count;
  };
  EXPECT_LE(wrong(found.side), frame.judgement.paper.wrong);
  EXPECT_GT(wrong(found.side * 2 / 3), frame.judgement.paper.wrong);
  EXPECT_EQ(frame.judgement.plain_same_side.wrong, wrong(1024));
}

}  // namespace
}  // namespace kagesen
