#include "sim/systemc/paper/shadow_lane.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace kagesen::tlm_model::paper {

ShadowLane::ShadowLane(const sc_core::sc_module_name& name)
    : sc_module(name), slots("lane_slots"), texels("texel_buffers"), slb("silhouette_buffer") {}

void ShadowLane::begin_pass(const Pass& pass) {
  pass_ = pass;
  slots.begin_pass(pass.slots, pass.verdicts);
  texels.begin_pass(pass.texel_bytes, pass.pitch_log2);
  slb.begin_pass(pass.slots, pass.slb_bytes);
  early_.assign(pass.slots, kNever);
  fragments_ = 0;
  accepted_ = placed_ = unblamed_ = 0;
}

void ShadowLane::take() {
  const std::uint32_t slot = slots.slot_of(fragments_);
  const unit::FragmentTrail& trail = slb.walk(slot).trail;
  // The first one is offered from the cycle before the pass on.
  const Cycle first = fragments_ == 0 ? kNever : accepted_ + 1;
  Cycle offered = pass_.offers.next(first);
  if (offered == kNever) offered = 0;
  accepted_ = std::max({offered, unblamed_, placed_});
  blame(placed_, LaneCause::kTexelPort);
  blame(accepted_, LaneCause::kInput);
  blame(accepted_ + 1, LaneCause::kFragment);
  if (pass_.cycles) pass_.cycles[fragments_ * pass_.stride].accepted = accepted_;
  ++fragments_;
  slots.open(slot, accepted_);
  if (!trail.reads_texel) {
    placed_ = TexelBuffers::place(accepted_);
    early_[slot] = kNever;
    slots.decide(slot, placed_);
    return;
  }
  placed_ = texels.place_to_read(accepted_);
  const Cycle early = texels.read(placed_, trail.x, trail.y);
  early_[slot] = early;
  if (trail.records.empty()) {
    slots.decide(slot, early);
  } else {
    slb.look_up(early, slot);
  }
}

/// The oldest fragment leaves. Returns the cycle from which on its slot counts as free.
Cycle ShadowLane::retire() {
  const std::uint64_t oldest = slots.retired();
  while (!slots.decided(slots.slot_of(oldest))) {
    if (slb.idle()) stuck(oldest);
    const SilhouetteBuffer::Step step = slb.step();
    if (step.last) slots.decide(step.slot, step.decided);
  }
  const Cycle fetched = slots.retire();
  if (pass_.cycles) pass_.cycles[oldest * pass_.stride].retired = slots.last_taken();
  return fetched + 1;
}

/// The oldest fragment waits, and nothing is under way that could decide it.
void ShadowLane::stuck(std::uint64_t oldest) {
  const SilhouetteBuffer::Walk& walk = slb.walk(slots.slot_of(oldest));
  std::string text = std::string(name()) + ": stuck. Fragment " + std::to_string(oldest) +
                     " has read " + std::to_string(walk.reads.size()) + " of " +
                     std::to_string(walk.trail.records.size()) + " records";
  if (!walk.reads.empty()) text += ", the last one until cycle " + std::to_string(walk.reads.back().responded);
  text += "; " + std::to_string(fragments_ - oldest) + " fragments in flight, no read is asked for";
  throw std::logic_error(text);
}

/// Waits for the slot of the next fragment.
void ShadowLane::free_slot() {
  const std::uint32_t oldest = slots.slot_of(slots.retired());
  const Cycle free = retire();
  if (free > unblamed_) blame_oldest(oldest, free);
}

/// No slot is free in the cycles up to `to`: what keeps the oldest fragment?
void ShadowLane::blame_oldest(std::uint32_t oldest, Cycle to) {
  const auto until = [&](Cycle end, LaneCause why) { blame(std::min(end, to), why); };
  if (early_[oldest] != kNever) {
    until(early_[oldest], LaneCause::kTexel);
    until(early_[oldest] + 1, LaneCause::kDecision);
    for (const MemoryPort::Read& read : slb.walk(oldest).reads) {
      until(read.accepted + 1, LaneCause::kSlbPort);
      until(read.responded + 1, LaneCause::kSlb);
      until(slb.decision.decided(read.responded) + 1, LaneCause::kDecision);
    }
  } else {
    until(slots.done(oldest), LaneCause::kTexel);
  }
  until(to, LaneCause::kVerdict);
}

void ShadowLane::drain() {
  if (fragments_ >= slots.count()) free_slot();
  while (slots.retired() < fragments_) retire();
}

void ShadowLane::end_pass(Cycle all_taken, Cycle cycles) {
  blame(std::min(placed_, cycles), LaneCause::kTexelPort);
  blame(std::min(all_taken, cycles), LaneCause::kInput);
  blame(cycles, LaneCause::kDrain);
  for (QueueMeter* meter : {&slots.meter, &slb.lookup_meter, &slb.more_meter}) {
    meter->end_pass(cycles);
  }
}

void ShadowLane::clear() {
  causes_.clear();
  for (QueueMeter* meter : {&slots.meter, &slb.lookup_meter, &slb.more_meter}) meter->clear();
}

void ShadowLane::trace(Timeline* timeline, const std::string& lane) {
  causes_.trace(timeline, lane);
  texel_port().trace(timeline, lane + ".texel_port");
  slb_port().trace(timeline, lane + ".slb_port");
  slots.meter.trace(timeline, lane + ".slots");
  slb.lookup_meter.trace(timeline, lane + ".lookup_fifo");
  slb.more_meter.trace(timeline, lane + ".more_fifo");
}

void ShadowLane::add_queues(const std::string& lane, std::vector<QueueCycles>& queues) const {
  queues.push_back(slots.meter.figures(lane + ".slots"));
  queues.push_back(slb.lookup_meter.figures(lane + ".lookup_fifo"));
  queues.push_back(slb.more_meter.figures(lane + ".more_fifo"));
}

}  // namespace kagesen::tlm_model::paper
