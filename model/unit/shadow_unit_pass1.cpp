#include <algorithm>

#include "model/unit/address_generator.h"
#include "model/unit/shadow_unit.h"
#include "model/unit/silhouette_detector.h"

namespace kagesen::unit {

void ShadowUnit::begin(const UnitConfig& config, const FrameSetup& setup) {
  config_ = config;
  bits_ = static_cast<int>(setup.fraction_bits);
  const int position_bits =
      config.position_bits == 0 ? bits_ : static_cast<int>(config.position_bits);
  // Mx and My need the bits of Fraction, and have no more than the trace.
  position_shift_ =
      bits_ - std::clamp(position_bits, static_cast<int>(config.fraction_bits), bits_);
  depth_shift_ = kDepthBits - static_cast<int>(config.depth_bits);
  id_mask_ = (1u << config.id_bits) - 1;
  polygon_mask_ = (1u << config.polygon_id_bits) - 1;
  centre_x_ = static_cast<std::int32_t>(config.map_width / 2);
  centre_y_ = static_cast<std::int32_t>(config.map_height / 2);
  ids_ = setup.unit_ids;
  texels_.clear(static_cast<std::uint32_t>(config.map_width),
                static_cast<std::uint32_t>(config.map_height), kDepthMax >> depth_shift_);
  slb_.clear(static_cast<std::uint32_t>(config.slb_buckets),
             static_cast<std::uint32_t>(config.slb_entries),
             static_cast<std::uint32_t>(config.lines_per_entry));
  link_depth_ = static_cast<std::uint32_t>(config.link_depth);
  decision_ = ShadowDecision(config);
  combinations_.clear();
  counters_ = UnitCounters{};
}

std::uint32_t ShadowUnit::bucket_at(std::uint32_t texel) const {
  return bucket_of(texel % texels_.width(), texel / texels_.width(), slb_.buckets());
}

void ShadowUnit::draw(const Caster& caster, TriangleTrail& trail) {
  trail.clear();
  trail_ = &trail;
  draw(caster);
  trail_ = nullptr;
}

void ShadowUnit::draw(const Caster& caster) {
  ++counters_.casters;
  if (!combinations_.empty()) combinations_.clear();
  Caster c = caster;
  for (LightPoint& v : c.vertex) v.z >>= depth_shift_;
  const Polygon polygon(c, bits_);
  if (polygon.degenerate()) return;
  polygon_ = &polygon;
  object_ = unit_id(c.object);
  polygon_id_ = c.polygon & polygon_mask_;
  if (trail_ != nullptr) {
    trail_->flat = false;
    trail_->object = object_;
    trail_->twice_area = polygon.twice_area();
    trail_->gradient_x = polygon.gradient_x();
    trail_->gradient_y = polygon.gradient_y();
  }

  const auto [low, high] = std::minmax({c.vertex[0].y, c.vertex[1].y, c.vertex[2].y});
  rows_.begin(
      std::max(0, (low >> bits_) + centre_y_),
      std::min(static_cast<std::int32_t>(config_.map_height) - 1, (high >> bits_) + centre_y_));
  emptied_.clear();
  for (int i = 0; i < 3; ++i) {
    const LightPoint& a = c.vertex[i];
    const LightPoint& b = c.vertex[(i + 1) % 3];
    if (a.x == b.x && a.y == b.y) continue;
    draw_edge(i,
              setup_edge(a, b, c.vertex[(i + 2) % 3], bits_, static_cast<int>(config_.slope_bits)));
  }
  empty_visited();
  if (trail_ != nullptr) trail_->edge[3] = static_cast<std::uint32_t>(trail_->outline.size());
  fill_spans();
}

void ShadowUnit::draw_edge(int index, const EdgeSetup& edge) {
  ++counters_.edges;
  EdgeWalker walker(edge, bits_, static_cast<int>(config_.fraction_bits));
  if (trail_ != nullptr) {
    const OutlineTexel first = walker.texel();
    trail_->edge[static_cast<std::size_t>(index)] =
        static_cast<std::uint32_t>(trail_->outline.size());
    trail_->start[static_cast<std::size_t>(index)] =
        polygon_->depth_numerator(first.x, first.y) -
        Int128{edge.first_depth - polygon_->first_depth()} * polygon_->twice_area();
  }
  for (;; walker.step()) {
    OutlineTexel at = walker.texel();
    at.x += centre_x_;
    at.y += centre_y_;
    if (trail_ != nullptr) trail_->outline.push_back({at.x, at.y});
    if (static_cast<std::uint32_t>(at.y) < texels_.height()) {
      rows_.visit(index, at.x, at.y);
      if (static_cast<std::uint32_t>(at.x) < texels_.width())
        visit_texel(at, texels_.index(at.x, at.y));
    }
    if (walker.last()) break;
  }
}

void ShadowUnit::mark_corner(Record& record, const OutlineTexel& at) {
  record.corner_covered =
      record.corner_covered || polygon_->covers_corner(at.x - centre_x_, at.y - centre_y_);
}

void ShadowUnit::visit_texel(const OutlineTexel& at, std::uint32_t texel_index) {
  ++counters_.edge_texels;
  Texel& texel = texels_[texel_index];
  if (trail_ != nullptr) {
    trail_->visits.push_back({at.nearest, texel.edge(), texel.overflow(),
                              polygon_->covers_corner(at.x - centre_x_, at.y - centre_y_),
                              at.line.has(Line::kStartHere) || at.line.has(Line::kEndHere),
                              config_.hidden_removal == HiddenRemoval::kCentre &&
                                  texel.depth < at.nearest,
                              TriangleTrail::EdgeVisit::kNone, TriangleTrail::EdgeVisit::kNone});
  }
  if (texel.overflow()) {
    texel.cover(at.nearest, object_);
    ++counters_.overflow_lines;
    return;
  }
  Line line = at.line;
  line.polygon = polygon_id_;
  const std::uint32_t bucket = bucket_of(at.x, at.y, slb_.buckets());
  std::uint32_t entry = slb_.find(bucket, texel_index, object_);

  if (entry != SilhouetteBuffer::kNone) {
    const bool match_id = config_.match_polygon_id;
    std::int32_t asked = 0;
    const bool cancelled = slb_.remove_first(entry, [&](const Line& other) {
      ++asked;
      return cancels(line, other, match_id);
    });
    if (cancelled) {
      ++counters_.lines_cancelled;
      mark_corner(slb_[entry], at);
      if (trail_ != nullptr) {
        TriangleTrail::EdgeVisit& visit = trail_->visits.back();
        visit.cancelled = asked - 1;
        if (slb_[entry].lines == 0) visit.emptied = static_cast<std::int32_t>(emptied_.size());
      }
      if (slb_[entry].lines == 0) emptied_.push_back({at.x, at.y, texel_index});
      return;
    }
  }
  if (config_.hidden_removal == HiddenRemoval::kCentre && texel.depth < at.nearest) {
    ++counters_.lines_hidden;
    return;
  }
  if (config_.depth_writes == DepthWrites::kAll) texel.cover(at.nearest, object_);
  const std::uint32_t used = slb_.used();
  if (entry == SilhouetteBuffer::kNone) {
    entry = slb_.insert(bucket, texel_index, object_, at.nearest);
  } else if (slb_[entry].lines == 0 || at.nearest < slb_[entry].nearest) {
    slb_.set_nearest(bucket, entry, at.nearest);
  }
  const bool stored = entry != SilhouetteBuffer::kNone && slb_.append(entry, line);
  if (!stored) ++counters_.overflow_lines;  // what is stored, overflow() counts
  if (!stored || (slb_.used() != used && slb_.chain_length(bucket, texel_index) > link_depth_)) {
    overflow(texel_index, at.nearest);
    return;
  }
  Record& record = slb_[entry];
  if (record.lines == 1 && record.more == SilhouetteBuffer::kNone) record.vertex = false;
  record.vertex |= line.has(Line::kStartHere) || line.has(Line::kEndHere);
  mark_corner(record, at);
  texel.set_edge(true);
  ++counters_.lines_stored;
}

void ShadowUnit::overflow(std::uint32_t texel_index, std::uint32_t depth) {
  ++counters_.overflow_texels;
  Texel& texel = texels_[texel_index];
  const std::uint32_t bucket = bucket_at(texel_index);
  texel.cover(depth, object_);
  for (std::uint32_t at = slb_.first_of(bucket, texel_index); at != SilhouetteBuffer::kNone;
       at = slb_.first_of(bucket, texel_index)) {
    counters_.overflow_lines += slb_.line_count(at);
    texel.cover(slb_[at].nearest, slb_[at].object);
    slb_.erase(bucket, at);
  }
  texel.set_edge(false);
  texel.set_overflow();
}

/// Entries without a line after all edges: the texel is covered all over or nowhere, as its corner
/// is.
void ShadowUnit::empty_visited() {
  for (const Visit& visit : emptied_) {
    const std::uint32_t bucket = bucket_at(visit.texel);
    const std::uint32_t entry = slb_.find(bucket, visit.texel, object_);
    if (trail_ != nullptr) trail_->emptied.push_back({texels_[visit.texel].edge(), false, 0});
    if (entry == SilhouetteBuffer::kNone || slb_[entry].lines != 0) continue;
    const bool covered = slb_[entry].corner_covered;
    slb_.erase(bucket, entry);
    update_edge_flag(visit.texel);
    if (!covered) continue;
    ++counters_.emptied_covered;
    const std::uint32_t centre =
        polygon_->centre_depth(visit.x - centre_x_, visit.y - centre_y_);
    if (trail_ != nullptr) {
      trail_->emptied.back().covered = true;
      trail_->emptied.back().hide_depth = hide_depth(centre);
    }
    cover(visit.texel, centre);
  }
}

void ShadowUnit::fill_spans() {
  const auto last_column = static_cast<std::int32_t>(texels_.width()) - 1;
  rows_.gaps([&](std::int32_t y, std::int32_t from, std::int32_t to) {
    from = std::max(from, 0);
    to = std::min(to, last_column);
    if (from > to) return;
    counters_.span_texels += static_cast<std::uint64_t>(to - from + 1);
    if (trail_ != nullptr) trail_->gaps.push_back({y, from, to});
    ExactRamp depth = polygon_->centre_ramp(from - centre_x_, y - centre_y_);
    const std::uint32_t first = texels_.index(from, y), last = texels_.index(to, y);
    for (std::uint32_t texel = first; texel <= last; ++texel, depth.advance()) {
      const auto centre = static_cast<std::uint32_t>(depth.whole);
      if (texels_[texel].edge()) {
        if (trail_ != nullptr) {
          const auto x = from + static_cast<std::int32_t>(texel - first);
          trail_->hiding.push_back({x, y, hide_depth(centre)});
        }
        cover(texel, centre);
      } else {
        texels_[texel].cover(centre, object_);
      }
    }
  });
}

void ShadowUnit::cover(std::uint32_t texel, std::uint32_t centre) {
  texels_[texel].cover(centre, object_);
  if (config_.hidden_removal == HiddenRemoval::kOff || !texels_[texel].edge()) return;
  remove_hidden(texel, hide_depth(centre));
}

/// What covers a texel with this depth at its centre hides lines behind.
std::uint32_t ShadowUnit::hide_depth(std::uint32_t centre) const {
  return config_.hidden_removal == HiddenRemoval::kCentre ? centre : polygon_->farthest(centre);
}

void ShadowUnit::remove_hidden(std::uint32_t texel, std::uint32_t depth) {
  const std::uint32_t bucket = bucket_at(texel);
  for (std::uint32_t at = slb_.first_of(bucket, texel); at != SilhouetteBuffer::kNone;) {
    const std::uint32_t next = slb_.next_of(at);
    if (depth < slb_[at].nearest) {
      counters_.lines_hidden += slb_.line_count(at);
      slb_.erase(bucket, at);
    }
    at = next;
  }
  update_edge_flag(texel);
}

void ShadowUnit::update_edge_flag(std::uint32_t texel) {
  texels_[texel].set_edge(slb_.first_of(bucket_at(texel), texel) != SilhouetteBuffer::kNone);
}

}  // namespace kagesen::unit
