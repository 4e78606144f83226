#pragma once
/// Which clusters of a long list can hold a point: a quadtree over one texel.
///
/// The hardware reads the list from its head; so do the counters. The tree only spares the model
/// the clusters that cannot hold the point.
#include <cstdint>
#include <vector>

#include "model/unit/winding/silhouette_buffer.h"

namespace kagesen::unit::winding {

class ClusterIndex {
 public:
  /// Lists shorter than this, or looked up less often, are read through.
  static constexpr std::uint32_t kWorthwhile = 64;

  ClusterIndex(const SilhouetteBuffer& slb, std::uint32_t list, const Widths& widths);

  std::uint32_t count() const { return static_cast<std::uint32_t>(members_.size()); }
  std::uint32_t member(std::uint32_t rank) const { return members_[rank]; }
  /// Segments of the clusters before `rank`.
  std::uint64_t segments_before(std::uint32_t rank) const { return segments_before_[rank]; }

  /// Calls use(rank, surely inside) in list order for clusters that may hold the point, until it
  /// returns false.
  template <typename Use>
  void candidates(const Place& place, Use use) const {
    const Node* node = &nodes_[0];
    for (int shift = texel_bits_ - 1; node->first_child != 0; --shift) {
      const auto right = static_cast<std::uint32_t>(place.x >> shift & 1);
      const auto upper = static_cast<std::uint32_t>(place.y >> shift & 1);
      node = &nodes_[node->first_child + 2 * upper + right];
    }
    for (std::uint32_t i = node->begin; i < node->end; ++i) {
      if (!use(entries_[i] >> 1, (entries_[i] & 1) != 0)) return;
    }
  }

 private:
  struct Node {
    std::uint32_t first_child = 0;  // of four; 0: a leaf
    std::uint32_t begin = 0, end = 0;
  };
  struct Square {  // units, upper bounds exclusive
    std::int64_t x, y, side;
  };
  void split(std::uint32_t node, const Square& square, std::vector<std::uint32_t> entries);
  /// 0: outside all over, 1: inside all over, 2: either
  int relation(const Cluster& cluster, const Square& square) const;

  const SilhouetteBuffer& slb_;
  int texel_bits_, shift_;
  std::int64_t smallest_ = 1;  // side of a leaf that is not split
  std::vector<std::uint32_t> members_;
  std::vector<std::uint64_t> segments_before_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> entries_;  // rank * 2 + surely inside
};

}  // namespace kagesen::unit::winding
