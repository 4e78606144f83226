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
  waiting_.resize(slots);
  first_ = last_ = tiles_left_ = 0;
  output_ = free_ = 0;
  word_offered_ = false;
  waits_.clear();
}

void EarlyDecision::look_up(Cycle entered, std::uint32_t slot,
                            const unit::winding::FragmentTrail& trail) {
  const std::uint32_t tile = (trail.y >> 3) << (map_bits_ - 3) | trail.x >> 3;
  const bool reads = tiles.has_to_read(tile);
  const std::uint64_t number = tiles.reads();
  while (reads && tiles_left_ + SharedReads::kWords <= number) {
    if (word_offered_) read_word();
    move_on();
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
  waiting_[last_++ % waiting_.size()] = {slot, word, trail.reads_texel, !trail.records.empty(),
                                         number};
}

/// The next fragment goes from its tile to its word, as far as it needs no read there.
void EarlyDecision::move_on() {
  const Waiting& next = waiting_[first_++ % waiting_.size()];
  const Stay& tile = stays_[next.slot].tile;
  Cycle left;
  if (tile.read.responded != 0) {
    left = tiles.leave(tile.looked_up, output_, next.tile_number, tile.read.responded);
    ++tiles_left_;
  } else {
    left = tiles.leave(tile.looked_up, output_);
  }
  const Cycle came = std::max(left + 1, texel_words.open());
  output_ = came;
  const bool reads = next.reads_word && texel_words.has_to_read(next.word);
  const std::uint64_t number = texel_words.reads();
  const Stay stay{texel_words.look_up(came, reads), {0, 0}};
  stays_[next.slot].word = stay;
  if (reads) {
    word_ = {next.slot, next.word, next.has_list, number, stay};
    word_offered_ = true;
  } else {
    finish(next.slot, next.has_list, texel_words.leave(stay.looked_up, 0));
  }
}

void EarlyDecision::read_word() {
  word_offered_ = false;
  word_.stay.read = read(word_.stay.looked_up + 1, word_.address);
  stays_[word_.slot].word = word_.stay;
  texel_words.read_taken(word_.stay.read.accepted);
  finish(word_.slot, word_.has_list,
         texel_words.leave(word_.stay.looked_up, 0, word_.number, word_.stay.read.responded));
}

void EarlyDecision::finish(std::uint32_t slot, bool has_list, Cycle left) {
  if (has_list) {
    lists_.look_up(left + 2, slot);
  } else {
    slots_.decide(slot, left + 4);
  }
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
