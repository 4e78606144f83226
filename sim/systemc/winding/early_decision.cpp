#include "sim/systemc/winding/early_decision.h"

#include <algorithm>

namespace kagesen::tlm_model::winding {

EarlyDecision::EarlyDecision(const sc_core::sc_module_name& name, LaneSlots& slots,
                             ListReader& lists)
    : sc_module(name),
      port("port"),
      tiles("tiles"),
      texel_words("texel_words"),
      slots_(slots),
      lists_(lists) {}

void EarlyDecision::begin_pass(std::uint32_t slots, unsigned map_bits, unsigned word_bytes) {
  port.begin_pass(word_bytes);
  tiles.begin_pass();
  texel_words.begin_pass();
  map_bits_ = map_bits;
  stays_.assign(slots, {});
  inside_.resize(slots);
  entered_ = left_tile_ = came_ = looked_up_ = left_word_ = 0;
  tile_reads_left_ = word_reads_left_ = 0;
  output_ = 0;
  offered_ = kNothing;
  free_ = 0;
  waits_.clear();
}

/// To the tiles' output, which is free once the one before has come for its word.
inline bool EarlyDecision::leave_tile() {
  if (left_tile_ == entered_ || left_tile_ != came_) return false;
  Inside& next = inside(left_tile_++);
  const Stay& tile = stays_[next.slot].tile;
  if (tile.read.responded == 0) {
    next.left_tile = tiles.leave(tile.looked_up, output_);
  } else {
    next.left_tile = tiles.leave(tile.looked_up, output_, next.tile_number, tile.read.responded);
    ++tile_reads_left_;
  }
  return true;
}

inline bool EarlyDecision::come_for_word() {
  if (came_ == left_tile_ || came_ != looked_up_) return false;
  Inside& next = inside(came_++);
  next.came = output_ = std::max(next.left_tile + 1, texel_words.open());
  if (next.needs_word && texel_words.has_to_read(next.word)) {
    next.word_number = texel_words.reads();
  }
  return true;
}

/// A read waits for its turn to be offered.
inline bool EarlyDecision::look_up_word() {
  if (looked_up_ == came_) return false;
  Inside& next = inside(looked_up_);
  const bool reads = next.word_number != kNothing;
  if (reads && (offered_ != kNothing ||
                word_reads_left_ + SharedReads::kWords <= next.word_number)) {
    return false;
  }
  if (reads) offered_ = looked_up_;
  ++looked_up_;
  stays_[next.slot].word = {texel_words.look_up(next.came, reads), {0, 0}};
  return true;
}

inline bool EarlyDecision::leave_word() {
  if (left_word_ == looked_up_ || left_word_ == offered_) return false;
  const Inside& next = inside(left_word_++);
  const Stay& word = stays_[next.slot].word;
  Cycle left;
  if (next.word_number == kNothing) {
    left = texel_words.leave(word.looked_up, 0);
  } else {
    left = texel_words.leave(word.looked_up, 0, next.word_number, word.read.responded);
    ++word_reads_left_;
  }
  if (next.has_list) {
    lists_.look_up(left + 2, next.slot);
  } else {
    slots_.decide(next.slot, left + 4);
  }
  return true;
}

/// Fragments take a step, those for whom it is known when. False if there is none.
bool EarlyDecision::move_on() {
  const bool left_tile = leave_tile(), came = come_for_word(), looked_up = look_up_word(),
             left_word = leave_word();
  return left_tile || came || looked_up || left_word;
}

void EarlyDecision::look_up(Cycle entered, std::uint32_t slot,
                            const unit::winding::FragmentTrail& trail) {
  const std::uint32_t tile = (trail.y >> 3) << (map_bits_ - 3) | trail.x >> 3;
  const bool reads = tiles.has_to_read(tile);
  const std::uint64_t number = tiles.reads();
  while (reads && tile_reads_left_ + SharedReads::kWords <= number) {
    if (!move_on()) read_word();
  }
  Stay& stay = stays_[slot].tile;
  stay.looked_up = tiles.look_up(entered, reads);
  stay.read = {0, 0};
  if (reads) {
    const Cycle offered = stay.looked_up + 1;
    while (next_word() <= std::max(free_, offered)) read_word();
    stay.read = read(offered, std::uint64_t{1} << (2 * map_bits_ - 2) | tile);
    tiles.read_taken(stay.read.accepted);
  }
  const std::uint32_t word = trail.tile_slot << 4 | (trail.y & 7) << 1 | (trail.x >> 2 & 1);
  inside(entered_++) = {slot, word, trail.reads_texel, !trail.records.empty(), number, kNothing, 0, 0};
}

void EarlyDecision::read_word() {
  const Inside& next = inside(offered_);
  offered_ = kNothing;
  Stay& word = stays_[next.slot].word;
  word.read = read(word.looked_up + 1, next.word);
  texel_words.read_taken(word.read.accepted);
}

MemoryPort::Read EarlyDecision::read(Cycle offered, std::uint64_t address) {
  const MemoryPort::Read read = port.read(std::max(free_, offered), address);
  free_ = read.accepted + 1;
  if (read.accepted > offered) waits_.push_back({offered, read.accepted});
  return read;
}

bool EarlyDecision::port_busy(Cycle at) {
  forget(at);
  for (const Wait& wait : waits_) {
    if (wait.begin <= at && at < wait.end) return true;
  }
  return false;
}

}  // namespace kagesen::tlm_model::winding
