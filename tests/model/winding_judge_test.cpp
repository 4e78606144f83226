// What the judge makes of the winding profile's verdicts: two runs, one contract, four causes.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "model/reference/beside_plain.h"
#include "model/reference/judge.h"
#include "model/rivals/plain_map.h"
#include "tests/model/fake_engine.h"

namespace kagesen {
namespace {

constexpr std::int32_t kT = 1 << 16;  // units a texel
constexpr Verdict kLit = Verdict::kLit, kDark = Verdict::kDark;

/// Level, of object 0, everything left of x = `right`; its contact distance is 68.
Caster level(std::uint32_t z, std::int32_t right = kT) {
  return {{{right, -100 * kT, z}, {right, 100 * kT, z}, {-200 * kT, 0, z}}, 0, 0};
}

Fragment fragment(std::int32_t x, std::uint32_t z, std::uint32_t object) {
  Fragment f;
  f.position = {x, 0, z};
  f.object = object;
  return f;
}

/// Eight by eight texels.
struct Frame {
  Trace trace;
  UnitConfig config;
  FakeEngine paper, physical;
  std::vector<Verdict> paper_verdicts, physical_verdicts;

  Frame(std::vector<Caster> casters, std::vector<Fragment> fragments, Verdict verdict) {
    config.profile = Profile::kWinding;
    config.map_width = config.map_height = 8;
    trace.header.objects.resize(2);
    trace.all_casters = std::move(casters);
    trace.all_fragments = std::move(fragments);
    paper_verdicts.assign(trace.all_fragments.size(), verdict);
    physical_verdicts = paper_verdicts;
  }
  Judgement judged(const JudgeOptions& options = {}) const {
    return judge(trace, config, FrameSetup{}, {paper, paper_verdicts},
                 {physical, physical_verdicts}, options);
  }
  /// The one fragment is wrong in both runs.
  void expect(Cause cause, std::uint64_t beyond) const {
    const Judgement j = judged();
    EXPECT_EQ(j.paper.wrong, 1u);
    EXPECT_STREQ(cause_name(j.cause_paper.at(0)), cause_name(cause));
    EXPECT_STREQ(cause_name(j.cause_physical.at(0)), cause_name(cause));
    EXPECT_EQ(j.paper.causes[static_cast<std::size_t>(cause)], 1u);
    EXPECT_EQ(j.paper.beyond_bound, beyond);
    EXPECT_EQ(j.physical.beyond_bound, beyond);
  }
};

// The object shadows itself only physically.
TEST(WindingJudge, EachRunIsHeldAgainstItsOwnSemantics) {
  Frame frame({level(100)}, {fragment(0, 900, 0)}, kLit);
  frame.physical_verdicts = {kDark};
  EXPECT_EQ(frame.judged().paper.wrong, 0u);
  EXPECT_EQ(frame.judged().physical.wrong, 0u);
  std::swap(frame.paper_verdicts, frame.physical_verdicts);
  EXPECT_EQ(frame.judged().paper.false_dark, 1u);
  EXPECT_EQ(frame.judged().paper.beyond_bound, 1u);
  EXPECT_EQ(frame.judged().physical.false_lit, 1u);
  EXPECT_EQ(frame.judged().physical.beyond_bound, 1u);
}

TEST(WindingJudge, WithinTheRadiusIsQuantisation) {
  Frame({level(100)}, {fragment(kT - 256, 900, 1)}, kLit).expect(Cause::kQuantisation, 0);
  Frame({level(100)}, {fragment(kT + 256, 900, 1)}, kDark).expect(Cause::kQuantisation, 0);
}

TEST(WindingJudge, BeyondTheRadiusTheContractIsBroken) {
  Frame({level(100)}, {fragment(kT - 258, 900, 1)}, kLit).expect(Cause::kOther, 1);
  Frame({level(100)}, {fragment(kT + 258, 900, 1)}, kDark).expect(Cause::kOther, 1);
}

TEST(WindingJudge, TheRadiusFollowsTheConfiguration) {
  Frame frame({level(100)}, {fragment(kT - 1024, 900, 1)}, kLit);
  frame.expect(Cause::kOther, 1);
  frame.config.fraction_bits = 6;
  frame.expect(Cause::kQuantisation, 0);
}

TEST(WindingJudge, ContactExcusesFalseLit) {
  Frame({level(100)}, {fragment(0, 168, 1)}, kLit).expect(Cause::kDepth, 0);
  Frame({level(100)}, {fragment(0, 169, 1)}, kLit).expect(Cause::kOther, 1);
}

TEST(WindingJudge, ContactNeverExcusesFalseDark) {
  Frame({level(100)}, {fragment(0, 100, 1)}, kDark).expect(Cause::kOther, 1);
}

TEST(WindingJudge, AnOverflowedTexelIsCapacity) {
  Frame frame({level(100)}, {fragment(0, 900, 1)}, kLit);
  const std::size_t texel = 4 * 8 + 4;
  frame.paper.map.overflowed[texel] = frame.physical.map.overflowed[texel] = 1;
  frame.expect(Cause::kCapacity, 1);
  frame.physical.map.overflowed[texel] = 0;
  const Judgement j = frame.judged();
  EXPECT_EQ(j.cause_paper[0], Cause::kCapacity);
  EXPECT_EQ(j.cause_physical[0], Cause::kOther);
}

TEST(WindingJudge, TheOtherProfileKeepsItsOwnContact) {
  Frame frame({level(100)}, {fragment(0, 104, 1)}, kLit);
  frame.config.profile = Profile::kPaper;
  EXPECT_EQ(frame.judged().paper.beyond_bound, 0u);
  frame.trace.all_fragments[0].position.z = 105;
  EXPECT_EQ(frame.judged().paper.beyond_bound, 1u);
}

// Fragments on the caster itself, lit: a plain map without a bias would shadow half of them.
TEST(WindingJudge, PlainMapsHaveTheRunsSemanticsAndABiasThatFits) {
  const Caster slope{
      {{-50 * kT, -50 * kT, 500'000}, {50 * kT, -50 * kT, 1'500'000}, {-50 * kT, 50 * kT, 500'000}},
      0,
      0};
  std::vector<Fragment> on_it;
  for (std::int32_t x = -3 * kT; x < 0; x += kT / 7) {
    const auto z = 500'000 + (std::int64_t{x} + 50 * kT) * 10'000 / kT;
    on_it.push_back(fragment(x, static_cast<std::uint32_t>(z), 0));
  }
  Frame frame({slope}, on_it, kLit);
  const Judgement physical = frame.judged();
  EXPECT_EQ(physical.physical.wrong, 0u);
  EXPECT_EQ(physical.plain_same_side.wrong, 0u);
  EXPECT_GT(physical.plain_same_side.bias, 3000u);
  EXPECT_LT(physical.plain_same_side.bias, 5001u);
  frame.config.semantics = Semantics::kPaper;
  EXPECT_EQ(frame.judged().plain_same_side.bias, 0u);
  EXPECT_EQ(frame.judged().plain_same_side.wrong, 0u);
}

/// Fragments of either object round the caster's right side; those of object 0 shadow themselves.
/// In paper semantics three are wrong, in physical semantics eight.
Frame along_an_edge() {
  constexpr std::int32_t kEdge = kT + kT / 3, kApart = 1500;
  std::vector<Fragment> fragments;
  for (std::int32_t i = -40; i < 40; ++i) {
    fragments.push_back(fragment(kEdge + i * kApart + 7, 900, static_cast<std::uint32_t>(i) & 1));
  }
  Frame frame({level(100, kEdge)}, fragments, kLit);
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const std::int32_t x = fragments[i].position.x - kEdge;
    if (x < 6 * kApart && fragments[i].object == 1) frame.paper_verdicts[i] = kDark;
    if (x < 8 * kApart) frame.physical_verdicts[i] = kDark;
  }
  return frame;
}

TEST(WindingJudge, TheOtherSemanticsHasItsOwnEquivalentSide) {
  Frame frame = along_an_edge();
  JudgeOptions both;
  both.other_equivalent_resolution = true;
  const Judgement physical = frame.judged(both);
  EXPECT_EQ(physical.paper.band_wrong, 3u);
  EXPECT_EQ(physical.physical.band_wrong, 8u);
  frame.config.semantics = Semantics::kPaper;
  const Judgement paper = frame.judged(both);
  EXPECT_NE(physical.equivalent_resolution.side, physical.other_equivalent_resolution.side);
  EXPECT_EQ(physical.equivalent_resolution.side, paper.other_equivalent_resolution.side);
  EXPECT_EQ(paper.equivalent_resolution.side, physical.other_equivalent_resolution.side);
  EXPECT_EQ(frame.judged().other_equivalent_resolution.side, 0u);
}

// What one judgement found exact serves the next, of other verdicts and another profile.
TEST(WindingJudge, AnExactFrameIsSharedWithoutADifference) {
  Frame frame = along_an_edge();
  JudgeOptions sharing;
  sharing.exact = std::make_shared<ExactFrame>();
  frame.judged(sharing);
  const ExactReference* reference = sharing.exact->reference.get();
  std::swap(frame.paper_verdicts, frame.physical_verdicts);
  for (const Profile profile : {Profile::kWinding, Profile::kPaper}) {
    frame.config.profile = profile;
    const Judgement alone = frame.judged(), shared = frame.judged(sharing);
    EXPECT_EQ(sharing.exact->reference.get(), reference);
    EXPECT_EQ(shared.exact_paper, alone.exact_paper);
    EXPECT_EQ(shared.exact_physical, alone.exact_physical);
    for (const Semantics semantics : {Semantics::kPaper, Semantics::kPhysical}) {
      const ErrorFigures &a = alone.figures_in(semantics), &b = shared.figures_in(semantics);
      EXPECT_GT(b.wrong, 0u);
      EXPECT_EQ(b.wrong, a.wrong);
      EXPECT_EQ(b.band, a.band);
      EXPECT_EQ(b.band_wrong, a.band_wrong);
      EXPECT_EQ(b.beyond_bound, a.beyond_bound);
      EXPECT_EQ(b.causes, a.causes);
    }
    EXPECT_EQ(shared.equivalent_resolution.side, alone.equivalent_resolution.side);
  }
}

RC_GTEST_PROP(WindingJudge, NoOtherBiasIsBetter, ()) {
  Frame frame({}, {}, kLit);
  const int casters = *rc::gen::inRange(0, 4), fragments = *rc::gen::inRange(0, 12);
  const auto depth = [] { return *rc::gen::inRange(0u, 30u); };
  for (int i = 0; i < casters; ++i) {
    const std::int32_t side = *rc::gen::inRange(-4, 4) * kT;
    frame.trace.all_casters.push_back(
        {{{side, -9 * kT, depth()}, {9 * kT, 9 * kT, depth()}, {-9 * kT, 9 * kT, depth()}}, 0, 0});
  }
  for (int i = 0; i < fragments; ++i) {
    frame.trace.all_fragments.push_back(fragment(*rc::gen::inRange(-4 * kT, 4 * kT), depth(), 0));
  }
  const ExactReference reference(frame.trace.all_casters);
  const FrameSetup setup;
  std::vector<std::uint8_t> exact;
  for (const Fragment& f : frame.trace.all_fragments)
    exact.push_back(reference.dark(f, Semantics::kPhysical));
  const std::vector<std::uint8_t> all(exact.size(), 1);
  const PlainFigures found =
      plain_map_figures({frame.trace, frame.config, setup, reference, Semantics::kPhysical,
                         frame.physical_verdicts, exact, all, all},
                        1);
  PlainMap map(8, 8, 8, 8, 16);
  for (const Caster& caster : frame.trace.all_casters) map.draw(caster);
  std::uint64_t least = exact.size();
  for (std::uint32_t bias = 0; bias < 32; ++bias) {
    std::uint64_t wrong = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const Verdict v = map.decide(frame.trace.all_fragments[i], Semantics::kPhysical, bias);
      wrong += (v == kDark) != (exact[i] != 0);
    }
    least = std::min(least, wrong);
  }
  RC_ASSERT(found.wrong == least);
}

}  // namespace
}  // namespace kagesen
