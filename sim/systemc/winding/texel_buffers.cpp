#include "sim/systemc/winding/texel_buffers.h"

namespace kagesen::tlm_model::winding {

using unit::winding::TexelVisit;

void TexelBuffers::reset(const UnitConfig& config, unsigned map_bits) {
  window.reset({static_cast<unsigned>(config.texel_lines),
                static_cast<unsigned>(config.visit_fifo_depth), 2 * map_bits - 2});
  silhouettes.reset(config);
  clear();
}

void TexelBuffers::clear() {
  window.clear();
  texels_.clear();
  visits_.clear();
  settled_.clear();
  dirty_ = 0;
  unkept_ = flush_ = running_ = resumed_ = sums_ = tile_ends_ = false;
  all_ = true;
}

void TexelBuffers::add_settled(const unit::winding::SettleTrail& trail) {
  settled_.insert(settled_.end(), trail.texels.begin(), trail.texels.end());
  silhouettes.walk.add_emptied(trail.emptied);
  silhouettes.walk.add_dropped(trail.dropped);
}

void TexelBuffers::touch(std::uint32_t slot) {
  constexpr std::size_t kTileTexels = 64;
  texels_.resize(std::max(texels_.size(), (slot + 1) * kTileTexels));
}

/// What golden said of the word's texels, and what is to be done with them.
void TexelBuffers::classify(const Work& work) {
  const TexelState* const word = &texels_[window.address() * kTexels];
  slow_ = put_ = 0;
  for (unsigned i = 0; i < kTexels; ++i) {
    if ((work.texels >> i & 1) == 0) continue;
    const TexelState& texel = word[i];
    if (work.kind == Work::kTile) {
      if (texel.kind != TexelState::kList) continue;
      ListVisit& visit = at_[i];
      visit = {};
      visit.settles = true;
      visit.emptied = settled_.front().emptied;
      visit.texel.dropped = settled_.front().dropped;
      settled_.pop_front();
      if (texel.bare) {
        slow_ |= 1u << i;
      } else {
        silhouettes.walk.skip(visit);
      }
      continue;
    }
    const ListVisit& visit = at_[i] = visits_.front();
    visits_.pop_front();
    const bool nothing = visit.nothing();
    bool put = false, slow = !nothing;
    switch (texel.kind) {
      case TexelState::kEmpty:
        put = visit.span;
        slow = slow && !visit.span;
        break;
      case TexelState::kPlane:
        put = visit.texel.plane == TexelVisit::Plane::kPuts;
        slow = slow && visit.texel.plane == TexelVisit::Plane::kMeets;
        break;
      case TexelState::kList: slow = slow || texel.covered; break;
      case TexelState::kOverflow: break;
    }
    slow_ |= unsigned{slow} << i;
    put_ |= unsigned{put} << i;
  }
}

void TexelBuffers::step(Cycle now, const Inputs& in) {
  asleep_ = asleep();
  if (asleep_) {
    load_ = pop_ = done_ = false;
    return;
  }
  in_ = in;
  pop_ = change_ = start_ = false;
  next_todo_ = todo_;
  next_resumed_ = resumed_;
  next_sums_ = sums_;
  put_now_ = 0;
  const bool mem_done = dirty_ == 0 || in.write_ready;
  const bool keep_done = !unkept_ || in.keep_ready;
  const bool valid = window.valid();
  load_ = valid && window.fresh() && mem_done && keep_done && !tile_ends_;
  const bool at_work = valid && !window.fresh() && !flush_ && !tile_ends_;
  if (at_work) {
    const Work& work = window.work();
    if (work.kind == Work::kBegin) {
      pop_ = true;
    } else if (sums_) {
      pop_ = sum_lane_ == kTexels - 1;
      next_sums_ = !pop_;
    } else if (!running_) {
      evaluate(work);
    }
  } else if (load_ && window.work().kind == Work::kTile) {
    // Is nothing to be done with the word?
    const TexelState* const word = &texels_[window.address() * kTexels];
    pop_ = true;
    for (unsigned i = 0; i < kTexels; ++i) pop_ = pop_ && !(word[i].kind == TexelState::kList && word[i].bare);
    pop_ = pop_ && !(all_ && all_held(word));
    if (pop_) classify(window.work());
  }
  done_ = silhouettes.step(now);
  if (at_work && running_ && done_) {
    change_ = silhouettes.texel.changed;
    const bool settles = window.work().kind == Work::kTile;
    pop_ = todo_ == 0 && !settles;
    next_resumed_ = !pop_;
  }
}

/// The word is looked at: planes are put, lists handed over.
void TexelBuffers::evaluate(const Work& work) {
  if (!resumed_) classify(work);
  const unsigned wanted = resumed_ ? todo_ & slow_ : slow_;
  if (!resumed_) put_now_ = put_;
  change_ = put_now_ != 0;
  next_resumed_ = wanted != 0;
  if (wanted != 0) {
    start_ = true;
    next_lane_ = static_cast<unsigned>(__builtin_ctz(wanted));
    next_todo_ = wanted & (wanted - 1);
    silhouettes.start(at_[next_lane_], texels_[held_ * kTexels + next_lane_]);
    return;
  }
  next_todo_ = 0;
  next_sums_ = work.kind == Work::kTile && all_ && all_held(&texels_[held_ * kTexels]);
  pop_ = !next_sums_;
}

bool TexelBuffers::all_held(const TexelState* word) {
  for (unsigned i = 0; i < kTexels; ++i) {
    const TexelState& t = word[i];
    const bool held =
        t.kind == TexelState::kPlane || (t.kind != TexelState::kEmpty && t.covered);
    if (!held) return false;
  }
  return true;
}

bool TexelBuffers::clock(Cycle now) {
  if (asleep_) return false;
  const bool settles = window.valid() && window.work().kind == Work::kTile;
  const bool begins = window.valid() && window.work().kind == Work::kBegin;
  const bool mem_done = dirty_ == 0 || in_.write_ready;
  const bool keep_done = !unkept_ || in_.keep_ready;
  const bool written = writes() && in_.write_ready, kept = unkept_ && back() && in_.keep_ready;
  const bool flush =
      flush_ ? !(mem_done && keep_done) : !window.valid() && !clean();
  const bool ends = tile_ends_ ? !in_.sum_ready : settles && pop_ && window.work().last;
  bool changed = load_ || pop_ || start_ || done_ || change_ || written || kept || sums_ ||
                 flush != flush_ || ends != tile_ends_ || next_sums_ != sums_;

  if ((tile_ends_ && in_.sum_ready) || (begins && pop_)) {
    all_ = true;
  } else if (!sums_ && settles && pop_) {
    all_ = false;
  }
  sum_lane_ = sums_ ? sum_lane_ + 1 : 0;
  if (written) dirty_ = 0;
  TexelState* const word = texels_.data() + held_ * kTexels;
  if (running_ && done_ && change_) {
    word[lane_] = silhouettes.texel;
    dirty_ |= 1u << lane_;
  }
  for (unsigned i = 0; put_now_ >> i != 0; ++i) {
    if ((put_now_ >> i & 1) != 0) word[i] = {TexelState::kPlane, false, false, 0, 0};
  }
  dirty_ |= put_now_;
  unkept_ = change_ || (unkept_ && !kept);
  flush_ = flush;
  tile_ends_ = ends;
  running_ = start_ || (running_ && !done_);
  resumed_ = next_resumed_;
  sums_ = next_sums_;
  todo_ = next_todo_;
  if (start_) lane_ = next_lane_;
  if (load_) held_ = window.address();
  changed |= silhouettes.clock(now);
  return changed;
}

}  // namespace kagesen::tlm_model::winding
