#pragma once
/// How memories and streams behave in time: one definition for the Verilated bench and for SystemC.
///
/// Cycles count from the first one of a pass. Nothing is drawn one after the other: whether a port
/// stalls in a cycle, and how late a response comes, follow from seed, pass, port and cycle alone.
/// So a model that jumps from event to event sees what one that steps through every cycle does.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <queue>
#include <stdexcept>
#include <vector>

#include "sim/memory/read_cache.h"

namespace kagesen {

/// The same timing gives the same cycles again.
struct Timing {
  std::uint32_t latency = 20;      ///< cycles from a request to its response, 1 or more
  std::uint32_t spread = 0;        ///< up to so many more, at random: responses overtake another
  std::uint32_t memory_stall = 0;  ///< per cent of the cycles in which a memory port takes nothing
  std::uint32_t stream_stall = 0;  ///< of those in which nothing is offered, or no verdict taken
  std::uint32_t interval = 1;      ///< cycles from one request of a read port to its next, at least
  std::uint32_t outstanding = 0;   ///< reads that a port has under way at most; 0: any number
  std::uint32_t banks = 1;         ///< of the memory behind a port; rows go to them in turn
  std::uint32_t bank_busy = 1;     ///< cycles from one read of a bank to its next, at least
  std::uint32_t row_words = 0;     ///< words of a bank's row; 0: a bank is one row
  std::uint32_t row_miss = 0;      ///< more of both, where another row is open
  CacheShape texel_cache, slb_cache;  ///< behind each port; a pass finds it empty
  std::uint32_t cache_latency = 1;    ///< cycles from a request to the response of a word that is there
  std::uint64_t seed = 1;
};

/// What the unit and its bench exchange; each lane has its own.
enum class Channel : std::uint8_t {
  kTriangles,
  kFragments,
  kVerdicts,
  kTexelReads,
  kSlbReads,
  kTexelWrites,
  kSlbWrites,
};
inline constexpr std::size_t kChannels = 7;

/// Which pass of a frame: its number (bench::Pass), and how many of the same went before.
struct PassNumber {
  std::uint32_t pass = 0, before = 0;
};

/// Random numbers of one channel in one pass, a cycle each.
class Chance {
 public:
  Chance() = default;
  Chance(std::uint64_t seed, PassNumber pass, Channel channel, unsigned lane)
      : key_(mix(mix(seed) ^ (std::uint64_t{pass.before} << 32 | pass.pass << 16 |
                              static_cast<unsigned>(channel) << 8 | lane))) {}

  std::uint32_t below(std::uint32_t n, Cycle at) const {
    return static_cast<std::uint32_t>((mix(key_ + at) >> 32) * n >> 32);
  }

 private:
  static std::uint64_t mix(std::uint64_t x) {  // splitmix64
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
  }
  std::uint64_t key_ = 0;
};

/// The cycles in which the far side of a channel does not move.
class Stalls {
 public:
  Stalls() = default;
  Stalls(std::uint32_t per_cent, const Chance& chance) : per_cent_(per_cent), chance_(chance) {}
  bool never() const { return per_cent_ == 0; }
  bool at(Cycle now) const { return per_cent_ != 0 && chance_.below(100, now) < per_cent_; }
  /// The first cycle from `from` on in which it does.
  Cycle next(Cycle from) const {
    if (per_cent_ != 0) {
      while (at(from)) ++from;
    }
    return from;
  }

 private:
  std::uint32_t per_cent_ = 0;
  Chance chance_;
};

/// When a read port takes requests, and when their responses come: at most one a cycle, each at the
/// earliest in the cycle after its request. Calls come in the order of time.
class ReadTiming {
 public:
  static constexpr std::size_t kMaxDelay = 1u << 14;  ///< of a response
  static constexpr std::uint32_t kTags = 256;         ///< reads under way at most

  void configure(const Timing& timing) {
    if (timing.latency < 1 || timing.interval < 1 || timing.banks < 1 || timing.bank_busy < 1 ||
        timing.cache_latency < 1 || longest_delay(timing) >= kMaxDelay) {
      throw std::invalid_argument("memory timing out of range");
    }
    timing_ = timing;
    in_order_ = timing.spread == 0 && simple_banks(timing) && timing.texel_cache.lines == 0 &&
                timing.slb_cache.lines == 0;
    constant_ = in_order_ && timing.memory_stall == 0 && timing.interval == 1 &&
                timing.outstanding == 0;
    due_.assign(in_order_ ? 0 : kMaxDelay, 0);
    begin_pass({}, Channel::kTexelReads, 0);
  }
  /// Nothing is under way, no row is open, the cache is empty.
  void begin_pass(PassNumber pass, Channel channel, unsigned lane) {
    const Chance chance(timing_.seed, pass, channel, lane);
    stalls_ = Stalls(timing_.memory_stall, chance);
    lateness_ = Chance(~timing_.seed, pass, channel, lane);
    free_ = 0;
    banks_.assign(timing_.banks, {});
    under_way_ = {};
    cache_.configure(channel == Channel::kTexelReads ? timing_.texel_cache
                     : channel == Channel::kSlbReads ? timing_.slb_cache
                                                     : CacheShape{});
    std::fill(due_.begin(), due_.end(), 0);
  }

  /// The time of an SLB's read depends on its address.
  static bool slb_address_counts(const Timing& t) {
    return !simple_banks(t) || t.slb_cache.lines != 0;
  }
  /// Cycles from a request's acceptance to its response, at most.
  static Cycle longest_delay(const Timing& t) {
    const Cycle queue = simple_banks(t) ? kTags : Cycle{kTags} * (t.bank_busy + t.row_miss);
    const Cycle line = std::max(t.texel_cache.line_words, t.slb_cache.line_words);
    return t.latency + t.spread + queue + (line - 1) * t.interval + t.cache_latency;
  }
  /// Every read is taken at once and takes timing().latency cycles.
  bool constant() const { return constant_; }
  const Timing& timing() const { return timing_; }

  /// Would a request be taken in this cycle?
  bool ready(Cycle now) {
    forget(now);
    return now >= free_ && !full() && !stalls_.at(now);
  }
  /// The first cycle from `from` on in which one is. The next request is taken then.
  Cycle next_ready(Cycle from) {
    if (constant_) return from;
    from = std::max(from, free_);
    for (forget(from); full(); forget(from)) from = under_way_.top();
    return stalls_.next(from);
  }
  /// A request is taken. Returns the cycle of its response.
  Cycle accept(Cycle now, std::uint64_t word) {
    if (!cache_.none()) {
      if (const Cycle* there = cache_.look_up(word)) {
        free_ = now + 1;
        return respond(std::max(now + timing_.cache_latency, *there));
      }
    }
    // A line comes word by word, the one that is asked for first.
    const Cycle rest = (cache_.line_words() - 1) * timing_.interval;
    free_ = now + timing_.interval + rest;
    Cycle at = now + timing_.latency;
    if (!simple_banks(timing_)) at += wait_for_bank(now, word);
    if (timing_.spread != 0) at += lateness_.below(timing_.spread + 1, now);
    if (!cache_.none()) cache_.fill(word, at + rest);
    return respond(at);
  }
  /// What the cache was asked for in this pass; counts nothing where there is none.
  ReadCache& cache() { return cache_; }
  const ReadCache& cache() const { return cache_; }

 private:
  static bool simple_banks(const Timing& t) { return t.bank_busy == 1 && t.row_miss == 0; }

  struct Bank {
    Cycle free = 0;
    std::uint64_t row = ~std::uint64_t{0};
  };

  /// Responses up to `now` are not under way any more.
  void forget(Cycle now) {
    while (!under_way_.empty() && under_way_.top() <= now) under_way_.pop();
  }
  bool full() const {
    return timing_.outstanding != 0 && under_way_.size() >= timing_.outstanding;
  }
  /// A port gives one response a cycle.
  Cycle respond(Cycle at) {
    if (!due_.empty()) {
      while (due_[at % kMaxDelay] == at) ++at;
      due_[at % kMaxDelay] = at;
    }
    if (timing_.outstanding != 0) under_way_.push(at);
    return at;
  }
  Cycle wait_for_bank(Cycle now, std::uint64_t word) {
    const std::uint64_t row = timing_.row_words ? word / timing_.row_words : word % timing_.banks;
    Bank& bank = banks_[row % timing_.banks];
    const bool miss = timing_.row_words != 0 && bank.row != row;
    bank.row = row;
    const Cycle start = std::max(now, bank.free);
    const Cycle more = miss ? timing_.row_miss : 0;
    bank.free = start + timing_.bank_busy + more;
    return start - now + more;
  }

  Timing timing_;
  bool constant_ = false, in_order_ = false;
  ReadCache cache_;
  Stalls stalls_;
  Chance lateness_;
  Cycle free_ = 0;  // for the next request
  std::vector<Bank> banks_;
  std::priority_queue<Cycle, std::vector<Cycle>, std::greater<>> under_way_;  // responses
  std::vector<Cycle> due_;  // cycles that have a response; empty where they cannot meet
};

}  // namespace kagesen
