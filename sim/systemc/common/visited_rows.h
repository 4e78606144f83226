#pragma once
/// The gaps between a triangle's outlines, row by row: when each is offered.
/// Twin: rtl/common/visited_rows.sv. Which gaps there are is golden's to say.
///
/// Timing: started in cycle n, the first row is read in n + 1; then a row without gaps takes a cycle.
///         A row is read ahead while the gaps of the one before are taken.
#include <algorithm>
#include <cstdint>
#include <systemc>

#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model {

class VisitedRows : public sc_core::sc_module {
 public:
  explicit VisitedRows(const sc_core::sc_module_name& name) : sc_module(name) {}

  /// A new triangle: no row on the map is visited.
  void begin() { first_ = last_ = -1; }
  /// An outline visits a row of the map.
  void visit(std::int32_t y) {
    if (first_ < 0) {
      first_ = last_ = y;
    } else {
      first_ = std::min(first_, y);
      last_ = std::max(last_, y);
    }
  }
  void start(Cycle at) {
    next_ = first_;
    read_ = at + 2;
    left_ = at;
  }
  /// The first cycle in which the next gap is offered. It is in row `y`.
  Cycle offered(std::int32_t y) {
    if (y < next_) return left_ + 1;  // another one of the last row
    const Cycle at = std::max(read_, left_) + static_cast<Cycle>(y - next_);
    next_ = y + 1;
    read_ = at + 1;
    return at + 1;
  }
  /// The gap is taken.
  void take(Cycle at) { left_ = at; }
  /// The first cycle in which nothing is to be done any more.
  Cycle done() const {
    if (first_ < 0 || next_ > last_) return left_ + 1;
    return std::max(read_, left_) + static_cast<Cycle>(last_ - next_) + 1;
  }

 private:
  std::int32_t first_ = -1, last_ = -1, next_ = 0;  // rows
  Cycle read_ = 0;  // when the next row is there
  Cycle left_ = 0;  // when the last gap was taken
};

}  // namespace kagesen::tlm_model
