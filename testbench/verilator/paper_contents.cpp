#include "testbench/verilator/paper_contents.h"

#include <stdexcept>
#include <utility>

#include "model/unit/address_generator.h"

namespace kagesen::rtl {
namespace {

class Reader {
 public:
  Reader(const UnitConfig& config, const PaperLayout& layout, const ReadWord& record)
      : layout_(layout),
        record_(record),
        buckets_(static_cast<std::uint32_t>(config.slb_buckets)),
        left_(std::uint64_t{2} << layout.widths.record_addr_bits) {}

  std::uint32_t buckets() const { return buckets_; }

  /// Calls visit(record) on the entries of a bucket.
  template <typename Visit>
  void entries(std::uint32_t bucket, Visit visit) {
    const PaperLayout::Record& r = layout_.record;
    Word word = read(bucket);
    if (r.used.get(word) == 0) return;
    for (;;) {
      visit(word);
      if (r.has_next.get(word) == 0) return;
      word = read(r.next.get(word));
      if (r.used.get(word) == 0) throw std::runtime_error("SLB: an unused record is linked");
    }
  }
  /// Calls visit(record) on an entry's record and its continuations.
  template <typename Visit>
  void records(Word word, Visit visit) {
    for (;;) {
      visit(std::as_const(word));
      if (layout_.record.has_more.get(word) == 0) return;
      word = read(layout_.record.more.get(word));
    }
  }

 private:
  Word read(std::uint64_t address) {
    if (left_-- == 0) throw std::runtime_error("SLB: a chain does not end");
    return record_(address);
  }
  const PaperLayout& layout_;
  const ReadWord& record_;
  std::uint32_t buckets_;
  std::uint64_t left_;  // reads before a chain is held endless
};

LineRecord line_at(const PaperLayout& layout, const Word& word, std::size_t index) {
  const PaperLayout::Line& l = layout.line;
  const std::size_t base = layout.record.lines_low + index * l.bits;
  LineRecord out;
  out.fraction = static_cast<std::uint32_t>(l.fraction.get(word, base));
  out.slope = static_cast<std::uint32_t>(l.slope.get(word, base));
  out.polygon = static_cast<std::uint32_t>(l.polygon.get(word, base));
  out.left = l.left.get(word, base) != 0;
  out.cross = l.cross.get(word, base) != 0;
  out.x_major = l.x_major.get(word, base) != 0;
  out.x_positive = l.x_positive.get(word, base) != 0;
  out.start_here = l.start_here.get(word, base) != 0;
  out.end_here = l.end_here.get(word, base) != 0;
  return out;
}

}  // namespace

MapContents paper_contents(const UnitConfig& config, const PaperLayout& layout,
                           const ReadWord& texel_word, const ReadWord& record) {
  const PaperLayout::Texel& t = layout.texel;
  const PaperLayout::Record& r = layout.record;
  const std::uint32_t pitch = PaperLayout::pitch_log2(config.map_width);
  MapContents out;
  out.width = static_cast<std::uint32_t>(config.map_width);
  out.height = static_cast<std::uint32_t>(config.map_height);
  for (std::uint32_t y = 0; y < out.height; ++y) {
    Word word;
    for (std::uint32_t x = 0; x < out.width; ++x) {
      if (x % 4 == 0) word = texel_word(std::uint64_t{y} << pitch | x / 4);
      const std::size_t base = x % 4 * t.bits;
      out.depth.push_back(static_cast<std::uint32_t>(t.depth.get(word, base)));
      out.object.push_back(t.covered.get(word, base) != 0
                               ? static_cast<std::uint32_t>(t.id.get(word, base))
                               : kNoObject);
      out.overflowed.push_back(t.overflow.get(word, base) != 0);
      if (t.edge.get(word, base) == 0) continue;
      Reader reader(config, layout, record);
      const std::uint64_t texel = std::uint64_t{y} << layout.widths.map_bits | x;
      reader.entries(unit::bucket_of(x, y, reader.buckets()), [&](const Word& entry_word) {
        if (r.texel.get(entry_word) != texel) return;
        TexelEntry entry;
        entry.texel_x = x;
        entry.texel_y = y;
        entry.object = static_cast<std::uint32_t>(r.object.get(entry_word));
        entry.nearest = static_cast<std::uint32_t>(r.nearest.get(entry_word));
        entry.vertex = r.vertex.get(entry_word) != 0;
        reader.records(entry_word, [&](const Word& part) {
          const std::uint64_t lines = r.count.get(part);
          if (lines > static_cast<std::uint64_t>(config.lines_per_entry))
            throw std::runtime_error("SLB: a record counts more lines than it holds");
          for (std::size_t i = 0; i < lines; ++i) entry.lines.push_back(line_at(layout, part, i));
        });
        out.entries.push_back(std::move(entry));
      });
    }
  }
  return out;
}

std::uint64_t paper_records(const UnitConfig& config, const PaperLayout& layout,
                            const ReadWord& record) {
  std::uint64_t count = 0;
  for (std::uint32_t bucket = 0; bucket < config.slb_buckets; ++bucket) {
    Reader reader(config, layout, record);
    reader.entries(bucket, [&](const Word& entry) {
      reader.records(entry, [&](const Word&) { ++count; });
    });
  }
  return count;
}

}  // namespace kagesen::rtl
