#pragma once
/// Walks the texels of an outline, one each time the front moves.
/// Twin: rtl/paper/edge_walker.sv. Which texels they are is golden's to say.
#include <systemc>

#include "model/unit/config.h"
#include "model/unit/triangle_trail.h"
#include "sim/systemc/common/visited_rows.h"
#include "sim/systemc/paper/visit.h"

namespace kagesen::tlm_model::paper {

class EdgeWalker : public sc_core::sc_module {
 public:
  explicit EdgeWalker(const sc_core::sc_module_name& name) : sc_module(name) {}

  void begin_pass(const UnitConfig& config) {
    width_ = static_cast<std::uint32_t>(config.map_width);
    height_ = static_cast<std::uint32_t>(config.map_height);
  }

  /// An edge was taken in cycle `at`. Returns the cycle after that in which the walker stands before
  /// its first texel.
  Cycle begin(Cycle at, VisitRegister& visits) const {
    if (visits.moves() <= at) visits.pass(at);
    const Cycle fresh = visits.moves();
    visits.pass(fresh);
    return fresh;
  }
  /// Returns the cycle of the last texel; the next edge may be taken in it.
  Cycle walk(const unit::TriangleTrail& triangle, unsigned edge, VisitRegister& visits,
             VisitedRows& rows) const {
    const unit::TriangleTrail::Texel* const end = triangle.outline.data() + triangle.edge[edge + 1];
    const unit::TriangleTrail::Texel* texel = triangle.outline.data() + triangle.edge[edge];
    for (;;) {
      const Cycle at = visits.moves();
      const bool on_row = static_cast<std::uint32_t>(texel->y) < height_;
      if (on_row) rows.visit(texel->y);
      if (on_row && static_cast<std::uint32_t>(texel->x) < width_) {
        visits.put(at, {Visit::kEdge, texel->x, texel->y, 0});
      } else {
        visits.pass(at);
      }
      const unit::TriangleTrail::Texel* const next = texel + 1;
      if (next == end) return at;
      // A step through a texel's corner goes along both axes, one after the other.
      if (next->x != texel->x && next->y != texel->y) visits.pass(visits.moves());
      texel = next;
    }
  }

 private:
  std::uint32_t width_ = 0, height_ = 0;
};

}  // namespace kagesen::tlm_model::paper
