#pragma once
/// The SLB's read port in pass 2: lists of clusters, record by record, each fragment's at its own pace.
/// Twin: rtl/winding/list_reader.sv.
///
/// Timing: a request leaves its queue two cycles after it went in at the earliest, one a cycle. Lists
///         that are being read go before new ones; whose turn it is is settled when one of them has
///         something to offer. The next record's request goes in in the cycle of the answer.
#include <algorithm>
#include <cstdint>
#include <systemc>
#include <vector>

#include "model/unit/winding/fragment_trail.h"
#include "sim/systemc/common/lane_slots.h"
#include "sim/systemc/common/memory_port.h"
#include "sim/systemc/common/queue_meter.h"
#include "sim/systemc/common/time_queue.h"
#include "sim/systemc/winding/shadow_decision.h"

namespace kagesen::tlm_model::winding {

class ListReader : public sc_core::sc_module {
 public:
  struct Record {
    MemoryPort::Read read;
    Cycle answered;
  };
  /// What a slot's fragment reads.
  struct Walk {
    unit::winding::FragmentTrail trail;  ///< what is to be read
    Cycle begun;                         ///< its list's request goes into its queue
    std::vector<Record> records;         ///< what was
  };

  MemoryPort port;
  ShadowDecision decision;
  QueueMeter list_meter, next_meter, response_meter;

  ListReader(const sc_core::sc_module_name& name, LaneSlots& slots)
      : sc_module(name), port("port"), decision("shadow_decision"), slots_(slots) {}

  void begin_pass(std::uint32_t slots, unsigned word_bytes) {
    port.begin_pass(word_bytes);
    decision.begin_pass();
    walks_.resize(slots);
    for (TimeQueue* queue : {&lists_, &next_, &responses_}) queue->reset(slots);
    for (QueueMeter* meter : {&list_meter, &next_meter, &response_meter}) meter->begin_pass();
    free_ = 0;
  }
  Walk& walk(std::uint32_t slot) { return walks_[slot]; }
  const Walk& walk(std::uint32_t slot) const { return walks_[slot]; }

  void look_up(Cycle at, std::uint32_t slot) {
    walks_[slot].begun = at;
    lists_.push(at, slot);
  }
  /// The cycle of the next step; kNever if no list is being read.
  Cycle next() const { return std::min(response(), request()); }
  /// The next response, or request. @pre look_up() was called for all lists up to next()
  void step() {
    if (response() <= request()) {
      take_response();
    } else {
      take_request();
    }
  }

 private:
  static constexpr Cycle kQueue = 2;  // through a fifo

  static Cycle head(const TimeQueue& queue) {
    return queue.empty() ? kNever : queue.front().at + kQueue;
  }
  Cycle response() const { return responses_.empty() ? kNever : responses_.front().at; }
  Cycle request() const { return std::max(free_, std::min(head(lists_), head(next_))); }

  void take_request() {
    const bool goes_on = head(next_) <= request();
    TimeQueue& queue = goes_on ? next_ : lists_;
    const auto [queued, slot] = queue.front();
    Walk& walk = walks_[slot];
    const std::uint32_t address = walk.trail.records[walk.records.size()].address;
    const MemoryPort::Read read = port.read(request(), address);
    queue.pop();
    free_ = read.accepted + 1;
    (goes_on ? next_meter : list_meter).word(queued, read.accepted);
    walk.records.push_back({read, kNever});
    responses_.push(read.responded, slot);
  }
  void take_response() {
    const std::uint32_t slot = responses_.front().slot;
    responses_.pop();
    Walk& walk = walks_[slot];
    const std::size_t number = walk.records.size();
    Record& record = walk.records.back();
    record.answered = decision.answer(record.read.responded, walk.trail.records[number - 1].boxed);
    response_meter.word(record.read.responded, decision.taken_up());
    if (number == walk.trail.records.size()) {
      slots_.decide(slot, record.answered);
    } else {
      next_.push(record.answered, slot);
    }
  }

  LaneSlots& slots_;
  std::vector<Walk> walks_;  // a slot each
  TimeQueue lists_, next_;   // requests
  TimeQueue responses_;
  Cycle free_ = 0;  // for the next request
};

}  // namespace kagesen::tlm_model::winding
