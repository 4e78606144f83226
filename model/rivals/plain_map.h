#pragma once
/// The plain shadow map with object IDs: nearest depth and ID at each texel's centre.
#include <cstdint>
#include <vector>

#include "model/engine.h"
#include "model/reference/reference.h"

namespace kagesen {

/// A plain map of `side` x `side` texels over the same area as a W x H unit map of 2^fraction_bits
/// units a texel. Holds depth and ID of the nearest surface at texel centres.
class PlainMap {
 public:
  PlainMap(std::uint32_t width, std::uint32_t height, std::uint32_t map_width, std::uint32_t map_height,
           std::uint32_t fraction_bits);
  /// Rasterises a caster: texels whose centre it covers (edges included).
  void draw(const Caster& caster);
  /// Paper semantics: dark iff the texel's ID differs from the fragment's and its depth is nearer.
  /// Physical: dark iff the depth is nearer by more than `bias`.
  Verdict decide(const Fragment& f, Semantics semantics, std::uint32_t bias = 0) const;
  std::uint64_t bytes() const;

 private:
  struct Texel {
    std::uint32_t depth, object;
  };
  std::vector<Texel> texels_;
  std::uint32_t width_, height_, map_width_, map_height_, fraction_bits_;
};

/// The verdict a plain map of the given side would give, from one exact query at the texel's centre;
/// for sides far too large to store.
Verdict plain_map_verdict(const ExactReference& reference, const Fragment& f, Semantics semantics, std::uint64_t side,
                          std::uint32_t map_width, std::uint32_t map_height, std::uint32_t fraction_bits);

}  // namespace kagesen
