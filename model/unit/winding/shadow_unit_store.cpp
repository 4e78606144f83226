#include <algorithm>
#include <limits>

#include "model/unit/winding/shadow_unit.h"

namespace kagesen::unit::winding {

/// Is something that begins at `nearest` behind what covers the texel, for every fragment that it
/// could shadow? Behind a cover of its own object, or else, where a fragment may belong to the
/// cover's object, behind two covers of different objects.
bool ShadowUnit::hidden(const Texel& texel, std::int64_t nearest, std::uint32_t object) const {
  if (texel.object == Texel::kNobody || texel.overflow()) return false;
  if (!texel.has_list()) {
    return (!paper_ || texel.object == object) &&
           nearest >= ThresholdPlane(texel.cover, widths_).farthest();
  }
  if (nearest < texel.cover.base) return false;
  if (!paper_ || texel.object == object) return true;
  for (std::uint32_t at = texel.list; at != SilhouetteBuffer::kNone; at = slb_[at].next) {
    const Cluster& c = slb_[at];
    if (c.full && c.object != texel.object &&
        nearest >= ThresholdPlane(c.threshold, widths_).farthest()) {
      return true;
    }
  }
  return false;
}

/// The cluster of the visit's plane, or kNone; and, if it is none, the records of the whole list.
std::uint32_t ShadowUnit::find(const Visit& visit, std::uint32_t object, std::uint32_t& records) {
  std::uint32_t passed = 0;
  records = 0;
  for (std::uint32_t at = visit.texel->list; at != SilhouetteBuffer::kNone; at = slb_[at].next) {
    if (slb_[at].same_plane(visit.threshold, object)) return at;
    records += slb_.records_of(slb_[at]);
    if (++passed == kLongList) return find_in_long_list(visit, object, records);
  }
  return SilhouetteBuffer::kNone;
}

std::uint32_t ShadowUnit::find_in_long_list(const Visit& visit, std::uint32_t object,
                                            std::uint32_t& records) {
  LongList& list = long_lists_[visit.index];
  if (list.clusters.empty()) {
    list.records = 0;
    for (std::uint32_t at = visit.texel->list; at != SilhouetteBuffer::kNone; at = slb_[at].next) {
      list.clusters.emplace(plane_key(slb_[at].threshold, slb_[at].object), at);
      list.records += slb_.records_of(slb_[at]);
    }
  }
  records = list.records;
  const auto found = list.clusters.find(plane_key(visit.threshold, object));
  return found == list.clusters.end() ? SilhouetteBuffer::kNone : found->second;
}

ShadowUnit::LongList* ShadowUnit::long_list(const Visit& visit) {
  if (long_lists_.empty()) return nullptr;
  const auto found = long_lists_.find(visit.index);
  return found == long_lists_.end() ? nullptr : &found->second;
}

std::uint32_t ShadowUnit::records_of_list(const Visit& visit) {
  if (const LongList* list = long_list(visit)) return list->records;
  std::uint32_t records = 0;
  for (std::uint32_t at = visit.texel->list; at != SilhouetteBuffer::kNone; at = slb_[at].next) {
    records += slb_.records_of(slb_[at]);
  }
  return records;
}

/// Makes the cover a cluster of the list. False if there is no room.
bool ShadowUnit::open_list(Texel& texel) {
  const std::uint32_t at = slb_.insert(texel.list, texel.cover, texel.object);
  if (at == SilhouetteBuffer::kNone) return false;
  slb_[at].full = true;
  note_cover(texel, ThresholdPlane(texel.cover, widths_).farthest(), texel.object);
  return true;
}

/// Of a texel with a list: its cover is the full cluster that ends nearest.
void ShadowUnit::note_cover(Texel& texel, std::int64_t farthest, std::uint32_t object) {
  const std::int64_t depth =
      std::min<std::int64_t>(farthest, std::numeric_limits<std::int32_t>::max());
  texel.cover = {static_cast<std::int32_t>(depth), 0, 0};
  texel.object = object;
}

/// Adds to the cluster of the visit's plane; null if there is no room for it.
Cluster* ShadowUnit::cluster_of(const Visit& visit, std::uint32_t object) {
  Texel& texel = *visit.texel;
  if (texel.one_plane() && !open_list(texel)) return nullptr;
  std::uint32_t records;
  std::uint32_t at = find(visit, object, records);
  if (trail_ != nullptr && at != SilhouetteBuffer::kNone) note()->found = slb_[at].record;
  if (at == SilhouetteBuffer::kNone) {
    if (records >= static_cast<std::uint32_t>(config_.chain_records)) return nullptr;
    at = slb_.insert(texel.list, visit.threshold, object);
    if (at == SilhouetteBuffer::kNone) return nullptr;
    if (LongList* list = long_list(visit)) {
      list->clusters.emplace(plane_key(visit.threshold, object), at);
      ++list->records;
    }
  }
  return &slb_[at];
}

/// Is it the plane that covers the texel, which has no list?
bool ShadowUnit::same_plane(const Visit& visit, std::uint32_t object) {
  const Texel& texel = *visit.texel;
  const bool same =
      texel.one_plane() && texel.cover == visit.threshold && texel.object == object;
  if (same && trail_ != nullptr) note()->plane = TexelVisit::Plane::kLeaves;
  return same;
}

void ShadowUnit::add(const Visit& visit, std::uint32_t object, bool corner,
                     const Segment* segment) {
  Texel& texel = *visit.texel;
  if (trail_ != nullptr) {
    note()->corner = corner;
    note()->segment = segment != nullptr;
    note()->may_meet = segment != nullptr && segment->may_meet();
  }
  if (!corner && segment == nullptr) return;
  if (texel.overflow()) return overflow(visit, object);
  if (same_plane(visit, object)) return;
  Cluster* cluster = cluster_of(visit, object);
  if (cluster == nullptr) return overflow(visit, object);
  if (cluster->full) return;
  cluster->corner += corner;
  if (cluster->corner >> config_.corner_bits) {
    if (trail_ != nullptr) note()->corner_full = true;
    return overflow(visit, object);
  }
  if (segment == nullptr) return;
  TexelVisit::Meeting meeting;
  const std::uint32_t before = slb_.records_of(*cluster);
  const bool stored = slb_.add(*cluster, *segment, meeting);
  if (trail_ != nullptr) note()->meeting = meeting;
  if (LongList* list = long_list(visit)) list->records += slb_.records_of(*cluster) - before;
  const bool grown = slb_.records_of(*cluster) > before;
  if (!stored ||
      (grown && records_of_list(visit) > static_cast<std::uint32_t>(config_.chain_records))) {
    return overflow(visit, object);
  }
  ++(meeting.cancels() ? counters_.lines_cancelled : counters_.lines_stored);
}

/// The facet covers the whole texel.
void ShadowUnit::cover(const Visit& visit, std::uint32_t object) {
  Texel& texel = *visit.texel;
  if (texel.overflow()) return overflow(visit, object);
  if (texel.empty()) {
    texel.cover = visit.threshold;
    texel.object = object;
    return;
  }
  if (texel.one_plane()) {
    if (same_plane(visit, object)) return;
    const bool replaces = (!paper_ || texel.object == object) &&
                          ThresholdPlane(texel.cover, widths_).nearest() >= visit.farthest;
    if (replaces) {
      if (trail_ != nullptr) note()->plane = TexelVisit::Plane::kPuts;
      texel.cover = visit.threshold;
      texel.object = object;
      return;
    }
  }
  Cluster* cluster = cluster_of(visit, object);
  if (cluster == nullptr) return overflow(visit, object);
  if (cluster->full) return;
  long_lists_.erase(visit.index);
  slb_.drop_segments(*cluster);
  cluster->full = true;
  cluster->corner = 0;
  if (texel.object == Texel::kNobody || visit.farthest < texel.cover.base) {
    note_cover(texel, visit.farthest, object);
    if (trail_ != nullptr) note()->covers_nearest = true;
  }
  const std::size_t dropped = dropped_ == nullptr ? 0 : dropped_->size();
  drop_hidden(texel);
  if (trail_ != nullptr) note()->dropped = static_cast<std::uint32_t>(dropped_->size() - dropped);
}

void ShadowUnit::drop_hidden(Texel& texel) {
  std::uint32_t previous = SilhouetteBuffer::kNone;
  for (std::uint32_t at = texel.list; at != SilhouetteBuffer::kNone;) {
    const Cluster& c = slb_[at];
    const std::uint32_t next = c.next;
    if (hidden(texel, ThresholdPlane(c.threshold, widths_).nearest(), c.object)) {
      counters_.lines_hidden += c.segment_count;
      if (dropped_ != nullptr) dropped_->push_back(c.record);
      slb_.erase(texel.list, previous);
    } else {
      previous = at;
    }
    at = next;
  }
  const Cluster& first = slb_[texel.list];
  if (first.full && first.next == SilhouetteBuffer::kNone) {
    texel.cover = first.threshold;
    texel.object = first.object;
    slb_.erase(texel.list, SilhouetteBuffer::kNone);
  }
}

void ShadowUnit::overflow(const Visit& visit, std::uint32_t object) {
  Texel& texel = *visit.texel;
  const auto keep_nearest = [&](const Threshold& t, std::uint32_t of) {
    const std::int64_t depth = t.base * (std::int64_t{1} << widths_.step_bits);
    const bool keeps = texel.object == Texel::kNobody || depth < texel.cover.base;
    if (keeps) note_cover(texel, depth, of);
    return keeps;
  };
  ++counters_.overflow_lines;
  long_lists_.erase(visit.index);
  if (!texel.overflow()) {
    ++counters_.overflow_texels;
    if (texel.one_plane()) {
      note_cover(texel, texel.cover.base * (std::int64_t{1} << widths_.step_bits), texel.object);
    } else {
      texel.object = Texel::kNobody;
    }
    while (texel.has_list()) {
      const Cluster& c = slb_[texel.list];
      counters_.overflow_lines += c.segment_count;
      keep_nearest(c.threshold, c.object);
      slb_.erase(texel.list, SilhouetteBuffer::kNone);
    }
    texel.list = Texel::kOverflow;
  }
  const bool keeps = keep_nearest(visit.threshold, object);
  if (trail_ != nullptr) note()->covers_nearest = keeps;
}

}  // namespace kagesen::unit::winding
