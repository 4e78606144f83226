#include "sim/systemc/winding/tile_buffer.h"

namespace kagesen::tlm_model::winding {

void TileBuffer::reset(const UnitConfig& config, unsigned map_bits) {
  constexpr unsigned kLines = 32;
  window.reset({kLines, static_cast<unsigned>(config.visit_fifo_depth), map_bits - 3});
  tiles_.assign(std::size_t{1} << (2 * (map_bits - 3)), {});
  clear();
}

void TileBuffer::clear() {
  window.clear();
  for (Tile& tile : tiles_) tile = {};
  pending_.reset(kPending);
  dirty_ = unkept_ = flush_ = touching_ = false;
  word_ = 0;
  slot_ = 0;
}

void TileBuffer::step(const Inputs& in) {
  in_ = in;
  pop_ = out_valid_ = touched_ = change_ = pends_ = false;
  next_word_ = word_;
  const bool mem_done = !dirty_ || in.write_ready, keep_done = !unkept_ || in.keep_ready;
  const bool fresh = window.fresh();
  load_ = window.valid() && fresh && mem_done && keep_done;
  if (!window.valid() || (fresh ? !load_ : flush_)) return;
  const Work& work = window.work();
  Tile& tile = tiles_[window.address()];
  out_ = work;
  out_.texels = work.passing;
  out_address_ = tile.slot * kWords + work.place;
  if (work.kind == Work::kBegin) {
    out_valid_ = true;
    pop_ = in.out_ready;
  } else if (work.kind == Work::kTile && !in.settling) {  // a fragment is announced
    change_ = pop_ = true;
  } else if (work.kind == Work::kTile) {
    out_valid_ = tile.touched && pending_.ready();
    out_.texels = 15;
    out_.last = word_ == kWords - 1;
    out_address_ = tile.slot * kWords + word_;
    const bool goes = out_valid_ && in.out_ready;
    pends_ = goes && out_.last;
    if (goes) next_word_ = (word_ + 1) % kWords;
    pop_ = pends_ || !tile.touched;
  } else if (work.passing == 0) {
    pop_ = true;
  } else if (!tile.touched) {
    touched_ = change_ = !touching_;
    if (touched_) tile = {true, slot_};
  } else if (!(touching_ && tile.slot == slot_ && (work.place - first_) % kWords >= written_)) {
    out_valid_ = true;
    pop_ = in.out_ready;
    change_ = pop_ && work.nearest;
  }
}

bool TileBuffer::clock() {
  const bool mem_done = !dirty_ || in_.write_ready, keep_done = !unkept_ || in_.keep_ready;
  const bool written = dirty_ && back() && in_.write_ready;
  const bool kept = unkept_ && back() && in_.keep_ready;
  const bool flush = flush_ ? !(mem_done && keep_done) : !window.valid() && !clean();
  const bool word_written = touching_ && in_.touch_ready;
  const bool summed = in_.sum_valid && in_.write_ready;
  const bool changed = load_ || pop_ || change_ || written || kept || word_written || summed ||
                       flush != flush_ || next_word_ != word_;
  const bool last = word_written && written_ == kWords - 1;
  dirty_ = change_ || (dirty_ && !written);
  unkept_ = change_ || (unkept_ && !kept);
  flush_ = flush;
  word_ = next_word_;
  if (touched_) {
    first_ = window.work().place;
    written_ = 0;
  } else if (word_written) {
    ++written_;
  }
  touching_ = touched_ || (touching_ && !last);
  if (last) ++slot_;
  const Nothing nothing;
  return pending_.step(pends_ ? &nothing : nullptr, summed) || changed;
}

}  // namespace kagesen::tlm_model::winding
