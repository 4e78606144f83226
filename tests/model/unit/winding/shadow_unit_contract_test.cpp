// The contract, against the exact reference: no wrong fragment is farther than 2^-F texel from an
// exact shadow boundary and clear of contact.
#include <gtest/gtest.h>

#include <array>

#include "model/facets.h"
#include "model/reference/reference.h"
#include "tests/model/unit/winding/soups.h"

namespace kagesen {
namespace {

/// |dz/dx| + |dz/dy| a texel.
double steepness(double gx, double gy, double texel) {
  return (std::abs(gx) + std::abs(gy)) * texel;
}

/// B of docs/unit.md: how much farther than a caster its threshold may lie.
double documented_bias(const Caster& c, const UnitConfig& config, int texel_bits) {
  const double texel = std::ldexp(1, texel_bits), r = std::ldexp(1, -int(config.fraction_bits));
  const auto m =
      std::min<std::int64_t>(10, std::max(config.gradient_bits, config.fraction_bits - 1));
  // The outline's two steps and the place's one: with two guard bits or more, less than r.
  const int end_bits = std::min(int(config.fraction_bits + config.end_guard_bits), texel_bits);
  const double slack = std::max(r, std::ldexp(3, -end_bits)) + std::ldexp(1, -int(m) - 1);
  const double fixed =
      2.0 * double(config.plane_tolerance) + std::ldexp(2, int(config.plane_step_bits)) + 8;
  const auto squared = [&](int i) {
    const LightPoint &a = c.vertex[i], &b = c.vertex[(i + 1) % 3];
    const double x = double(b.x) - a.x, y = double(b.y) - a.y;
    return x * x + y * y;
  };
  int longest = 0;
  for (int i = 1; i < 3; ++i) {
    if (squared(i) > squared(longest)) longest = i;
  }
  if (16 * squared(longest) <= texel * r * texel * r) {
    return fixed + farthest_depth(c) - nearest_depth(c);
  }
  const LightPoint *v = c.vertex, &a = v[longest], &b = v[(longest + 1) % 3];
  const LightPoint& third = v[(longest + 2) % 3];
  const double ex = double(b.x) - a.x, ey = double(b.y) - a.y, ez = double(b.z) - a.z;
  const double fx = double(third.x) - a.x, fy = double(third.y) - a.y, fz = double(third.z) - a.z;
  if (is_narrow(c, std::uint32_t(texel_bits), int(config.fraction_bits))) {
    const double off = fz - ez * (ex * fx + ey * fy) / squared(longest);
    return fixed + std::abs(off) +
           steepness(ez * ex / squared(longest), ez * ey / squared(longest), texel) * slack;
  }
  const double area = ex * fy - ey * fx;
  return fixed + steepness((ez * fy - fz * ey) / area, (ex * fz - fx * ez) / area, texel) * slack;
}

bool clear_of_contact(const Trace& trace, const Fragment& f, const UnitConfig& config) {
  for (const Caster& c : trace.all_casters) {
    if (config.semantics == Semantics::kPaper && c.object == f.object) continue;
    const Weights w = weights_at(c, f.position.x, f.position.y);
    if (w.inside() &&
        plane_depth(c, w) + documented_bias(c, config, int(trace.header.fraction_bits)) <
            double(f.position.z)) {
      return true;
    }
  }
  return false;
}

struct Tally {
  std::uint64_t dark = 0, lit = 0, wrong = 0;
};

void expect_contract(const Trace& trace, const UnitConfig& config, Tally& tally,
                     const std::string& where) {
  const Outcome got = run_winding(trace, config);
  ASSERT_EQ(got.counters.overflow_texels, 0u);
  const ExactReference reference(trace.all_casters);
  const double radius = std::ldexp(1, int(trace.header.fraction_bits) - int(config.fraction_bits));
  for (std::size_t i = 0; i < trace.all_fragments.size(); ++i) {
    const Fragment& f = trace.all_fragments[i];
    const bool exact = reference.dark(f, config.semantics);
    ++(exact ? tally.dark : tally.lit);
    if (exact == (got.verdicts[i] == Verdict::kDark)) continue;
    ++tally.wrong;
    if (exact && !clear_of_contact(trace, f, config)) continue;
    // The reference knows distances to a unit.
    const double distance =
        reference.boundary_distance(f.position, f.object, config.semantics, 2 * radius + 2);
    ASSERT_LE(distance, radius + 1)
        << where << ": fragment " << i << " of object " << f.object << " at " << f.position.x << ','
        << f.position.y << ',' << f.position.z << " is false-" << (exact ? "lit" : "dark");
  }
}

class WindingContract : public testing::TestWithParam<int> {};

TEST_P(WindingContract, HoldsForAnySoup) {
  const int texel_bits = GetParam();
  Tally tally;
  const std::array fractions{8, 4, 10, 12, 14, 6, 15, 2};
  for (unsigned seed = 0; seed < 144; ++seed) {
    const int fraction_bits = fractions[seed / 4 % 8];
    const RandomTrace random(kScenes[seed % 4], texel_bits, fraction_bits,
                             10'000 * unsigned(texel_bits) + seed, 600);
    for (const Semantics semantics : {Semantics::kPaper, Semantics::kPhysical}) {
      UnitConfig config = random.fit(winding_config(semantics, fraction_bits));
      if (seed % 5 == 1) config.plane_tolerance = 200;
      if (seed % 5 == 2) config.plane_step_bits = 0;
      if (seed % 7 == 3) config.end_guard_bits = 1;
      if (seed % 7 == 4) config.gradient_bits = 3;
      expect_contract(random.trace, config, tally,
                      "seed " + std::to_string(seed) + ", F " + std::to_string(fraction_bits) +
                          (semantics == Semantics::kPaper ? ", paper" : ", physical"));
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(tally.dark, 5000u);
  EXPECT_GT(tally.lit, 5000u);
  EXPECT_GT(tally.wrong, 100u) << "fragments do not come near to boundaries";
}

INSTANTIATE_TEST_SUITE_P(Scales, WindingContract, testing::Range(16, 27));

}  // namespace
}  // namespace kagesen
