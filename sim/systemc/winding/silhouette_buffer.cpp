#include "sim/systemc/winding/silhouette_buffer.h"

namespace kagesen::tlm_model::winding {

using unit::winding::TexelVisit;

SilhouetteBuffer::SilhouetteBuffer(const sc_core::sc_module_name& name)
    : sc_module(name),
      records("records"),
      pool("record_pool"),
      walk("list_walk", pool, texel),
      cluster("cluster_update", pool) {}

void SilhouetteBuffer::reset(const UnitConfig& config) {
  paper_ = config.semantics == Semantics::kPaper;
  chain_limit_ = static_cast<std::uint32_t>(config.chain_records);
  records.reset(static_cast<unsigned>(config.record_lines));
  pool.clear(static_cast<std::uint32_t>(config.cluster_records));
  texel.reset(config);
  walk.reset();
  cluster.reset(static_cast<std::uint32_t>(config.segments_per_record), chain_limit_);
  state_ = next_state_ = kIdle;
  starts_ = seen_ = false;
}

void SilhouetteBuffer::start(const ListVisit& visit, const TexelState& before) {
  visit_ = visit;
  texel.load(before, visit);
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
  moved_ = starts_;
  const State was = state_;
  cause_ = was == kWalk && walk.at_first(at_) && !step.hit() ? Cause::kRecord : Cause::kChain;
  switch (was) {
    case kIdle: begin(step); break;
    case kTake: take(step); break;
    case kTaken:
      if (!step.hit()) break;
      pool.take();
      next_state_ = insert_ ? kInsert : kCheck;
      break;
    case kCheck: check(step); break;
    case kOpen: open(step); break;
    case kInsert: insert(step); break;
    case kWalk:
      if (!step.hit() || (walk.bounded() && !seen_)) break;
      go_on(walk.step(visit_, at_, step), step);
      moved_ = walk.changed();
      break;
    case kWork:
      go_on(cluster.step(visit_, at_, step), step);
      moved_ = cluster.changed();
      break;
    case kLast:
      if (step.hit()) take_last(step);
      break;
    case kSpill: spill(step); break;
    case kKeep:
      texel.note(visit_.texel.covers_nearest);
      next_state_ = kDone;
      break;
    case kDone: next_state_ = kIdle; break;
  }
  if (step.update && !step.written) cause_ = Cause::kWrite;
  requests_ = {step.lookup, was == kIdle, step.written, step.address, step.update_address};
  const bool seen = step.hit() && !step.lookup;
  moved_ = moved_ || step.lookup || step.written || next_state_ != was || seen != seen_;
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

/// What a texel calls for that is no list.
SilhouetteBuffer::State SilhouetteBuffer::first_state(TexelState::Kind kind) {
  return kind == TexelState::kEmpty ? kInsert : kind == TexelState::kPlane ? kOpen : kKeep;
}

void SilhouetteBuffer::begin(ListStep& step) {
  insert_ = false;
  walk.start(0);
  if (!pool.spare_ready()) {
    next_state_ = kTake;
  } else if (texel.kind != TexelState::kList) {
    next_state_ = first_state(texel.kind);
  } else {
    // A list without the mark has no cluster of the plane; nor can it be too long.
    const bool absent = texel.unmarked() && pool.used() < chain_limit_;
    if (visit_.settles || !absent) step.look_up(texel.first);
    next_state_ = visit_.settles || texel.covered || visit_.nothing() ? kCheck
                  : absent                                            ? kInsert
                                                                      : kWalk;
    if (next_state_ == kWalk) walk.begin(ListWalk::kFind, visit_);
  }
}

/// A spare record, before all else.
void SilhouetteBuffer::take(ListStep& step) {
  next_state_ = insert_ ? kInsert : kCheck;
  if (!pool.spare_ready() && pool.free_valid()) {
    step.look_up(pool.free());
    next_state_ = kTaken;
  }
}

void SilhouetteBuffer::check(ListStep& step) {
  const bool behind = texel.covered && visit_.texel.behind != TexelVisit::Behind::kNot;
  if (texel.kind != TexelState::kList) {
    next_state_ = first_state(texel.kind);
  } else if (visit_.settles) {
    begin_walk(step, ListWalk::kSettle);
  } else if (behind ? visit_.texel.behind == TexelVisit::Behind::kOfItsObject : visit_.nothing()) {
    next_state_ = kDone;
  } else {
    begin_walk(step, behind ? ListWalk::kCovers : ListWalk::kFind);
  }
}

void SilhouetteBuffer::begin_walk(ListStep& step, ListWalk::Mode mode) {
  walk.begin(mode, visit_);
  step.look_up(texel.first);
  next_state_ = kWalk;
}

/// The cover becomes a cluster.
void SilhouetteBuffer::open(ListStep& step) {
  if (pool.full()) {
    next_state_ = kSpill;
  } else if (step.write(pool.spare())) {
    texel.open(pool.give({true, false, false, 0, 0}));
    walk.start(1);
    insert_ = true;
    next_state_ = kTake;
  }
}

/// A cluster of the visit's plane, in front.
void SilhouetteBuffer::insert(ListStep& step) {
  if (walk.count() >= chain_limit_ || pool.full()) {
    next_state_ = kSpill;
    return;
  }
  if (!step.write(pool.spare())) return;
  const bool segment = visit_.texel.segment && !visit_.span;
  const bool follows = texel.kind == TexelState::kList;
  texel.insert(pool.give({visit_.span, false, follows, segment, texel.first}),
               !visit_.span && !segment);
  next_state_ = kDone;
  if (visit_.span) {
    texel.note(visit_.texel.covers_nearest);
    drop_hidden(step);
  }
}

/// After a walk.
void SilhouetteBuffer::go_on(ListWalk::End end, ListStep& step) {
  if (end == ListWalk::End::kNone) return;
  if (end == ListWalk::End::kFound) {
    next_state_ = kWork;
    return;
  }
  if (end == ListWalk::End::kEmptied) {
    texel.become(TexelState::kEmpty);
    next_state_ = kDone;
    return;
  }
  switch (walk.mode()) {
    case ListWalk::kFind: next_state_ = kInsert; break;
    case ListWalk::kCovers:
      if (visit_.texel.behind == TexelVisit::Behind::kHidden || visit_.nothing()) {
        next_state_ = kDone;
      } else {
        begin_walk(step, ListWalk::kFind);
      }
      break;
    case ListWalk::kCoversDrop: begin_walk(step, ListWalk::kDrop); break;
    case ListWalk::kDrop:
      step.look_up(texel.first);
      next_state_ = kLast;
      break;
    case ListWalk::kSettle:
      texel.bare = false;
      next_state_ = kDone;
      if (texel.covered) drop_hidden(step);
      break;
    case ListWalk::kFree:
      pool.put(texel.first);
      texel.become(TexelState::kOverflow);
      next_state_ = kKeep;
      break;
    case ListWalk::kCount: next_state_ = walk.count() > chain_limit_ ? kSpill : kDone; break;
  }
}

/// After work on the visit's cluster.
void SilhouetteBuffer::go_on(ClusterUpdate::End end, ListStep& step) {
  if (cluster.bare()) texel.lay_bare();
  switch (end) {
    case ClusterUpdate::End::kNone: break;
    case ClusterUpdate::End::kDone: next_state_ = kDone; break;
    case ClusterUpdate::End::kEnds: next_state_ = kIdle; break;
    case ClusterUpdate::End::kCovers:
      texel.note(visit_.texel.covers_nearest);
      drop_hidden(step);
      break;
    case ClusterUpdate::End::kGrown: begin_walk(step, ListWalk::kCount); break;
    case ClusterUpdate::End::kSpills: next_state_ = kSpill; break;
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
  texel.become(TexelState::kPlane);
  next_state_ = kIdle;
}

/// No room: the texel keeps the nearest depth.
void SilhouetteBuffer::spill(ListStep& step) {
  texel.changed = true;
  texel.covered = texel.kind == TexelState::kPlane;
  if (texel.kind == TexelState::kList) {
    begin_walk(step, ListWalk::kFree);
  } else {
    texel.become(TexelState::kOverflow);
    next_state_ = kKeep;
  }
}

}  // namespace kagesen::tlm_model::winding
