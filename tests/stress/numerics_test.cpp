// The measurement of numbers: every bound holds, and one that does not is seen.
#include <gtest/gtest.h>

#include "tests/stress/numerics/page.h"

namespace kagesen::stress {
namespace {

constexpr std::uint64_t kSamples = 1500;

TEST(Numerics, EveryQuantityKeepsItsBound) {
  for (const Quantity& q : all_quantities()) {
    const Worst worst = find_worst(q, 11, kSamples);
    EXPECT_EQ(worst.exceeded, 0u) << q.profile << " " << q.name << ": " << worst.value;
    EXPECT_GT(worst.samples, kSamples / 50) << q.profile << " " << q.name;
  }
}

TEST(Numerics, TheWorstInputGivesTheWorstValueAgain) {
  for (const Quantity& q : all_quantities()) {
    const Worst worst = find_worst(q, 12, 500);
    if (worst.inputs.empty()) continue;
    EXPECT_EQ(worst.inputs.size(), q.inputs.size()) << q.name;
    EXPECT_EQ(*q.measure(worst.inputs), worst.value) << q.name;
  }
}

TEST(Numerics, ComesNearTheBound) {
  for (const Quantity& q : all_quantities()) {
    if (q.limit == 0) continue;
    EXPECT_GT(find_worst(q, 13, kSamples).value, q.limit * Exact(1, 2)) << q.profile << q.name;
  }
}

TEST(Numerics, ABoundThatIsTooTightIsSeen) {
  for (Quantity q : all_quantities()) {
    q.limit = q.limit == 0 ? Exact(-1000) : Exact(q.limit * Exact(1, 2));
    const Worst worst = find_worst(q, 14, kSamples);
    EXPECT_GT(worst.exceeded, 0u) << q.profile << " " << q.name;
    const std::string page = numerics_page({{q, worst}}, "command");
    EXPECT_NE(page.find("**"), std::string::npos) << q.name;
  }
}

TEST(Numerics, SignedBits) {
  EXPECT_EQ(signed_bits(Exact(0)), 1);
  EXPECT_EQ(signed_bits(Exact(-1)), 1);
  EXPECT_EQ(signed_bits(Exact(1)), 2);
  EXPECT_EQ(signed_bits(Exact(127)), 8);
  EXPECT_EQ(signed_bits(Exact(128)), 9);
  EXPECT_EQ(signed_bits(Exact(-128)), 8);
}

}  // namespace
}  // namespace kagesen::stress
