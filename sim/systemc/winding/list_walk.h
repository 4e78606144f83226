#pragma once
/// Reads the records of a texel's list one after the other; the mode says what it does with them.
/// Twin: rtl/winding/list_walk.sv.
#include <deque>
#include <systemc>
#include <vector>

#include "sim/systemc/winding/list_texel.h"

namespace kagesen::tlm_model::winding {

class ListWalk : public sc_core::sc_module {
 public:
  /// Find: the visit's cluster. Covers, CoversDrop: what ends nearest. Drop: clusters that are hidden.
  /// Settle: those without segments. Free: all. Count: records.
  enum Mode : std::uint8_t { kFind, kCovers, kCoversDrop, kDrop, kSettle, kFree, kCount };
  enum class End : std::uint8_t {
    kNone,
    kFound,    ///< the visit's cluster, by kFind
    kEnded,    ///< the list is at its end
    kEmptied,  ///< no cluster is left
  };

  ListWalk(const sc_core::sc_module_name& name, RecordPool& pool, ListTexel& texel)
      : sc_module(name), pool_(pool), texel_(texel) {}

  void reset() {
    dropped_.clear();
    emptied_.clear();
  }
  /// What walks to come drop, and what settling finds, in order.
  void add_dropped(const std::vector<std::uint32_t>& numbers) {
    dropped_.insert(dropped_.end(), numbers.begin(), numbers.end());
  }
  void add_emptied(const std::vector<unit::winding::SettleTrail::Emptied>& clusters) {
    emptied_.insert(emptied_.end(), clusters.begin(), clusters.end());
  }
  /// A texel is passed over in settling.
  void skip(const ListVisit& visit) {
    dropped_.erase(dropped_.begin(), dropped_.begin() + visit.texel.dropped);
    emptied_.erase(emptied_.begin(), emptied_.begin() + visit.emptied);
  }

  /// A new texel, of whose list so many records are known.
  void start(std::uint32_t records) { count_ = records; }
  /// The first record is looked up in this cycle by the owner. Walks from the next one on.
  void begin(Mode mode, const ListVisit& visit) {
    mode_ = mode;
    state_ = kWalk;
    continued_ = prev_valid_ = false;
    if (mode == kDrop) dropped_left_ = visit.texel.dropped;
    if (mode == kCount) count_ = 0;
  }
  Mode mode() const { return mode_; }
  /// It compares bounds: a record takes two cycles.
  bool bounded() const { return state_ == kWalk && mode_ >= kCovers && mode_ <= kSettle; }
  bool at_first(WordAddress at) const { return state_ == kWalk && at == texel_.first; }
  std::uint32_t count() const { return count_; }  ///< records

  /// @param at  the record that was looked up, and is there
  End step(const ListVisit& visit, WordAddress at, ListStep& step);
  bool changed() const { return changed_; }  ///< in the last step

 private:
  enum State : std::uint8_t { kWalk, kErase, kLink };

  End walk(const ListVisit& visit, WordAddress at, ListStep& step);
  bool settle(WordAddress at, ListStep& step);
  End erase(WordAddress at, ListStep& step);

  RecordPool& pool_;
  ListTexel& texel_;
  std::deque<std::uint32_t> dropped_;
  std::deque<unit::winding::SettleTrail::Emptied> emptied_;
  std::uint32_t dropped_left_ = 0;  // clusters of this visit

  Mode mode_ = kFind;
  State state_ = kWalk;
  bool continued_ = false, prev_valid_ = false, next_valid_ = false, changed_ = false;
  WordAddress prev_ = 0, chain_ = 0, next_ = 0;
  std::uint32_t count_ = 0;
};

}  // namespace kagesen::tlm_model::winding
