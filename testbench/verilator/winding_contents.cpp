#include "testbench/verilator/winding_contents.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace kagesen::rtl {
namespace {

std::int64_t sign_extended(std::uint64_t value, std::size_t width) {
  const std::uint64_t sign = std::uint64_t{1} << (width - 1);
  return static_cast<std::int64_t>((value ^ sign) - sign);
}

class Reader {
 public:
  Reader(const UnitConfig& config, const WindingLayout& layout, const ReadWord& record,
         MapContents& out)
      : config_(config), layout_(layout), record_(record), out_(out) {}

  void texel(std::uint32_t x, std::uint32_t y, const Word& word) {
    const WindingLayout::Texel& t = layout_.texel;
    const std::size_t low = x % 4 * t.bits;
    const std::size_t at = std::size_t{y} * out_.width + x;
    const std::size_t first = out_.clusters.size();
    const std::uint64_t kind = t.kind.get(word, low);
    if (kind == WindingLayout::kPlane) {
      TexelCluster c = cluster(x, y, word, low);
      c.object = static_cast<std::uint32_t>(t.object.get(word, low));
      c.full = true;
      cover(at, std::int64_t{c.base} << config_.plane_step_bits, c.object);
      out_.clusters.push_back(c);
    } else if (kind != WindingLayout::kEmpty) {
      out_.overflowed[at] = kind == WindingLayout::kOverflow;
      if (t.covered.get(word, low) != 0) {
        cover(at, sign_extended(t.cover_depth.get(word, low), WindingLayout::kCoverBits),
              static_cast<std::uint32_t>(t.object.get(word, low)));
      }
      if (kind == WindingLayout::kList) list(x, y, t.first.get(word, low));
    }
    std::sort(out_.clusters.begin() + static_cast<std::ptrdiff_t>(first), out_.clusters.end(),
              [](const TexelCluster& a, const TexelCluster& b) {
                return std::tie(a.base, a.gradient_x, a.gradient_y, a.object) <
                       std::tie(b.base, b.gradient_x, b.gradient_y, b.object);
              });
  }
  std::uint64_t records() const { return records_; }

 private:
  void cover(std::size_t at, std::int64_t depth, std::uint32_t object) {
    out_.depth[at] = static_cast<std::uint32_t>(std::clamp<std::int64_t>(depth, 0, kDepthMax));
    out_.object[at] = object;
  }
  TexelCluster cluster(std::uint32_t x, std::uint32_t y, const Word& word, std::size_t low) const {
    const WindingLayout::Threshold& t = layout_.threshold;
    TexelCluster c;
    c.texel_x = x;
    c.texel_y = y;
    c.base = static_cast<std::int32_t>(sign_extended(t.base.get(word, low), t.base.width));
    c.gradient_x = static_cast<std::uint32_t>(t.gradient_x.get(word, low));
    c.gradient_y = static_cast<std::uint32_t>(t.gradient_y.get(word, low));
    return c;
  }
  void list(std::uint32_t x, std::uint32_t y, std::uint64_t address) {
    const WindingLayout::Record& r = layout_.record;
    for (bool more = true, continued = false; more;) {
      if (++records_ > static_cast<std::uint64_t>(config_.cluster_records)) {
        throw std::runtime_error("SLB: more records are linked than there are");
      }
      const Word word = record_(address);
      if (!continued) {
        out_.clusters.push_back(cluster(x, y, word, r.threshold_low));
        TexelCluster& c = out_.clusters.back();
        c.object = static_cast<std::uint32_t>(r.object.get(word));
        c.corner = static_cast<std::uint32_t>(r.corner.get(word));
        c.full = r.full.get(word) != 0;
      }
      segments(word, out_.clusters.back());
      continued = r.goes_on.get(word) != 0;
      more = r.has_next.get(word) != 0;
      if (continued && !more) throw std::runtime_error("SLB: a cluster goes on nowhere");
      address = r.next.get(word);
    }
    for (TexelCluster& c : out_.clusters) {
      if (c.texel_x == x && c.texel_y == y) sort(c.segments);
    }
  }
  void segments(const Word& word, TexelCluster& c) const {
    const WindingLayout::Segment& s = layout_.segment;
    const std::uint64_t count = layout_.record.count.get(word);
    if (count > static_cast<std::uint64_t>(config_.segments_per_record)) {
      throw std::runtime_error("SLB: a record counts more segments than it holds");
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto field = [&](const WindingLayout::Field& f) {
        return static_cast<std::uint32_t>(f.get(word, i * s.bits));
      };
      c.segments.push_back({field(s.x0), field(s.y0), field(s.x1), field(s.y1),
                            field(s.positive) != 0, field(s.crosses_left) != 0});
    }
  }
  static void sort(std::vector<SegmentRecord>& segments) {
    std::sort(segments.begin(), segments.end(), [](const auto& a, const auto& b) {
      return std::tie(a.x0, a.y0, a.x1, a.y1, a.positive, a.crosses_left) <
             std::tie(b.x0, b.y0, b.x1, b.y1, b.positive, b.crosses_left);
    });
  }

  const UnitConfig& config_;
  const WindingLayout& layout_;
  const ReadWord& record_;
  MapContents& out_;
  std::uint64_t records_ = 0;
};

}  // namespace

MapContents winding_contents(const UnitConfig& config, const WindingLayout& layout,
                             const ReadWord& texel_word, const ReadWord& record,
                             std::uint64_t* records) {
  MapContents out;
  out.width = static_cast<std::uint32_t>(config.map_width);
  out.height = static_cast<std::uint32_t>(config.map_height);
  const std::size_t count = std::size_t{out.width} * out.height;
  out.depth.assign(count, kDepthMax);
  out.object.assign(count, kNoObject);
  out.overflowed.assign(count, 0);
  Reader reader(config, layout, record, out);
  for (std::uint32_t y = 0; y < out.height; ++y) {
    Word tile;
    for (std::uint32_t x = 0; x < out.width; ++x) {
      if (x % 8 == 0) tile = texel_word(layout.tile_address(x, y));
      if (layout.tile.touched.get(tile) == 0) continue;
      reader.texel(x, y,
                   texel_word(WindingLayout::texel_address(layout.tile.slot.get(tile), x, y)));
    }
  }
  if (records != nullptr) *records = reader.records();
  return out;
}

}  // namespace kagesen::rtl
