#pragma once
/// The buffers of the golden unit as words of the texel and SLB memories, for what reads them alone:
/// records stand anywhere, and the texels of a bucket are interleaved, as far as the order of each
/// texel's entries allows.
#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "model/engine.h"
#include "model/unit/address_generator.h"
#include "testbench/verilator/bits.h"
#include "testbench/verilator/memory.h"

namespace kagesen::rtl {

/// The widths of shadow_pkg.sv and the words made of them.
struct PaperLayout {
  std::size_t fraction = 8, slope = 8, depth = 24, id = 16, polygon = 14, lines = 3, record_addr = 19;
  std::size_t map_bits = 10, line_count = 4;

  std::size_t line_bits() const { return 6 + polygon + slope + fraction; }
  std::size_t texel_bits() const { return 3 + id + depth; }
  std::size_t record_bits() const {
    return 5 + 2 * record_addr + 2 * map_bits + id + depth + line_count + lines * line_bits();
  }

  std::uint64_t line(const LineRecord& l) const {
    std::uint64_t word = 0;
    for (const bool flag : {l.left, l.cross, l.x_major, l.x_positive, l.start_here, l.end_here}) {
      word = word << 1 | flag;
    }
    return ((word << polygon | l.polygon) << slope | l.slope) << fraction | l.fraction;
  }

  struct Record {
    bool used = false;
    std::uint64_t next = 0, more = 0;  ///< 0: none, as no chain leads to the first bucket
    TexelEntry entry;                  ///< lines: of this record alone
  };
  Word record(const Record& r) const {
    Word word = make_word(record_bits());
    Layout layout(record_bits());
    const auto put = [&](std::size_t width, std::uint64_t value) {
      layout.field(width).set(word, value);
    };
    put(1, r.used);
    put(1, r.next != 0);
    put(1, r.more != 0);
    put(record_addr, r.next);
    put(record_addr, r.more);
    put(2 * map_bits, std::uint64_t{r.entry.texel_y} << map_bits | r.entry.texel_x);
    put(id, r.entry.object);
    put(depth, r.entry.nearest);
    put(1, r.entry.vertex);
    put(1, 0);
    put(line_count, r.entry.lines.size());
    for (std::size_t i = 0; i < r.entry.lines.size(); ++i) {
      set_bits(word, i * line_bits(), line_bits(), line(r.entry.lines[i]));
    }
    return word;
  }
};

/// @param buckets_log2  of the lane's registers; the golden unit's own hash does not matter
inline void encode_contents(const MapContents& contents, const PaperLayout& layout,
                            unsigned pitch_log2, unsigned buckets_log2, unsigned seed,
                            Memory& texels, Memory& records) {
  std::mt19937 random(seed);
  const std::uint64_t buckets = std::uint64_t{1} << buckets_log2;
  std::set<std::uint64_t> edge_texels;
  std::map<std::uint64_t, std::vector<std::vector<const TexelEntry*>>> chains;  // bucket: a texel each
  std::uint64_t last_texel = ~std::uint64_t{0};
  for (const TexelEntry& entry : contents.entries) {
    const std::uint64_t texel = std::uint64_t{entry.texel_y} * contents.width + entry.texel_x;
    auto& bucket = chains[unit::bucket_of(
        entry.texel_x, entry.texel_y, static_cast<std::uint32_t>(buckets))];
    edge_texels.insert(texel);
    if (texel != last_texel) bucket.emplace_back();
    last_texel = texel;
    bucket.back().push_back(&entry);
  }

  for (std::uint64_t y = 0; y < contents.height; ++y) {
    for (std::uint64_t x = 0; x < contents.width; x += 4) {
      Word word = make_word(4 * layout.texel_bits());
      for (std::uint64_t i = 0; i < 4 && x + i < contents.width; ++i) {
        const std::uint64_t texel = y * contents.width + x + i;
        const bool covered = contents.object[texel] != kNoObject;
        const std::uint64_t flags = (contents.overflowed[texel] != 0 ? 4u : 0u) |
                                    (edge_texels.count(texel) != 0 ? 2u : 0u) | (covered ? 1u : 0u);
        const std::size_t base = i * layout.texel_bits();
        set_bits(word, base, layout.depth, contents.depth[texel]);
        set_bits(word, base + layout.depth, layout.id, covered ? contents.object[texel] : random());
        set_bits(word, base + layout.depth + layout.id, 3, flags);
      }
      texels.poke(y << pitch_log2 | x >> 2, word);
    }
  }

  std::set<std::uint64_t> taken;
  const auto allocate = [&] {
    for (;;) {
      const std::uint64_t at =
          buckets + random() % ((std::uint64_t{1} << layout.record_addr) - buckets);
      if (taken.insert(at).second) return at;
    }
  };
  for (std::uint64_t bucket = 0; bucket < buckets; ++bucket) {
    records.poke(bucket, make_word(layout.record_bits()));
  }
  for (auto& [bucket, lists] : chains) {
    std::vector<const TexelEntry*> chain;
    std::vector<std::size_t> from(lists.size(), 0), left;
    for (;;) {
      left.clear();
      for (std::size_t i = 0; i < lists.size(); ++i) {
        if (from[i] < lists[i].size()) left.push_back(i);
      }
      if (left.empty()) break;
      const std::size_t i = left[random() % left.size()];
      chain.push_back(lists[i][from[i]++]);
    }
    std::uint64_t at = bucket;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const std::uint64_t next = i + 1 < chain.size() ? allocate() : 0;
      const std::vector<LineRecord>& lines = chain[i]->lines;
      PaperLayout::Record record{at == bucket, next, 0, *chain[i]};
      for (std::size_t first = 0; first == 0 || first < lines.size(); first += layout.lines) {
        const std::size_t last = std::min(lines.size(), first + layout.lines);
        record.entry.lines.assign(lines.begin() + static_cast<std::ptrdiff_t>(first),
                                  lines.begin() + static_cast<std::ptrdiff_t>(last));
        record.more = last < lines.size() ? allocate() : 0;
        records.poke(at, layout.record(record));
        // Of a continuation record, nothing counts but its lines and what lies behind.
        at = record.more;
        record = {random() % 2 != 0, random() % 2, 0, *chain[i]};
        record.entry.nearest = static_cast<std::uint32_t>(random() & 0xffffff);
        record.entry.vertex = random() % 2 != 0;
      }
      at = next;
    }
  }
}

}  // namespace kagesen::rtl
