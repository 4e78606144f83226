#include <gtest/gtest.h>

#include <random>

#include "Vplane_divider_test_dut.h"
#include "model/unit/fixed.h"

namespace {

/// Numerators of every even number of bits, quotients with and without zeros to skip.
TEST(PlaneDivider, MatchesFloorDiv) {
  std::mt19937_64 random(1);
  Vplane_divider_test_dut dut;
  const auto cycle = [&] {
    dut.clk_i = 1;
    dut.eval();
    dut.clk_i = 0;
    dut.eval();
  };
  dut.clk_i = dut.clear_i = dut.valid_i = dut.ready_i = 0;
  dut.rst_ni = 0;
  dut.eval();
  dut.rst_ni = 1;
  for (int i = 0; i < 100000; ++i) {
    const unsigned pairs = 1 + random() % 25;
    const std::uint64_t numerator = (random() >> (64 - 2 * pairs)) >> random() % (2 * pairs);
    const std::uint64_t divisor = 1 + ((random() >> 36) >> random() % 28) % ((1u << 28) - 1);
    dut.numerator_i = numerator << (50 - 2 * pairs);
    dut.pairs_i = static_cast<std::uint8_t>(pairs);
    dut.divisor_i = static_cast<std::uint32_t>(divisor);
    dut.valid_i = 1;
    dut.eval();
    ASSERT_TRUE(dut.ready_o);
    cycle();
    dut.valid_i = 0;
    unsigned cycles = 1;
    for (; !dut.valid_o; ++cycles) {
      ASSERT_LE(cycles, pairs);
      ASSERT_FALSE(dut.ready_o);
      cycle();
    }
    for (auto stall = random() % 3; stall > 0; --stall) cycle();
    const std::int64_t quotient = kagesen::unit::floor_div(static_cast<std::int64_t>(numerator),
                                                           static_cast<std::int64_t>(divisor));
    ASSERT_TRUE(dut.valid_o);
    ASSERT_EQ(dut.quotient_o, static_cast<std::uint64_t>(quotient));
    ASSERT_EQ(dut.remainder_o, numerator - static_cast<std::uint64_t>(quotient) * divisor);
    dut.ready_i = 1;
    cycle();
    dut.ready_i = 0;
  }
}

}  // namespace
