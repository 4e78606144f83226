#pragma once
/// What goes through the store's stages: a visit, an announced fragment, or a tile or word to settle.
/// Twin: visit_t of rtl/winding/shadow_pkg.sv with VisitTile, as far as it takes time.
#include <cstdint>

namespace kagesen::tlm_model::winding {

/// Of a word of the texel memory, of a tile, or of an SLB record.
using WordAddress = std::uint32_t;

struct Work {
  enum Kind : std::uint8_t { kBegin, kEdge, kTile, kSpan } kind = kBegin;
  std::uint8_t texels = 0;   ///< of the word: those visited; behind the tiles: those that pass
  std::uint8_t passing = 0;  ///< which the receiver mask does not refuse
  std::uint8_t place = 0;    ///< of the word in its tile
  WordAddress tile = 0;      ///< of a visit
  bool nearest = false;      ///< the tile's nearest depth changes
  bool last = false;         ///< settling: the word is its tile's last
};

}  // namespace kagesen::tlm_model::winding
