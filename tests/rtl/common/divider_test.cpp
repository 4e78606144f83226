#include <gtest/gtest.h>

#include <random>

#include "Vdivider_short_dut.h"
#include "Vdivider_test_dut.h"
#include "model/unit/fixed.h"

namespace {

using kagesen::unit::floor_div;
using kagesen::unit::Int128;

/// Sends numbers through the divider and waits for their results.
template <typename Dut>
class Bench {
 public:
  Bench() {
    dut.clk_i = 0;
    dut.clear_i = 0;
    dut.valid_i = 0;
    dut.ready_i = 0;
    dut.rst_ni = 1;
    dut.eval();
    dut.rst_ni = 0;
    dut.eval();
    dut.rst_ni = 1;
  }
  void cycle() {
    dut.clk_i = 1;
    dut.eval();
    dut.clk_i = 0;
    dut.eval();
  }
  /// Expects the floor of the quotient and the remainder; the result waits `stall` cycles.
  void divide(std::int64_t numerator, std::int64_t divisor, int numerator_bits, int quotient_bits,
              int stall) {
    dut.numerator_i =
        static_cast<std::uint64_t>(numerator) & ((std::uint64_t{1} << numerator_bits) - 1);
    dut.divisor_i = static_cast<std::uint64_t>(divisor);
    dut.valid_i = 1;
    dut.eval();
    ASSERT_TRUE(dut.ready_o);
    cycle();
    dut.valid_i = 0;
    int cycles = 1;
    for (; !dut.valid_o; ++cycles) {
      ASSERT_LT(cycles, 1 + quotient_bits / 2 + 1);
      ASSERT_FALSE(dut.ready_o);
      cycle();
    }
    for (; stall > 0; --stall) cycle();
    const std::int64_t quotient = floor_div(numerator, divisor);
    ASSERT_TRUE(dut.valid_o);
    ASSERT_EQ(static_cast<std::uint64_t>(dut.quotient_o),
              static_cast<std::uint64_t>(quotient) & ((std::uint64_t{1} << quotient_bits) - 1))
        << numerator << " / " << divisor;
    ASSERT_EQ(static_cast<std::int64_t>(dut.remainder_o), numerator - quotient * divisor)
        << numerator << " / " << divisor;
    dut.ready_i = 1;
    cycle();
    dut.ready_i = 0;
    ASSERT_FALSE(dut.valid_o);
    total_cycles += cycles;
  }
  Dut dut;
  std::int64_t total_cycles = 0;
};

/// Random magnitudes of any length, and the numbers around multiples of the divisor.
template <typename Dut>
void divide_random(int numerator_bits, int divisor_bits, int quotient_bits) {
  std::mt19937_64 random(1);
  Bench<Dut> bench;
  const std::int64_t limit = std::int64_t{1} << (numerator_bits - 1);
  const Int128 quotient_limit = Int128{1} << (quotient_bits - 1);
  int done = 0;
  for (int i = 0; i < 60000; ++i) {
    const auto divisor =
        static_cast<std::int64_t>(random() >> (64 - divisor_bits + random() % divisor_bits)) |
        (i % 7 == 0);
    if (divisor == 0) continue;
    auto numerator = static_cast<std::int64_t>(random()) >>
                     (64 - numerator_bits + static_cast<int>(random() % numerator_bits));
    if (i % 3 == 0) numerator = numerator / divisor * divisor + static_cast<int>(random() % 3) - 1;
    if (i % 50 == 0) numerator = i % 100 == 0 ? limit - 1 : -limit;
    if (numerator < -limit || numerator >= limit) continue;
    const std::int64_t quotient = floor_div(numerator, divisor);
    if (quotient >= quotient_limit || quotient < -quotient_limit) continue;
    bench.divide(numerator, divisor, numerator_bits, quotient_bits, static_cast<int>(random() % 3));
    if (testing::Test::HasFatalFailure()) return;
    ++done;
  }
  EXPECT_GT(done, 20000);
}

TEST(Divider, SkippingMatchesFloorDiv) { divide_random<Vdivider_test_dut>(63, 56, 63); }
TEST(Divider, ShortQuotientMatchesFloorDiv) { divide_random<Vdivider_short_dut>(55, 28, 29); }

/// Divisors and rests of full length, quotients of any: what the topmost bits of rest and divisor
/// do.
TEST(Divider, DividesByTheLongestDivisors) {
  std::mt19937_64 random(3);
  Bench<Vdivider_test_dut> bench;
  for (int i = 0; i < 4000; ++i) {
    std::int64_t divisor = static_cast<std::int64_t>(random() >> 8) | std::int64_t{1} << 55;
    if (i % 4 == 0) divisor >>= random() % 8;
    const auto quotient = static_cast<std::int64_t>(random() >> (58 + random() % 6));
    // A rest of any length, or one below the divisor.
    const std::int64_t rest =
        i % 5 == 0 ? divisor - 1
                   : static_cast<std::int64_t>(random() >> (8 + random() % 56)) % divisor;
    if (quotient > ((std::int64_t{1} << 61) - rest) / divisor) continue;
    const std::int64_t numerator = quotient * divisor + rest;
    bench.divide(i % 2 == 0 ? numerator : -numerator, divisor, 63, 63, 0);
    if (testing::Test::HasFatalFailure()) return;
  }
}

/// A skip would lose the one high bit of the rest, whichever it is.
TEST(Divider, SkipsOnlyOverZeros) {
  std::mt19937_64 random(5);
  Bench<Vdivider_test_dut> bench;
  for (int i = 0; i < 800; ++i) {
    const std::int64_t rest =
        std::int64_t{1} << (48 + i % 8) | static_cast<std::int64_t>(random() % 4096);
    const int below = 6 + 2 * static_cast<int>(random() % 3);
    if (rest >= std::int64_t{1} << (62 - below)) continue;
    const std::int64_t divisor = rest + 1 + static_cast<std::int64_t>(random() % 1000);
    const std::int64_t numerator =
        rest << below | static_cast<std::int64_t>(random() % (1u << below));
    bench.divide(i % 3 == 0 ? -numerator : numerator, divisor, 63, 63, 0);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(Divider, SkipsLeadingZerosOfTheQuotient) {
  Bench<Vdivider_test_dut> bench;
  bench.divide((std::int64_t{1} << 55) + 12345, std::int64_t{1} << 50, 63, 63, 0);
  EXPECT_LE(bench.total_cycles, 1 + 7 + 4);
}

TEST(Divider, ClearDropsADivision) {
  Bench<Vdivider_test_dut> bench;
  bench.dut.numerator_i = 1000;
  bench.dut.divisor_i = 7;
  bench.dut.valid_i = 1;
  bench.cycle();
  bench.dut.valid_i = 0;
  bench.dut.clear_i = 1;
  bench.cycle();
  bench.dut.clear_i = 0;
  bench.dut.eval();
  EXPECT_TRUE(bench.dut.ready_o);
  EXPECT_FALSE(bench.dut.valid_o);
  bench.divide(-1000, 7, 63, 63, 0);
}

}  // namespace
