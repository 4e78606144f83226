#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

#include "Vcorner_functions_test_dut.h"
#include "model/unit/span_filler.h"

namespace kagesen {
namespace {

using Wide = __int128;

/// Puts `bits` bits of `value` at bit `at` of a port wider than 64 bits.
template <typename Port>
void put(Port& port, int at, int bits, std::int64_t value) {
  for (int i = 0; i < bits; ++i) {
    const int bit = at + i;
    const std::uint32_t mask = 1u << (bit % 32);
    port[bit / 32] = (value >> i & 1) != 0 ? port[bit / 32] | mask : port[bit / 32] & ~mask;
  }
}

class Walk {
 public:
  Walk(const Caster& c, int bits, std::int32_t x, std::int32_t y) {
    Wide area = 0;
    std::uint32_t inexact = 0;
    for (int i = 0; i < 3; ++i) {
      const LightPoint &a = c.vertex[i], &b = c.vertex[(i + 1) % 3], &o = c.vertex[(i + 2) % 3];
      const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
      area = Wide{dx} * (std::int64_t{o.y} - a.y) - Wide{dy} * (std::int64_t{o.x} - a.x);
      const auto value = static_cast<std::int64_t>(Wide{dx} * ((std::int64_t{y} << bits) - a.y) -
                                                   Wide{dy} * ((std::int64_t{x} << bits) - a.x));
      put(dut_.start_i, 42 * i, 42, value >> bits);
      inexact |= std::uint32_t((value & ((std::int64_t{1} << bits) - 1)) != 0) << i;
      put(dut_.dx_i, 29 * i, 29, dx);
      put(dut_.dy_i, 29 * i, 29, dy);
    }
    dut_.inexact_i = inexact;
    dut_.clockwise_i = area < 0;
    move(true, 0, 0);
  }
  void move(bool restart, int dx, int dy) {
    dut_.restart_i = restart;
    dut_.move_x_i = dx != 0;
    dut_.back_i = dx < 0;
    dut_.move_y_i = dy != 0;
    dut_.clk_i = 0;
    dut_.eval();
    dut_.clk_i = 1;
    dut_.eval();
  }
  bool inside() const { return dut_.inside_o != 0; }

 private:
  Vcorner_functions_test_dut dut_;
};

/// Corners on the edges and a few units beside them: vertices on corners or 2^k units from one,
/// edges along the rows and columns. Fails if a function is wrong where it is 0 or nearly so.
TEST(CornerFunctions, TellTheEdgesApartToTheUnit) {
  std::mt19937_64 random(2);
  const auto in = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  constexpr int kBits = 16;
  int covered = 0;
  for (int round = 0; round < 3000; ++round) {
    Caster c;
    for (LightPoint& p : c.vertex) {
      p.x = 2 * in(-2, 2) << kBits;
      p.y = 2 * in(-2, 2) << kBits;
      const int off = in(0, 2) == 0 ? (in(0, 1) ? 1 : -1) << in(0, 8) : 0;
      (in(0, 1) ? p.x : p.y) += off;
    }
    const unit::Polygon polygon(c, kBits);
    if (polygon.degenerate()) continue;
    const int start_x = in(-4, 4), start_y = in(-4, 0);
    int x = start_x, y = start_y;
    Walk walk(c, kBits, x, y);
    for (int step = 0; step < 30; ++step) {
      ASSERT_EQ(walk.inside(), polygon.covers_corner(x, y))
          << "round " << round << " step " << step;
      covered += walk.inside();
      const bool restart = y == 4 || in(0, 19) == 0;
      if (restart) x = start_x, y = start_y;
      const int dx = in(x == -4 ? 0 : -1, x == 4 ? 0 : 1), dy = in(0, 3) == 0;
      x += dx;
      y += dy;
      walk.move(restart, dx, dy);
    }
  }
  EXPECT_GT(covered, 3000);
}

/// Walks at random over triangles of every size, some with vertices and edges on corners; fails if
/// a step is wrong, if an exact tie goes to the wrong side, or if the winding matters.
TEST(CornerFunctions, CoversAsTheModelDoes) {
  std::mt19937_64 random(1);
  const auto in = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  int covered = 0;
  for (int round = 0; round < 6000; ++round) {
    const int bits = static_cast<int>(in(16, 26));
    const std::int64_t texel = std::int64_t{1} << bits;
    const std::int64_t limit = std::int64_t{1} << 27;
    const std::int64_t size =
        std::min(limit, std::int64_t{1} << in(bits - 2, std::min(bits + 5, 27)));
    Caster c;
    const std::int64_t cx = in(-limit, limit - 1), cy = in(-limit, limit - 1);
    const bool lattice = in(0, 2) == 0;
    for (LightPoint& p : c.vertex) {
      std::int64_t x = cx + in(-size, size), y = cy + in(-size, size);
      if (lattice) x &= -texel, y &= -texel;
      if (in(0, 20) == 0) x = in(0, 1) ? -limit : limit - 1;
      p.x = static_cast<std::int32_t>(std::clamp(x, -limit, limit - 1));
      p.y = static_cast<std::int32_t>(std::clamp(y, -limit, limit - 1));
    }
    if (lattice && in(0, 3) == 0) c.vertex[1].y = c.vertex[0].y;
    if (lattice && in(0, 3) == 0) c.vertex[2].x = c.vertex[0].x;
    const unit::Polygon polygon(c, bits);
    if (polygon.degenerate()) continue;
    std::int32_t x = c.vertex[0].x >> bits, y = c.vertex[0].y >> bits;
    Walk walk(c, bits, x, y);
    const std::int32_t start_x = x, start_y = y;
    for (int step = 0; step < 40; ++step) {
      ASSERT_EQ(walk.inside(), polygon.covers_corner(x, y))
          << "round " << round << " step " << step << " bits " << bits;
      covered += walk.inside();
      const bool restart = in(0, 9) == 0;
      if (restart) x = start_x, y = start_y;
      int dx = static_cast<int>(in(-1, 1)), dy = static_cast<int>(in(0, 1));
      const std::int64_t low = -limit >> bits, high = (limit >> bits) - 1;
      if (x + dx < low || x + dx > high) dx = 0;
      if (y + dy > high) dy = 0;
      x += dx;
      y += dy;
      walk.move(restart, dx, dy);
    }
  }
  EXPECT_GT(covered, 5000);
}

}  // namespace
}  // namespace kagesen
