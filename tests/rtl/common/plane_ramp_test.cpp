#include <gtest/gtest.h>

#include <random>

#include "Vplane_ramp_test_dut.h"
#include "model/unit/fixed.h"

namespace {

using kagesen::unit::floor_div;
using kagesen::unit::Int128;

/// Walks at random over planes of any steepness: the ramp is the floor of the plane at every texel.
TEST(PlaneRamp, IsTheFloorOfThePlaneEverywhere) {
  std::mt19937_64 random(1);
  Vplane_ramp_test_dut dut;
  dut.clk_i = 0;
  dut.load_i = dut.move_i = dut.along_y_i = dut.back_i = 0;
  dut.eval();
  constexpr std::uint64_t kWhole = (std::uint64_t{1} << 60) - 1;
  for (int plane = 0; plane < 3000; ++plane) {
    const int steep = static_cast<int>(random() % 50);
    const auto base = static_cast<std::int64_t>((random() >> (8 + random() % 56)) | 1);
    const auto any = [&] {
      return random() % 8 == 0 ? base * static_cast<std::int64_t>(random() % 3)
                               : static_cast<std::int64_t>(random()) >> (10 + steep);
    };
    const std::int64_t step_x = any(), step_y = any(), start = any();
    const auto rest = [&](std::int64_t n) {
      return static_cast<std::uint64_t>(n - floor_div(n, base) * base);
    };
    const auto whole = [&](std::int64_t n) {
      return static_cast<std::uint64_t>(floor_div(n, base)) & kWhole;
    };
    dut.base_i = static_cast<std::uint64_t>(base);
    dut.x_whole_i = whole(step_x);
    dut.x_rest_i = rest(step_x);
    dut.y_whole_i = whole(step_y);
    dut.y_rest_i = rest(step_y);
    dut.whole_i = whole(start);
    dut.rest_i = rest(start);
    std::int64_t x = 0, y = 0;
    for (int step = 0; step < 60; ++step) {
      dut.load_i = step == 0 || random() % 16 == 0;
      if (dut.load_i) x = y = 0;
      const unsigned way = random() % 5;
      dut.back_i = random() % 2;
      dut.move_i = way != 0;
      dut.along_y_i = way == 3 || way == 4;
      if (dut.move_i) (dut.along_y_i ? y : x) += dut.back_i ? -1 : 1;
      dut.clk_i = 1;
      dut.eval();
      dut.clk_i = 0;
      dut.eval();
      const Int128 value = Int128{start} + Int128{step_x} * x + Int128{step_y} * y;
      const std::int64_t expected = floor_div(value, base);
      ASSERT_EQ(dut.whole_o, static_cast<std::uint64_t>(expected) & kWhole);
      ASSERT_EQ(dut.rest_o, static_cast<std::uint64_t>(value - Int128{expected} * base));
    }
  }
}

}  // namespace
