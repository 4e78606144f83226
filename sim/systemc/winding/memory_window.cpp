#include "sim/systemc/winding/memory_window.h"

namespace kagesen::tlm_model::winding {

void MemoryWindow::reset(const Size& size) {
  size_ = size;
  line_bits_ = 0;
  while (1u << line_bits_ < size.lines) ++line_bits_;
  piece_mask_ = 32 * size.depth - 1;
  payloads_.reset(size.depth);
  lines_.reset(size.depth);
  all_.assign(size.lines, {});
  clear();
}

void MemoryWindow::clear() {
  for (Line& line : all_) line.valid = false;
  payloads_.reset(size_.depth);
  lines_.reset(size_.depth);
  entry_valid_ = ahead_valid_ = newest_valid_ = held_valid_ = false;
  pushed_ = popped_ = 0;
  settle();
}

/// All of the address plays a part; the low bits of the one coordinate meet the high bits of the other.
unsigned MemoryWindow::line_of(WordAddress address) const {
  const unsigned mask = (1u << line_bits_) - 1;
  unsigned line = 0, upper = 0;
  for (unsigned row = address & ((1u << size_.row_bits) - 1); row != 0; row >>= line_bits_) {
    line ^= row & mask;
  }
  for (unsigned rest = address >> size_.row_bits; rest != 0; rest >>= line_bits_) {
    upper ^= rest & mask;
  }
  const unsigned turn = (line_bits_ + 1) / 2;
  return line ^ ((upper << turn | upper >> (line_bits_ - turn)) & mask);
}

void MemoryWindow::settle() {
  hit_ = reads_ = false;
  if (!entry_valid_ || entry_.bare) return;
  const Line& line = all_[entry_.line];
  hit_ = line.valid && line.address == entry_.address;
  if (hit_) return;
  const unsigned pieces = (pushed_ - popped_) & piece_mask_;
  const unsigned age = (pushed_ - line.piece) & piece_mask_;
  const bool in_use = line.valid && ((pieces != 0 && age <= pieces) ||
                                     (held_valid_ && held_line_ == entry_.line));
  reads_ = !in_use && !line.busy && lines_.ready();
}

bool MemoryWindow::step(const Inputs& in) {
  if (in.work == nullptr && !in.response && empty()) return false;
  const bool push = pushes(in.fetched);
  const bool let_go =
      entry_valid_ && !entry_.bare && !hit_ && pushed_ == popped_ && in.clean;
  bool take = false, same = false;
  if (lines_.valid() && (!ahead_valid_ || in.pop)) {
    const Entry& next = lines_.front();
    same = !next.bare && newest_valid_ && newest_line_ == next.line;
    take = next.bare || same ||
           (all_[next.line].valid && !all_[next.line].busy &&
            !(held_valid_ && held_line_ == next.line));
  }
  const bool lets_go = let_go && (newest_valid_ || held_valid_);
  bool changed = in.work != nullptr || push || take || in.pop || in.load || in.response || lets_go;

  if (in.response) all_[in.line].busy = false;
  if (push && !entry_.bare) {
    Line& line = all_[entry_.line];
    if (in.fetched) line.valid = line.busy = true;
    line.address = entry_.address;
    line.piece = pushed_;
  }
  if (let_go) newest_valid_ = held_valid_ = false;
  if (in.load) {
    held_line_ = ahead_.line;
    held_valid_ = true;
    ahead_fresh_ = false;
  }
  if (take) {
    ahead_ = lines_.front();
    ahead_fresh_ = !ahead_.bare && !same;
    if (!ahead_.bare) {
      newest_line_ = ahead_.line;
      newest_valid_ = true;
    }
  }
  ahead_valid_ = take || (ahead_valid_ && !in.pop);
  changed |= lines_.step(push ? &entry_ : nullptr, take);
  changed |= payloads_.step(in.work, in.pop);
  pushed_ = (pushed_ + push) & piece_mask_;
  popped_ = (popped_ + in.pop) & piece_mask_;
  entry_valid_ = in.work != nullptr || (entry_valid_ && !push);
  if (in.work != nullptr) entry_ = {in.address, line_of(in.address), in.bare};
  if (changed) settle();
  return changed;
}

}  // namespace kagesen::tlm_model::winding
