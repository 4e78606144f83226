#include "sim/systemc/paper/record_walk.h"

namespace kagesen::tlm_model::paper {

void RecordWalk::wipe(const UnitConfig& config) {
  const auto buckets = static_cast<RecordAddress>(config.slb_buckets);
  bucket_mask_ = buckets - 1;
  record_limit_ = static_cast<std::uint32_t>(config.slb_entries);
  chain_limit_ = static_cast<std::uint32_t>(config.link_depth);
  lines_ = static_cast<std::uint8_t>(config.lines_per_entry);
  wants_hiding_ = config.hidden_removal != HiddenRemoval::kOff;
  records_.assign(std::size_t{buckets} + record_limit_, {});
  pool_.begin(buckets, record_limit_);
  state_ = SlbState::kIdle;
}

SlbFacts RecordWalk::facts(bool hit, bool texel_hit) const {
  const SlbRecord& record = records_[at_];
  const Operation& o = operation_;
  SlbFacts f{};
  f.hit = hit;
  f.texel_hit = texel_hit;
  f.at = at_;
  f.is_edge = o.kind == Operation::kEdge;
  f.edge_flag = f.is_edge ? o.edge.edge : o.emptied.edge;
  f.overflow = f.is_edge && o.edge.overflow;
  f.hidden = f.is_edge && o.edge.hidden;
  f.covered = o.emptied.covered;
  f.same_texel = record.used && record.texel == tag(walk_.word_x);
  f.same_entry = f.same_texel && record.object == o.object;
  f.match = f.is_edge && o.edge.cancelled >= 0 &&
            static_cast<std::uint32_t>(o.edge.cancelled) / lines_ == walk_.record;
  f.beyond_it = record.nearest > o.edge.nearest;
  f.before_it = record.nearest < o.edge.nearest;
  f.nearer = record.count == 0 || f.beyond_it;
  f.new_corner = o.edge.corner && !record.corner;
  f.new_vertex = o.edge.vertex && !record.vertex;
  f.room = record.count != lines_;
  f.erasable = (o.kind == Operation::kSpan ? o.hide_depth[walk_.word_x] : o.emptied.hide_depth) <
               record.nearest;
  f.full = pool_.used() == record_limit_;
  f.few = pool_.used() < chain_limit_;
  f.short_chain = f.few || (!walk_.continued && walk_.length < chain_limit_);
  f.too_long = walk_.length > chain_limit_;
  f.edges = o.edges;
  f.wants_hiding = wants_hiding_;
  f.spot = pool_.spot();
  f.has_spot = pool_.has_spot();
  f.dry = pool_.dry();
  f.free = pool_.free();
  f.has_free = pool_.has_free();
  return f;
}

const SlbStep& RecordWalk::plan(bool hit, bool texel_hit) {
  const SlbFacts f = facts(hit, texel_hit);
  const SlbRecord& record = records_[at_];
  next_state_ = state_;
  next_walk_ = walk_;
  SlbWalk& w = next_walk_;
  step_ = state_ < SlbState::kScan     ? chain_find(next_state_, w, f, record)
          : state_ < SlbState::kBehind ? entry_lines(next_state_, w, f, record)
          : state_ < SlbState::kJudge  ? entry_move(next_state_, w, f, record)
                                       : chain_erase(next_state_, w, f, record);
  if (step_.restart) {
    next_state_ = SlbState::kFind;
    step_.look_address = w.place = w.own;
    w.has_prev = w.push = w.placed = w.seen = w.continued = false;
    w.length = 0;
  }
  if (step_.spread) {
    if (w.todo == 0) step_.last = true;
    const unsigned next = w.todo & 1 ? 0 : w.todo & 2 ? 1 : w.todo & 4 ? 2 : 3;
    w.own = (w.own + ((next - w.word_x) & 3)) & bucket_mask_;
    w.word_x = next;
    w.mode = Erase::kHidden;
    w.todo &= ~(1u << next);
  }
  if (step_.walk || step_.spread) {
    next_state_ = SlbState::kWalk;
    step_.look = true;
    step_.look_address = w.own;
    w.has_prev = w.kept = false;
  }
  step_.touch = step_.touch || step_.stored;
  if (step_.last) next_state_ = SlbState::kIdle;
  return step_;
}

void RecordWalk::fire() {
  const SlbRecord looked_up = records_[at_];
  if (step_.write) records_[step_.write_address] = written();
  pool_.step(step_, looked_up);
  if (step_.look && !step_.last) at_ = step_.look_address;
  state_ = next_state_;
  walk_ = next_walk_;
}

SlbRecord RecordWalk::written() const {
  SlbRecord record = records_[at_];
  if (step_.unused_record) return {};
  if (step_.fresh) {
    record.used = true;
    record.has_next = record.has_more = false;
    record.count = 0;
    record.corner = false;
    record.texel = tag(static_cast<std::uint32_t>(operation_.x) & 3);
    record.object = operation_.object;
  }
  if (step_.set_next) {
    record.has_next = step_.link_has;
    record.next = step_.link_address;
  }
  if (step_.set_more) {
    record.has_more = step_.more_has;
    record.more = step_.more_address;
  }
  if (step_.fresh || step_.set_nearest) record.nearest = operation_.edge.nearest;
  record.corner = record.corner || (step_.set_corner && operation_.edge.corner);
  const bool vertex = record.vertex && record.count != 0;
  if (step_.fresh) record.vertex = false;
  if (step_.set_vertex) record.vertex = vertex || operation_.edge.vertex;
  if (step_.append) {
    ++record.count;
  } else if (step_.remove && !step_.refill) {
    --record.count;
  }
  return record;
}

void RecordWalk::start(const Operation& operation) {
  operation_ = operation;
  state_ = operation.kind == Operation::kSpan ? SlbState::kSpan : SlbState::kFind;
  at_ = operation.bucket;
  walk_ = SlbWalk{};
  walk_.word_x = static_cast<unsigned>(operation.x) & 3;
  walk_.own = walk_.place = operation.bucket;
}

}  // namespace kagesen::tlm_model::paper
