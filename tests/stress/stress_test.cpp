// The suite itself: it finds what is wrong with a unit, makes it small, and lets good units pass.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "tests/stress/flawed_engine.h"
#include "tests/stress/state_file.h"
#include "tests/stress/transforms.h"
#include "traces/format/error.h"
#include "traces/format/trace_file.h"

namespace kagesen::stress {
namespace {

EngineFactory engine_with(Flaw flaw) {
  return [flaw] { return std::make_unique<FlawedEngine>(flaw); };
}

SuiteOptions options_for(Flaw flaw, std::uint64_t cases) {
  SuiteOptions options;
  options.make_engine = engine_with(flaw);
  options.cases.profile = Profile::kWinding;
  options.case_limit = cases;
  options.shrinking = {2, 1000};
  options.shrink_per_kind = 1;
  return options;
}

State run(const SuiteOptions& options, std::uint64_t seed = 7) {
  State state;
  state.seed = seed;
  run_suite(options, state);
  return state;
}

std::set<std::string> failed_checks(const State& state) {
  std::set<std::string> names;
  for (const Failure& f : state.failures) names.insert(f.check);
  return names;
}

bool same_point(const LightPoint& a, const LightPoint& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
bool same(const Trace& a, const Trace& b) {
  const auto same_caster = [](const Caster& p, const Caster& q) {
    return std::equal(p.vertex, p.vertex + 3, q.vertex, same_point) && p.object == q.object;
  };
  const auto same_fragment = [](const Fragment& p, const Fragment& q) {
    return same_point(p.position, q.position) && p.object == q.object && p.flags == q.flags;
  };
  return std::equal(a.all_casters.begin(), a.all_casters.end(), b.all_casters.begin(),
                    b.all_casters.end(), same_caster) &&
         std::equal(a.all_fragments.begin(), a.all_fragments.end(), b.all_fragments.begin(),
                    b.all_fragments.end(), same_fragment);
}

TEST(StressCase, IsAFunctionOfSeedAndNumber) {
  for (std::uint64_t n = 0; n < 2 * families().size(); ++n) {
    const StressCase a = make_case(3, n, {}), b = make_case(3, n, {});
    EXPECT_TRUE(same(a.trace, b.trace)) << a.family->name;
    ASSERT_EQ(a.plan.size(), b.plan.size());
    for (std::size_t i = 0; i < a.plan.size(); ++i) EXPECT_EQ(a.plan[i].seed, b.plan[i].seed);
    EXPECT_FALSE(same(a.trace, make_case(4, n, {}).trace)) << a.family->name;
  }
}

TEST(StressCase, IsATraceThatAFileMayHold) {
  for (std::uint64_t n = 0; n < 6 * families().size(); ++n) {
    const Trace trace = make_case(5, n, {}).trace;
    EXPECT_NO_THROW({
      check_header(trace.header, "header");
      for (const Caster& c : trace.all_casters) check_caster(c, trace.header, "caster");
      for (const Fragment& f : trace.all_fragments) check_fragment(f, trace.header, "fragment");
    });
    EXPECT_GT(trace.all_casters.size(), 0u) << n;
  }
}

TEST(StressCase, HasDarkAndLitFragmentsInEveryFamily) {
  for (std::uint64_t n = 0; n < families().size(); ++n) {
    std::size_t dark = 0, all = 0;
    for (std::uint64_t round = 0; round < 8; ++round) {
      const StressCase test = make_case(6, n + round * families().size(), {});
      const Subject subject(test.trace);
      for (const std::uint8_t d : subject.exact(Semantics::kPhysical)) dark += d;
      all += test.trace.all_fragments.size();
    }
    EXPECT_GT(dark, all / 50) << family_of(n).name;
    EXPECT_LT(dark, all - all / 50) << family_of(n).name;
  }
}

TEST(StressSuite, PassesAnExactUnit) {
  const State state = run(options_for(Flaw::kNone, families().size()));
  EXPECT_EQ(state.total().violations, 0u);
  EXPECT_EQ(state.total().cases, families().size());
  EXPECT_GT(state.total().judged, 20'000u);
  EXPECT_GT(state.total().compared, 20'000u);
}

TEST(StressSuite, PassesAUnitThatErrsWithinTheBound) {
  SuiteOptions options = options_for(Flaw::kHalfRadius, 2 * families().size());
  const State state = run(options);
  // Reversed axes and borders of the map do not: only the contract is for such a unit.
  for (const Failure& f : state.failures) EXPECT_NE(f.check, "contract") << f.family;
}

struct Expected {
  Flaw flaw;
  const char* check;
};
class FindsTheFlaw : public ::testing::TestWithParam<Expected> {};

TEST_P(FindsTheFlaw, AndMakesItSmall) {
  SuiteOptions options = options_for(GetParam().flaw, 2 * families().size());
  std::map<std::string, Trace> written;
  options.write_trace = [&](const Trace& trace, const std::string& name) {
    written[name] = trace;
    return name;
  };
  const State state = run(options);
  EXPECT_EQ(failed_checks(state).count(GetParam().check), 1u);
  const Failure* least = nullptr;
  for (const Failure& f : state.failures) {
    if (f.check == GetParam().check && (!least || f.size() < least->size())) least = &f;
  }
  ASSERT_NE(least, nullptr);
  // A flaw that depends on portions needs more than one portion.
  if (GetParam().flaw != Flaw::kFirstPortion) {
    EXPECT_EQ(least->fragments, 1u);
  }
  EXPECT_LE(least->casters, 3u);
  ASSERT_EQ(written.count(least->file), 1u);
  EXPECT_EQ(written[least->file].all_casters.size(), least->casters);
  ASSERT_FALSE(least->replay.empty());
  EXPECT_EQ(least->replay[0].rfind("kagesen run " + least->file, 0), 0u) << least->replay[0];
}

INSTANTIATE_TEST_SUITE_P(StressSuite, FindsTheFlaw,
                         ::testing::Values(Expected{Flaw::kThreeRadii, "contract"},
                                           Expected{Flaw::kForgetsLast, "order"},
                                           Expected{Flaw::kSkipLies, "skips"},
                                           Expected{Flaw::kFirstPortion, "portions"},
                                           Expected{Flaw::kCellBound, "translation"},
                                           Expected{Flaw::kCellBound, "turn"},
                                           Expected{Flaw::kForgetsLast, "refinement"},
                                           Expected{Flaw::kCountsCasters, "hidden"}));

TEST(StressSuite, GoesOnWhereItWasStopped) {
  SuiteOptions options = options_for(Flaw::kThreeRadii, 20);
  options.shrink_per_kind = 0;
  const State whole = run(options);
  options.case_limit = 9;
  State parts = run(options);
  const std::string path =
      (std::filesystem::temp_directory_path() / "kagesen-stress-state.json").string();
  write_state(parts, path);
  State read = read_state(path);
  std::filesystem::remove(path);
  options.case_limit = 11;
  run_suite(options, read);
  EXPECT_EQ(read.next_case, whole.next_case);
  read.seconds = whole.seconds;
  EXPECT_EQ(state_json(read), state_json(whole));
}

TEST(StressSuite, RunsOneFamilyAlone) {
  SuiteOptions options = options_for(Flaw::kNone, 3);
  options.family = "fan";
  const State state = run(options);
  ASSERT_EQ(state.families.size(), 1u);
  EXPECT_EQ(state.families.at("fan").cases, 3u);
}

TEST(StressSuite, StateFileThatIsNoneIsRefused) {
  EXPECT_THROW(read_state("/nonexistent/state.json"), UserError);
}

TEST(Transforms, TurnIsUndoneByTurns) {
  const Trace trace = make_case(9, 2, {}).trace;
  Dice dice(1);
  const std::uint64_t before = trace.all_casters.size();
  Trace turned = trace;
  ASSERT_TRUE(turn(turned, dice));
  EXPECT_FALSE(same(turned, trace));
  EXPECT_EQ(turned.all_casters.size(), before);
}

TEST(Transforms, FacetsGoWithTheirCasters) {
  Trace trace;
  trace.header.objects.resize(2);
  trace.all_casters = {{{{0, 0, 1}, {9, 0, 1}, {0, 9, 1}}, 1, 0},
                       {{{50, 0, 1}, {90, 0, 1}, {50, 90, 1}}, 1, 1}};
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    FrameSetup setup;
    setup.facets = {{0, 1}, {1, 4}};  // edge 0 of the first, edge 2 of the second
    Dice dice(seed);
    const Trace out = shuffled(trace, dice, &setup);
    for (std::size_t i = 0; i < 2; ++i) {
      const Caster& c = out.all_casters[i];
      const Facet& facet = setup.facets[i];
      ASSERT_EQ(facet.plane, c.polygon);
      for (int e = 0; e < 3; ++e) {
        const LightPoint &a = c.vertex[e], &b = c.vertex[(e + 1) % 3];
        const bool marked = c.polygon == 0 ? a.y == 0 && b.y == 0 : a.x == 50 && b.x == 50;
        EXPECT_EQ((facet.inner_edges >> e & 1) != 0, marked);
      }
    }
  }
}

}  // namespace
}  // namespace kagesen::stress
