#include "sim/systemc/winding/shadow_lane.h"

#include <stdexcept>
#include <string>

namespace kagesen::tlm_model::winding {

ShadowLane::ShadowLane(const sc_core::sc_module_name& name)
    : sc_module(name),
      slots("lane_slots"),
      lists("list_reader", slots),
      early("early_decision", slots, lists) {}

void ShadowLane::begin_pass(const Pass& pass) {
  pass_ = pass;
  slots.begin_pass(pass.slots, pass.verdicts);
  lists.begin_pass(pass.slots, pass.slb_bytes);
  early.begin_pass(pass.slots, pass.map_bits, pass.texel_bytes);
  free_from_.assign(pass.slots, 0);
  fragments_ = 0;
  accepted_ = entered_ = fetched_ = unblamed_ = 0;
}

void ShadowLane::take() {
  const std::uint32_t slot = slots.slot_of(fragments_);
  // The first one is offered from the cycle before the pass on.
  Cycle offered = pass_.offers.next(fragments_ == 0 ? kNever : accepted_ + 1);
  if (offered == kNever) offered = 0;
  accepted_ = std::max({offered, unblamed_, entered_});
  if (unblamed_ < entered_) blame_entry(entered_);
  blame(accepted_, LaneCause::kInput);
  blame(accepted_ + 1, LaneCause::kFragment);
  early.forget(unblamed_);
  if (pass_.cycles) pass_.cycles[fragments_ * pass_.stride].accepted = accepted_;
  ++fragments_;
  slots.open(slot, accepted_);
  entered_ = accepted_ + 1;
  const Trail& trail = lists.walk(slot).trail;
  if (trail.reads_tile) {
    entered_ = std::max(entered_, early.open());
    early.look_up(entered_, slot, trail);
  } else {
    early.pass_by(slot);
    slots.decide(slot, entered_);
  }
}

/// Goes on with the reads, in the order of time, until the oldest fragment is decided; or false if
/// that takes a read after `until`.
bool ShadowLane::decide_oldest(Cycle until) {
  const std::uint32_t oldest = slots.slot_of(slots.retired());
  for (;;) {
    const Cycle word = early.next_word();
    if (slots.decided(oldest)) return true;
    const Cycle list = lists.next();
    if (list == kNever && word == kNever) stuck();
    if (std::min(list, word) > until) return false;
    if (word <= list) {
      early.read_word();
    } else {
      lists.step();
    }
  }
}

/// The oldest fragment waits, and nothing is under way that could decide it.
void ShadowLane::stuck() const {
  const ListReader::Walk& walk = lists.walk(slots.slot_of(slots.retired()));
  throw std::logic_error(std::string(name()) + ": stuck. Fragment " +
                         std::to_string(slots.retired()) + " has read " +
                         std::to_string(walk.records.size()) + " of " +
                         std::to_string(walk.trail.records.size()) + " records; " +
                         std::to_string(fragments_ - slots.retired()) +
                         " fragments in flight, no read is asked for");
}

void ShadowLane::retire() {
  const std::uint64_t oldest = slots.retired();
  decide_oldest(kNever);
  fetched_ = slots.retire();
  free_from_[slots.slot_of(oldest)] = fetched_ + 1;
  if (pass_.cycles) pass_.cycles[oldest * pass_.stride].retired = slots.last_taken();
}

/// Waits for the slot of the next fragment.
void ShadowLane::free_slot() {
  const std::uint32_t slot = slots.slot_of(fragments_);
  const Cycle taken = slots.last_taken();  // the verdict before
  if (slots.retired() + slots.count() == fragments_) retire();
  const Cycle free = free_from_[slot];
  if (free <= unblamed_) return;
  blame(std::min(taken, free), LaneCause::kVerdict);
  blame_oldest(slot, free);
}

/// No slot is free in the cycles up to `to`: what keeps the oldest fragment?
void ShadowLane::blame_oldest(std::uint32_t oldest, Cycle to) {
  const auto until = [&](Cycle end, LaneCause why) { blame(std::min(end, to), why); };
  const EarlyDecision::Stays& stays = early.stays(oldest);
  for (const EarlyDecision::Stay* stay : {&stays.tile, &stays.word}) {
    if (stay->read.responded == 0) continue;
    until(stay->looked_up + 2, LaneCause::kDecision);
    until(stay->read.accepted + 1, LaneCause::kTexelPort);
    until(stay->read.responded + 1, LaneCause::kTexel);
  }
  const ListReader::Walk& walk = lists.walk(oldest);
  if (!walk.records.empty()) until(walk.begun + 1, LaneCause::kDecision);
  for (const ListReader::Record& record : walk.records) {
    until(record.read.accepted + 1, LaneCause::kSlbPort);
    until(record.read.responded + 1, LaneCause::kSlb);
    until(record.answered + 1, LaneCause::kDecision);
  }
  until(to, LaneCause::kDecision);
}

/// A slot is free in the cycles up to `to`, but the last fragment is not let into the tiles' stage.
void ShadowLane::blame_entry(Cycle to) {
  while (unblamed_ < to) {
    const LaneCause why = verdict_waits(unblamed_)     ? LaneCause::kVerdict
                          : early.port_busy(unblamed_) ? LaneCause::kTexelPort
                                                       : LaneCause::kTexel;
    blame(unblamed_ + 1, why);
  }
}

/// Is a verdict offered in this cycle that nobody takes?
bool ShadowLane::verdict_waits(Cycle at) {
  if (pass_.verdicts.never()) return false;
  while (slots.last_taken() < at && slots.retired() < fragments_) {
    if (!decide_oldest(at) || slots.done(slots.slot_of(slots.retired())) >= at) return false;
    retire();
  }
  return fetched_ < at && at < slots.last_taken();
}

void ShadowLane::drain() {
  if (fragments_ >= slots.count()) free_slot();
  blame_entry(entered_);
  while (slots.retired() < fragments_) retire();
}

void ShadowLane::end_pass(Cycle all_taken, Cycle cycles) {
  blame(std::min(all_taken, cycles), LaneCause::kInput);
  blame(cycles, LaneCause::kDrain);
  for (const Metered& m : meters()) m.meter.end_pass(cycles);
}

/// The queues, by their instances in the Verilog.
std::vector<ShadowLane::Metered> ShadowLane::meters() {
  return {{"early_stage.texel_words.queue", early.texel_words.meter}, {"early_stage.tiles.queue", early.tiles.meter},
          {"lists.list_queue", lists.list_meter},          {"lists.next_queue", lists.next_meter},
          {"lists.response_queue", lists.response_meter},  {"slots", slots.meter}};
}

void ShadowLane::clear() {
  causes_.clear();
  for (const Metered& m : meters()) m.meter.clear();
}

void ShadowLane::trace(Timeline* timeline, const std::string& lane) {
  causes_.trace(timeline, lane);
  texel_port().trace(timeline, lane + ".texel_port");
  slb_port().trace(timeline, lane + ".slb_port");
  for (const Metered& m : meters()) m.meter.trace(timeline, lane + "." + m.queue);
}

void ShadowLane::add_queues(const std::string& lane, std::vector<QueueCycles>& queues) {
  for (const Metered& m : meters()) queues.push_back(m.meter.figures(lane + "." + m.queue));
}

}  // namespace kagesen::tlm_model::winding
