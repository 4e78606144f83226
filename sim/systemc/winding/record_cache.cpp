#include "sim/systemc/winding/record_cache.h"

#include <algorithm>

namespace kagesen::tlm_model::winding {

void RecordCache::reset(unsigned lines) {
  line_bits_ = 0;
  while (1u << line_bits_ < lines) ++line_bits_;
  lines_.assign(lines, {});
  busy_count_ = 0;
  clear();
}

void RecordCache::clear() {
  for (Line& line : lines_) line.valid = false;
  lookup_ = read_valid_ = write_valid_ = false;
  settle();
}

void RecordCache::begin_pass(unsigned word_bytes, const Stalls& writes) {
  lookups_ = 0;
  port.begin_pass(word_bytes);
  writes_ = writes;
  accepted_ = kNever;
  due_.clear();
}

unsigned RecordCache::line_of(WordAddress address) const {
  unsigned line = 0;
  for (; address != 0; address >>= line_bits_) line ^= address & ((1u << line_bits_) - 1);
  return line;
}

void RecordCache::settle() {
  const Line& line = lines_[lookup_line_];
  present_ = line.valid && key_ == looked_up_;
  hit_ = lookup_ && (forward_ || (!raced_ && present_ && !line.busy));
}

Cycle RecordCache::next(Cycle from) const {
  Cycle at = due_.next();
  if (accepted_ != kNever) at = std::min(at, accepted_);
  if (write_valid_) at = std::min(at, writes_.next(from));
  return at;
}

bool RecordCache::step(Cycle now, const Inputs& in) {
  lookups_ += in.lookup;
  if (!lookup_ && !in.lookup && !in.update && idle()) return false;
  // ---- The memory ----
  if (reads() && accepted_ == kNever) {
    const MemoryPort::Read read = port.read(now, read_address_);
    accepted_ = read.accepted;
    due_.push(read.responded, read_line_);
  }
  const bool read_ready = accepted_ == now;
  const bool response = due_.next() == now;
  const bool write_taken = write_valid_ && !writes_.at(now);

  // ---- Fill and update ----
  const bool moves = in.update && !(hit_ && in.update_address == looked_up_);
  const unsigned update_line = in.update ? line_of(in.update_address) : 0;
  const bool fill = (!read_valid_ || read_ready) && !moves && lookup_ && !forward_ && !present_ &&
                    !raced_ && !lines_[lookup_line_].busy;
  const bool key_write = moves || fill;
  const unsigned key_line = in.update && !fill ? update_line : lookup_line_;

  // ---- The clock's edge ----
  bool changed = in.lookup || (lookup_ && in.lookup_end) || in.update || fill || read_ready ||
                 response || write_taken;
  if (in.lookup || (lookup_ && (!hit_ || in.update))) {
    const WordAddress address = in.lookup ? in.lookup_address : looked_up_;
    const unsigned line = in.lookup ? line_of(address) : lookup_line_;
    const bool kept = response && lines_[due_.front()].valid;
    const bool forward = in.update && in.update_address == address;
    const bool raced = (in.update && update_line == line) ||
                       (kept && due_.front() == line) || (key_write && key_line == line);
    changed |= forward != forward_ || raced != raced_ || key_ != lines_[line].address;
    forward_ = forward;
    raced_ = raced;
    key_ = lines_[line].address;
    lookup_line_ = line;
  }
  const WordAddress fill_address = looked_up_;
  if (in.lookup) looked_up_ = in.lookup_address;
  const unsigned fill_line = line_of(fill_address);
  lookup_ = in.lookup || (lookup_ && !in.lookup_end);
  if (response) {
    lines_[due_.front()].busy = false;
    --busy_count_;
    due_.pop();
  }
  if (in.update) {
    lines_[update_line].valid = true;
    if (moves) lines_[update_line].address = in.update_address;
  }
  if (fill) {
    lines_[fill_line] = {true, true, fill_address};
    ++busy_count_;
    read_address_ = fill_address;
    read_line_ = fill_line;
  }
  if (read_ready) accepted_ = kNever;
  read_valid_ = fill || (read_valid_ && !read_ready);
  write_valid_ = in.update || (write_valid_ && !write_taken);
  if (in.update) write_address_ = in.update_address;
  settle();
  return changed;
}

}  // namespace kagesen::tlm_model::winding
