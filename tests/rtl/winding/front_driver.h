#pragma once
/// Runs the RTL's front of the winding profile over triangles, and packs and unpacks its structures.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "Vwinding_front_test_dut.h"
#include "tests/rtl/winding/golden_visits.h"

namespace kagesen::rtl {

/// Fields of a packed structure, from its last one upwards.
template <typename Port>
class Packed {
 public:
  explicit Packed(Port& port) : port_(port) {}
  void put(int bits, std::int64_t value) {
    for (int i = 0; i < bits; ++i, ++at_) {
      const std::uint32_t mask = std::uint32_t{1} << (at_ % 32);
      port_[at_ / 32] = (value >> i & 1) != 0 ? port_[at_ / 32] | mask : port_[at_ / 32] & ~mask;
    }
  }
  std::uint32_t take(int bits) {
    std::uint32_t value = 0;
    for (int i = 0; i < bits; ++i, ++at_) {
      value |= (port_[at_ / 32] >> (at_ % 32) & 1u) << i;
    }
    return value;
  }

 private:
  Port& port_;
  int at_ = 0;
};

struct FrontCycles {
  std::uint64_t all = 0, setup = 0, visits = 0;
};

class FrontDriver {
 public:
  FrontDriver(const UnitConfig& config, const FrameSetup& setup) : config_(config), setup_(setup) {
    Packed<decltype(dut_.settings_i)> s(dut_.settings_i);
    s.put(1, config.skip_fragments);
    s.put(1, config.skip_edges);
    s.put(1, config.skip_tiles);
    s.put(1, config.skip_first_test);
    s.put(1, config.skip_receiver_mask);
    s.put(1, config.semantics == Semantics::kPaper);
    s.put(17, config.plane_tolerance);
    s.put(25, 0);
    s.put(25, 0);
    s.put(11, config.map_height);
    s.put(11, config.map_width);
    s.put(5, setup.fraction_bits);
    dut_.rst_ni = 1;
    dut_.eval();
    dut_.rst_ni = 0;
    clock();
    dut_.rst_ni = 1;
    clock();
  }

  /// Runs all triangles through. @param valid, ready  chance in 10 that a beat is offered, taken
  std::vector<GoldenVisit> run(const std::vector<GoldenTri>& tris, unsigned valid, unsigned ready,
                               std::uint64_t seed) {
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    std::vector<GoldenVisit> out;
    std::size_t next = 0;
    bool plane_sent = false, offered = false;
    std::uint64_t quiet = 0;
    for (;;) {
      if (next < tris.size()) {
        const bool shares = tris[next].facet.plane != Facet::kOwnPlane;
        if (!offered) {
          offered = random() % 10 < valid;
          offer(tris[next], shares && !plane_sent, shares);
        }
      }
      dut_.tri_valid_i = offered;
      dut_.visit_ready_i = random() % 10 < ready;
      dut_.eval();
      const bool taken = dut_.visit_valid_o && dut_.visit_ready_i;
      if (taken) out.push_back(visit());
      quiet = taken ? 0 : quiet + 1;
      cycles.all += 1;
      cycles.setup += dut_.setup_o != 0;
      cycles.visits += taken;
      count();
      const bool idle = dut_.idle_o && next == tris.size();
      if (dut_.tri_valid_i && dut_.tri_ready_o) {
        offered = false;
        const bool was_plane = tris[next].facet.plane != Facet::kOwnPlane && !plane_sent;
        plane_sent = was_plane;
        if (!was_plane) ++next;
      }
      clock();
      if (idle) break;
      if (quiet > 100'000) {
        ADD_FAILURE() << "stuck after " << out.size() << " visits";
        break;
      }
    }
    return out;
  }
  /// Offers a triangle for so many cycles, then drops what is in flight.
  void disturb(const GoldenTri& tri, int for_cycles) {
    offer(tri, false, false);
    dut_.visit_ready_i = 1;
    for (int i = 0; i < for_cycles; ++i) {
      dut_.tri_valid_i = i < 3;
      clock();
    }
    dut_.tri_valid_i = 0;
    dut_.clear_i = 1;
    clock();
    dut_.clear_i = 0;
  }

  GoldenVisitCounts counts;
  FrontCycles cycles;

 protected:
  void clock() {
    dut_.clk_i = 1;
    dut_.eval();
    dut_.clk_i = 0;
    dut_.eval();
  }
  void offer(const GoldenTri& tri, bool is_plane, bool shares) {
    const Caster& c = is_plane ? setup_.planes[tri.facet.plane] : tri.caster;
    Packed<decltype(dut_.tri_i)> t(dut_.tri_i);
    for (int i = 2; i >= 0; --i) {
      t.put(24, c.vertex[i].z);
      t.put(28, c.vertex[i].y);
      t.put(28, c.vertex[i].x);
    }
    t.put(24, tri.caster.object);
    t.put(24, c.polygon);
    t.put(3, is_plane ? 0 : tri.facet.inner_edges);
    t.put(1, !is_plane && shares);
    t.put(1, is_plane);
  }
  void count() {
    std::uint32_t e = dut_.events_o;
    counts.span_texels += e & 7;
    counts.inner_texels += e >> 3 & 1;
    counts.edge_texels += e >> 4 & 1;
    counts.edges += e >> 5 & 1;
    counts.casters += e >> 6 & 1;
  }
  GoldenVisit visit() {
    GoldenVisit out;
    Packed<decltype(dut_.visit_o)> v(dut_.visit_o);
    out.mask = v.take(4);
    const auto base = [&v] { return static_cast<std::int32_t>(v.take(27) << 5) >> 5; };
    for (int i = 3; i >= 0; --i) out.base[std::size_t(i)] = base();
    out.segment.y1 = std::int32_t(v.take(12));
    out.segment.x1 = std::int32_t(v.take(12));
    out.segment.y0 = std::int32_t(v.take(12));
    out.segment.x0 = std::int32_t(v.take(12));
    using unit::winding::Segment;
    if (v.take(1)) out.segment.flags |= Segment::kPositive;
    if (v.take(1)) out.segment.flags |= Segment::kCrossesLeft;
    if (v.take(1)) out.segment.flags |= Segment::kInner;
    out.corner = v.take(1) != 0;
    out.has_segment = v.take(1) != 0;
    out.y = std::int32_t(v.take(10));
    out.x = std::int32_t(v.take(10));
    out.kind = static_cast<GoldenVisit::Kind>(v.take(2));
    // What a kind does not use may be anything.
    if (out.kind != GoldenVisit::kEdge) out.has_segment = out.corner = false;
    if (!out.has_segment) out.segment = {};
    if (out.kind == GoldenVisit::kBegin) out.x = out.y = 0;
    if (out.kind != GoldenVisit::kSpan) out.mask = out.kind == GoldenVisit::kEdge;
    for (int i = 0; i < 4; ++i) {
      if ((out.mask >> i & 1) == 0) out.base[std::size_t(i)] = 0;
    }
    if (out.kind != GoldenVisit::kSpan) out.mask = 0;
    const std::uint64_t tri = dut_.visit_tri_o;
    out.gradient_y = tri & 0x1fff;
    out.gradient_x = tri >> 13 & 0x1fff;
    out.object = std::uint32_t(tri >> 26);
    return out;
  }

  Vwinding_front_test_dut dut_;
  UnitConfig config_;
  const FrameSetup& setup_;
};

inline bool same(const GoldenVisit& a, const GoldenVisit& b) {
  return a.kind == b.kind && a.x == b.x && a.y == b.y && a.has_segment == b.has_segment &&
         a.corner == b.corner && a.segment.same_ends(b.segment) &&
         a.segment.flags == b.segment.flags && a.base == b.base && a.mask == b.mask &&
         a.object == b.object && a.gradient_x == b.gradient_x && a.gradient_y == b.gradient_y;
}
inline std::ostream& operator<<(std::ostream& out, const GoldenVisit& v) {
  out << "kind " << int(v.kind) << " at " << v.x << ", " << v.y << " corner " << v.corner;
  if (v.has_segment) {
    out << " segment " << v.segment.x0 << "," << v.segment.y0 << " " << v.segment.x1 << ","
        << v.segment.y1 << " flags " << int(v.segment.flags);
  }
  out << " mask " << v.mask << " base";
  for (const std::int32_t b : v.base) out << ' ' << b;
  return out << " object " << v.object << " gradients " << v.gradient_x << ' ' << v.gradient_y;
}

/// The whole stream of visits against the golden one, and the counters.
inline ::testing::AssertionResult front_agrees(FrontDriver& driver, const std::vector<Caster>& casters,
                                               const FrameSetup& setup, const UnitConfig& config,
                                               unsigned valid, unsigned ready, std::uint64_t seed) {
  GoldenVisitCounts counts;
  const std::vector<GoldenVisit> expected = golden_visits(casters, setup, config, &counts);
  driver.counts = {};
  const std::vector<GoldenVisit> seen =
      driver.run(golden_tris(casters, setup, config), valid, ready, seed);
  std::size_t tri = 0;
  for (std::size_t i = 0; i < std::min(expected.size(), seen.size()); ++i) {
    tri += expected[i].kind == GoldenVisit::kBegin;
    if (!same(expected[i], seen[i])) {
      return ::testing::AssertionFailure() << "visit " << i << " (triangle with an area " << tri << ")\n  golden "
                                           << expected[i] << "\n  RTL    " << seen[i];
    }
  }
  if (expected.size() != seen.size()) {
    return ::testing::AssertionFailure() << seen.size() << " visits, golden " << expected.size();
  }
  const GoldenVisitCounts& c = driver.counts;
  if (c.casters != counts.casters || c.edges != counts.edges || c.edge_texels != counts.edge_texels ||
      c.inner_texels != counts.inner_texels || c.span_texels != counts.span_texels) {
    return ::testing::AssertionFailure() << "counters differ";
  }
  return ::testing::AssertionSuccess();
}

}  // namespace kagesen::rtl
