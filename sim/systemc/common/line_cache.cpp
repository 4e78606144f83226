#include "sim/systemc/common/line_cache.h"

#include <cstring>

namespace kagesen::tlm_model {

void LineCache::reset(unsigned lines, bool fold) {
  set_bits_ = 0;
  while (2u << set_bits_ < lines) ++set_bits_;
  fold_ = fold;
  lines_.assign(lines, {});
  keys_.assign(lines, 0);
  busy_count_ = 0;
  std::memset(&r_, 0, sizeof r_);
  lookup_set_ = hint_set_ = 0;
  settle();
}

void LineCache::clear() {
  for (Line& line : lines_) line.valid = false;
  r_.lookup = r_.hint = r_.hinting = r_.read = r_.write = false;
  settle();
}

void LineCache::fill_in_turn(Address words) {
  const Address sets = Address{1} << set_bits_;
  for (Address address = words > sets ? words - sets : 0; address < words; ++address) {
    const unsigned line = 2 * set_of(address);
    lines_[line] = {true, false, false, false};
    lines_[line + 1].valid = false;
    keys_[line] = address;
  }
  settle();
}

unsigned LineCache::set_of(Address address) const {
  if (fold_) {
    for (Address rest = address >> set_bits_; rest != 0; rest >>= set_bits_) address ^= rest;
  }
  return address & ((1u << set_bits_) - 1);
}

/// Which way holds the looked-up word, or will take it; the same for the hint.
void LineCache::settle() {
  hit_ = present_ = lookup_free_ = hint_done_ = hint_free_ = false;
  if (r_.lookup) settle_lookup();
  if (r_.hint) settle_hint();
}

void LineCache::settle_lookup() {
  const Line* const looked = &lines_[2 * lookup_set_];
  lookup_way_ = r_.turn;
  for (unsigned way = 0; way < 2; ++way) {
    if (looked[way].busy) continue;
    const bool chosen = looked[lookup_way_].awaited(), other = looked[way].awaited();
    if (!lookup_free_ || (chosen && !other) || (chosen == other && r_.turn)) {
      lookup_free_ = true;
      lookup_way_ = way;
    }
  }
  for (unsigned way = 0; way < 2; ++way) {
    if (looked[way].valid && r_.lookup_keys[way] == r_.lookup_address) {
      present_ = true;
      lookup_way_ = way;
    }
  }
  if (r_.forward) lookup_way_ = r_.forward_way;
  hit_ = r_.forward || (!r_.raced && present_ && !looked[lookup_way_].busy);
}

void LineCache::settle_hint() {
  const Line* const hinted = &lines_[2 * hint_set_];
  done_way_ = 0;
  hint_way_ = r_.turn;
  for (unsigned way = 0; way < 2; ++way) {
    if (hinted[way].valid && r_.hint_keys[way] == r_.hint_address && !r_.hint_raced) {
      hint_done_ = true;
      done_way_ = way;
    }
    const bool may = !r_.lookup || (lookup_set_ != hint_set_ && !hinted[way].awaited());
    if (!hinted[way].busy && may && !(hint_free_ && hint_way_ == r_.turn)) {
      hint_free_ = true;
      hint_way_ = way;
    }
  }
}

bool LineCache::in_place(Address address) const {
  const bool new_ready =
      r_.lookup && r_.is_new && !r_.forward && !r_.raced && !present_ && lookup_free_;
  return (hit_ || new_ready) && address == r_.lookup_address;
}

bool LineCache::update_ready(Address address, bool write_ready, bool read_ready) const {
  if (r_.write && !write_ready) return false;
  const bool here = in_place(address);
  if (here && hit_) return true;
  if (can_fill(read_ready) && (wants_fill() || wants_hint())) return false;
  const Line* const set = &lines_[2 * set_of(address)];
  return here || (!set[0].busy && !set[1].busy);
}

bool LineCache::wants_fill() const {
  return r_.lookup && !r_.is_new && !r_.forward && !present_ && !r_.raced && lookup_free_;
}

bool LineCache::wants_hint() const {
  return r_.hint && hint_free_ && !hint_done_ && !r_.hint_raced;
}

/// Hangs on no update: one that takes a line waits for it.
LineCache::Fill LineCache::fill(const Inputs& in) const {
  const bool can = can_fill(in.read_ready), lookup = can && wants_fill();
  return {lookup, can && !lookup && wants_hint()};
}

bool LineCache::hint_ready(const Inputs& in) const {
  return takes_hint(fill(in));
}

/// A weak hint is dropped where it would have to wait.
bool LineCache::takes_hint(const Fill& fill) const {
  return !r_.hint || hint_done_ || fill.hint || (r_.hint_weak && !hint_free_ && !r_.hint_raced);
}

void LineCache::step(const Inputs& in) {
  lookups_ += in.lookup;
  unchanged_ = !(r_.lookup || r_.hint || r_.read || r_.write || in.lookup || in.hint || in.update ||
                 in.response);
  if (unchanged_) return;
  const Registers before = r_;
  const Fill fills = fill(in);
  const bool hint_taken = takes_hint(fills), read_taken = reads() && in.read_ready;
  const bool moves = in.update && !in_place(in.update_address);
  const bool claims = in.update && !moves && !hit_;
  const unsigned update_set = !in.update ? 0 : moves ? set_of(in.update_address) : lookup_set_;
  const unsigned update_way = moves ? 0 : lookup_way_, update_line = 2 * update_set + update_way;
  const Address fill_address = fills.lookup ? r_.lookup_address : r_.hint_address;
  const unsigned fill_line = fills.lookup ? 2 * lookup_set_ + lookup_way_ : 2 * hint_set_ + hint_way_;
  const bool key_write = moves || claims || fills.any();
  const unsigned key_line = in.update && !fills.any() ? update_line : fill_line;
  const bool kept = in.response && lines_[in.response_line].valid;
  const unsigned hint_line = 2 * hint_set_ + done_way_, lookup_line = 2 * lookup_set_ + lookup_way_;
  const bool again = r_.hint && hint_done_ && !r_.hint_weak, met = hit_ && !r_.met;
  const bool hints_again = again && !(met && hint_line == lookup_line);
  const bool meets = met && !(again && hint_line == lookup_line);
  unchanged_ = !(in.update || fills.any() || in.response || hints_again || meets);

  // ---- Registers ----
  if (in.lookup) {
    r_.met = in.lookup_address == r_.lookup_address && (r_.met || hit_);
    r_.is_new = in.lookup_new;
  } else if (hit_) {
    r_.met = true;
  }
  if (in.lookup || (r_.lookup && (!hit_ || in.update))) {
    if (in.lookup && in.lookup_address != r_.lookup_address) {
      r_.lookup_address = in.lookup_address;
      lookup_set_ = set_of(in.lookup_address);
    }
    const unsigned set = lookup_set_;
    r_.lookup_keys[0] = keys_[2 * set];
    r_.lookup_keys[1] = keys_[2 * set + 1];
    r_.forward = in.update && in.update_address == r_.lookup_address;
    r_.forward_way = update_way != 0;
    r_.raced = (in.update && update_set == set) || (kept && in.response_line / 2 == set) ||
               (key_write && key_line / 2 == set);
  }
  r_.lookup = in.lookup || (r_.lookup && !in.lookup_end);
  const bool repeats = r_.hinting && in.hint_address == r_.hint_address;
  r_.hint = hint_taken ? in.hint && !repeats : true;
  if (in.hint && hint_taken) {
    r_.hint_weak = in.hint_weak;
    if (in.hint_address != r_.hint_address) {
      r_.hint_address = in.hint_address;
      hint_set_ = set_of(in.hint_address);
    }
  }
  r_.hinting = r_.hinting || in.hint;
  if (r_.hint) {
    r_.hint_keys[0] = keys_[2 * hint_set_];
    r_.hint_keys[1] = keys_[2 * hint_set_ + 1];
    r_.hint_raced = key_write && key_line / 2 == hint_set_;
  }
  r_.turn = r_.turn != fills.any();
  r_.read = fills.any() || (r_.read && !read_taken);
  r_.write = in.update || (r_.write && !in.write_ready);
  if (fills.any()) {
    r_.read_address = fill_address;
    r_.read_line = static_cast<std::uint8_t>(fill_line);
  }
  if (in.update) r_.write_address = in.update_address;

  // ---- Lines ----
  if (hints_again) {
    lines_[hint_line].again = lines_[hint_line].hinted;
    lines_[hint_line].hinted = true;
  }
  if (meets) {
    lines_[lookup_line].hinted = lines_[lookup_line].again;
    lines_[lookup_line].again = false;
  }
  if (in.response) {
    lines_[in.response_line].busy = false;
    --busy_count_;
  }
  if (moves) lines_[2 * update_set + 1].valid = false;
  if (in.update) {
    lines_[update_line].valid = true;
    if (moves || claims) lines_[update_line].hinted = lines_[update_line].again = false;
  }
  if (fills.any()) {
    lines_[fill_line] = {true, true, fills.hint && !before.hint_weak, false};
    ++busy_count_;
  }
  if (key_write) keys_[key_line] = in.update && !fills.any() ? in.update_address : fill_address;
  unchanged_ = unchanged_ && std::memcmp(&before, &r_, sizeof r_) == 0;
  settle();
}

}  // namespace kagesen::tlm_model
