#pragma once
/// What a visit does to the cluster of its plane, a cycle at a time.
/// Twin: rtl/winding/cluster_update.sv.
#include <systemc>

#include "sim/systemc/winding/list_step.h"

namespace kagesen::tlm_model::winding {

class ClusterUpdate : public sc_core::sc_module {
 public:
  enum class End : std::uint8_t {
    kNone,
    kDone,
    kEnds,    ///< done, and nothing follows
    kCovers,  ///< the cluster is full now
    kGrown,   ///< a record more: is the list too long?
    kSpills,  ///< no room
  };

  ClusterUpdate(const sc_core::sc_module_name& name, RecordPool& pool)
      : sc_module(name), pool_(pool) {}

  void reset(std::uint32_t segments_per_record, std::uint32_t chain_limit) {
    room_ = segments_per_record;
    chain_limit_ = chain_limit;
    state_ = kFound;
  }
  /// @param at  the record that is looked up
  End step(const ListVisit& visit, WordAddress at, ListStep& step);
  bool changed() const { return changed_; }  ///< in the last step
  bool bare() const { return bare_; }        ///< in it, the cluster lost its last segment

 private:
  enum State : std::uint8_t {
    kFound, kAppend, kGrow, kTrim, kFull, kScan, kCorner, kCut, kLift, kPatch, kRefill, kRelease
  };
  End work(const ListVisit& visit, WordAddress at, ListStep& step);
  End found(const ListVisit& visit, WordAddress at, ListStep& step);
  void scan(const ListVisit& visit, WordAddress at, ListStep& step);
  End take_away(WordAddress at, ListStep& step);

  RecordPool& pool_;
  std::uint32_t room_ = 2, chain_limit_ = 0;
  State state_ = kFound;
  bool changed_ = false, bare_ = false;
  WordAddress head_ = 0, link_ = 0, next_ = 0;
  bool next_valid_ = false, refill_ = false;
  std::uint32_t passed_ = 0;  // segments, by a scan
};

}  // namespace kagesen::tlm_model::winding
