#include "sim/systemc/winding/front.h"

#include <cstdlib>

namespace kagesen::tlm_model::winding {
namespace {

// From the cycle in which a walker is loaded to its first texel, where it starts from the place.
constexpr Cycle kApproach = 3;
constexpr unsigned kNone = 3;

}  // namespace

Front::Front(const sc_core::sc_module_name& name)
    : sc_module(name),
      plane_("plane_setup"),
      edges_("edge_setup"),
      rows_("visited_rows"),
      filler_("span_filler") {}

void Front::begin_pass(const UnitConfig& config, unsigned texel_bits, VisitTaker& store) {
  plane_.begin_pass(config, texel_bits);
  visits_.begin_pass(store);
  causes_.clear();
  width_ = static_cast<std::uint32_t>(config.map_width);
  height_ = static_cast<std::uint32_t>(config.map_height);
  idle_ = 0;
}

Cycle Front::take(Cycle offered) {
  const Cycle at = std::max(offered, idle_);
  causes_.none(idle_, at + 1);
  return at;
}

Cycle Front::draw_plane(Cycle offered) {
  const Cycle at = take(offered);
  idle_ = PlaneSetup::plane(at);
  causes_.setup(at + 1, idle_);
  return at;
}

Cycle Front::draw(const Trail& triangle, Cycle offered) {
  const Cycle taken = take(offered);
  if (triangle.flat) {
    idle_ = PlaneSetup::flat(taken);
    causes_.setup(taken + 1, idle_);
    return taken;
  }
  const Cycle begins = plane_.triangle(triangle, taken, edges_) + 1;
  causes_.setup(taken + 1, begins + 1);
  rows_.begin();
  visits_.put(begins, {});
  Cycle ended = begins;  // what was before the next edge
  unsigned vertex = kNone;
  for (unsigned i = 0; i < triangle.edge_count; ++i) {
    const Trail::Edge& edge = triangle.edges[i];
    plane_.serve(edges_);
    Cycle load = edges_.ready();
    if (i == 0 || load > ended) {
      load = std::max(load, ended + 1);
      set_up(ended + 1, load + 1);
    } else {
      load = ended;
    }
    if (i + 1 < triangle.edge_count) edges_.begin(triangle.edges[i + 1].figures, load + 1);
    if (edge.from != vertex) place_ = triangle.low;
    vertex = edge.to;
    ended = edge.passed ? pass(triangle, i, load) : walk(triangle, i, load);
  }
  const Cycle gaps = std::max(ended + 1, visits_.moves());
  set_up(ended + 1, gaps + 1);
  rows_.start(gaps + 1);
  filler_.fill(triangle, visits_, rows_);
  idle_ = std::max(rows_.done(), visits_.empty()) + 1;
  return taken;
}

/// The walker was loaded in cycle `at`. Returns the cycle of the last texel.
Cycle Front::walk(const Trail& triangle, unsigned edge, Cycle at) {
  const Trail::Texel* texel = triangle.outline.data() + triangle.edges[edge].begin;
  const Trail::Texel* const end = triangle.outline.data() + triangle.end(edge);
  at += kApproach + static_cast<Cycle>(texel->y - place_.y + std::abs(texel->x - place_.x));
  for (;; ++texel) {
    at = std::max(at, visits_.moves());
    if (static_cast<std::uint32_t>(texel->y) < height_) rows_.visit(texel->y);
    if (on_map(texel->x, texel->y)) {
      visits_.put(at, {Visit::kEdge, texel->x, texel->y, 0});
    } else {
      visits_.pass(at);
    }
    if (texel + 1 == end) break;
    // A step through a texel's corner is two, whether the register is free or not.
    at += texel[1].x != texel->x && texel[1].y != texel->y ? 2 : 1;
  }
  place_ = *texel;
  return at;
}

/// The same of an inner edge that is not walked. A row that runs to -x is passed first; if a corner
/// is to be counted in it, the place comes back and visits, and then goes to the row's end again.
Cycle Front::pass(const Trail& triangle, unsigned edge, Cycle at) {
  const bool rightward = triangle.edges[edge].rightward;
  const Trail::Row* row = triangle.rows.data() + triangle.edges[edge].begin;
  const Trail::Row* const end = triangle.rows.data() + triangle.end(edge);
  const auto first = [rightward](const Trail::Row& r) { return rightward ? r.low : r.high; };
  const auto last = [rightward](const Trail::Row& r) { return rightward ? r.high : r.low; };
  at += kApproach + static_cast<Cycle>(row->y - place_.y + std::abs(first(*row) - place_.x));
  for (;; ++row) {
    if (static_cast<std::uint32_t>(row->y) < height_) rows_.visit(row->y);
    const bool probes = !rightward && row->low != row->high;
    if (probes) {
      for (std::int32_t x = row->high; x >= row->low; --x) {
        at = std::max(at, visits_.moves());
        visits_.pass(at++);
      }
      ++at;  // judged in this cycle
    }
    if (!probes || row->counts) {
      if (probes) ++at;
      for (std::int32_t x = row->low; x <= row->high; ++x) {
        at = std::max(at, visits_.moves());
        visit_inner(triangle, *row, x, at++);
      }
      at += probes ? static_cast<Cycle>(row->high - row->low) + 1 : 0;
      if (!probes) --at;
    }
    if (row + 1 == end) break;
    at += first(row[1]) != last(*row) ? 2 : 1;
  }
  place_ = {last(*row), row->y};
  return at;
}

void Front::visit_inner(const Trail& triangle, const Trail::Row& row, std::int32_t x, Cycle at) {
  if (!on_map(x, row.y)) {
    visits_.pass(at);
  } else if (triangle.corners[row.corners + static_cast<std::uint32_t>(x - std::max(row.low, 0))]) {
    visits_.put(at, {Visit::kEdge, x, row.y, 0});
  } else {
    visits_.drop(at);
  }
}

}  // namespace kagesen::tlm_model::winding
