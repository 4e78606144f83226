#include <algorithm>
#include <limits>

#include "model/unit/winding/shadow_unit.h"

namespace kagesen::unit::winding {

void ShadowUnit::begin(const UnitConfig& config, const FrameSetup& setup) {
  config_ = config;
  widths_ = Widths(config, static_cast<int>(setup.fraction_bits));
  paper_ = config.semantics == Semantics::kPaper;
  id_mask_ = (1u << config.id_bits) - 1;
  centre_x_ = static_cast<std::int32_t>(config.map_width / 2);
  centre_y_ = static_cast<std::int32_t>(config.map_height / 2);
  ids_ = setup.unit_ids;
  facets_ = setup.facets;
  planes_ = setup.planes;
  unshadowable_ = setup.unshadowable;
  texels_.clear(static_cast<std::uint32_t>(config.map_width),
                static_cast<std::uint32_t>(config.map_height));
  slb_.clear(static_cast<std::uint32_t>(config.cluster_records),
             static_cast<std::uint32_t>(config.segments_per_record));
  long_lists_.clear();
  settled_ = true;
  counters_ = UnitCounters{};
}

void ShadowUnit::announce(const Fragment* fragments, std::size_t count) {
  if (!config_.skip_receiver_mask) return;
  for (std::size_t i = 0; i < count; ++i) {
    const Fragment& f = fragments[i];
    const std::int32_t x = (f.position.x >> widths_.texel_bits) + centre_x_;
    const std::int32_t y = (f.position.y >> widths_.texel_bits) + centre_y_;
    if (known(f, x, y)) continue;
    Tile& tile = texels_.tile(x, y);
    tile.occupied |= std::uint64_t{1} << TexelBuffers::within(x, y);
    tile.last_fragment = std::max(tile.last_fragment, f.position.z);
  }
}

void ShadowUnit::draw(const Caster& caster) {
  const std::uint64_t number = counters_.casters++;
  const Polygon polygon(caster, widths_.texel_bits);
  if (polygon.degenerate()) return;
  settled_ = false;
  const Facet hint = number < facets_.size() ? facets_[number] : Facet{};
  const bool shares = hint.plane != Facet::kOwnPlane;
  const FacetPlane plane(caster, shares ? &planes_[hint.plane] : nullptr, widths_);
  const Drawn facet{caster, polygon, plane, unit_id(caster.object)};

  const LightPoint* v = caster.vertex;
  const auto [low, high] = std::minmax({v[0].y, v[1].y, v[2].y});
  const auto row = [this](std::int32_t y) { return (y >> widths_.texel_bits) + centre_y_; };
  rows_.begin(std::max(0, row(low)),
              std::min(static_cast<std::int32_t>(config_.map_height) - 1, row(high)));
  const unsigned inner = config_.skip_edges ? hint.inner_edges : 0;
  unsigned passed = 0;
  for (int i = 0; i < 3; ++i) {
    const LightPoint& a = v[i];
    const LightPoint& b = v[(i + 1) % 3];
    if ((inner >> i & 1) != 0 || (a.x == b.x && a.y == b.y)) continue;
    walk_edge(facet, i, passed);
    passed |= 1u << i;
  }
  for (int i = 0; i < 3; ++i) {
    if ((inner >> i & 1) == 0) continue;
    pass_inner_edge(facet, i, passed);
    passed |= 1u << i;
  }
  fill_spans(facet);
}

/// @param passed  edges walked before: the corner of a texel that they visited is counted
void ShadowUnit::walk_edge(const Drawn& facet, int index, unsigned passed) {
  ++counters_.edges;
  const LightPoint* v = facet.caster.vertex;
  EdgeWalker walker(v[index], v[(index + 1) % 3], v[(index + 2) % 3], widths_.texel_bits,
                    widths_.end_bits);
  for (;; walker.step()) {
    const std::int32_t x = walker.x() + centre_x_, y = walker.y() + centre_y_;
    if (static_cast<std::uint32_t>(y) < texels_.height()) {
      rows_.visit(index, x, y);
      Visit at;
      if (static_cast<std::uint32_t>(x) < texels_.width()) {
        ++counters_.edge_texels;
        if (visit(x, y, facet.plane.in(walker.x(), walker.y()), facet.object, at)) {
          Segment segment;
          const bool stored = walker.segment(segment);
          const bool corner = !rows_.visited(passed, x, y) && covers_corner(facet, x, y);
          add(at, facet.object, corner, stored ? &segment : nullptr);
        }
      }
    }
    if (walker.last()) break;
  }
}

/// Beyond an inner edge the same plane goes on: of a texel there, one facet has the corner.
void ShadowUnit::pass_inner_edge(const Drawn& facet, int index, unsigned passed) {
  const LightPoint* v = facet.caster.vertex;
  EdgeWalker walker(v[index], v[(index + 1) % 3], v[(index + 2) % 3], widths_.texel_bits,
                    widths_.end_bits);
  for (;; walker.next_row()) {
    const std::int32_t y = walker.y() + centre_y_;
    if (static_cast<std::uint32_t>(y) < texels_.height()) {
      std::int32_t low, high;
      walker.row(low, high);
      low += centre_x_;
      high += centre_x_;
      rows_.visit(index, low, y);
      rows_.visit(index, high, y);
      high = std::min(high, static_cast<std::int32_t>(texels_.width()) - 1);
      for (std::int32_t x = std::max(low, 0); x <= high; ++x) {
        ++counters_.skips.inner_edge_texels;
        Visit at;
        if (rows_.visited(passed, x, y) || !covers_corner(facet, x, y) ||
            !visit(x, y, facet.plane.in(x - centre_x_, y - centre_y_), facet.object, at)) {
          continue;
        }
        add(at, facet.object, true, nullptr);
      }
    }
    if (walker.last_row()) break;
  }
}

void ShadowUnit::fill_spans(const Drawn& facet) {
  const auto last_column = static_cast<std::int32_t>(texels_.width()) - 1;
  rows_.gaps([&](std::int32_t y, std::int32_t from, std::int32_t to) {
    from = std::max(from, 0);
    to = std::min(to, last_column);
    if (from > to) return;
    counters_.span_texels += static_cast<std::uint64_t>(to - from + 1);
    ExactRamp depth = facet.plane.ramp(from - centre_x_, y - centre_y_);
    for (std::int32_t x = from; x <= to; ++x, depth.advance()) {
      Visit at;
      if (visit(x, y, facet.plane.at(depth), facet.object, at)) cover(at, facet.object);
    }
  });
}

bool ShadowUnit::visit(std::uint32_t x, std::uint32_t y, const Threshold& threshold,
                       std::uint32_t object, Visit& out) {
  ++counters_.skips.texel_visits;
  Tile& tile = texels_.tile(x, y);
  const ThresholdPlane plane(threshold, widths_);
  const std::int64_t nearest = plane.nearest();
  if (config_.skip_receiver_mask &&
      ((tile.occupied >> TexelBuffers::within(x, y) & 1) == 0 || nearest >= tile.last_fragment)) {
    ++counters_.skips.masked_visits;
    return false;
  }
  if (tile.slot == Tile::kUntouched) texels_.touch(tile);
  tile.nearest = std::min(tile.nearest, nearest);
  Texel& texel = texels_.texel(tile, x, y);
  if (hidden(texel, nearest, object)) {
    ++counters_.skips.hidden_visits;
    return false;
  }
  out = {&texel, threshold, plane.farthest()};
  return true;
}

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

/// The cluster of that plane, or kNone; and the records of the whole list.
std::uint32_t ShadowUnit::find(const Texel& texel, const Threshold& threshold, std::uint32_t object,
                               std::uint32_t& records) const {
  std::uint32_t found = SilhouetteBuffer::kNone;
  records = 0;
  for (std::uint32_t at = texel.list; at != SilhouetteBuffer::kNone; at = slb_[at].next) {
    if (slb_[at].same_plane(threshold, object)) found = at;
    records += slb_.records_of(slb_[at]);
  }
  return found;
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

/// The cluster of the visit's plane, there or new, and the records of the whole list; null if there
/// is no room for it.
Cluster* ShadowUnit::cluster_of(const Visit& visit, std::uint32_t object, std::uint32_t& records) {
  Texel& texel = *visit.texel;
  if (texel.one_plane() && !open_list(texel)) return nullptr;
  std::uint32_t at = find(texel, visit.threshold, object, records);
  if (at == SilhouetteBuffer::kNone) {
    if (records >= static_cast<std::uint32_t>(config_.chain_records)) return nullptr;
    at = slb_.insert(texel.list, visit.threshold, object);
    if (at == SilhouetteBuffer::kNone) return nullptr;
    ++records;
  }
  return &slb_[at];
}

void ShadowUnit::add(const Visit& visit, std::uint32_t object, bool corner,
                     const Segment* segment) {
  Texel& texel = *visit.texel;
  if (!corner && segment == nullptr) return;
  if (texel.overflow()) return overflow(visit, object);
  if (texel.one_plane() && texel.cover == visit.threshold && texel.object == object) return;
  std::uint32_t records;
  Cluster* cluster = cluster_of(visit, object, records);
  if (cluster == nullptr) return overflow(visit, object);
  if (cluster->full) return;
  cluster->corner += corner;
  if (cluster->corner >> config_.corner_bits) return overflow(visit, object);
  if (segment == nullptr) return;
  const std::uint32_t others = records - slb_.records_of(*cluster);
  bool cancelled;
  if (!slb_.add(*cluster, *segment, cancelled) ||
      others + slb_.records_of(*cluster) > static_cast<std::uint32_t>(config_.chain_records)) {
    return overflow(visit, object);
  }
  ++(cancelled ? counters_.lines_cancelled : counters_.lines_stored);
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
    if (texel.cover == visit.threshold && texel.object == object) return;
    const bool replaces = (!paper_ || texel.object == object) &&
                          ThresholdPlane(texel.cover, widths_).nearest() >= visit.farthest;
    if (replaces) {
      texel.cover = visit.threshold;
      texel.object = object;
      return;
    }
  }
  std::uint32_t records;
  Cluster* cluster = cluster_of(visit, object, records);
  if (cluster == nullptr) return overflow(visit, object);
  if (cluster->full) return;
  slb_.drop_segments(*cluster);
  cluster->full = true;
  cluster->corner = 0;
  if (texel.object == Texel::kNobody || visit.farthest < texel.cover.base) {
    note_cover(texel, visit.farthest, object);
  }
  drop_hidden(texel);
}

void ShadowUnit::drop_hidden(Texel& texel) {
  std::uint32_t previous = SilhouetteBuffer::kNone;
  for (std::uint32_t at = texel.list; at != SilhouetteBuffer::kNone;) {
    const Cluster& c = slb_[at];
    const std::uint32_t next = c.next;
    if (hidden(texel, ThresholdPlane(c.threshold, widths_).nearest(), c.object)) {
      counters_.lines_hidden += c.segment_count;
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
    const std::int64_t depth = std::int64_t{t.base} << widths_.step_bits;
    if (texel.object == Texel::kNobody || depth < texel.cover.base) note_cover(texel, depth, of);
  };
  ++counters_.overflow_lines;
  if (!texel.overflow()) {
    ++counters_.overflow_texels;
    if (texel.one_plane()) {
      note_cover(texel, std::int64_t{texel.cover.base} << widths_.step_bits, texel.object);
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
  keep_nearest(visit.threshold, object);
}

}  // namespace kagesen::unit::winding
