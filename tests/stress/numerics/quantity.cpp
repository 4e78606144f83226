#include "tests/stress/numerics/quantity.h"

#include <algorithm>

namespace kagesen::stress {
namespace {

/// FNV-1a: the same on every platform.
std::uint64_t number_of(const std::string& name) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

/// Some other inputs, near these.
Inputs changed(const Inputs& inputs, Dice& dice) {
  Inputs out = inputs;
  const auto count = dice.in(1, 2);
  for (std::int64_t i = 0; i < count; ++i) {
    std::int64_t& value = out[dice.index(out)];
    value += dice.one_in(2) ? dice.in(-3, 3) : dice.either(dice.magnitude(24));
  }
  return out;
}

}  // namespace

Worst find_worst(const Quantity& quantity, std::uint64_t seed, std::uint64_t samples) {
  Worst worst;
  // Every quantity has its own dice, so that one more of them changes none of the others.
  Dice dice = Dice::of_case(seed, number_of(quantity.profile + quantity.name));
  for (std::uint64_t n = 0; n < samples; ++n) {
    const bool near = !worst.inputs.empty() && dice.one_in(2);
    const Inputs inputs = near ? changed(worst.inputs, dice) : quantity.draw(dice);
    const std::optional<Exact> value = quantity.measure(inputs);
    if (!value) continue;
    ++worst.samples;
    worst.exceeded += !quantity.within(*value);
    if (worst.inputs.empty() || *value > worst.value) {
      worst.value = *value;
      worst.inputs = inputs;
    }
  }
  return worst;
}

std::vector<Quantity> all_quantities() {
  std::vector<Quantity> all = paper_quantities();
  for (Quantity& q : winding_value_quantities()) all.push_back(std::move(q));
  for (Quantity& q : winding_width_quantities()) all.push_back(std::move(q));
  return all;
}

int signed_bits(const Exact& value) {
  boost::multiprecision::cpp_int whole = boost::multiprecision::numerator(value);
  if (whole < 0) whole = -whole - 1;
  return whole == 0 ? 1 : static_cast<int>(msb(whole)) + 2;
}

}  // namespace kagesen::stress
