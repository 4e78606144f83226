#include <gtest/gtest.h>

#include <random>

#include "Vtwo_pass_multiplier_test_dut.h"

namespace {

/// A product every other cycle, three cycles after its operands.
TEST(TwoPassMultiplier, MatchesAndKeepsPace) {
  std::mt19937_64 random(1);
  Vtwo_pass_multiplier_test_dut dut;
  dut.clk_i = 0;
  dut.eval();
  std::int64_t expected[2] = {0, 0};
  for (int i = 0; i < 200000; ++i) {
    // A product is there in the first of two cycles; the operands are taken in the second.
    if (i >= 2) {
      ASSERT_EQ(static_cast<std::int64_t>(dut.product_o << 6) >> 6, expected[i % 2]);
    }
    std::int64_t factor[2];
    for (auto& f : factor) {
      f = static_cast<std::int64_t>(random()) >> (35 + random() % 29);
      if (random() % 16 == 0) f = random() % 2 ? -(1 << 28) : (1 << 28) - 1;
    }
    expected[i % 2] = factor[0] * factor[1];
    for (const bool take : {false, true}) {
      dut.take_i = take;
      const std::int64_t noise = take ? 0 : 0x1555555;
      dut.a_i = static_cast<std::uint32_t>(factor[0] ^ noise) & ((1u << 29) - 1);
      dut.b_i = static_cast<std::uint32_t>(factor[1] ^ noise) & ((1u << 29) - 1);
      dut.clk_i = 1;
      dut.eval();
      dut.clk_i = 0;
      dut.eval();
    }
  }
}

}  // namespace
