#pragma once
/// The memories beside a Verilated unit: words, and read ports with tags. When a port moves is
/// sim/memory/timing.h's to say.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>
#include <vector>

#include "testbench/verilator/bench.h"

namespace kagesen::bench {

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

/// One read port: a request's word is copied when it is accepted.
template <unsigned kStride>
class ReadPort {
 public:
  struct Response {
    bool due = false;
    std::uint8_t tag = 0;
    std::uint32_t words[kStride];
  };

  ReadPort() : ring_(ReadTiming::kMaxDelay) {}

  void configure(const Timing& timing) { timing_.configure(timing); }
  /// @param first  cycle of the pass
  void begin_pass(PassNumber pass, Channel channel, unsigned lane, Cycle first) {
    timing_.begin_pass(pass, channel, lane);
    first_ = first;
  }
  bool ready(Cycle now) { return timing_.ready(now - first_); }
  /// Returns the cycle of the response.
  Cycle accept(Cycle now, std::uint8_t tag, std::uint64_t address, const std::uint32_t* words) {
    if (under_way_[tag]) throw Failure("a memory tag is used before its response came");
    under_way_[tag] = true;
    Cycle at = first_ + timing_.accept(now - first_, address);
    while (ring_[at % ring_.size()].due) ++at;  // of a pass before
    Response& response = ring_[at % ring_.size()];
    response.due = true;
    response.tag = tag;
    std::memcpy(response.words, words, sizeof response.words);
    ++outstanding_;
    return at;
  }
  ReadCache& cache() { return timing_.cache(); }
  std::uint32_t outstanding() const { return outstanding_; }
  /// The response of this cycle, or null. It stays valid until the next accept().
  const Response* take(Cycle now) {
    if (outstanding_ == 0) return nullptr;
    Response& response = ring_[now % ring_.size()];
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

 private:
  ReadTiming timing_;
  Cycle first_ = 0;
  std::vector<Response> ring_;
  bool under_way_[ReadTiming::kTags] = {};
  std::uint32_t outstanding_ = 0;
};

}  // namespace kagesen::bench
