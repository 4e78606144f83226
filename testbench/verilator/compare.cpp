#include "testbench/verilator/compare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <tuple>

namespace kagesen {
namespace {

std::string text_of(const LineRecord& l) {
  std::string text = fmt::format("line {}/{} polygon {}", l.fraction, l.slope, l.polygon);
  const auto flag = [&](bool set, const char* name) {
    if (set) text += fmt::format(" {}", name);
  };
  flag(l.left, "left");
  flag(l.cross, "cross");
  flag(l.x_major, "x-major");
  flag(l.x_positive, "x-positive");
  flag(l.start_here, "start-here");
  flag(l.end_here, "end-here");
  return text;
}

std::string text_of(const TexelEntry& e) {
  std::string text = fmt::format("entry of object {}, nearest {}{}", e.object, e.nearest,
                                 e.vertex ? ", vertex" : "");
  for (const LineRecord& l : e.lines) text += "; " + text_of(l);
  return text;
}

std::string text_of(const TexelCluster& c) {
  std::string text = fmt::format("cluster of object {}, base {}, gradient {:#x} {:#x}", c.object,
                                 c.base, c.gradient_x, c.gradient_y);
  text += c.full ? ", full" : fmt::format(", corner {}", c.corner);
  for (const SegmentRecord& s : c.segments) {
    text += fmt::format("; ({}, {}) to ({}, {}) {}{}", s.x0, s.y0, s.x1, s.y1,
                        s.positive ? "+" : "-", s.crosses_left ? " crosses-left" : "");
  }
  return text;
}

/// A walk over lists that are in the order of their texels.
template <typename Item>
class Cursor {
 public:
  explicit Cursor(const std::vector<Item>& items) : items_(items) {}
  /// Calls use(item) for those of the texel. @pre texels are asked for in order
  template <typename Use>
  void each(std::uint32_t x, std::uint32_t y, Use use) {
    while (at_ < items_.size() &&
           std::tie(items_[at_].texel_y, items_[at_].texel_x) < std::tie(y, x)) {
      ++at_;
    }
    for (; at_ < items_.size() && items_[at_].texel_x == x && items_[at_].texel_y == y; ++at_) {
      use(items_[at_]);
    }
  }

 private:
  const std::vector<Item>& items_;
  std::size_t at_ = 0;
};

/// Two lists hold the same of a texel.
template <typename Item>
bool same(Cursor<Item>& a, Cursor<Item>& b, std::uint32_t x, std::uint32_t y) {
  std::vector<const Item*> of_a, of_b;
  a.each(x, y, [&](const Item& i) { of_a.push_back(&i); });
  b.each(x, y, [&](const Item& i) { of_b.push_back(&i); });
  if (of_a.size() != of_b.size()) return false;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    if (text_of(*of_a[i]) != text_of(*of_b[i])) return false;
  }
  return true;
}

}  // namespace

std::vector<std::string> texel_lines(const MapContents& contents, std::uint32_t x,
                                     std::uint32_t y) {
  std::vector<std::string> lines;
  const std::size_t at = std::size_t{y} * contents.width + x;
  if (x < contents.width && y < contents.height) {
    if (contents.object[at] != kNoObject) {
      lines.push_back(
          fmt::format("covered by object {}, depth {}", contents.object[at], contents.depth[at]));
    }
    if (contents.overflowed[at]) lines.push_back("overflowed");
  }
  Cursor<TexelEntry>(contents.entries).each(x, y, [&](const TexelEntry& e) {
    lines.push_back(text_of(e));
  });
  Cursor<TexelCluster>(contents.clusters).each(x, y, [&](const TexelCluster& c) {
    lines.push_back(text_of(c));
  });
  if (lines.empty()) lines.push_back("nothing");
  return lines;
}

BufferDifferences compare_contents(const MapContents& golden, const MapContents& other) {
  BufferDifferences out;
  Cursor<TexelEntry> entries(golden.entries), other_entries(other.entries);
  Cursor<TexelCluster> clusters(golden.clusters), other_clusters(other.clusters);
  for (std::uint32_t y = 0; y < golden.height; ++y) {
    for (std::uint32_t x = 0; x < golden.width; ++x) {
      const std::size_t at = std::size_t{y} * golden.width + x;
      const bool lists = same(entries, other_entries, x, y) & same(clusters, other_clusters, x, y);
      if (lists && golden.depth[at] == other.depth[at] && golden.object[at] == other.object[at] &&
          golden.overflowed[at] == other.overflowed[at]) {
        continue;
      }
      if (out.texels++ == 0) {
        out.first_x = x;
        out.first_y = y;
      }
    }
  }
  return out;
}

std::vector<std::string> compare_counters(const UnitCounters& golden, const UnitCounters& other) {
  std::vector<std::string> out;
  const auto hold = [&](const char* name, std::uint64_t a, std::uint64_t b) {
    if (a != b) out.push_back(fmt::format("{}: {}, but {}", name, a, b));
  };
#define HOLD(field) hold(#field, golden.field, other.field)
  HOLD(casters);
  HOLD(edges);
  HOLD(edge_texels);
  HOLD(span_texels);
  HOLD(lines_stored);
  HOLD(lines_cancelled);
  HOLD(lines_hidden);
  HOLD(emptied_covered);
  HOLD(slb_texels);
  HOLD(slb_entries);
  HOLD(slb_lines);
  HOLD(peak_entries);
  HOLD(collisions);
  HOLD(overflow_lines);
  HOLD(overflow_texels);
  HOLD(payload_bytes);
  HOLD(allocated_bytes);
  HOLD(map_bytes);
  HOLD(max_chain);
  HOLD(fragments);
  HOLD(averted);
  HOLD(outside);
  HOLD(dark_by_buffer);
  HOLD(dark_by_lines);
  HOLD(lit);
  HOLD(slb_lookups);
  HOLD(entries_read);
  HOLD(lines_read);
  HOLD(skips.texel_visits);
  HOLD(skips.masked_visits);
  HOLD(skips.hidden_visits);
  HOLD(skips.inner_edge_texels);
  HOLD(skips.cleared_texels);
  HOLD(skips.known_fragments);
  HOLD(skips.tile_lit);
  HOLD(skips.tile_dark);
  HOLD(skips.texel_lookups);
  HOLD(skips.first_test_dark);
#undef HOLD
  if (golden.chain_histogram != other.chain_histogram) {
    out.push_back(fmt::format("chain_histogram: [{}], but [{}]",
                              fmt::join(golden.chain_histogram, " "),
                              fmt::join(other.chain_histogram, " ")));
  }
  return out;
}

}  // namespace kagesen
