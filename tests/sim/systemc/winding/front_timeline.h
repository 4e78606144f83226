#pragma once
/// A front of the winding profile, cycle by cycle: its model and the Verilated one.
#include <vector>

#include "tests/rtl/winding/front_driver.h"
// Verilator's headers come before SystemC's.
#include "model/frame_setup.h"
#include "model/unit/winding/shadow_unit.h"
#include "sim/systemc/winding/front.h"
#include "tests/sim/systemc/front_timeline.h"

namespace kagesen::tlm_model::winding {

struct Case {
  const std::vector<Caster>& casters;
  const FrameSetup& setup;
  UnitConfig config;
  Stalls offers, store;
};

inline FrontTimeline model(const Case& run) {
  FrontTimeline line;
  unit::winding::ShadowUnit golden;
  golden.begin(run.config, run.setup);
  static Front front("front");
  StallingStore<Visit> store(run.store, front.causes(), line);
  front.begin_pass(run.config, run.setup.fraction_bits, store);
  unit::winding::TriangleTrail trail;
  Cycle free = 0;
  const auto taken = [&](Cycle at) {
    line.beats.push_back(at);
    free = at + 1;
  };
  for (std::size_t i = 0; i < run.casters.size(); ++i) {
    golden.draw(run.casters[i], trail);
    if (i < run.setup.facets.size() && run.setup.facets[i].plane != Facet::kOwnPlane) {
      taken(front.draw_plane(run.offers.next(free)));
    }
    taken(front.draw(trail, run.offers.next(free)));
  }
  line.idle = front.idle();
  store.count(line.idle);
  return line;
}

class Verilog : public rtl::FrontDriver {
 public:
  explicit Verilog(const Case& run) : FrontDriver(run.config, run.setup), run_(run) {}

  FrontTimeline timeline() {
    const std::vector<rtl::GoldenTri> tris = rtl::golden_tris(run_.casters, run_.setup, run_.config);
    FrontTimeline line;
    std::size_t next = 0;
    bool plane_sent = false, offered = false, plane = false;
    for (Cycle now = 0;; ++now) {
      if (!offered && next < tris.size() && !run_.offers.at(now)) {
        const bool shares = tris[next].facet.plane != Facet::kOwnPlane;
        offered = true;
        plane = shares && !plane_sent;
        offer(tris[next], plane, shares);
      }
      dut_.tri_valid_i = offered;
      dut_.visit_ready_i = !run_.store.at(now);
      dut_.eval();
      if (dut_.idle_o && next == tris.size()) {
        line.idle = now;
        return line;
      }
      if (!dut_.visit_valid_o) ++(dut_.setup_o ? line.setup : dut_.idle_o ? line.none : line.walk);
      if (dut_.visit_valid_o && dut_.visit_ready_i) {
        const rtl::GoldenVisit v = visit();
        line.visits.push_back({now, v.kind, v.x, v.y});
      }
      if (dut_.tri_valid_i && dut_.tri_ready_o) {
        line.beats.push_back(now);
        offered = false;
        plane_sent = plane;
        if (!plane) ++next;
      }
      clock();
    }
  }

 private:
  const Case& run_;
};

inline Stalls stalls(std::uint32_t per_cent, unsigned seed, Channel channel) {
  return Stalls(per_cent, Chance(seed, {}, channel, 0));
}

}  // namespace kagesen::tlm_model::winding
