#pragma once
/// Which words a cache behind a read port has, and from when on: sets of lines, the least recently
/// used of a set goes. Writes go through it, so they change nothing here.
#include <algorithm>
#include <cstdint>
#include <vector>

namespace kagesen {

using Cycle = std::uint64_t;

struct CacheShape {
  std::uint32_t lines = 0;  ///< 0: there is no cache
  std::uint32_t ways = 1;
  std::uint32_t line_words = 1;
};

class ReadCache {
 public:
  void configure(const CacheShape& shape) {
    shape_ = shape;
    ways_ = std::min(shape.ways, shape.lines);
    sets_ = ways_ == 0 ? 0 : shape.lines / ways_;
    clear();
  }
  /// It is empty, and nothing is counted.
  void clear() {
    lines_.assign(std::size_t{sets_} * ways_, {});
    clock_ = 0;
    forget_counts();
  }
  void forget_counts() { lookups_ = misses_ = 0; }
  bool none() const { return sets_ == 0; }
  std::uint32_t line_words() const { return none() ? 1 : shape_.line_words; }
  std::uint64_t lookups() const { return lookups_; }
  std::uint64_t misses() const { return misses_; }

  /// The cycle from which on the word is there; null: it has to be fetched. @pre !none()
  const Cycle* look_up(std::uint64_t word) {
    const std::uint64_t number = word / shape_.line_words;
    Line* const set = &lines_[number % sets_ * ways_];
    ++lookups_;
    ++clock_;
    for (Line* line = set; line != set + ways_; ++line) {
      if (line->used == 0 || line->number != number) continue;
      line->used = clock_;
      return &line->from;
    }
    ++misses_;
    return nullptr;
  }
  /// The word that was just missed comes with its line, which is whole in this cycle.
  void fill(std::uint64_t word, Cycle from) {
    const std::uint64_t number = word / shape_.line_words;
    Line* const set = &lines_[number % sets_ * ways_];
    *std::min_element(set, set + ways_, [](const Line& a, const Line& b) {
      return a.used < b.used;
    }) = {number, clock_, from};
  }

 private:
  struct Line {
    std::uint64_t number = 0;
    std::uint64_t used = 0;  // the last look-up of it; 0: empty
    Cycle from = 0;
  };
  CacheShape shape_;
  std::uint32_t ways_ = 0, sets_ = 0;
  std::vector<Line> lines_;  // a set's side by side
  std::uint64_t clock_ = 0, lookups_ = 0, misses_ = 0;
};

}  // namespace kagesen
