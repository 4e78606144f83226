#include "sim/systemc/paper/front.h"

namespace kagesen::tlm_model::paper {

Front::Front(const sc_core::sc_module_name& name)
    : sc_module(name),
      setup_("edge_setup"),
      walker_("edge_walker"),
      rows_("visited_rows"),
      filler_("span_filler") {}

void Front::begin_pass(const UnitConfig& config, unsigned texel_bits, VisitTaker& store) {
  setup_.begin_pass(config, texel_bits);
  walker_.begin_pass(config);
  visits_.begin_pass(store);
  causes_.clear();
  walked_ = 0;
  free_ = 0;
}

Cycle Front::draw(const unit::TriangleTrail& triangle, Cycle offered) {
  causes_.none(idle(), offered);
  const Cycle area = setup_.begin(triangle, offered);
  if (triangle.flat) {
    causes_.setup(std::max(offered, walked_), area + 1);
    free_ = area + 1;
    return area;
  }
  const Cycle begins = std::max({setup_.edge_ready(0), walked_, visits_.moves()});
  causes_.setup(std::max(offered, walked_), begins + 1);
  rows_.begin();
  visits_.put(begins, {});
  Cycle taken = begins;
  for (unsigned edge = 0;; ++edge) {
    setup_.take(taken, walker_.begin(taken, visits_));
    const Cycle last = walker_.walk(triangle, edge, visits_, rows_);
    if (edge == 2) break;
    taken = setup_.edge_ready(edge + 1);
    if (taken <= last) {
      taken = last;
    } else {
      taken = std::max(taken, visits_.moves());
      causes_.setup(last + 1, taken + 1);
    }
  }
  const Cycle edges_done = visits_.moves();
  visits_.put(edges_done, {Visit::kEdgesDone, 0, 0, 0});
  rows_.start(edges_done);
  filler_.fill(triangle, visits_, rows_);
  walked_ = rows_.done() + 1;
  free_ = taken + 1;
  return taken;
}

}  // namespace kagesen::tlm_model::paper
