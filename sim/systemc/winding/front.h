#pragma once
/// The front: when each triangle is taken, and each of its visits given to the store.
/// Twin: rtl/winding/front.sv.
///
/// A triangle is set up, walked and filled before the next one is taken; the next edge is set up
/// while one is walked.
#include <systemc>

#include "sim/systemc/common/front_causes.h"
#include "sim/systemc/common/visited_rows.h"
#include "sim/systemc/winding/edge_setup.h"
#include "sim/systemc/winding/plane_setup.h"
#include "sim/systemc/winding/span_filler.h"
#include "sim/systemc/winding/visit.h"

namespace kagesen::tlm_model::winding {

class Front : public sc_core::sc_module {
 public:
  explicit Front(const sc_core::sc_module_name& name);

  void begin_pass(const UnitConfig& config, unsigned texel_bits, VisitTaker& store);
  /// A triangle is offered from this cycle on. Returns the cycle in which it is taken.
  Cycle draw(const unit::winding::TriangleTrail& triangle, Cycle offered);
  /// The same of the plane that the next triangle shares.
  Cycle draw_plane(Cycle offered);
  /// The first cycle with nothing inside, if no more triangles come.
  Cycle idle() const { return idle_; }
  /// Why there was no visit, up to the last one that draw() gave to the store.
  FrontCauses& causes() { return causes_; }

 private:
  using Trail = unit::winding::TriangleTrail;

  Cycle take(Cycle offered);
  void set_up(Cycle from, Cycle to) { causes_.setup(std::max(from, visits_.offered()), to); }
  bool on_map(std::int32_t x, std::int32_t y) const {
    return static_cast<std::uint32_t>(x) < width_ && static_cast<std::uint32_t>(y) < height_;
  }
  Cycle walk(const Trail& triangle, unsigned edge, Cycle at);
  Cycle pass(const Trail& triangle, unsigned edge, Cycle at);
  void visit_inner(const Trail& triangle, const Trail::Row& row, std::int32_t x, Cycle at);

  PlaneSetup plane_;
  EdgeSetup edges_;
  VisitedRows rows_;
  SpanFiller filler_;
  VisitRegister visits_;
  FrontCauses causes_;
  std::uint32_t width_ = 0, height_ = 0;
  Cycle idle_ = 0;
  Trail::Texel place_{};  // where the last edge ended
};

}  // namespace kagesen::tlm_model::winding
