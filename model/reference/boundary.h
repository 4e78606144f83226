#pragma once
/// The outline of the shadow at one depth: how far a point is from it.
///
/// At depth z the region in shadow is the union, over the relevant casters, of the part of each
/// triangle whose plane is nearer than z. Its outline consists of pieces of open edges and of the
/// lines at which a plane passes z. Doubles, relative to the query point; accurate to well below
/// one unit. Gaps narrower than 1/16 unit count as closed.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/reference/caster_tree.h"
#include "model/reference/reference.h"

namespace kagesen {

/// What counts as the outline of a shadow at one depth.
enum class Outline : std::uint8_t {
  kWhole,  ///< edges, and the lines at which a surface passes that depth
  kEdges,  ///< edges alone
};

class BoundaryFinder {
 public:
  /// Keeps a reference to the tree, which is one of outlines.
  explicit BoundaryFinder(const CasterTree& tree);

  /// Whose shadow, at what point and depth.
  struct Query {
    LightPoint p;
    std::uint32_t object;
    Semantics semantics;
    Outline outline = Outline::kWhole;
    bool relevant(std::uint32_t o) const {
      return semantics == Semantics::kPhysical || o != object;
    }
  };
  /// Distance to the outline in units, `limit` if none is nearer. `dark`: the exact verdict.
  double distance(const Query& q, bool dark, double limit) const;
  /// Is there an edge, covered or not, within `radius` units? A lit point sees every one.
  bool edge_within(const Query& q, double radius) const;

 private:
  struct Vector {
    double x, y;
  };
  /// A piece of some triangle's outline at the query's depth, relative to the query point.
  struct Segment {
    double distance;  ///< from the query point
    Vector a, b;
    Vector outward;  ///< unit normal away from the triangle's shadow
    std::uint32_t caster;
  };
  static constexpr std::uint32_t kNobody = 0xffffffffu, kSeveral = 0xfffffffeu;
  /// What a node and all below it can contribute to an outline.
  struct Summary {
    std::uint32_t open_nearest = 0xffffffffu;  ///< of casters with open edges
    std::uint32_t cut_nearest = 0xffffffffu, cut_farthest = 0;
    std::uint32_t object = kNobody;  ///< the only one there, kNobody or kSeveral

    void add_object(std::uint32_t o) {
      if (o != kNobody && o != object) object = object == kNobody ? o : kSeveral;
    }
    bool matters(const Query& q) const {
      if (q.semantics == Semantics::kPaper && object == q.object) return false;
      const bool cut = q.outline == Outline::kWhole && cut_nearest < q.p.z && q.p.z <= cut_farthest;
      return cut || open_nearest < q.p.z;
    }
  };

  void summarise();
  /// Where searches in growing rings start, units.
  double first_radius(const Query& q) const;
  /// True if one of the first few pieces found within `radius` has a lit point there just outside.
  template <class Emit>
  bool visit_segments(const Query& q, double radius, Emit emit) const;
  template <class Emit>
  bool emit_segments(const Query& q, std::uint32_t caster, unsigned edges, Emit emit) const;
  double lit_distance(const Query& q, double radius) const;
  double dark_distance(const Query& q, double radius) const;
  double uncovered_distance(const Query& q, const Segment& s, double best) const;
  bool covering_interval(const Query& q, const Segment& s, Vector along, double at, double& low,
                         double& high) const;

  const CasterTree& tree_;
  std::vector<std::uint8_t> open_;  ///< a caster each: its open edges
  std::vector<Summary> summaries_;  ///< a node each
};

}  // namespace kagesen
