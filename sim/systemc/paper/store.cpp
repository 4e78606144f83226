#include "sim/systemc/paper/store.h"

#include <algorithm>

#include "model/golden.h"
#include "model/unit/address_generator.h"

namespace kagesen::tlm_model::paper {
namespace {

constexpr std::size_t kComing = 2, kEmptiedAhead = 32;

}  // namespace

Store::Store(const sc_core::sc_module_name& name)
    : sc_module(name), texels("texel_buffers"), records("record_buffer"), walk_("silhouette_buffer") {}

void Store::reset(const UnitConfig& config) {
  config_ = config;
  pitch_log2_ =
      static_cast<unsigned>(bits_for(static_cast<std::uint64_t>((config.map_width + 3) / 4)));
  texels.cache.reset(static_cast<unsigned>(config.texel_lines), true);
  records.cache.reset(static_cast<unsigned>(config.record_lines), false);
  coming_.reset(kComing);
  visits_.reset(static_cast<std::size_t>(config.visit_fifo_depth));
  emptied_.reset(~std::size_t{0});
  soon_.reset(kEmptiedAhead);
  closing_ = 0;
  links_.reset(static_cast<unsigned>(config.record_lines));
  spans_.reset(static_cast<unsigned>(config.texel_lines),
               static_cast<RecordAddress>(config.slb_buckets) - 1);
  edges_.assign(static_cast<std::size_t>(config.map_height) << pitch_log2_, 0);
  meter_.reset(config);
}

void Store::begin_pass(unsigned texel_bytes, const Stalls& texel_writes, unsigned record_bytes,
                       const Stalls& record_writes) {
  texels.begin_pass(texel_bytes, texel_writes);
  records.begin_pass(record_bytes, record_writes);
  now_ = 0;
  unchanged_ = false;
  meter_.begin_pass();
}

/// The first cycle clears what is on chip.
Cycle Store::wipe() {
  walk_.wipe(config_);
  texels.cache.clear();
  records.cache.clear();
  const auto words = static_cast<std::uint32_t>(config_.map_height) << pitch_log2_;
  const auto buckets = static_cast<std::uint32_t>(config_.slb_buckets);
  return std::max({texels.wipe(1, words), records.wipe(1, buckets),
                   static_cast<Cycle>(links_.wipe_cycles()) + 1}) + 1;
}

void Store::begin(const unit::TriangleTrail& triangle) {
  triangle_ = &triangle;
  next_visit_ = next_hiding_ = 0;
}

Operation Store::operation_of(const Visit& visit) {
  Operation o;
  o.x = visit.x;
  o.y = visit.y;
  o.object = triangle_->object;
  const auto x = static_cast<std::uint32_t>(visit.x), y = static_cast<std::uint32_t>(visit.y);
  o.bucket = unit::bucket_of(x, y, static_cast<std::uint32_t>(config_.slb_buckets));
  o.word = y << pitch_log2_ | x >> 2;
  switch (visit.kind) {
    case Visit::kEdge:
      o.edge = triangle_->visits[next_visit_++];
      if (o.edge.emptied >= 0) {
        o.emptied = triangle_->emptied[static_cast<std::size_t>(o.edge.emptied)];
      }
      break;
    case Visit::kSpan:
      o.kind = Operation::kSpan;
      o.mask = visit.mask;
      for (; next_hiding_ < triangle_->hiding.size(); ++next_hiding_) {
        const unit::TriangleTrail::Hiding& h = triangle_->hiding[next_hiding_];
        if (h.y != visit.y || h.x < visit.x || h.x > visit.x + 3) break;
        const auto i = static_cast<unsigned>(h.x - visit.x);
        o.edges |= 1u << i;
        o.hide_depth[i] = h.hide_depth;
      }
      break;
    default:
      o.kind = Operation::kEdgesDone;
  }
  return o;
}

Cycle Store::take(const Visit& visit, Cycle offered) {
  pass_over(offered);
  const bool begins = visit.kind == Visit::kBegin;
  const Operation operation = begins ? Operation{} : operation_of(visit);
  while (!step(&operation, begins)) {
    if (unchanged_) pass_over(kNever);
  }
  return now_ - 1;
}

bool Store::ready(Cycle) { return false; }  // the paper profile's front never asks

Cycle Store::finish(Cycle front_idle) {
  pass_over(front_idle);
  while (!idle()) {
    step(nullptr, false);
    if (unchanged_) pass_over(kNever);
  }
  step(nullptr, false);
  return now_;
}

bool Store::active() const {
  return !(coming_.empty() && visits_.empty() && emptied_.empty() && soon_.empty()) || walk_.busy();
}
bool Store::idle() const { return !active() && texels.cache.idle() && records.cache.idle(); }

/// Cycles up to `until` without a visit at the input; if the last one changed nothing, to the next
/// in which a memory does something at once. kNever: only that.
void Store::pass_over(Cycle until) {
  while (now_ < until) {
    if (unchanged_) {
      const Cycle next = std::min({until, texels.next(now_), records.next(now_)});
      if (next == kNever) meter_.stuck(name(), now_, cause_, words());
      count(cause_, next - now_);
      now_ = next;
      unchanged_ = false;
      if (until == kNever) return;
    } else if (until == kNever) {
      return;
    } else {
      step(nullptr, false);
    }
  }
}

/// One cycle. @param offered  null: no visit is  @return is it taken?
bool Store::step(const Operation* offered, bool begins) {
  LineCache::Inputs texel = texels.inputs(now_), record = records.inputs(now_);

  // ---- The operation's step ----
  const bool busy = walk_.busy(), first = busy && walk_.first();
  const bool texel_hit = texels.cache.hit();
  bool fire = false, last = false, look = false, look_new = false, emptied = false, acts = false;
  RecordLinks::Inputs link;
  cause_ = StoreCause::kInput;
  if (busy) {
    const SlbStep& s = walk_.plan(records.cache.hit(), texel_hit);
    const Operation& o = walk_.operation();
    const bool record_ready =
        !s.write || records.cache.update_ready(s.write_address, record.write_ready, record.read_ready);
    const bool texel_ready =
        !s.touch || (texel_hit && texels.cache.update_ready(o.word, texel.write_ready, texel.read_ready));
    acts = s.act;
    fire = s.act && record_ready && texel_ready;
    last = fire && s.last;
    look = fire && s.look && !s.last;
    look_new = s.look_new;
    texel.update = fire && s.touch;
    texel.update_address = o.word;
    record.update = fire && s.write;
    record.update_address = s.write_address;
    record.lookup_address = s.look_address;
    const bool writes = s.act && s.write && texel_ready;
    link.learn = writes ? record_ready : records.cache.hit();
    link.learn_address = writes ? s.write_address : walk_.at();
    if (link.learn) link.known = writes ? walk_.written() : walk_.record(walk_.at());
    if (texel.update && (s.set_edge || s.stored)) {
      const unsigned bit = 1u << walk_.texel();
      std::uint8_t& flags = edges_[o.word];
      flags = static_cast<std::uint8_t>(s.stored || s.edge_flag ? flags | bit : flags & ~bit);
    }
    emptied = fire && s.emptied;
    cause_ = last ? (o.kind == Operation::kEdge   ? StoreCause::kEdge
                     : o.kind == Operation::kSpan ? StoreCause::kSpan
                                                  : StoreCause::kOther)
             : first && !acts ? (texel_hit ? StoreCause::kRecord : StoreCause::kTexel)
             : acts && !fire  ? StoreCause::kWrite
                              : StoreCause::kChain;
  }

  // ---- The next operation ----
  const bool edges_done = visits_.valid() && visits_.front().kind == Operation::kEdgesDone;
  if (!busy && edges_done) cause_ = StoreCause::kOther;
  const bool ready = !busy || last;
  const bool no_emptied = emptied_.empty() && soon_.empty() && !emptied;
  const bool start = ready && (edges_done ? soon_.valid() : visits_.valid());
  const bool take_emptied = edges_done && start;
  const bool take_visit = ready && (edges_done ? no_emptied : visits_.valid());
  const Operation* const next =
      start ? (edges_done ? &soon_.front() : &visits_.front()) : nullptr;
  texel.lookup = start;
  texel.lookup_end = last;
  record.lookup = start ? next->kind != Operation::kSpan : look;
  record.lookup_new = !start && look_new;
  record.lookup_end = last;
  if (start) {
    texel.lookup_address = next->word;
    record.lookup_address = next->bucket;
  }

  // ---- Hints, and the visit that is offered ----
  const bool record_hint_ready = records.cache.hint_ready(record);
  const bool hints_ready = texels.cache.hint_ready(texel) && record_hint_ready;
  const bool hint_emptied = emptied_.valid() && soon_.ready() && closing_ != 0;
  const bool taken = offered != nullptr && coming_.ready();
  const bool hints = hint_emptied && hints_ready;
  const bool enter = coming_.valid() && visits_.ready() && hints_ready && !hint_emptied;
  const Operation& entering = coming_.front();  // if any enters
  const Operation* const hinted = hints ? &emptied_.front() : &entering;
  texel.hint = hints || (enter && entering.kind != Operation::kEdgesDone);
  const bool visit_hint = hints || (enter && entering.kind == Operation::kEdge);
  if (texel.hint) texel.hint_address = hinted->word;
  link.hint = visit_hint;
  link.hint_ready = record_hint_ready;
  link.hint_address = visit_hint ? hinted->bucket : 0;
  if (record.response) {
    link.came = &walk_.record(records.cache.address_of(record.response_line));
  }
  link.active = active();
  link.soon = spans_.valid();
  if (link.soon) link.soon_address = spans_.address();
  const bool follows = links_.valid() && link.active;
  record.hint = visit_hint || follows;
  record.hint_weak = !visit_hint;
  record.hint_address = visit_hint ? link.hint_address : follows ? links_.address() : 0;
  SpanHints::Inputs span;
  span.visit = enter && entering.kind != Operation::kEdgesDone;
  if (span.visit) {
    span.visit_word = entering.word;
    span.visit_bucket = entering.bucket;
    span.visit_mask = config_.hidden_removal != HiddenRemoval::kOff ? entering.mask : 0;
  }
  span.read = texel.read_ready;
  span.read_word = texels.cache.read_address();
  span.read_line = texels.cache.read_line();
  span.response = texel.response;
  span.response_line = texel.response_line;
  if (span.response) span.edges = edges_[texels.cache.address_of(texel.response_line)];
  span.hint_ready = links_.soon_ready(link.came);

  // ---- The clock's edge ----
  count(cause_, 1);
  bool changed = fire || start;
  changed |= links_.step(link);
  changed |= spans_.step(span);
  const bool closing = enter && entering.kind == Operation::kEdgesDone;
  closing_ += closing;
  closing_ -= take_visit && edges_done;
  Operation of_emptied;
  if (emptied) {
    of_emptied = walk_.operation();
    of_emptied.kind = Operation::kEmptied;
  }
  if (fire) walk_.fire();
  if (start) walk_.start(*next);
  changed |= visits_.step(enter ? &entering : nullptr, take_visit);
  changed |= coming_.step(taken && !begins ? offered : nullptr, enter);
  changed |= soon_.step(hints ? &emptied_.front() : nullptr, take_emptied);
  changed |= emptied_.step(emptied ? &of_emptied : nullptr, hints);
  texels.step(texel);
  records.step(record);
  unchanged_ = !changed && texels.cache.unchanged() && records.cache.unchanged();
  ++now_;
  return taken;
}

void Store::count(StoreCause cause, Cycle cycles) {
  meter_.count(cause, now_, cycles, words());
  if (!walk_.busy()) return;
  constexpr std::uint32_t kTile = PassCycles::kTile;
  const Operation& o = walk_.operation();
  meter_.tiles.add(static_cast<std::uint32_t>(o.x) / kTile, static_cast<std::uint32_t>(o.y) / kTile,
                   cycles);
}

}  // namespace kagesen::tlm_model::paper
