#pragma once
/// The packed structs of rtl/winding/shadow_pkg.sv, field by field in their order there.
#include <algorithm>
#include <cstdint>

#include "model/unit/winding/plane.h"
#include "testbench/verilator/bits.h"

namespace kagesen::rtl {

/// Widths of the package that the configuration alone does not give.
struct WindingWidths {
  std::size_t map_bits = 10, record_addr_bits = 22;
};

struct WindingLayout {
  using Field = Layout::Field;
  static constexpr std::size_t kTexelsPerWord = 4, kLimitBits = 25, kCountBits = 4, kCoverBits = 32,
                               kCoordBits = 28, kObjectBits = 24, kDepthBits = 24, kMaxTexelBits = 26;
  enum Kind : std::uint64_t { kEmpty, kPlane, kList, kOverflow };

  struct Segment {
    std::size_t bits;
    Field inner, crosses_left, positive, x0, y0, x1, y1;
  };
  struct Threshold {
    std::size_t bits;
    Field base, gradient_x, gradient_y;
  };
  struct Texel {
    std::size_t bits, word_bits;
    Field kind, object;                 ///< and, from bit 0 on, a threshold, or:
    Field covered, bare, cover_depth, first;  ///< of a list
  };
  struct Tile {
    std::size_t bits;
    Field touched, slot, several, object_valid, object, nearest, farthest, last, mask;
  };
  struct Record {
    std::size_t bits, threshold_low;
    Field object, corner, full, count, goes_on, has_next, next;  ///< segment i at i * Segment::bits
  };
  struct Visit {
    std::size_t bits;
    Field kind, x, y, has_segment, corner;
    std::size_t segment_low;
    Field base[4], mask;
  };
  struct VisitTri {
    std::size_t bits;
    Field object, gradient_x, gradient_y;
  };
  struct Frag {
    std::size_t bits;
    Field unshadowable, outside, averted, object, x, y, z;
  };
  struct Settings {
    std::size_t bits;
    Field texel_bits, map_width, map_height, record_limit, chain_limit, plane_tolerance,
        paper_semantics, skip_receiver_mask, skip_first_test, skip_tiles, skip_edges, skip_fragments;
  };
  struct Events {
    std::size_t bits;
    Field line_stored, line_cancelled, emptied_covered, texel_visits, masked_visits, hidden_visits,
        tile_touched, lines_hidden, overflow_lines, overflow_texel;
  };

  WindingLayout(const UnitConfig& config, const WindingWidths& widths) : widths(widths) {
    const unit::winding::Widths w(config, kMaxTexelBits);
    const auto end = static_cast<std::size_t>(w.end_bits) + 1;
    const auto code = static_cast<std::size_t>(w.gradient_code_bits());
    const auto base = static_cast<std::size_t>(w.base_bits());
    const auto id = static_cast<std::size_t>(config.id_bits);
    const auto corner = static_cast<std::size_t>(config.corner_bits);
    const auto segments = static_cast<std::size_t>(config.segments_per_record);
    const std::size_t map = widths.map_bits, address = widths.record_addr_bits;

    Layout l(3 + 4 * end);
    segment.bits = l.bits();
    for (Field* flag : {&segment.inner, &segment.crosses_left, &segment.positive})
      *flag = l.field(1);
    for (Field* f : {&segment.x0, &segment.y0, &segment.x1, &segment.y1}) *f = l.field(end);

    Layout h(base + 2 * code);
    threshold.bits = h.bits();
    threshold.base = h.field(base);
    threshold.gradient_x = h.field(code);
    threshold.gradient_y = h.field(code);

    Layout list(2 + kCoverBits + address);
    Layout t(2 + id + std::max(threshold.bits, list.bits()));
    texel.bits = t.bits();
    texel.word_bits = kTexelsPerWord * texel.bits;
    texel.kind = t.field(2);
    texel.object = t.field(id);
    texel.covered = list.field(1);
    texel.bare = list.field(1);
    texel.cover_depth = list.field(kCoverBits);
    texel.first = list.field(address);

    const std::size_t slot = 2 * map - 6;
    Layout tl(3 + slot + id + 25 + 25 + 24 + 64);
    tile.bits = tl.bits();
    tile.touched = tl.field(1);
    tile.slot = tl.field(slot);
    tile.several = tl.field(1);
    tile.object_valid = tl.field(1);
    tile.object = tl.field(id);
    tile.nearest = tl.field(25);
    tile.farthest = tl.field(25);
    tile.last = tl.field(24);
    tile.mask = tl.field(64);

    Layout r(threshold.bits + id + corner + 3 + kCountBits + address + segments * segment.bits);
    record.bits = r.bits();
    record.threshold_low = r.field(threshold.bits).low;
    record.object = r.field(id);
    record.corner = r.field(corner);
    record.full = r.field(1);
    record.count = r.field(kCountBits);
    record.goes_on = r.field(1);
    record.has_next = r.field(1);
    record.next = r.field(address);

    Layout v(2 + 2 * map + 2 + segment.bits + 4 * base + kTexelsPerWord);
    visit.bits = v.bits();
    visit.kind = v.field(2);
    visit.x = v.field(map);
    visit.y = v.field(map);
    visit.has_segment = v.field(1);
    visit.corner = v.field(1);
    visit.segment_low = v.field(segment.bits).low;
    for (Field& b : visit.base) b = v.field(base);
    visit.mask = v.field(kTexelsPerWord);

    Layout tri(id + 2 * code);
    visit_tri.bits = tri.bits();
    visit_tri.object = tri.field(id);
    visit_tri.gradient_x = tri.field(code);
    visit_tri.gradient_y = tri.field(code);

    Layout f(3 + kObjectBits + 2 * kCoordBits + kDepthBits);
    frag.bits = f.bits();
    for (Field* flag : {&frag.unshadowable, &frag.outside, &frag.averted}) *flag = f.field(1);
    frag.object = f.field(kObjectBits);
    frag.x = f.field(kCoordBits);
    frag.y = f.field(kCoordBits);
    frag.z = f.field(kDepthBits);

    Layout s(5 + 2 * (map + 1) + 2 * kLimitBits + 17 + 6);
    settings.bits = s.bits();
    settings.texel_bits = s.field(5);
    settings.map_width = s.field(map + 1);
    settings.map_height = s.field(map + 1);
    settings.record_limit = s.field(kLimitBits);
    settings.chain_limit = s.field(kLimitBits);
    settings.plane_tolerance = s.field(17);
    for (Field* flag : {&settings.paper_semantics, &settings.skip_receiver_mask,
                        &settings.skip_first_test, &settings.skip_tiles, &settings.skip_edges,
                        &settings.skip_fragments})
      *flag = s.field(1);

    Layout e(3 + 9 + 1 + 32 + 1);
    events.bits = e.bits();
    for (Field* flag : {&events.line_stored, &events.line_cancelled, &events.emptied_covered})
      *flag = e.field(1);
    for (Field* count : {&events.texel_visits, &events.masked_visits, &events.hidden_visits})
      *count = e.field(3);
    events.tile_touched = e.field(1);
    events.lines_hidden = e.field(16);
    events.overflow_lines = e.field(16);
    events.overflow_texel = e.field(1);
  }

  std::size_t texel_data_bits() const { return std::max(texel.word_bits, tile.bits); }
  std::uint64_t tile_address(std::uint64_t x, std::uint64_t y) const {
    return std::uint64_t{1} << (2 * widths.map_bits - 2) | y / 8 << (widths.map_bits - 3) | x / 8;
  }
  static std::uint64_t texel_address(std::uint64_t slot, std::uint64_t x, std::uint64_t y) {
    return slot * 16 + y % 8 * 2 + x % 8 / 4;
  }

  /// settings_t of a configuration.
  Word make_settings(const UnitConfig& c, std::uint32_t fraction_bits_of_texel) const {
    Word word = make_word(settings.bits);
    settings.texel_bits.set(word, fraction_bits_of_texel);
    settings.map_width.set(word, static_cast<std::uint64_t>(c.map_width));
    settings.map_height.set(word, static_cast<std::uint64_t>(c.map_height));
    settings.record_limit.set(word, static_cast<std::uint64_t>(c.cluster_records));
    settings.chain_limit.set(word, static_cast<std::uint64_t>(c.chain_records));
    settings.plane_tolerance.set(word, static_cast<std::uint64_t>(c.plane_tolerance));
    settings.paper_semantics.set(word, c.semantics == Semantics::kPaper);
    settings.skip_receiver_mask.set(word, c.skip_receiver_mask);
    settings.skip_first_test.set(word, c.skip_first_test);
    settings.skip_tiles.set(word, c.skip_tiles);
    settings.skip_edges.set(word, c.skip_edges);
    settings.skip_fragments.set(word, c.skip_fragments);
    return word;
  }

  WindingWidths widths;
  Segment segment;
  Threshold threshold;
  Texel texel;
  Tile tile;
  Record record;
  Visit visit;
  VisitTri visit_tri;
  Frag frag;
  Settings settings;
  Events events;
};

}  // namespace kagesen::rtl
