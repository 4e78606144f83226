#include "sim/systemc/winding/silhouette_buffer.h"

#include "model/unit/winding/plane.h"

namespace kagesen::tlm_model::winding {

using unit::winding::TexelVisit;

SilhouetteBuffer::SilhouetteBuffer(const sc_core::sc_module_name& name)
    : sc_module(name), records("records"), pool("record_pool"), cluster_("cluster_update", pool) {}

void SilhouetteBuffer::reset(const UnitConfig& config) {
  paper_ = config.semantics == Semantics::kPaper;
  chain_limit_ = static_cast<std::uint32_t>(config.chain_records);
  const unit::winding::Widths widths(config, kMaxFractionBits);
  base_bits_ = static_cast<unsigned>(widths.base_bits());
  code_bits_ = static_cast<unsigned>(widths.gradient_code_bits());
  records.reset(static_cast<unsigned>(config.record_lines));
  pool.clear(static_cast<std::uint32_t>(config.cluster_records));
  cluster_.reset(static_cast<std::uint32_t>(config.segments_per_record), chain_limit_);
  dropped_.clear();
  emptied_.clear();
  state_ = next_state_ = kIdle;
  starts_ = seen_ = false;
}

void SilhouetteBuffer::add_dropped(const std::vector<std::uint32_t>& numbers) {
  dropped_.insert(dropped_.end(), numbers.begin(), numbers.end());
}
void SilhouetteBuffer::add_emptied(
    const std::vector<unit::winding::SettleTrail::Emptied>& clusters) {
  emptied_.insert(emptied_.end(), clusters.begin(), clusters.end());
}
void SilhouetteBuffer::skip(const ListVisit& visit) {
  dropped_.erase(dropped_.begin(), dropped_.begin() + visit.texel.dropped);
  emptied_.erase(emptied_.begin(), emptied_.begin() + visit.emptied);
}

/// The bits of a plane and its object, in groups of five.
std::uint32_t SilhouetteBuffer::mark_of(const ListVisit& visit) const {
  const auto low = [](std::uint64_t value, unsigned bits) {
    return value & ((std::uint64_t{1} << bits) - 1);
  };
  const unit::winding::Threshold& t = visit.texel.threshold;
  unsigned __int128 plane = low(static_cast<std::uint32_t>(t.base), base_bits_);
  plane = plane << code_bits_ | low(t.gradient_x, code_bits_);
  plane = plane << code_bits_ | low(t.gradient_y, code_bits_);
  unsigned number = 0;
  for (; plane != 0; plane >>= 5) number ^= static_cast<unsigned>(plane) & 31;
  for (std::uint32_t object = visit.object; object != 0; object >>= 5) number ^= object & 31;
  return 1u << number;
}

void SilhouetteBuffer::start(const ListVisit& visit, const TexelState& texel) {
  visit_ = visit;
  texel_ = texel;
  starts_ = true;
}

bool SilhouetteBuffer::step(Cycle now) {
  if (state_ == kIdle && !starts_) {
    requests_ = {};
    requests_.lookup_end = true;
    moved_ = seen_ != records.hit();
    seen_ = records.hit();
    return false;
  }
  ListStep step(records, now);
  next_state_ = state_;
  moved_ = false;
  const State was = state_;
  const bool bounded = was == kWalk && mode_ >= kCovers && mode_ <= kSettle;
  const bool there = step.hit() && (!bounded || seen_);
  cause_ = was == kWalk && at_ == texel_.first && !step.hit() ? Cause::kRecord : Cause::kChain;
  switch (was) {
    case kIdle: begin(step); break;
    case kTake:
      next_state_ = insert_ ? kInsert : kCheck;
      if (!pool.spare_ready() && pool.free_valid()) {
        step.look_up(pool.free());
        next_state_ = kTaken;
      }
      break;
    case kTaken:
      if (!there) break;
      pool.take();
      next_state_ = insert_ ? kInsert : kCheck;
      break;
    case kCheck: check(step); break;
    case kOpen: open(step); break;
    case kInsert: insert(step); break;
    case kWalk:
      if (there) walk(step);
      break;
    case kWork: work(step); break;
    case kErase:
      if (there) erase(step);
      break;
    case kLink:
      if (there) link(step);
      break;
    case kLast:
      if (there) take_last(step);
      break;
    case kSpill: spill(step); break;
    case kKeep:
      note(visit_.texel.covers_nearest);
      next_state_ = kDone;
      break;
    case kDone: next_state_ = kIdle; break;
  }
  if (step.update && !step.written) cause_ = Cause::kWrite;
  requests_ = {step.lookup, was == kIdle, step.written, step.address, step.update_address};
  const bool seen = step.hit() && !step.lookup;
  moved_ = moved_ || starts_ || step.lookup || step.written || next_state_ != was || seen != seen_;
  seen_ = seen;
  if (step.lookup) at_ = step.address;
  starts_ = false;
  return was != kIdle && next_state_ == kIdle;
}

bool SilhouetteBuffer::clock(Cycle now) {
  const bool moved = moved_;
  state_ = next_state_;
  return records.step(now, requests_) || moved;
}

void SilhouetteBuffer::begin(ListStep& step) {
  mark_ = mark_of(visit_);
  texel_.bare = texel_.bare && texel_.kind == TexelState::kList;
  changed_ = insert_ = continued_ = false;
  count_ = 0;
  mode_ = kFind;
  next_state_ = kCheck;
  if (!pool.spare_ready()) {
    next_state_ = kTake;
  } else if (texel_.kind == TexelState::kList) {
    // A list without the mark has no cluster of the plane; nor can it be too long.
    const bool absent =
        !texel_.covered && (texel_.marks & mark_) == 0 && pool.used() < chain_limit_;
    if (visit_.settles || !absent) step.look_up(texel_.first);
    if (!visit_.settles && !texel_.covered && !visit_.nothing()) {
      next_state_ = absent ? kInsert : kWalk;
    }
  } else {
    next_state_ = texel_.kind == TexelState::kEmpty   ? kInsert
                  : texel_.kind == TexelState::kPlane ? kOpen
                                                      : kKeep;
  }
}

/// What the texel calls for.
void SilhouetteBuffer::check(ListStep& step) {
  continued_ = false;
  if (texel_.kind != TexelState::kList) {
    next_state_ = texel_.kind == TexelState::kEmpty   ? kInsert
                  : texel_.kind == TexelState::kPlane ? kOpen
                                                      : kKeep;
    return;
  }
  const TexelVisit::Behind behind = visit_.texel.behind;
  mode_ = kFind;
  if (visit_.settles) {
    mode_ = kSettle;
    prev_valid_ = false;
  } else if (texel_.covered && behind != TexelVisit::Behind::kNot) {
    mode_ = kCovers;
    if (behind == TexelVisit::Behind::kOfItsObject) {
      next_state_ = kDone;
      return;
    }
  } else if (visit_.nothing()) {
    next_state_ = kDone;
    return;
  }
  step.look_up(texel_.first);
  next_state_ = kWalk;
}

/// The cover becomes a cluster.
void SilhouetteBuffer::open(ListStep& step) {
  if (pool.full()) {
    next_state_ = kSpill;
  } else if (step.write(pool.spare())) {
    texel_ = {TexelState::kList, true, texel_.bare, texel_.marks, pool.give({true, false, false, 0, 0})};
    changed_ = insert_ = true;
    count_ = 1;
    next_state_ = kTake;
  }
}

/// A cluster of the visit's plane, in front.
void SilhouetteBuffer::insert(ListStep& step) {
  if (count_ >= chain_limit_ || pool.full()) {
    next_state_ = kSpill;
    return;
  }
  if (!step.write(pool.spare())) return;
  const bool empty = texel_.kind == TexelState::kEmpty;
  const bool segment = visit_.texel.segment && !visit_.span;
  texel_.first = pool.give({visit_.span, false, texel_.kind == TexelState::kList, segment, texel_.first});
  if (empty) {
    texel_.covered = false;
    texel_.marks = mark_;
  } else if (!texel_.covered) {
    texel_.marks |= mark_;
  }
  if (!visit_.span && !segment) texel_.bare = true;
  texel_.kind = TexelState::kList;
  changed_ = true;
  next_state_ = kDone;
  if (visit_.span) {
    note(visit_.texel.covers_nearest);
    drop_hidden(step);
  }
}

/// A walk begins again at the first record.
void SilhouetteBuffer::restart(ListStep& step, Mode mode) {
  mode_ = mode;
  continued_ = false;
  step.look_up(texel_.first);
  next_state_ = kWalk;
}

/// Clusters that are hidden go.
void SilhouetteBuffer::drop_hidden(ListStep& step) {
  prev_valid_ = false;
  dropped_left_ = visit_.texel.dropped;
  restart(step, paper_ ? kCoversDrop : kDrop);
}

void SilhouetteBuffer::walk(ListStep& step) {
  const Record record = pool[at_];
  if (!visit_record(step)) return;
  if (record.has_next) {
    continued_ = record.goes_on;
    step.look_up(record.next);
  } else {
    end_walk(step);
  }
}

/// Is the walk done with this record?
bool SilhouetteBuffer::visit_record(ListStep& step) {
  Record& record = pool[at_];
  switch (mode_) {
    case kFind:
      ++count_;
      if (continued_ || visit_.texel.found == TexelVisit::kNone ||
          pool.address_of(visit_.texel.found) != at_) {
        return true;
      }
      next_state_ = kWork;
      return false;
    case kDrop:
      chain_ = at_;
      if (!continued_ && dropped_left_ != 0 && pool.address_of(dropped_.front()) == at_) {
        --dropped_left_;
        dropped_.pop_front();
        next_state_ = kErase;
        return false;
      }
      prev_ = at_;
      prev_valid_ = true;
      return true;
    case kSettle:
      chain_ = at_;
      if (!continued_ && !record.full && record.count == 0) {
        if (!emptied_.front().covers) {
          emptied_.pop_front();
          next_state_ = kErase;
          return false;
        }
        if (!step.write(at_)) return false;
        record.full = true;
        note(emptied_.front().nearest);
        emptied_.pop_front();
      }
      prev_ = at_;
      prev_valid_ = true;
      return true;
    case kFree:
      if (!record.has_next) {
        if (!step.write(at_)) return false;
        pool.lead_to_free(record);
        record.goes_on = false;
      }
      pool.release();
      note(!continued_ && !texel_.covered);
      return true;
    case kCount:
      ++count_;
      return true;
    default:  // the covers' nearest end is golden's to say
      return true;
  }
}

void SilhouetteBuffer::end_walk(ListStep& step) {
  continued_ = false;
  switch (mode_) {
    case kFind: next_state_ = kInsert; break;
    case kCovers:
      mode_ = kFind;
      if (visit_.texel.behind == TexelVisit::Behind::kHidden || visit_.nothing()) {
        next_state_ = kDone;
      } else {
        step.look_up(texel_.first);
      }
      break;
    case kCoversDrop:
      mode_ = kDrop;
      prev_valid_ = false;
      step.look_up(texel_.first);
      break;
    case kDrop:
      step.look_up(texel_.first);
      next_state_ = kLast;
      break;
    case kSettle:
      next_state_ = kDone;
      texel_.bare = false;
      if (texel_.covered) drop_hidden(step);
      break;
    case kFree:
      pool.put(texel_.first);
      texel_.kind = TexelState::kOverflow;
      next_state_ = kKeep;
      break;
    case kCount: next_state_ = count_ > chain_limit_ ? kSpill : kDone; break;
  }
}

/// The cluster goes, its records from chain_ on. Those of an earlier one are linked to what follows.
void SilhouetteBuffer::erase(ListStep& step) {
  Record& record = pool[at_];
  if (record.goes_on) {
    pool.release();
    step.look_up(record.next);
    return;
  }
  if (!step.write(at_)) return;
  next_ = record.next;
  next_valid_ = record.has_next;
  pool.lead_to_free(record);
  pool.release();
  pool.put(chain_);
  continued_ = false;
  if (prev_valid_) {
    step.look_up(prev_);
    next_state_ = kLink;
    return;
  }
  next_state_ = kWalk;
  texel_.first = next_;
  changed_ = true;
  if (next_valid_) {
    step.look_up(next_);
  } else {
    texel_.kind = TexelState::kEmpty;
    next_state_ = kDone;
  }
}

void SilhouetteBuffer::link(ListStep& step) {
  if (!step.write(at_)) return;
  pool[at_].next = next_;
  pool[at_].has_next = next_valid_;
  next_state_ = kWalk;
  if (next_valid_) {
    step.look_up(next_);
  } else {
    end_walk(step);
  }
}

/// A cover alone needs no record.
void SilhouetteBuffer::take_last(ListStep& step) {
  Record& record = pool[at_];
  next_state_ = kDone;
  if (!record.full || record.has_next) return;
  next_state_ = kLast;
  if (!step.write(at_)) return;
  pool.lead_to_free(record);
  pool.release();
  pool.put(at_);
  texel_.kind = TexelState::kPlane;
  changed_ = true;
  next_state_ = kIdle;
}

/// No room: the texel keeps the nearest depth.
void SilhouetteBuffer::spill(ListStep& step) {
  changed_ = true;
  const TexelState::Kind kind = texel_.kind;
  texel_.covered = kind == TexelState::kPlane;
  if (kind == TexelState::kList) {
    restart(step, kFree);
  } else {
    texel_.kind = TexelState::kOverflow;
    next_state_ = kKeep;
  }
}

void SilhouetteBuffer::work(ListStep& step) {
  const ClusterUpdate::End end = cluster_.step(visit_, at_, step);
  moved_ = cluster_.changed();
  if (cluster_.bare()) {
    changed_ = changed_ || !texel_.bare;
    texel_.bare = true;
  }
  switch (end) {
    case ClusterUpdate::End::kNone: break;
    case ClusterUpdate::End::kDone: next_state_ = kDone; break;
    case ClusterUpdate::End::kEnds: next_state_ = kIdle; break;
    case ClusterUpdate::End::kCovers:
      note(visit_.texel.covers_nearest);
      drop_hidden(step);
      break;
    case ClusterUpdate::End::kGrown:
      count_ = 0;
      restart(step, kCount);
      break;
    case ClusterUpdate::End::kSpills: next_state_ = kSpill; break;
  }
}

}  // namespace kagesen::tlm_model::winding
