#pragma once
/// Fills the gaps between a facet's outlines, a pair of texels each time the visits' register is
/// free; a visit is a word of four. It goes up from the first pair of a row to the next row.
/// Twin: rtl/winding/span_filler.sv.
#include <algorithm>
#include <cstdlib>
#include <systemc>

#include "model/unit/winding/triangle_trail.h"
#include "sim/systemc/common/visited_rows.h"
#include "sim/systemc/winding/visit.h"

namespace kagesen::tlm_model::winding {

class SpanFiller : public sc_core::sc_module {
 public:
  explicit SpanFiller(const sc_core::sc_module_name& name) : sc_module(name) {}

  void fill(const unit::winding::TriangleTrail& triangle, VisitRegister& visits,
            VisitedRows& rows) const {
    std::int32_t x = triangle.low.x & ~1, y = triangle.low.y;  // where it stands
    std::int32_t start = x;                                    // where it goes up from
    bool first = true;
    Cycle free = 0;  // after the last pair
    for (const unit::winding::TriangleTrail::Gap& gap : triangle.gaps) {
      const std::int32_t from = gap.from & ~1, to = gap.to & ~1;
      Cycle at = std::max(rows.offered(gap.y), free);
      if (first) ++at;
      if (gap.y != y) x = start;
      at += static_cast<Cycle>(gap.y - y + std::abs(from - x) / 2);
      if (gap.y != y || first) start = from;
      first = false;
      y = gap.y;
      for (x = from;; x += 2) {
        at = std::max(at, visits.moves());
        const bool last = x == to;
        if (last) rows.take(at);
        if (last || (x & 2) != 0) {
          const std::int32_t word = x & ~3;
          const std::int32_t low = std::max(gap.from, word), high = std::min(gap.to, word | 3);
          visits.put(at, {Visit::kSpan, word, y, (2u << (high - word)) - (1u << (low - word))});
        } else {
          visits.pass(at);
        }
        ++at;
        if (last) break;
      }
      free = at;
    }
  }
};

}  // namespace kagesen::tlm_model::winding
