#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "Vfifo_test_dut.h"

namespace {

/// Random pushes and pops against std::deque; fails if a word is lost, doubled or out of order.
TEST(Fifo, KeepsOrderUnderRandomStalls) {
  for (int seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    Vfifo_test_dut dut;
    dut.clk_i = 0;
    dut.rst_ni = 0;
    dut.clear_i = 0;
    dut.eval();
    dut.rst_ni = 1;
    std::deque<std::uint8_t> expected;
    const unsigned push = 1 + random() % 10, pop = 1 + random() % 10;
    std::uint64_t popped = 0;
    for (int cycle = 0; cycle < 20000; ++cycle) {
      dut.valid_i = random() % 10 < push;
      dut.ready_i = random() % 10 < pop;
      dut.clear_i = random() % 1000 == 0;
      dut.data_i = static_cast<std::uint8_t>(random());
      dut.eval();
      ASSERT_LE(expected.size(), 5u);
      ASSERT_EQ(dut.empty_o != 0, expected.empty());
      if (dut.valid_o && dut.ready_i && !dut.clear_i) {
        ASSERT_FALSE(expected.empty());
        ASSERT_EQ(dut.data_o, expected.front());
        expected.pop_front();
        ++popped;
      }
      if (dut.valid_i && dut.ready_o) expected.push_back(dut.data_i);
      if (dut.clear_i) expected.clear();
      dut.clk_i = 1;
      dut.eval();
      dut.clk_i = 0;
      dut.eval();
    }
    EXPECT_GT(popped, 1000u);
  }
}

}  // namespace
