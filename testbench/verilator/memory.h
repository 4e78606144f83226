#pragma once
/// A memory behind a port of the unit (docs/rtl.md, Handshakes): tagged reads of any latency, writes
/// without response.
#include <algorithm>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "testbench/verilator/bits.h"

namespace kagesen::rtl {

struct MemorySettings {
  unsigned least_latency = 20, most_latency = 20;  ///< cycles from a read's acceptance, at least 1
  unsigned read_ready_percent = 100, write_ready_percent = 100;
  std::uint64_t seed = 1;
};

/// One clock cycle: `start()` gives what the memory drives, `finish(...)` takes what the unit drove.
class Memory {
 public:
  struct Response {
    bool valid = false;
    std::uint32_t tag = 0;
    Word data;
  };

  Memory(std::size_t bits, const MemorySettings& settings)
      : bits_(bits), settings_(settings), random_(settings.seed) {}

  void start() {
    ++cycle_;
    read_ready_ = random_() % 100 < settings_.read_ready_percent;
    write_ready_ = random_() % 100 < settings_.write_ready_percent;
    response_.valid = false;
    const auto due = std::find_if(pending_.begin(), pending_.end(),
                                  [&](const Pending& p) { return p.due <= cycle_; });
    if (due == pending_.end()) return;
    response_ = {true, due->tag, due->data};
    pending_.erase(due);
  }
  bool read_ready() const { return read_ready_; }
  bool write_ready() const { return write_ready_; }
  const Response& response() const { return response_; }

  /// A read that is valid in a cycle of read_ready().
  void read(std::uint64_t address, std::uint32_t tag) {
    if (!read_ready_) return;
    for (const Pending& p : pending_) {
      if (p.tag == tag) throw std::logic_error("a tag is used again before its response");
    }
    const unsigned span = settings_.most_latency - settings_.least_latency + 1;
    pending_.push_back({cycle_ + settings_.least_latency + random_() % span, tag, peek(address)});
    ++reads_;
  }
  /// A write that is valid in a cycle of write_ready(). Call after this cycle's read().
  void write(std::uint64_t address, const Word& data) {
    if (!write_ready_) return;
    words_[address] = data;
    ++writes_;
  }
  /// The same with a bit of `mask` for each of the word's equal parts.
  void write(std::uint64_t address, const Word& data, unsigned mask, std::size_t part_bits) {
    if (!write_ready_) return;
    Word word = peek(address);
    for (std::size_t low = 0; low < bits_; low += part_bits, mask >>= 1) {
      if ((mask & 1) == 0) continue;
      for (std::size_t done = 0; done < part_bits; done += 32) {
        const std::size_t count = std::min<std::size_t>(32, part_bits - done);
        set_bits(word, low + done, count, get_bits(data, low + done, count));
      }
    }
    words_[address] = word;
    ++writes_;
  }

  /// A word as it stands now; unwritten ones hold noise.
  Word peek(std::uint64_t address) const {
    const auto found = words_.find(address);
    if (found != words_.end()) return found->second;
    Word noise = make_word(bits_);
    for (std::size_t i = 0; i < noise.size(); ++i)
      noise[i] = static_cast<std::uint32_t>((address + i + 1) * 2654435761u);
    if (bits_ % 32 != 0) noise.back() &= (1u << bits_ % 32) - 1;
    return noise;
  }
  void poke(std::uint64_t address, const Word& data) { words_[address] = data; }
  /// The unit is being reset: what is under way never comes back.
  void drop_pending() { pending_.clear(); }
  std::uint64_t reads() const { return reads_; }
  std::uint64_t writes() const { return writes_; }

 private:
  struct Pending {
    std::uint64_t due;
    std::uint32_t tag;
    Word data;
  };
  std::size_t bits_;
  MemorySettings settings_;
  std::mt19937_64 random_;
  std::unordered_map<std::uint64_t, Word> words_;
  std::vector<Pending> pending_;
  Response response_;
  std::uint64_t cycle_ = 0, reads_ = 0, writes_ = 0;
  bool read_ready_ = true, write_ready_ = true;
};

}  // namespace kagesen::rtl
