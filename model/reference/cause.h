#pragma once
/// Why a unit's verdict is wrong, found from the final contents of its buffers.
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/engine.h"
#include "model/reference/judge.h"
#include "model/reference/reference.h"
#include "model/unit/combination.h"

namespace kagesen {

/// Attributes wrong verdicts (paper semantics), one fragment at a time.
///
/// It follows the source that misled the unit: the buffers' depth and ID, or an entry's lines.
/// Lines are compared with the exact outline of their object in that texel (edges cancelled by
/// equal ends, not by rounded fields): other lines are a matter of cancelling or hidden removal;
/// equal lines are a matter of rounding if the exact half planes in their place give the right
/// answer, else of combination.
class CauseFinder {
 public:
  CauseFinder(const Trace& trace, const UnitConfig& config, const FrameSetup& setup,
              const MapContents& contents, const ExactReference& reference);

  /// @param fragment  one whose verdict differs from `exact_dark`
  Cause find(const Fragment& fragment, bool exact_dark) const;

 private:
  struct OutlineLine {  // an exact edge of an object that crosses the texel, and its stored form
    unit::Line line;
    LightPoint from, to;
    std::uint32_t nearest = 0;
  };
  struct Place {
    std::int32_t x, y;    // texel
    std::uint32_t index;  // of the texel
    std::uint32_t depth;  // of the fragment, as the unit compares it
    std::uint32_t id;     // of the fragment's object
    unit::SubTexel point;
  };

  Cause false_dark(const Fragment& f, const Place& at) const;
  Cause false_lit(const Fragment& f, const Place& at) const;
  Cause missed_object(const Fragment& f, const Place& at, std::uint32_t object) const;
  /// An entry's lines held against its object's exact outline in the texel.
  struct Outline {
    bool crossed = false;  ///< some edge of the object crosses the texel, cancelled or not
    std::vector<OutlineLine> expected;
    bool equal = false;              ///< the stored lines are those of the outline
    std::vector<OutlineLine> match;  ///< if equal: of each stored line
  };

  Cause outline(const Fragment& f, const Place& at, const TexelEntry& entry, bool covered) const;
  const Outline& outline_of(const Place& at, std::uint32_t id) const;
  bool removed_as_hidden(const Place& at, const Outline& outline) const;
  bool within_bound(const OutlineLine& line, const Fragment& f, const Place& at) const;
  void find_outline(const Place& at, std::uint32_t id, Outline& out) const;
  unit::Combination& combination_of(const TexelEntry& entry) const;
  bool covered(const Fragment& f, std::uint32_t id) const;
  const TexelEntry* entry_of(const Place& at, std::uint32_t id) const;
  std::pair<const TexelEntry*, const TexelEntry*> entries_at(std::uint32_t texel) const;
  std::uint32_t unit_id(std::uint32_t object) const;

  const Trace& trace_;
  const UnitConfig config_;
  const FrameSetup setup_;
  const MapContents& contents_;
  const ExactReference& reference_;
  unit::ShadowDecision decision_;
  std::vector<std::vector<std::uint32_t>> objects_of_id_;        // where IDs are shared
  mutable std::unordered_map<std::uint64_t, Outline> outlines_;  // by texel and ID
  mutable std::unordered_map<const TexelEntry*, unit::Combination> combinations_;
};

}  // namespace kagesen
