#include "sim/systemc/winding/list_walk.h"

namespace kagesen::tlm_model::winding {

using unit::winding::TexelVisit;

ListWalk::End ListWalk::step(const ListVisit& visit, WordAddress at, ListStep& step) {
  const State before = state_;
  End end = End::kNone;
  if (state_ == kWalk) {
    end = walk(visit, at, step);
  } else if (state_ == kErase) {
    end = erase(at, step);
  } else if (step.write(at)) {  // an earlier cluster is linked to what follows
    pool_[at].next = next_;
    pool_[at].has_next = next_valid_;
    state_ = kWalk;
    if (next_valid_) step.look_up(next_);
    if (!next_valid_) end = End::kEnded;
  }
  changed_ = end != End::kNone || state_ != before || step.lookup || step.written;
  return end;
}

ListWalk::End ListWalk::walk(const ListVisit& visit, WordAddress at, ListStep& step) {
  const Record record = pool_[at];
  switch (mode_) {
    case kFind:
      ++count_;
      if (!continued_ && visit.texel.found != TexelVisit::kNone &&
          pool_.address_of(visit.texel.found) == at) {
        return End::kFound;
      }
      break;
    case kCovers:
    case kCoversDrop: break;  // which end nearest golden knows
    case kDrop:
      chain_ = at;
      if (!continued_ && dropped_left_ != 0 && pool_.address_of(dropped_.front()) == at) {
        --dropped_left_;
        dropped_.pop_front();
        state_ = kErase;
        return End::kNone;
      }
      break;
    case kSettle:
      chain_ = at;
      if (!continued_ && !record.full && record.count == 0 && !settle(at, step)) return End::kNone;
      break;
    case kFree:
      if (!record.has_next) {
        if (!step.write(at)) return End::kNone;
        pool_.lead_to_free(pool_[at]);
        pool_[at].goes_on = false;
      }
      pool_.release();
      texel_.note(!continued_ && !texel_.covered);
      break;
    case kCount: ++count_; break;
  }
  prev_ = at;
  prev_valid_ = true;
  if (!record.has_next) return End::kEnded;
  continued_ = record.goes_on;
  step.look_up(record.next);
  return End::kNone;
}

/// A cluster without segments covers the texel now, or goes. Does the walk go on?
bool ListWalk::settle(WordAddress at, ListStep& step) {
  if (!emptied_.front().covers) {
    emptied_.pop_front();
    state_ = kErase;
    return false;
  }
  if (!step.write(at)) return false;
  pool_[at].full = true;
  texel_.note(emptied_.front().nearest);
  emptied_.pop_front();
  return true;
}

/// The cluster goes, its records from chain_ on.
ListWalk::End ListWalk::erase(WordAddress at, ListStep& step) {
  Record& record = pool_[at];
  if (record.goes_on) {
    pool_.release();
    step.look_up(record.next);
    return End::kNone;
  }
  if (!step.write(at)) return End::kNone;
  next_ = record.next;
  next_valid_ = record.has_next;
  pool_.lead_to_free(record);
  pool_.release();
  pool_.put(chain_);
  continued_ = false;
  if (prev_valid_) {
    step.look_up(prev_);
    state_ = kLink;
    return End::kNone;
  }
  state_ = kWalk;
  texel_.first = next_;
  texel_.changed = true;
  if (!next_valid_) return End::kEmptied;
  step.look_up(next_);
  return End::kNone;
}

}  // namespace kagesen::tlm_model::winding
