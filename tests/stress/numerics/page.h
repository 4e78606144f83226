#pragma once
/// docs/numerics.md.
#include <string>
#include <vector>

#include "tests/stress/numerics/quantity.h"

namespace kagesen::stress {

struct Measured {
  Quantity quantity;
  Worst worst;
};

/// @param command  that writes this very page
std::string numerics_page(const std::vector<Measured>& measured, const std::string& command);

}  // namespace kagesen::stress
