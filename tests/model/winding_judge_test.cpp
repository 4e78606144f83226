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

/// Level, of object 0, everything left of x = 1 texel; its contact distance is 68.
Caster level(std::uint32_t z) {
  return {{{kT, -100 * kT, z}, {kT, 100 * kT, z}, {-200 * kT, 0, z}}, 0, 0};
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
  Judgement judged() const {
    return judge(trace, config, FrameSetup{}, {paper, paper_verdicts},
                 {physical, physical_verdicts});
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
