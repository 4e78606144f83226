#include "model/stored_figures.h"

#include <algorithm>
#include <unordered_map>

#include "model/golden.h"
#include "model/unit/address_generator.h"
#include "model/unit/winding/plane.h"
#include "model/unit/winding/texel_buffers.h"

namespace kagesen {
namespace {

using unit::winding::TexelBuffers;
using unit::winding::Widths;

/// Bits of a stored entry and line, payload alone: 42 and 36 by default, as Table 8 implies.
struct PaperBits {
  explicit PaperBits(const UnitConfig& c) {
    entry = c.depth_bits + c.id_bits + 2;  // Vertex Flag, Edge Flag
    line = c.fraction_bits + c.slope_bits + c.polygon_id_bits + 6;
    const int link = bits_for(static_cast<std::uint64_t>(c.slb_entries) + 1);
    const int tag = bits_for(static_cast<std::uint64_t>(c.map_width) *
                             static_cast<std::uint64_t>(c.map_height));
    const int count = bits_for(static_cast<std::uint64_t>(c.lines_per_entry) + 1);
    record = entry + c.lines_per_entry * line + tag + 2 * link + count + 1;  // covers-corner flag
    bucket = link;
  }
  std::int64_t entry, line, record, bucket;
};

/// Bits of what the winding profile stores (docs/unit.md).
struct WindingBits {
  WindingBits(const UnitConfig& c, const Widths& w, std::uint64_t tiles) {
    const int id = c.semantics == Semantics::kPaper ? static_cast<int>(c.id_bits) : 0;
    const int link = bits_for(static_cast<std::uint64_t>(c.cluster_records) + 1);
    const int plane = w.base_bits() + 2 * w.gradient_code_bits();
    const auto per_record = static_cast<std::uint64_t>(c.segments_per_record);
    segment = 4 * (w.end_bits + 1) + 2 + (c.skip_edges ? 0 : 1);  // inner
    cluster = plane + id + static_cast<int>(c.corner_bits) + 1;
    record = cluster + static_cast<int>(per_record) * segment + bits_for(per_record + 1) + 1 + link;
    texel = 2 + id + std::max(plane, kDepthBits + link);
    tile = bits_for(tiles + 1) + 2 * kDepthBits + id;
    if (c.skip_receiver_mask) tile += static_cast<int>(TexelBuffers::kTileTexels) + kDepthBits;
  }
  int segment, cluster, record, texel, tile;
};

std::uint64_t records_for(std::uint64_t items, std::int64_t per_record) {
  const auto per = static_cast<std::uint64_t>(per_record);
  return std::max<std::uint64_t>(1, (items + per - 1) / per);
}

/// Calls `texel(first, last)` for each run of neighbours in the list that share a texel.
template <typename Item, typename Use>
void by_texel(const std::vector<Item>& items, Use use) {
  for (auto first = items.begin(); first != items.end();) {
    const auto last = std::find_if(first, items.end(), [&](const Item& i) {
      return i.texel_x != first->texel_x || i.texel_y != first->texel_y;
    });
    use(first, last);
    first = last;
  }
}

void add_paper(const UnitConfig& config, const MapContents& contents, UnitCounters& counters) {
  StoredFigures figures(counters);
  std::unordered_map<std::uint32_t, std::uint64_t> texels_of_bucket;
  by_texel(contents.entries, [&](auto first, auto last) {
    const std::uint32_t bucket = unit::bucket_of(first->texel_x, first->texel_y,
                                                 static_cast<std::uint32_t>(config.slb_buckets));
    counters.collisions += texels_of_bucket[bucket]++ > 0;
    std::uint64_t records = 0;
    for (; first != last; ++first) {
      figures.add_entry(first->lines.size());
      records += records_for(first->lines.size(), config.lines_per_entry);
    }
    figures.add_texel(records);
  });
}

void add_winding(const UnitConfig& config, const MapContents& contents, UnitCounters& counters) {
  StoredFigures figures(counters);
  by_texel(contents.clusters, [&](auto first, auto last) {
    // Once pass 1 is settled, a full cluster alone is the texel's cover and stands in no list.
    if (last - first == 1 && first->full) return;
    std::uint64_t records = 0;
    for (; first != last; ++first) {
      figures.add_entry(first->segments.size());
      records += records_for(first->segments.size(), config.segments_per_record);
    }
    figures.add_texel(records);
  });
}

}  // namespace

void add_paper_bytes(const UnitConfig& config, UnitCounters& c) {
  const PaperBits bits(config);
  const auto texels = static_cast<std::uint64_t>(config.map_width * config.map_height);
  const auto buckets = static_cast<std::uint64_t>(config.slb_buckets);
  c.payload_bytes = (c.slb_entries * bits.entry + c.slb_lines * bits.line + 7) / 8;
  c.allocated_bytes = (c.peak_entries * bits.record + buckets * bits.bucket + 7) / 8;
  c.map_bytes = (texels * (config.depth_bits + config.id_bits + 2) + 7) / 8;
}

void add_winding_bytes(const UnitConfig& config, std::uint32_t fraction_bits, UnitCounters& c) {
  const auto tiles =
      static_cast<std::uint64_t>(((config.map_width + 7) / 8) * ((config.map_height + 7) / 8));
  const WindingBits bits(config, Widths(config, static_cast<int>(fraction_bits)), tiles);
  c.payload_bytes = (c.slb_entries * bits.cluster + c.slb_lines * bits.segment + 7) / 8;
  c.allocated_bytes = (c.peak_entries * bits.record + 7) / 8;
  c.map_bytes = (tiles * bits.tile + c.skips.cleared_texels * bits.texel + 7) / 8;
}

void add_stored_figures(const UnitConfig& config, const MapContents& contents,
                        UnitCounters& counters) {
  if (config.profile == Profile::kPaper) {
    add_paper(config, contents, counters);
  } else {
    add_winding(config, contents, counters);
  }
}

}  // namespace kagesen
