#include "sim/systemc/winding/cluster_update.h"

namespace kagesen::tlm_model::winding {

using unit::winding::TexelVisit;

ClusterUpdate::End ClusterUpdate::step(const ListVisit& visit, WordAddress at, ListStep& step) {
  const State before = state_;
  bare_ = false;
  const End end = work(visit, at, step);
  if (end != End::kNone) state_ = kFound;
  changed_ = end != End::kNone || state_ != before || step.lookup || step.written;
  return end;
}

ClusterUpdate::End ClusterUpdate::work(const ListVisit& visit, WordAddress at, ListStep& step) {
  if (state_ == kFull) {
    if (!step.write(head_)) return End::kNone;
    pool_[head_] = {true, false, next_valid_, 0, next_};
    return End::kCovers;
  }
  if (!step.hit()) return End::kNone;
  Record& record = pool_[at];
  switch (state_) {
    case kFound:
      return found(visit, at, step);
    case kAppend:
      if (record.count < room_) {
        if (!step.write(at)) return End::kNone;
        ++record.count;
        return End::kDone;
      }
      // The first record's segments move into a new one behind it.
      if (pool_.full()) return End::kSpills;
      if (step.write(pool_.spare())) {
        const Record moved = record;
        next_ = pool_.give(moved);
        state_ = kGrow;
      }
      return End::kNone;
    case kGrow:
      if (!step.write(at)) return End::kNone;
      record.count = 1;
      record.goes_on = record.has_next = true;
      record.next = next_;
      return pool_.used() > chain_limit_ ? End::kGrown : End::kDone;
    case kTrim:  // the records behind the first one go
      if (record.goes_on) {
        pool_.release();
        step.look_up(record.next);
      } else if (step.write(at)) {
        pool_.release();
        next_ = record.next;
        next_valid_ = record.has_next;
        pool_.lead_to_free(record);
        pool_.put(link_);
        state_ = kFull;
      }
      return End::kNone;
    case kScan:
      scan(visit, at, step);
      return End::kNone;
    case kCorner:
      return step.write(at) ? End::kDone : End::kNone;
    case kCut:
    case kLift:
      return take_away(at, step);
    case kPatch:
      if (!step.write(at)) return End::kNone;
      if (!refill_) return End::kDone;
      step.look_up(next_);
      state_ = kRefill;
      return End::kNone;
    case kRefill:
      if (step.write(head_)) {
        pool_[head_] = record;
        state_ = kRelease;
      }
      return End::kNone;
    default:  // kRelease
      if (!step.write(at)) return End::kNone;
      pool_.lead_to_free(record);
      pool_.release();
      pool_.put(at);
      return End::kDone;
  }
}

ClusterUpdate::End ClusterUpdate::found(const ListVisit& visit, WordAddress at, ListStep& step) {
  Record& record = pool_[at];
  head_ = at;
  next_ = link_ = record.next;
  next_valid_ = record.has_next;
  passed_ = 0;
  if (record.full) return End::kDone;
  if (visit.span) {
    if (record.goes_on) step.look_up(record.next);
    state_ = record.goes_on ? kTrim : kFull;
    return End::kNone;
  }
  if (visit.texel.corner_full) return End::kSpills;
  if (visit.texel.segment && visit.texel.may_meet) {
    state_ = kScan;
  } else if (!visit.texel.segment || record.count < room_) {
    if (!step.write(at)) return End::kNone;
    record.count = static_cast<std::uint8_t>(record.count + visit.texel.segment);
    return End::kEnds;
  } else {
    state_ = kAppend;
  }
  return End::kNone;
}

/// Does the visit's segment meet one of this record's?
void ClusterUpdate::scan(const ListVisit& visit, WordAddress at, ListStep& step) {
  const Record& record = pool_[at];
  const TexelVisit::Meeting& meeting = visit.texel.meeting;
  link_ = at;
  passed_ += record.count;
  if (meeting.what != TexelVisit::Meeting::kNothing && meeting.before < passed_) {
    state_ = !meeting.cancels() ? kCorner : at == head_ ? kCut : kLift;
  } else if (record.goes_on) {
    step.look_up(record.next);
    return;
  } else {
    state_ = kAppend;
  }
  step.look_up(head_);
}

/// The cluster's last segment takes the place of the cancelled one, in the first record or in link_.
ClusterUpdate::End ClusterUpdate::take_away(WordAddress at, ListStep& step) {
  if (!step.write(at)) return End::kNone;
  Record& record = pool_[at];
  --record.count;
  refill_ = record.count == 0 && record.goes_on;
  bare_ = record.count == 0 && !record.goes_on;
  next_ = record.next;
  if (state_ == kLift) {
    step.look_up(link_);
    state_ = kPatch;
  } else if (refill_) {
    step.look_up(next_);
    state_ = kRefill;
  } else {
    return End::kDone;
  }
  return End::kNone;
}

}  // namespace kagesen::tlm_model::winding
