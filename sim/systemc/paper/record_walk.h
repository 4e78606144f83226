#pragma once
/// Carries out operations on the SLB, a step each time that what the step needs is on chip.
/// Twin: rtl/paper/silhouette_buffer.sv.
///
/// Which line is where in an entry golden knows; which record stands where only hardware does, and
/// that decides which words meet on chip. So records' links are kept here once more.
#include <systemc>
#include <vector>

#include "model/unit/config.h"
#include "model/unit/fragment_trail.h"
#include "model/unit/triangle_trail.h"
#include "sim/systemc/paper/slb_pool.h"

namespace kagesen::tlm_model::paper {

/// A visit, or an emptied entry, with what golden found.
struct Operation {
  enum Kind : std::uint8_t { kEdge, kEmptied, kSpan, kEdgesDone } kind = kEdge;
  std::int32_t x = 0, y = 0;
  RecordAddress bucket = 0;
  std::uint32_t word = 0;  ///< of the texel memory
  std::uint32_t object = 0;
  unit::TriangleTrail::EdgeVisit edge{};
  unit::TriangleTrail::Emptied emptied{};      ///< if that, or the entry that an edge's visit empties
  unsigned mask = 0;                           ///< span: texels that it covers
  unsigned edges = 0;                          ///< span: texels that hold lines
  std::array<std::uint32_t, 4> hide_depth{};   ///< and of each
};

class RecordWalk : public sc_core::sc_module {
 public:
  explicit RecordWalk(const sc_core::sc_module_name& name) : sc_module(name) {}

  /// All buckets are empty.
  void wipe(const UnitConfig& config);

  bool busy() const { return state_ != SlbState::kIdle; }
  const Operation& operation() const { return operation_; }
  unsigned texel() const { return walk_.word_x; }  ///< of the word, that is worked on
  const SlbRecord& record(RecordAddress at) const { return records_[at]; }

  /// Fills in where the records stand that a fragment reads.
  void locate(unit::FragmentTrail& trail) const {
    RecordAddress entry = trail.bucket;
    std::uint32_t number = 0;
    for (const unit::FragmentTrail::Place& place : trail.places) {
      for (; number < place.entry; ++number) entry = records_[entry].next;
      RecordAddress at = entry;
      for (std::uint32_t part = place.part; part > 0; --part) at = records_[at].more;
      trail.records.push_back(at);
    }
  }

  /// What this cycle's step is. @pre busy()
  const SlbStep& plan(bool hit, bool texel_hit);
  /// What it writes.
  SlbRecord written() const;
  /// It is done.
  void fire();
  RecordAddress at() const { return at_; }  ///< of the record that is looked up
  /// The operation begins in the next cycle.
  void start(const Operation& operation);
  /// Nothing was done for the operation yet.
  bool first() const {
    return state_ == SlbState::kSpan ||
           (state_ == SlbState::kFind && !walk_.has_prev && !walk_.relink);
  }

 private:
  std::uint32_t tag(unsigned word_x) const {
    return static_cast<std::uint32_t>(operation_.y) << 16 |
           (static_cast<std::uint32_t>(operation_.x) & ~3u) | word_x;
  }
  SlbFacts facts(bool hit, bool texel_hit) const;

  RecordAddress bucket_mask_ = 0;
  std::uint32_t record_limit_ = 0, chain_limit_ = 0;
  std::uint8_t lines_ = 3;
  bool wants_hiding_ = false;
  std::vector<SlbRecord> records_;
  SlbPool pool_;

  SlbState state_ = SlbState::kIdle, next_state_ = SlbState::kIdle;
  SlbWalk walk_, next_walk_;
  SlbStep step_;
  RecordAddress at_ = 0;  // of the record that is looked up
  Operation operation_;
};

}  // namespace kagesen::tlm_model::paper
