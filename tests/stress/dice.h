#pragma once
/// Choices of the stress suite: the same for a seed on every platform.
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "traces/scene/random.h"

namespace kagesen::stress {

class Dice : public Random {
 public:
  using Random::Random;
  /// Independent dice for one case of a seed.
  static Dice of_case(std::uint64_t seed, std::uint64_t number) {
    Random mixed(seed ^ Random(number).next());
    return Dice(mixed.next());
  }

  /// A whole number in [low, high]; the bias towards some is below 2^-30.
  std::int64_t in(std::int64_t low, std::int64_t high) {
    const auto count = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<std::int64_t>(next() % count);
  }
  int small(int low, int high) { return static_cast<int>(in(low, high)); }
  bool one_in(std::int64_t n) { return in(1, n) == 1; }
  double real(double low, double high) { return uniform(low, high); }
  /// Either sign.
  std::int64_t either(std::int64_t value) { return one_in(2) ? value : -value; }
  /// Mostly 0, else within a few units of it.
  std::int64_t nudge(std::int64_t most = 1) { return one_in(3) ? in(-most, most) : 0; }
  /// 2^k - ish: every magnitude up to 2^bits equally likely.
  std::int64_t magnitude(int bits) {
    const std::int64_t top = std::int64_t{1} << in(0, bits);
    return in(top / 2, top);
  }
  template <typename Value>
  Value pick(std::initializer_list<Value> values) {
    return *(values.begin() + in(0, static_cast<std::int64_t>(values.size()) - 1));
  }
  template <typename Range>
  std::size_t index(const Range& range) {
    return static_cast<std::size_t>(in(0, static_cast<std::int64_t>(range.size()) - 1));
  }
};

}  // namespace kagesen::stress
