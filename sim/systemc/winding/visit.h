#pragma once
/// A visit of the winding profile: what a front hands to the store. Twin: visit_t in shadow_pkg.sv.
#include <cstdint>

#include "sim/systemc/common/visit_register.h"

namespace kagesen::tlm_model::winding {

struct Visit {
  enum Kind : std::uint8_t { kBegin = 0, kEdge = 1, kSpan = 3 };
  Kind kind = kBegin;
  std::int32_t x = 0, y = 0;  ///< texel on the map; of a span: the word's first texel
  unsigned mask = 0;          ///< of a span: texels that it covers
};

using VisitTaker = tlm_model::VisitTaker<Visit>;
using VisitRegister = tlm_model::VisitRegister<Visit>;

}  // namespace kagesen::tlm_model::winding
