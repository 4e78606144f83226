#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "Vvisited_rows_test_dut.h"
#include "model/unit/span_filler.h"

namespace kagesen {
namespace {

using Gap = std::array<std::int32_t, 3>;  // y, from, to

class Rows {
 public:
  explicit Rows(int width) {
    dut_.map_width_i = static_cast<std::uint32_t>(width);
    dut_.rst_ni = 0;
    dut_.eval();
    dut_.rst_ni = 1;
    idle();
  }
  void begin() {
    dut_.begin_i = 1;
    idle();
    dut_.begin_i = 0;
  }
  void visit(int edge, std::int32_t x, std::int32_t y, bool visit = true) {
    dut_.visit_i = visit;
    dut_.edge_i = static_cast<std::uint8_t>(edge);
    dut_.x_i = static_cast<std::uint32_t>(x) & 0x3fff;
    dut_.y_i = static_cast<std::uint32_t>(y);
    idle();
    dut_.visit_i = dut_.lookup_i = 0;
  }
  bool lookup(unsigned passed, int edge, std::int32_t x, std::int32_t y, bool with_visit) {
    dut_.lookup_i = 1;
    dut_.passed_i = static_cast<std::uint8_t>(passed);
    visit(edge, x, y, with_visit);
    return dut_.visited_o != 0;
  }
  std::vector<Gap> gaps(std::mt19937_64& random, unsigned& cycles) {
    std::vector<Gap> out;
    dut_.gaps_i = 1;
    idle();
    dut_.gaps_i = 0;
    const unsigned ready = 1 + random() % 10;
    for (cycles = 0; dut_.gaps_busy_o; ++cycles) {
      dut_.gap_ready_i = random() % 10 < ready;
      dut_.eval();
      if (dut_.gap_valid_o && dut_.gap_ready_i) {
        out.push_back({dut_.gap_y_o, dut_.gap_from_o, dut_.gap_to_o});
      }
      idle();
    }
    return out;
  }
  void clear() {
    dut_.clear_i = 1;
    idle();
    dut_.clear_i = 0;
  }

 private:
  void idle() {
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
    dut_.eval();
  }
  Vvisited_rows_test_dut dut_;
};

/// Three monotone chains of intervals, partly off the map; look-ups of earlier edges while one
/// walks. Fails if an interval leaks from another triangle, row or edge, or a gap is lost, doubled
/// or unclipped.
void answers_and_gaps(int width, int height, int rounds, std::size_t least) {
  std::mt19937_64 random(7);
  const auto in = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  Rows dut(width);
  std::size_t found = 0, hits = 0;
  for (int round = 0; round < rounds; ++round) {
    unit::VisitedRows model;
    const int low_row = in(0, height - 1), high_row = std::min(height - 1, low_row + in(0, 12));
    model.begin(low_row, high_row);
    dut.begin();
    const int near = in(0, width - 20);
    unsigned passed = 0;
    const int edges = in(1, 3);
    for (int n = 0, edge = in(0, 2); n < edges; ++n, edge = (edge + 1) % 3) {
      int x = in(0, 5) == 0   ? in(-2000, 2500)
              : in(0, 2) == 0 ? in(-10, width + 10)
                              : in(near, near + 10);
      const int from = n == 0 ? low_row : in(low_row, high_row);
      const int to = n == 0 ? high_row : in(from, high_row);
      const int way = in(0, 1) ? 1 : -1;
      for (int y = from; y <= to; ++y) {
        for (int left = in(0, 4); left >= 0; --left) {
          model.visit(edge, x, y);
          const bool ask = in(0, 1) != 0 && x >= 0 && x < width;
          if (ask) {
            const bool visited = dut.lookup(passed, edge, x, y, true);
            ASSERT_EQ(visited, model.visited(passed, x, y)) << round;
            hits += visited;
          } else {
            dut.visit(edge, x, y);
          }
          if (left > 0) x += way;
        }
        x += in(0, 2) == 0 ? way : 0;
      }
      passed |= 1u << edge;
    }
    if (in(0, 9) == 0) {
      dut.clear();
      continue;
    }
    std::vector<Gap> expected;
    model.gaps([&](std::int32_t y, std::int32_t from, std::int32_t to) {
      from = std::max(from, 0);
      to = std::min(to, width - 1);
      if (from <= to) expected.push_back({y, from, to});
    });
    unsigned cycles = 0;
    ASSERT_EQ(dut.gaps(random, cycles), expected) << round;
    found += expected.size();
  }
  EXPECT_GT(found, least);
  EXPECT_GT(hits, least / 10);
}

/// All bits of rows and columns.
TEST(VisitedRows, OnTheLargestMap) { answers_and_gaps(1024, 1024, 3000, 3000); }
TEST(VisitedRows, OnASmallMap) { answers_and_gaps(40, 24, 10000, 3000); }

}  // namespace
}  // namespace kagesen
