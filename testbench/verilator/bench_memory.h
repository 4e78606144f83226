#pragma once
/// The memories beside a Verilated unit: words, and read ports with tags, latency and stalls.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

#include "testbench/verilator/bench.h"

namespace kagesen::bench {

/// xorshift64*.
class Random {
 public:
  explicit Random(std::uint64_t seed = 1) : state_(seed * 0x9e3779b97f4a7c15u | 1) { next(); }
  std::uint32_t next() {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return static_cast<std::uint32_t>(state_ * 0x2545f4914f6cdd1du >> 32);
  }
  std::uint32_t below(std::uint32_t n) {
    return static_cast<std::uint32_t>(std::uint64_t{next()} * n >> 32);
  }
  bool per_cent(std::uint32_t p) { return p != 0 && below(100) < p; }

 private:
  std::uint64_t state_;
};

/// Words of kWidth bits. Zeros at first; the system gives pages as they are touched.
template <unsigned kWidth, unsigned kAddrBits>
class WordMemory {
 public:
  static constexpr unsigned kStride = (kWidth + 31) / 32;
  static constexpr std::uint64_t kCount = std::uint64_t{1} << kAddrBits;

  WordMemory() : words_(static_cast<std::uint32_t*>(std::calloc(kCount * kStride, 4))) {
    if (words_ == nullptr) throw std::bad_alloc();
  }
  ~WordMemory() { std::free(words_); }
  WordMemory(const WordMemory&) = delete;
  WordMemory& operator=(const WordMemory&) = delete;

  const std::uint32_t* at(std::uint64_t address) const { return words_ + address * kStride; }
  std::uint32_t* at(std::uint64_t address) { return words_ + address * kStride; }
  const std::uint32_t* words() const { return words_; }

 private:
  std::uint32_t* words_;
};

/// The response side of one read port: at most one a cycle, each at the earliest in the cycle after
/// its request. A request's word is copied when the request is accepted.
template <unsigned kStride>
class ReadPort {
 public:
  struct Response {
    bool due = false;
    std::uint8_t tag = 0;
    std::uint32_t words[kStride];
  };

  void configure(std::uint32_t latency, std::uint32_t spread, std::uint64_t seed) {
    latency_ = latency;
    spread_ = spread;
    random_ = Random(seed);
  }
  void accept(std::uint64_t now, std::uint8_t tag, const std::uint32_t* words) {
    std::uint64_t at = now + latency_;
    if (under_way_[tag]) throw Failure("a memory tag is used before its response came");
    under_way_[tag] = true;
    if (spread_ != 0) at += random_.below(spread_ + 1);
    while (ring_[at % kSlots].due) ++at;
    Response& response = ring_[at % kSlots];
    response.due = true;
    response.tag = tag;
    std::memcpy(response.words, words, sizeof response.words);
    ++outstanding_;
  }
  /// The response of this cycle, or null. It stays valid until the next accept().
  const Response* take(std::uint64_t now) {
    if (outstanding_ == 0) return nullptr;
    Response& response = ring_[now % kSlots];
    if (!response.due) return nullptr;
    response.due = false;
    under_way_[response.tag] = false;
    --outstanding_;
    return &response;
  }
  void drop() {
    for (Response& response : ring_) response.due = false;
    for (bool& tag : under_way_) tag = false;
    outstanding_ = 0;
  }

  static constexpr std::uint32_t kMaxDelay = 3000;  ///< latency and spread

 private:
  static constexpr std::size_t kSlots = 4096;  // above kMaxDelay and the requests under way
  Response ring_[kSlots];
  bool under_way_[256] = {};  // tags
  std::uint32_t latency_ = 1, spread_ = 0, outstanding_ = 0;
  Random random_;
};

}  // namespace kagesen::bench
