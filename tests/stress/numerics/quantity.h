#pragma once
/// Fixed-point quantities of the unit, each with its bound on paper and the worst value found.
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/stress/dice.h"

namespace kagesen::stress {

/// Exact arithmetic, of any size.
using Exact = boost::multiprecision::cpp_rational;

/// What a quantity is measured on: a few integers, named in Quantity::inputs.
using Inputs = std::vector<std::int64_t>;

struct Quantity {
  std::string profile;  ///< "paper" or "winding"
  std::string name;
  std::string format;   ///< as stored or computed
  std::string meaning;  ///< of the value that is bounded, with its unit
  std::string bound;    ///< on paper: the formula
  Exact limit;          ///< its value
  bool strict = false;  ///< the value stays below the limit; else it may reach it
  std::vector<std::string> inputs;
  Inputs (*draw)(Dice&);
  /// The value, or nothing where the inputs are outside its domain.
  std::optional<Exact> (*measure)(const Inputs&);

  bool within(const Exact& value) const { return strict ? value < limit : value <= limit; }
};

struct Worst {
  Exact value = 0;
  Inputs inputs;               ///< empty: nothing was measured
  std::uint64_t samples = 0;   ///< that were in the domain
  std::uint64_t exceeded = 0;  ///< of these, beyond the bound
};

/// Draws inputs, and changes the worst ones a little, until the samples are used up.
Worst find_worst(const Quantity& quantity, std::uint64_t seed, std::uint64_t samples);

std::vector<Quantity> paper_quantities();
std::vector<Quantity> winding_value_quantities();
std::vector<Quantity> winding_width_quantities();
std::vector<Quantity> all_quantities();

/// Bits of a two's complement number that holds the value.
int signed_bits(const Exact& value);

}  // namespace kagesen::stress
