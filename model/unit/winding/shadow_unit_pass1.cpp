#include <algorithm>
#include <tuple>

#include "model/unit/winding/shadow_unit.h"

namespace kagesen::unit::winding {
namespace {

/// A bound of a tile's depths, as it is stored.
std::int64_t clamped(std::int64_t depth) {
  return std::clamp<std::int64_t>(depth, -1, (std::int64_t{1} << 24) - 1);
}

}  // namespace

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
  indices_.clear();
  settled_ = true;
  counters_ = UnitCounters{};
}

void ShadowUnit::announce(const Fragment* fragments, std::size_t count) {
  if (!config_.skip_receiver_mask) return;
  Tile none;
  Tile* tile = &none;  // neighbours in the image are mostly neighbours here
  std::uint64_t occupied = 0;
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Fragment& f = fragments[i];
    const std::int32_t x = (f.position.x >> widths_.texel_bits) + centre_x_;
    const std::int32_t y = (f.position.y >> widths_.texel_bits) + centre_y_;
    if (known(f, x, y)) continue;
    Tile* const at = &texels_.tile(x, y);
    if (at != tile) {
      tile->occupied |= occupied;
      tile->last_fragment = std::max(tile->last_fragment, last);
      tile = at;
      occupied = last = 0;
    }
    occupied |= std::uint64_t{1} << TexelBuffers::within(x, y);
    last = std::max(last, f.position.z);
  }
  tile->occupied |= occupied;
  tile->last_fragment = std::max(tile->last_fragment, last);
}

bool ShadowUnit::place(const Fragment& fragment, TriangleTrail::Texel& texel) const {
  texel.x = (fragment.position.x >> widths_.texel_bits) + centre_x_;
  texel.y = (fragment.position.y >> widths_.texel_bits) + centre_y_;
  return !known(fragment, texel.x, texel.y);
}

void ShadowUnit::draw(const Caster& caster, TriangleTrail& trail) {
  trail.clear();
  trail_ = &trail;
  dropped_ = &trail.dropped;
  draw(caster);
  trail_ = nullptr;
  dropped_ = nullptr;
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
  if (trail_ != nullptr) {
    trail_->shares = shares;
    begin_trail(facet);
  }

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
    walk_edge(facet, i, passed, (hint.inner_edges >> i & 1) != 0);
    passed |= 1u << i;
  }
  for (int i = 0; i < 3; ++i) {
    if ((inner >> i & 1) == 0) continue;
    pass_inner_edge(facet, i, passed);
    passed |= 1u << i;
  }
  fill_spans(facet);
}

void ShadowUnit::begin_trail(const Drawn& facet) {
  const LightPoint* v = facet.caster.vertex;
  const LightPoint low = *std::min_element(v, v + 3, [](const LightPoint& a, const LightPoint& b) {
    return std::tie(a.y, a.x) < std::tie(b.y, b.x);
  });
  const std::int32_t x = low.x >> widths_.texel_bits, y = low.y >> widths_.texel_bits;
  trail_->flat = false;
  trail_->object = facet.object;
  trail_->twice_area = facet.polygon.twice_area();
  trail_->plane = facet.plane.figures(facet.caster, x, y);
  trail_->low = {x + centre_x_, y + centre_y_};
}

void ShadowUnit::begin_edge_trail(const Drawn& facet, int index, bool passed,
                                  const EdgeWalker& walker) {
  const LightPoint* v = facet.caster.vertex;
  const auto a = static_cast<unsigned>(index), b = (a + 1) % 3;
  const bool upward = std::tie(v[a].y, v[a].x) < std::tie(v[b].y, v[b].x);
  const unsigned from = upward ? a : b, to = upward ? b : a;
  trail_->begin_edge({from, to, passed, v[to].x >= v[from].x, walker.figures(), 0});
}

/// @param passed  edges walked before: the corner of a texel that they visited is counted
void ShadowUnit::walk_edge(const Drawn& facet, int index, unsigned passed, bool inner) {
  ++counters_.edges;
  const LightPoint* v = facet.caster.vertex;
  EdgeWalker walker(v[index], v[(index + 1) % 3], v[(index + 2) % 3], widths_.texel_bits,
                    widths_.end_bits);
  if (trail_ != nullptr) begin_edge_trail(facet, index, false, walker);
  for (;; walker.step()) {
    const std::int32_t x = walker.x() + centre_x_, y = walker.y() + centre_y_;
    if (trail_ != nullptr) trail_->outline.push_back({x, y});
    if (static_cast<std::uint32_t>(y) < texels_.height()) {
      rows_.visit(index, x, y);
      Visit at;
      if (static_cast<std::uint32_t>(x) < texels_.width()) {
        ++counters_.edge_texels;
        if (visit(x, y, facet.plane.in(walker.x(), walker.y()), facet.object, at)) {
          Segment segment;
          bool stored = walker.segment(segment);
          if (inner) {
            stored = stored && !segment.dot();
            segment.flags |= Segment::kInner;
          }
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
  if (trail_ != nullptr) begin_edge_trail(facet, index, true, walker);
  for (;; walker.next_row()) {
    const std::int32_t y = walker.y() + centre_y_;
    if (trail_ != nullptr) trail_->add_row(walker, centre_x_, y);
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
        const bool corner = !rows_.visited(passed, x, y) && covers_corner(facet, x, y);
        if (trail_ != nullptr) trail_->add_corner(corner);
        Visit at;
        if (!corner ||
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
    if (trail_ != nullptr) trail_->gaps.push_back({y, from, to});
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
  if (trail_ != nullptr) trail_->visits.emplace_back().threshold = threshold;
  if (config_.skip_receiver_mask &&
      ((tile.occupied >> TexelBuffers::within(x, y) & 1) == 0 || nearest >= tile.last_fragment)) {
    ++counters_.skips.masked_visits;
    if (trail_ != nullptr) note()->masked = true;
    return false;
  }
  if (tile.slot == Tile::kUntouched) texels_.touch(tile);
  if (trail_ != nullptr) note()->nearest = clamped(nearest) < clamped(tile.nearest);
  tile.nearest = std::min(tile.nearest, nearest);
  Texel& texel = texels_.texel(tile, x, y);
  const bool is_hidden = hidden(texel, nearest, object);
  if (trail_ != nullptr) note_visit(texel, nearest, object, is_hidden);
  if (is_hidden) {
    ++counters_.skips.hidden_visits;
    return false;
  }
  out = {&texel, texels_.index(tile, x, y), threshold, plane.farthest()};
  return true;
}

void ShadowUnit::note_visit(const Texel& texel, std::int64_t nearest, std::uint32_t object,
                            bool is_hidden) {
  TexelVisit& visit = *note();
  if (!texel.has_list()) {
    if (is_hidden) visit.plane = TexelVisit::Plane::kLeaves;
  } else if (texel.object != Texel::kNobody && nearest >= texel.cover.base) {
    visit.behind = !paper_ || texel.object == object ? TexelVisit::Behind::kOfItsObject
                   : is_hidden                       ? TexelVisit::Behind::kHidden
                                                     : TexelVisit::Behind::kShown;
  }
}

}  // namespace kagesen::unit::winding
