#pragma once
/// What becomes of a texel that is visited, or settled: what a model of the store's time needs.
///
/// A record of the SLB goes by its number: the n-th one that was given out, from 0.
#include <cstdint>
#include <vector>

#include "model/unit/winding/plane.h"

namespace kagesen::unit::winding {

struct TexelVisit {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  /// What a texel that one plane covers does with it.
  enum class Plane : std::uint8_t { kMeets, kLeaves, kPuts };
  /// Is it behind the cover of a texel with a list? kOfItsObject: and that hides it; kHidden: another
  /// object's cover hides it, too; kShown: none does.
  enum class Behind : std::uint8_t { kNot, kOfItsObject, kHidden, kShown };
  /// What its segment meets in its cluster, of which so many are before that, the last one stored
  /// first.
  struct Meeting {
    enum : std::uint8_t { kNothing, kSamePoint, kOpposite } what = kNothing;
    std::uint32_t before = 0;
    bool cancels() const { return what == kOpposite; }
  };

  Threshold threshold;
  std::uint32_t found = kNone;    ///< the first record of its plane's cluster
  Meeting meeting;
  std::uint32_t dropped = 0;      ///< how many clusters it hides
  bool masked = false;            ///< no fragment is there, or none is far enough: nothing else
  bool nearest = false;           ///< of its tile, as clamped depths go
  bool corner = false, segment = false;  ///< an edge's: what it adds
  bool may_meet = false;          ///< its segment may meet another
  bool corner_full = false;       ///< its cluster counts no more corners
  bool covers_nearest = false;    ///< it is the texel's nearest cover
  Plane plane = Plane::kMeets;
  Behind behind = Behind::kNot;
};

/// What settling does to texels with lists, in the order in which they are settled.
struct SettleTrail {
  struct Texel {
    std::uint32_t emptied, dropped;  ///< how many of both
  };
  /// A cluster without segments.
  struct Emptied {
    std::uint32_t record;
    bool covers;   ///< else it goes
    bool nearest;  ///< of the texel's covers
  };
  std::vector<Texel> texels;
  std::vector<Emptied> emptied;
  std::vector<std::uint32_t> dropped;

  void clear() {
    texels.clear();
    emptied.clear();
    dropped.clear();
  }
};

}  // namespace kagesen::unit::winding
