#pragma once
/// Exact rationals for the tests: what the blocks compute in integers, said in plain arithmetic.
#include <cstdint>

namespace kagesen {

class Rational {
 public:
  using Wide = __int128;
  constexpr Rational(std::int64_t value = 0) : n_(value), d_(1) {}  // NOLINT: numbers convert
  constexpr Rational(Wide numerator, Wide denominator)
      : n_(denominator < 0 ? -numerator : numerator),
        d_(denominator < 0 ? -denominator : denominator) {
    reduce();
  }

  friend constexpr Rational operator+(Rational a, Rational b) {
    return {a.n_ * b.d_ + b.n_ * a.d_, a.d_ * b.d_};
  }
  friend constexpr Rational operator-(Rational a, Rational b) {
    return {a.n_ * b.d_ - b.n_ * a.d_, a.d_ * b.d_};
  }
  friend constexpr Rational operator*(Rational a, Rational b) { return {a.n_ * b.n_, a.d_ * b.d_}; }
  friend constexpr Rational operator/(Rational a, Rational b) { return {a.n_ * b.d_, a.d_ * b.n_}; }
  friend constexpr bool operator<(Rational a, Rational b) { return a.n_ * b.d_ < b.n_ * a.d_; }
  friend constexpr bool operator<=(Rational a, Rational b) { return !(b < a); }
  friend constexpr bool operator==(Rational a, Rational b) { return !(a < b) && !(b < a); }

  constexpr std::int64_t floor() const {
    return static_cast<std::int64_t>(n_ / d_ - (n_ % d_ < 0 ? 1 : 0));
  }

 private:
  constexpr void reduce() {
    Wide a = n_ < 0 ? -n_ : n_, b = d_;
    while (b != 0) {
      const Wide rest = a % b;
      a = b;
      b = rest;
    }
    n_ /= a;
    d_ /= a;
  }
  Wide n_, d_;
};

}  // namespace kagesen
