#include "model/unit/winding/cluster_index.h"

#include <algorithm>
#include <utility>

namespace kagesen::unit::winding {
namespace {

constexpr std::size_t kLeaf = 8;

/// As many leaves as would hold so many clusters side by side: where they lie in layers, more
/// would not part them.
int levels(std::size_t clusters) {
  int n = 0;
  while ((std::size_t{kLeaf} << (2 * n)) < 4 * clusters) ++n;
  return n;
}

}  // namespace

ClusterIndex::ClusterIndex(const SilhouetteBuffer& slb, std::uint32_t list, const Widths& widths)
    : slb_(slb), texel_bits_(widths.texel_bits), shift_(widths.texel_bits - widths.end_bits) {
  std::uint64_t segments = 0;
  for (std::uint32_t at = list; at != SilhouetteBuffer::kNone; at = slb[at].next) {
    members_.push_back(at);
    segments_before_.push_back(segments);
    segments += slb[at].segment_count;
  }
  segments_before_.push_back(segments);
  std::vector<std::uint32_t> all;
  for (std::uint32_t rank = 0; rank < count(); ++rank) {
    all.push_back(2 * rank + slb[members_[rank]].full);
  }
  nodes_.emplace_back();
  smallest_ = std::int64_t{1} << std::max(texel_bits_ - levels(all.size()), 0);
  split(0, {0, 0, std::int64_t{1} << texel_bits_}, std::move(all));
}

int ClusterIndex::relation(const Cluster& cluster, const Square& square) const {
  const std::int64_t reach = shift_ == 0 ? 0 : std::int64_t{1} << (shift_ - 1);
  const Place lower{square.x, square.y};
  int winding = cluster.corner;
  bool touched = false;
  slb_.each_segment(cluster, [&](const Segment& s) {
    const auto apart = [&](std::int32_t a, std::int32_t b, std::int64_t from) {
      const std::int64_t low = std::int64_t{std::min(a, b)} << shift_;
      const std::int64_t high = std::int64_t{std::max(a, b)} << shift_;
      return high + reach < from || low - reach >= from + square.side;
    };
    touched = !apart(s.x0, s.x1, square.x) && !apart(s.y0, s.y1, square.y);
    winding += crossing(s, lower, shift_).winding;
    return !touched;
  });
  if (touched) return 2;
  return winding > 0 ? 1 : 0;
}

void ClusterIndex::split(std::uint32_t node, const Square& square,
                         std::vector<std::uint32_t> entries) {
  const bool undecided = std::any_of(entries.begin(), entries.end(),
                                     [](std::uint32_t entry) { return (entry & 1) == 0; });
  if (entries.size() <= kLeaf || !undecided || square.side <= smallest_) {
    nodes_[node].begin = static_cast<std::uint32_t>(entries_.size());
    entries_.insert(entries_.end(), entries.begin(), entries.end());
    nodes_[node].end = static_cast<std::uint32_t>(entries_.size());
    return;
  }
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first_child = child;
  nodes_.resize(nodes_.size() + 4);
  const std::int64_t half = square.side / 2;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Square part{square.x + (i & 1) * half, square.y + (i >> 1) * half, half};
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t entry : entries) {
      const int known = (entry & 1) != 0 ? 1 : relation(slb_[members_[entry >> 1]], part);
      if (known != 0) kept.push_back((entry & ~1u) | (known == 1));
    }
    split(child + i, part, std::move(kept));
  }
}

}  // namespace kagesen::unit::winding
