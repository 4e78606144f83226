#pragma once
/// Triangles through the Verilated front, its visits compared with the golden ones one by one.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "tests/rtl/paper/golden_visits.h"

namespace kagesen::rtl {

struct FrontRun {
  unsigned triangle_percent = 100, visit_percent = 100;  ///< cycles in which one is offered, taken
  unsigned plane_percent = 0;  ///< beats of the winding profile in between, to be dropped
  unsigned seed = 1;
};

struct FrontCycles {
  std::uint64_t cycles = 0, setup = 0;
  GoldenVisitCounts counts;
};

template <typename Dut>
class FrontDriver {
 public:
  FrontDriver() {
    dut.clk_i = 0;
    dut.rst_ni = 1;
    dut.clear_i = 0;
    dut.tri_valid_i = 0;
    dut.visit_ready_i = 0;
    dut.is_plane_i = 0;
    dut.eval();
    dut.rst_ni = 0;
    dut.eval();
    dut.rst_ni = 1;
  }

  void tick() {
    dut.clk_i = 1;
    dut.eval();
    dut.clk_i = 0;
    dut.eval();
  }

  void settings(const UnitConfig& config, int texel_bits) {
    dut.texel_bits_i = static_cast<std::uint8_t>(texel_bits);
    dut.map_width_i = static_cast<std::uint16_t>(config.map_width);
    dut.map_height_i = static_cast<std::uint16_t>(config.map_height);
    dut.farthest_i = config.hidden_removal == HiddenRemoval::kFarthest;
  }

  void offer(const Caster& c) {
    const auto coordinate = [](std::int32_t v) {
      return static_cast<std::uint32_t>(v) & ((1u << 28) - 1);
    };
    dut.x0_i = coordinate(c.vertex[0].x);
    dut.x1_i = coordinate(c.vertex[1].x);
    dut.x2_i = coordinate(c.vertex[2].x);
    dut.y0_i = coordinate(c.vertex[0].y);
    dut.y1_i = coordinate(c.vertex[1].y);
    dut.y2_i = coordinate(c.vertex[2].y);
    dut.z0_i = c.vertex[0].z;
    dut.z1_i = c.vertex[1].z;
    dut.z2_i = c.vertex[2].z;
    dut.polygon_i = c.polygon & 0xFFFFFFu;
    dut.object_i = c.object;
  }

  /// Draws `casters` (object: unit ID) and stops at the first visit that differs.
  FrontCycles draw(const std::vector<Caster>& casters, const UnitConfig& config, int texel_bits,
                   const FrontRun& run) {
    GoldenVisitCounts expected_counts;
    const std::vector<GoldenVisit> expected =
        golden_visits(casters, config, texel_bits, &expected_counts);
    settings(config, texel_bits);
    std::mt19937 random(run.seed);
    FrontCycles result;
    std::size_t sent = 0, seen = 0;
    std::uint64_t quiet = 0;
    bool offered = false;
    dut.eval();
    while (sent < casters.size() || seen < expected.size() || !dut.idle_o) {
      if (!offered && random() % 100 < run.triangle_percent) {
        if (random() % 100 < run.plane_percent) {
          offered = true;
          dut.is_plane_i = 1;
          offer(Caster{});
        } else if (sent < casters.size()) {
          offered = true;
          dut.is_plane_i = 0;
          offer(casters[sent]);
        }
      }
      dut.tri_valid_i = offered;
      dut.visit_ready_i = random() % 100 < run.visit_percent;
      dut.eval();
      if (dut.visit_valid_o && dut.visit_ready_i) {
        quiet = 0;
        if (seen >= expected.size()) {
          ADD_FAILURE() << "a visit too many";
          return result;
        }
        if (!same(expected[seen], config)) {
          ADD_FAILURE() << "visit " << seen << " of triangle with " << sent << " taken, f "
                        << texel_bits;
          return result;
        }
        ++seen;
      } else if (++quiet > 100000) {
        ADD_FAILURE() << "stuck after visit " << seen << " of " << expected.size();
        return result;
      }
      if (dut.tri_valid_i && dut.tri_ready_o) {
        offered = false;
        if (!dut.is_plane_i) ++sent;
      }
      result.setup += dut.setup_o && !dut.visit_valid_o;
      result.counts.casters += dut.caster_o;
      result.counts.edges += dut.edge_begun_o;
      result.counts.edge_texels += dut.edge_texel_o;
      result.counts.span_texels += dut.span_texels_o;
      ++result.cycles;
      tick();
      dut.tri_valid_i = offered;
      dut.eval();
    }
    EXPECT_EQ(result.counts.casters, expected_counts.casters);
    EXPECT_EQ(result.counts.edges, expected_counts.edges);
    EXPECT_EQ(result.counts.edge_texels, expected_counts.edge_texels);
    EXPECT_EQ(result.counts.span_texels, expected_counts.span_texels);
    return result;
  }

  Dut dut;

 private:
  template <typename A, typename B>
  static bool equal(const char* field, const A& got, const B& expected) {
    if (static_cast<std::uint64_t>(got) == static_cast<std::uint64_t>(expected)) return true;
    ADD_FAILURE() << field << ": " << static_cast<std::uint64_t>(got) << ", golden "
                  << static_cast<std::uint64_t>(expected);
    return false;
  }

  bool same(const GoldenVisit& v, const UnitConfig& config) {
    bool ok = equal("kind", dut.kind_o, v.kind) && equal("object", dut.object_o, v.object) &&
              equal("most", dut.most_o, v.most);
    if (ok && config.hidden_removal == HiddenRemoval::kFarthest) {
      // A rise beyond the range of depths is as good as the range.
      ok = dut.rise_o >= v.rise && (dut.rise_o == v.rise || v.rise == v.most - v.least);
      EXPECT_TRUE(ok) << "rise " << dut.rise_o << ", golden " << v.rise;
    }
    if (v.kind == GoldenVisit::kEdge || v.kind == GoldenVisit::kSpan) {
      ok = ok && equal("x", dut.x_o, v.x) && equal("y", dut.y_o, v.y);
    }
    if (v.kind == GoldenVisit::kEdge) {
      ok = ok && equal("flags", dut.flags_o, v.line.flags) &&
           equal("polygon", dut.polygon_o, v.line.polygon) &&
           equal("slope", dut.slope_o, v.line.slope) &&
           equal("fraction", dut.fraction_o, v.line.fraction) &&
           equal("nearest", dut.nearest_o, v.nearest) && equal("corner", dut.corner_o, v.corner) &&
           equal("depth0", dut.depth0_o, v.depth[0]);
    }
    if (v.kind == GoldenVisit::kSpan) {
      ok = ok && equal("mask", dut.mask_o, v.mask);
      const std::uint32_t depth[4] = {dut.depth0_o, dut.depth1_o, dut.depth2_o, dut.depth3_o};
      for (int i = 0; i < 4; ++i) {
        if (v.mask >> i & 1) ok = ok && equal("depth", depth[i], v.depth[i]);
      }
    }
    return ok;
  }
};

}  // namespace kagesen::rtl
