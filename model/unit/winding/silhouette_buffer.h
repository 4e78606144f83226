#pragma once
/// Silhouette line buffer (SLB) of the winding profile: clusters of segments, linked by texel.
#include <cstdint>
#include <vector>

#include "model/unit/winding/plane.h"
#include "model/unit/winding/segment.h"
#include "model/unit/winding/store_trail.h"

namespace kagesen::unit::winding {

/// The facets of one plane in one texel.
struct Cluster {
  Threshold threshold;
  std::uint32_t object = 0;  ///< 0 in physical semantics
  std::int32_t corner = 0;   ///< how many of its facets cover the texel's corner
  bool full = false;         ///< one of them covers all of the texel: neither corner nor segments
  std::uint32_t segment_count = 0;
  std::uint32_t first_segment = 0;
  std::uint32_t next = 0;    ///< in the texel
  std::uint32_t record = 0;  ///< number of its first record

  bool same_plane(const Threshold& t, std::uint32_t of_object) const {
    return threshold == t && object == of_object;
  }
};

/// Clusters and segments in pools. Memory is counted in records, as hardware would allocate: one a
/// cluster with room for `segments_per_record` segments, and one for each so many more. All records
/// of a cluster but its first are full; segments go to the first one, and leave from there: where
/// one is cancelled, the last one stored takes its place.
class SilhouetteBuffer {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  void clear(std::uint32_t capacity, std::uint32_t segments_per_record);

  Cluster& operator[](std::uint32_t at) { return clusters_[at]; }
  const Cluster& operator[](std::uint32_t at) const { return clusters_[at]; }
  /// A cluster of no facet in front of the list `head`, or kNone if there is no room.
  std::uint32_t insert(std::uint32_t& head, const Threshold& threshold, std::uint32_t object);
  /// Unlinks and frees the cluster that follows `previous` (kNone: is first).
  void erase(std::uint32_t& head, std::uint32_t previous);
  /// Stores a segment, or cancels the other piece of an inner edge; a dot is stored once. False if
  /// there is no room.
  bool add(Cluster& c, const Segment& segment, TexelVisit::Meeting& meeting);
  void drop_segments(Cluster& c);
  /// The last one stored first: record by record.
  template <typename Use>
  void each_segment(const Cluster& cluster, Use use) const {
    for (std::uint32_t at = cluster.first_segment; at != kNone; at = segments_[at].next) {
      if (!use(segments_[at].segment)) return;
    }
  }
  std::uint32_t records_of(const Cluster& c) const { return records_for(c.segment_count); }
  std::uint32_t segments_per_record() const { return per_record_; }
  /// In the cluster's first record.
  std::uint32_t first_segments_of(const Cluster& c) const {
    return c.segment_count == 0 ? 0 : (c.segment_count - 1) % per_record_ + 1;
  }
  /// The record behind this one in its cluster.
  std::uint32_t record_behind(std::uint32_t record) const { return behind_[record]; }
  std::uint64_t records() const { return records_; }
  std::uint64_t peak_records() const { return peak_; }

 private:
  struct Node {
    Segment segment;
    std::uint32_t next;
  };
  std::uint32_t records_for(std::uint32_t segments) const {
    return segments <= per_record_ ? 1 : (segments + per_record_ - 1) / per_record_;
  }
  std::uint32_t new_record(std::uint32_t behind) {
    behind_.push_back(behind);
    return static_cast<std::uint32_t>(behind_.size() - 1);
  }
  void take(std::uint32_t records) {
    records_ += records;
    if (records_ > peak_) peak_ = records_;
  }

  std::vector<Cluster> clusters_;
  std::vector<Node> segments_;
  std::vector<std::uint32_t> behind_;  // by a record's number
  std::uint32_t free_cluster_ = kNone, free_segment_ = kNone;
  std::uint64_t capacity_ = 0, records_ = 0, peak_ = 0;
  std::uint32_t per_record_ = 1;
};

}  // namespace kagesen::unit::winding
