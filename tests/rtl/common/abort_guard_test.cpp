#include <gtest/gtest.h>

#include <random>

#include "Vabort_guard_test_dut.h"

namespace {

/// Masters that keep valid up until they are taken, as they must. Outside, valid may never fall
/// without a handshake; once closed, nothing is offered.
TEST(AbortGuard, NeverTakesAnOfferBack) {
  for (int seed = 1; seed <= 50; ++seed) {
    std::mt19937 random(seed);
    Vabort_guard_test_dut dut;
    dut.clk_i = dut.rst_ni = dut.close_i = dut.valid_i = dut.ready_i = 0;
    dut.eval();
    dut.rst_ni = 1;
    unsigned valid = 0, offered = 0;  // of three channels
    int closings = 0;
    for (int cycle = 0; cycle < 3000; ++cycle) {
      valid |= random() & 7;
      dut.valid_i = valid;
      dut.ready_i = random() & 7;
      if (dut.close_i ? dut.closed_o && random() % 4 == 0 : random() % 20 == 0) {
        dut.close_i = !dut.close_i;
        closings += dut.close_i;
      }
      dut.eval();
      ASSERT_EQ(dut.valid_o & offered, offered) << "an offer was taken back";
      ASSERT_EQ(dut.ready_o & ~unsigned{dut.ready_i} & 7, 0u);
      if (dut.closed_o) {
        ASSERT_EQ(dut.valid_o, 0);
        ASSERT_EQ(dut.ready_o, 0);
      }
      const unsigned moved_inside = valid & dut.ready_o, moved_outside = dut.valid_o & dut.ready_i;
      ASSERT_EQ(moved_inside, moved_outside);
      offered = dut.valid_o & ~dut.ready_i & 7;
      valid &= ~moved_inside;
      if (dut.closed_o) valid = 0;  // what an abort drops
      dut.clk_i = 1;
      dut.eval();
      dut.clk_i = 0;
      dut.eval();
    }
    EXPECT_GT(closings, 10);
  }
}

}  // namespace
