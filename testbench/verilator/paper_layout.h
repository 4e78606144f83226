#pragma once
/// The packed structs of rtl/paper/shadow_pkg.sv, field by field in their order there.
#include <cstdint>

#include "model/unit/config.h"
#include "testbench/verilator/bits.h"

namespace kagesen::rtl {

/// Widths of the package that the configuration alone does not give.
struct PaperWidths {
  std::size_t map_bits = 10, record_addr_bits = 19;
};

struct PaperLayout {
  using Field = Layout::Field;
  static constexpr std::size_t kTexelsPerWord = 4, kLimitBits = 25, kLineCountBits = 4;

  struct Line {
    std::size_t bits;
    Field left, cross, x_major, x_positive, start_here, end_here, polygon, slope, fraction;
  };
  struct Texel {
    std::size_t bits, word_bits;
    Field overflow, edge, covered, id, depth;
  };
  struct Record {
    std::size_t bits;
    Field used, has_next, has_more, next, more, texel, object, nearest, vertex, corner, count;
    std::size_t lines_low;  ///< line i at lines_low + i * Line::bits
  };
  struct Visit {
    std::size_t bits;
    Field kind, x, y;
    std::size_t line_low;
    Field nearest, corner, depth[4], mask;
  };
  struct VisitTri {
    std::size_t bits;
    Field object, most, rise;
  };
  struct Settings {
    std::size_t bits;
    Field texel_bits, map_width, map_height, pitch_log2, buckets_log2, record_limit, chain_limit,
        own_id_literal, vertex_per_entry, table7_printed, depth_writes_all, hidden_removal,
        match_polygon_id;
  };
  struct Events {
    std::size_t bits;
    Field line_stored, line_cancelled, emptied_covered, lines_hidden, overflow_lines,
        overflow_texel;
  };

  PaperLayout(const UnitConfig& config, const PaperWidths& widths) : widths(widths) {
    const auto fraction = static_cast<std::size_t>(config.fraction_bits);
    const auto slope = static_cast<std::size_t>(config.slope_bits);
    const auto polygon = static_cast<std::size_t>(config.polygon_id_bits);
    const auto depth = static_cast<std::size_t>(config.depth_bits);
    const auto id = static_cast<std::size_t>(config.id_bits);
    const auto lines = static_cast<std::size_t>(config.lines_per_entry);
    const std::size_t map = widths.map_bits, address = widths.record_addr_bits;

    Layout l(6 + polygon + slope + fraction);
    line.bits = l.bits();
    for (Field* flag : {&line.left, &line.cross, &line.x_major, &line.x_positive, &line.start_here,
                        &line.end_here})
      *flag = l.field(1);
    line.polygon = l.field(polygon);
    line.slope = l.field(slope);
    line.fraction = l.field(fraction);

    Layout t(3 + id + depth);
    texel.bits = t.bits();
    texel.word_bits = kTexelsPerWord * t.bits();
    for (Field* flag : {&texel.overflow, &texel.edge, &texel.covered}) *flag = t.field(1);
    texel.id = t.field(id);
    texel.depth = t.field(depth);

    Layout r(5 + 2 * address + 2 * map + id + depth + kLineCountBits + lines * line.bits);
    record.bits = r.bits();
    for (Field* flag : {&record.used, &record.has_next, &record.has_more}) *flag = r.field(1);
    record.next = r.field(address);
    record.more = r.field(address);
    record.texel = r.field(2 * map);
    record.object = r.field(id);
    record.nearest = r.field(depth);
    record.vertex = r.field(1);
    record.corner = r.field(1);
    record.count = r.field(kLineCountBits);
    record.lines_low = 0;

    Layout v(2 + 2 * map + line.bits + 5 * depth + 1 + kTexelsPerWord);
    visit.bits = v.bits();
    visit.kind = v.field(2);
    visit.x = v.field(map);
    visit.y = v.field(map);
    visit.line_low = v.field(line.bits).low;
    visit.nearest = v.field(depth);
    visit.corner = v.field(1);
    for (Field& d : visit.depth) d = v.field(depth);
    visit.mask = v.field(kTexelsPerWord);

    Layout tri(id + 2 * depth + 1);
    visit_tri.bits = tri.bits();
    visit_tri.object = tri.field(id);
    visit_tri.most = tri.field(depth);
    visit_tri.rise = tri.field(depth + 1);

    Layout s(5 + 2 * (map + 1) + 4 + 5 + 2 * kLimitBits + 7);
    settings.bits = s.bits();
    settings.texel_bits = s.field(5);
    settings.map_width = s.field(map + 1);
    settings.map_height = s.field(map + 1);
    settings.pitch_log2 = s.field(4);
    settings.buckets_log2 = s.field(5);
    settings.record_limit = s.field(kLimitBits);
    settings.chain_limit = s.field(kLimitBits);
    settings.own_id_literal = s.field(1);
    settings.vertex_per_entry = s.field(1);
    settings.table7_printed = s.field(1);
    settings.depth_writes_all = s.field(1);
    settings.hidden_removal = s.field(2);
    settings.match_polygon_id = s.field(1);

    Layout e(36);
    events.bits = e.bits();
    for (Field* flag : {&events.line_stored, &events.line_cancelled, &events.emptied_covered})
      *flag = e.field(1);
    events.lines_hidden = e.field(16);
    events.overflow_lines = e.field(16);
    events.overflow_texel = e.field(1);
  }

  /// log2 of the texel words of a row.
  static std::uint32_t pitch_log2(std::int64_t map_width) {
    std::uint32_t bits = 0;
    while ((std::int64_t{4} << bits) < map_width) ++bits;
    return bits;
  }
  static std::uint32_t log2(std::int64_t power) {
    std::uint32_t bits = 0;
    while ((std::int64_t{1} << bits) < power) ++bits;
    return bits;
  }
  /// settings_t of a configuration.
  Word make_settings(const UnitConfig& c, std::uint32_t fraction_bits_of_texel) const {
    Word word = make_word(settings.bits);
    settings.texel_bits.set(word, fraction_bits_of_texel);
    settings.map_width.set(word, static_cast<std::uint64_t>(c.map_width));
    settings.map_height.set(word, static_cast<std::uint64_t>(c.map_height));
    settings.pitch_log2.set(word, pitch_log2(c.map_width));
    settings.buckets_log2.set(word, log2(c.slb_buckets));
    settings.record_limit.set(word, static_cast<std::uint64_t>(c.slb_entries));
    settings.chain_limit.set(word, static_cast<std::uint64_t>(c.link_depth));
    settings.own_id_literal.set(word, c.own_id_rule == OwnIdRule::kLiteral);
    settings.vertex_per_entry.set(word, c.vertex_rule == VertexRule::kPerEntry);
    settings.table7_printed.set(word, c.table7 == Table7::kPrinted);
    settings.depth_writes_all.set(word, c.depth_writes == DepthWrites::kAll);
    settings.hidden_removal.set(word, static_cast<std::uint64_t>(c.hidden_removal));
    settings.match_polygon_id.set(word, c.match_polygon_id);
    return word;
  }

  PaperWidths widths;
  Line line;
  Texel texel;
  Record record;
  Visit visit;
  VisitTri visit_tri;
  Settings settings;
  Events events;
};

}  // namespace kagesen::rtl
