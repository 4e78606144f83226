#include <algorithm>

#include "model/unit/winding/shadow_unit.h"

namespace kagesen::unit::winding {

void ShadowUnit::settle(SettleTrail& trail) {
  trail.clear();
  settle_trail_ = &trail;
  dropped_ = &trail.dropped;
  settle();
  settle_trail_ = nullptr;
  dropped_ = nullptr;
}

void ShadowUnit::settle() {
  if (settled_) return;
  settled_ = true;
  long_lists_.clear();
  indices_.clear();
  for (Tile& tile : texels_.tiles()) {
    if (tile.slot == Tile::kUntouched) continue;
    for (std::uint32_t i = 0; i < TexelBuffers::kTileTexels; ++i) {
      Texel& texel = texels_.texel(tile, i & 7, i >> 3);
      if (texel.has_list()) settle_texel(texel);
    }
    sum_up(tile);
  }
}

/// A cluster whose segments have all cancelled covers the texel as it covers the corner.
void ShadowUnit::settle_texel(Texel& texel) {
  SettleTrail* const trail = settle_trail_;
  const std::size_t emptied = trail ? trail->emptied.size() : 0;
  const std::size_t dropped = trail ? trail->dropped.size() : 0;
  std::uint32_t previous = SilhouetteBuffer::kNone;
  for (std::uint32_t at = texel.list; at != SilhouetteBuffer::kNone;) {
    Cluster& c = slb_[at];
    const std::uint32_t next = c.next;
    const bool constant = !c.full && c.segment_count == 0;
    if (constant && trail != nullptr) trail->emptied.push_back({c.record, c.corner > 0, false});
    if (constant && c.corner <= 0) {
      slb_.erase(texel.list, previous);
    } else {
      if (constant) {
        c.full = true;
        c.corner = 0;
        ++counters_.emptied_covered;
        const std::int64_t farthest = ThresholdPlane(c.threshold, widths_).farthest();
        if (texel.object == Texel::kNobody || farthest < texel.cover.base) {
          note_cover(texel, farthest, c.object);
          if (trail != nullptr) trail->emptied.back().nearest = true;
        }
      }
      previous = at;
    }
    at = next;
  }
  if (texel.list != Texel::kNoList) drop_hidden(texel);
  if (trail != nullptr) {
    trail->texels.push_back({static_cast<std::uint32_t>(trail->emptied.size() - emptied),
                             static_cast<std::uint32_t>(trail->dropped.size() - dropped)});
  }
}

void ShadowUnit::sum_up(Tile& tile) {
  std::int64_t farthest = -ThresholdPlane::kUnbounded;
  std::uint32_t object = Texel::kNobody;
  for (std::uint32_t i = 0; i < TexelBuffers::kTileTexels; ++i) {
    const Texel& texel = texels_.texel(tile, i & 7, i >> 3);
    if (texel.object == Texel::kNobody) return;
    object = object == Texel::kNobody || object == texel.object ? texel.object : Tile::kSeveral;
    farthest = std::max(farthest, texel.list == Texel::kNoList
                                      ? ThresholdPlane(texel.cover, widths_).farthest()
                                      : std::int64_t{texel.cover.base});
  }
  tile.object = object;
  tile.farthest = farthest;
}

void ShadowUnit::decide(const Fragment* fragments, std::size_t count, Verdict* verdicts) {
  settle();
  Tally tally;
  for (std::size_t i = 0; i < count; ++i) verdicts[i] = decide_one(fragments[i], tally, nullptr);
  this->count(tally, count);
}

Verdict ShadowUnit::decide(const Fragment& fragment, FragmentTrail& trail, Tally& tally) {
  return decide_one(fragment, tally, &trail);
}

void ShadowUnit::count(const Tally& tally, std::size_t fragments) {
  counters_.fragments += fragments;
  counters_.averted += tally.averted;
  counters_.outside += tally.outside;
  counters_.dark_by_buffer += tally.dark_by_buffer;
  counters_.dark_by_lines += tally.dark_by_lines;
  counters_.lit +=
      fragments - tally.averted - tally.outside - tally.dark_by_buffer - tally.dark_by_lines;
  counters_.slb_lookups += tally.lists;
  counters_.entries_read += tally.clusters;
  counters_.lines_read += tally.segments;
  SkipCounters& skips = counters_.skips;
  skips.known_fragments += tally.known;
  skips.tile_lit += tally.tile_lit;
  skips.tile_dark += tally.tile_dark;
  skips.texel_lookups += tally.texels;
  skips.first_test_dark += tally.first_test;
}

bool ShadowUnit::by_definition(const Fragment& f, std::int32_t x, std::int32_t y) const {
  return (f.flags & (Fragment::kAverted | Fragment::kOutside)) != 0 || !texels_.holds(x, y);
}

bool ShadowUnit::known(const Fragment& f, std::int32_t x, std::int32_t y) const {
  return by_definition(f, x, y) || (config_.skip_fragments && f.object < unshadowable_.size() &&
                                    unshadowable_[f.object] != 0);
}

inline Verdict ShadowUnit::decide_one(const Fragment& fragment, Tally& tally,
                                      FragmentTrail* trail) {
  const std::int32_t x = (fragment.position.x >> widths_.texel_bits) + centre_x_;
  const std::int32_t y = (fragment.position.y >> widths_.texel_bits) + centre_y_;
  if (known(fragment, x, y)) {
    tally.known += config_.skip_fragments;
    const bool averted = (fragment.flags & Fragment::kAverted) != 0;
    if (by_definition(fragment, x, y)) {
      ++(averted ? tally.averted : tally.outside);
      if (!config_.skip_fragments && texels_.holds(x, y)) {
        Tally unused;
        look_up(fragment, x, y, unused, trail);
        tally.texels += unused.texels;
        if (trail != nullptr) {  // its verdict is known: the tile is the last that it reads
          trail->reads_texel = false;
          trail->records.clear();
        }
      }
    }
    return averted ? Verdict::kDark : Verdict::kLit;
  }
  return look_up(fragment, x, y, tally, trail);
}

inline Verdict ShadowUnit::look_up(const Fragment& fragment, std::int32_t x, std::int32_t y,
                                   Tally& tally, FragmentTrail* trail) {
  const Tile& tile = texels_.tile(x, y);
  if (trail != nullptr) {
    trail->reads_tile = true;
    trail->x = static_cast<std::uint32_t>(x);
    trail->y = static_cast<std::uint32_t>(y);
  }
  const std::int64_t depth = fragment.position.z;
  if (config_.skip_tiles) {
    if (depth <= tile.nearest) {
      ++tally.tile_lit;
      return Verdict::kLit;
    }
    if (depth > tile.farthest &&
        (!paper_ || (tile.object != Tile::kSeveral && tile.object != unit_id(fragment.object)))) {
      ++tally.tile_dark;
      ++tally.dark_by_buffer;
      return Verdict::kDark;
    }
  }
  ++tally.texels;
  if (tile.slot == Tile::kUntouched) return Verdict::kLit;
  if (trail != nullptr) {
    trail->reads_texel = true;
    trail->tile_slot = tile.slot;
  }
  return read_texel(texels_.texel(tile, x, y), fragment, tally, trail);
}

Verdict ShadowUnit::read_texel(const Texel& texel, const Fragment& fragment, Tally& tally,
                               FragmentTrail* trail) {
  if (texel.empty()) return Verdict::kLit;
  const std::int64_t depth = fragment.position.z;
  const std::uint32_t object = unit_id(fragment.object);
  const std::int64_t mask = (std::int64_t{1} << widths_.texel_bits) - 1;
  const Place place{fragment.position.x & mask, fragment.position.y & mask};
  const int shift = widths_.texel_bits - widths_.end_bits;
  const auto beyond = [&](const Threshold& threshold) {
    return depth >
           ThresholdPlane(threshold, widths_).at(place.x >> shift, place.y >> shift, widths_);
  };
  const bool other = texel.object != Texel::kNobody && !passes_over(texel.object, object);
  if (!texel.has_list()) {
    const bool dark = other && (texel.overflow() ? depth > texel.cover.base : beyond(texel.cover));
    tally.dark_by_buffer += dark;
    return dark ? Verdict::kDark : Verdict::kLit;
  }
  if (config_.skip_first_test && other && depth > texel.cover.base) {
    ++tally.first_test;
    ++tally.dark_by_buffer;
    return Verdict::kDark;
  }
  ++tally.lists;
  const auto dark = [&](const Cluster& c, bool surely) {
    return !passes_over(c.object, object) && beyond(c.threshold) &&
           (surely || inside(c, place, shift));
  };
  std::uint32_t read = 0;
  bool found = false;
  if (const ClusterIndex* index = index_of(texel.list)) {
    read = index->count();
    index->candidates(place, [&](std::uint32_t rank, bool surely) {
      found = dark(slb_[index->member(rank)], surely);
      if (found) read = rank + 1;
      return !found;
    });
    tally.segments += index->segments_before(read);
  } else {
    for (std::uint32_t at = texel.list; at != SilhouetteBuffer::kNone && !found;
         at = slb_[at].next) {
      ++read;
      tally.segments += slb_[at].segment_count;
      found = dark(slb_[at], slb_[at].full);
    }
  }
  tally.clusters += read;
  tally.dark_by_lines += found;
  if (trail != nullptr) follow(texel.list, read, place, shift, *trail);
  return found ? Verdict::kDark : Verdict::kLit;
}

/// The records of a list's first clusters, as hardware stores them.
void ShadowUnit::follow(std::uint32_t list, std::uint32_t clusters, const Place& place, int shift,
                        FragmentTrail& trail) const {
  for (; clusters > 0; --clusters, list = slb_[list].next) {
    const Cluster& cluster = slb_[list];
    std::uint32_t left = slb_.first_segments_of(cluster);
    FragmentTrail::Record record{cluster.record, 0};
    slb_.each_segment(cluster, [&](const Segment& segment) {
      if (left-- == 0) {
        trail.records.push_back(record);
        record = {slb_.record_behind(record.address), 0};
        left = slb_.segments_per_record() - 1;
      }
      record.boxed += boxed(segment, place, shift);
      return true;
    });
    trail.records.push_back(record);
  }
}

/// Of a long list that is read often; null where reading it through costs less.
const ClusterIndex* ShadowUnit::index_of(std::uint32_t list) {
  std::uint32_t count = 0;
  for (std::uint32_t at = list; at != SilhouetteBuffer::kNone; at = slb_[at].next) {
    if (++count < ClusterIndex::kWorthwhile) continue;
    OftenRead& known = indices_[list];
    if (known.index == nullptr && ++known.lookups > ClusterIndex::kWorthwhile) {
      known.index = std::make_unique<ClusterIndex>(slb_, list, widths_);
    }
    return known.index.get();
  }
  return nullptr;
}

bool ShadowUnit::inside(const Cluster& cluster, const Place& place, int shift) const {
  int winding = cluster.corner;
  bool near = false;
  slb_.each_segment(cluster, [&](const Segment& segment) {
    const Crossing met = crossing(segment, place, shift);
    winding += met.winding;
    near = met.near;
    return !near;
  });
  return near || winding > 0;
}

}  // namespace kagesen::unit::winding
