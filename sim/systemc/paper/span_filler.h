#pragma once
/// Fills the gaps between a triangle's outlines, two texels each time the front moves; a visit is a
/// word of four. It is led to a gap from where the one before began, a texel a cycle.
/// Twin: rtl/paper/span_filler.sv.
#include <algorithm>
#include <cstdlib>
#include <systemc>

#include "model/unit/triangle_trail.h"
#include "sim/systemc/common/visited_rows.h"
#include "sim/systemc/paper/visit.h"

namespace kagesen::tlm_model::paper {

class SpanFiller : public sc_core::sc_module {
 public:
  explicit SpanFiller(const sc_core::sc_module_name& name) : sc_module(name) {}

  void fill(const unit::TriangleTrail& triangle, VisitRegister& visits, VisitedRows& rows) const {
    // From the lowest edge's first texel.
    unit::TriangleTrail::Texel anchor = triangle.outline[triangle.edge[0]];
    for (unsigned edge = 1; edge < 3; ++edge) {
      const unit::TriangleTrail::Texel first = triangle.outline[triangle.edge[edge]];
      if (first.y < anchor.y) anchor = first;
    }
    for (const unit::TriangleTrail::Gap& gap : triangle.gaps) {
      const Cycle begins = std::max(visits.moves(), rows.offered(gap.y));
      const auto way = static_cast<Cycle>(gap.y - anchor.y + std::abs(gap.from - anchor.x));
      visits.pass(begins + std::max<Cycle>(way, 1) - 1);
      for (std::int32_t x = gap.from; x <= gap.to;) {
        const std::int32_t last = std::min(gap.to, x | (kTexelsPerWord - 1));
        // An even and an odd column are one step.
        const auto steps = static_cast<Cycle>((last >> 1) - (x >> 1) + 1);
        const Cycle at = visits.moves() + steps - 1;
        if (last == gap.to) rows.take(at);
        const std::int32_t word = x & ~(kTexelsPerWord - 1);
        const unsigned mask = (2u << (last - word)) - (1u << (x - word));
        visits.put(at, {Visit::kSpan, word, gap.y, mask});
        x = last + 1;
      }
      anchor = {gap.from, gap.y};
    }
  }

 private:
  static constexpr std::int32_t kTexelsPerWord = 4;
};

}  // namespace kagesen::tlm_model::paper
