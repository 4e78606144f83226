#include "model/unit/winding/silhouette_buffer.h"

namespace kagesen::unit::winding {

void SilhouetteBuffer::clear(std::uint32_t capacity, std::uint32_t segments_per_record) {
  clusters_.clear();
  segments_.clear();
  behind_.clear();
  free_cluster_ = free_segment_ = kNone;
  capacity_ = capacity;
  per_record_ = segments_per_record;
  records_ = peak_ = 0;
}

std::uint32_t SilhouetteBuffer::insert(std::uint32_t& head, const Threshold& threshold,
                                       std::uint32_t object) {
  if (records_ >= capacity_) return kNone;
  take(1);
  std::uint32_t at = free_cluster_;
  if (at != kNone) {
    free_cluster_ = clusters_[at].next;
  } else {
    at = static_cast<std::uint32_t>(clusters_.size());
    clusters_.emplace_back();
  }
  clusters_[at] = {threshold, object, 0, false, 0, kNone, head, new_record(kNone)};
  head = at;
  return at;
}

void SilhouetteBuffer::erase(std::uint32_t& head, std::uint32_t previous) {
  std::uint32_t& link = previous == kNone ? head : clusters_[previous].next;
  const std::uint32_t at = link;
  drop_segments(clusters_[at]);
  records_ -= 1;
  link = clusters_[at].next;
  clusters_[at].next = free_cluster_;
  free_cluster_ = at;
}

bool SilhouetteBuffer::add(Cluster& c, const Segment& segment, TexelVisit::Meeting& meeting) {
  meeting = {};
  const bool may_meet = segment.may_meet();
  for (std::uint32_t at = c.first_segment; may_meet && at != kNone; at = segments_[at].next, ++meeting.before) {
    if (segment.dot() && segments_[at].segment.dot() && segments_[at].segment.same_ends(segment)) {
      meeting.what = TexelVisit::Meeting::kSamePoint;
      return true;
    }
    if (!segments_[at].segment.opposes(segment)) continue;
    const std::uint32_t last = c.first_segment;
    segments_[at].segment = segments_[last].segment;
    c.first_segment = segments_[last].next;
    segments_[last].next = free_segment_;
    free_segment_ = last;
    if (records_for(c.segment_count) > records_for(c.segment_count - 1)) {
      --records_;
      behind_[c.record] = behind_[behind_[c.record]];
    }
    --c.segment_count;
    meeting.what = TexelVisit::Meeting::kOpposite;
    return true;
  }
  const std::uint32_t more = records_for(c.segment_count + 1) - records_for(c.segment_count);
  if (records_ + more > capacity_) return false;
  take(more);
  if (more != 0) behind_[c.record] = new_record(behind_[c.record]);
  std::uint32_t at = free_segment_;
  if (at != kNone) {
    free_segment_ = segments_[at].next;
  } else {
    at = static_cast<std::uint32_t>(segments_.size());
    segments_.emplace_back();
  }
  segments_[at] = {segment, c.first_segment};
  c.first_segment = at;
  ++c.segment_count;
  return true;
}

void SilhouetteBuffer::drop_segments(Cluster& c) {
  records_ -= records_for(c.segment_count) - 1;
  while (c.first_segment != kNone) {
    const std::uint32_t at = c.first_segment;
    c.first_segment = segments_[at].next;
    segments_[at].next = free_segment_;
    free_segment_ = at;
  }
  c.segment_count = 0;
  behind_[c.record] = kNone;
}

}  // namespace kagesen::unit::winding
