#include <gtest/gtest.h>

#include <random>

#include "Vmultiplier_test_dut.h"

namespace {

/// A product a cycle, each two cycles after its operands.
TEST(Multiplier, MatchesAndKeepsPace) {
  std::mt19937_64 random(1);
  Vmultiplier_test_dut dut;
  dut.clk_i = 0;
  dut.eval();
  std::int64_t expected[2] = {0, 0};
  for (int i = 0; i < 200000; ++i) {
    std::int64_t factor[2];
    for (auto& f : factor) {
      f = static_cast<std::int64_t>(random()) >> (35 + random() % 29);
      if (random() % 16 == 0) f = random() % 2 ? -(1 << 28) : (1 << 28) - 1;
    }
    dut.a_i = static_cast<std::uint32_t>(factor[0]) & ((1u << 29) - 1);
    dut.b_i = static_cast<std::uint32_t>(factor[1]) & ((1u << 29) - 1);
    dut.clk_i = 1;
    dut.eval();
    dut.clk_i = 0;
    dut.eval();
    const auto product = static_cast<std::int64_t>(dut.product_o << 6) >> 6;
    if (i >= 1) {
      ASSERT_EQ(product, expected[(i - 1) % 2]);
    }
    expected[i % 2] = factor[0] * factor[1];
  }
}

}  // namespace
