#include <algorithm>
#include <tuple>

#include "model/golden.h"
#include "model/stored_figures.h"
#include "model/unit/winding/shadow_unit.h"

namespace kagesen {
namespace {

using unit::winding::Cluster;
using unit::winding::Segment;
using unit::winding::ShadowUnit;
using unit::winding::SilhouetteBuffer;
using unit::winding::Texel;
using unit::winding::TexelBuffers;
using unit::winding::Threshold;
using unit::winding::ThresholdPlane;
using unit::winding::Tile;

class WindingEngine : public Engine {
 public:
  explicit WindingEngine(std::shared_ptr<ShadowUnit> unit)
      : own_(unit ? std::move(unit) : std::make_shared<ShadowUnit>()), unit_(*own_) {}
  std::string name() const override { return "golden"; }
  void begin(const UnitConfig& config, const FrameSetup& setup) override {
    unit_.begin(config, setup);
  }
  void announce(const Fragment* fragments, std::size_t count) override {
    unit_.announce(fragments, count);
  }
  void draw(const Caster* casters, std::size_t count) override {
    for (std::size_t i = 0; i < count; ++i) unit_.draw(casters[i]);
  }
  void decide(const Fragment* fragments, std::size_t count, Verdict* verdicts) override {
    unit_.decide(fragments, count, verdicts);
  }

  MapContents contents() const override {
    unit_.settle();
    MapContents out;
    const TexelBuffers& texels = unit_.texels();
    out.width = texels.width();
    out.height = texels.height();
    const std::size_t count = std::size_t{out.width} * out.height;
    out.depth.assign(count, kDepthMax);
    out.object.assign(count, kNoObject);
    out.overflowed.assign(count, 0);
    for (std::uint32_t y = 0; y < out.height; ++y) {
      for (std::uint32_t x = 0; x < out.width; ++x) {
        const Tile& tile = texels.tile(x, y);
        if (tile.slot != Tile::kUntouched) append(texels.texel(tile, x, y), x, y, out);
      }
    }
    return out;
  }

  UnitCounters counters() const override {
    unit_.settle();
    UnitCounters c = unit_.counters();
    const TexelBuffers& texels = unit_.texels();
    StoredFigures figures(c);
    for (const Tile& tile : texels.tiles()) {
      if (tile.slot == Tile::kUntouched) continue;
      for (std::uint32_t i = 0; i < TexelBuffers::kTileTexels; ++i) {
        count_texel(texels.texel(tile, i & 7, i >> 3), figures);
      }
    }
    c.peak_entries = unit_.slb().peak_records();
    c.skips.cleared_texels = texels.touched_texels();
    add_winding_bytes(unit_.config(), static_cast<std::uint32_t>(unit_.widths().texel_bits), c);
    return c;
  }

 private:
  void append(const Texel& texel, std::uint32_t x, std::uint32_t y, MapContents& out) const {
    const std::size_t at = std::size_t{y} * out.width + x;
    out.overflowed[at] = texel.overflow();
    if (texel.object != Texel::kNobody) {
      const std::int64_t depth = texel.list == Texel::kNoList
                                     ? ThresholdPlane(texel.cover, unit_.widths()).base
                                     : std::int64_t{texel.cover.base};
      out.depth[at] = static_cast<std::uint32_t>(std::clamp<std::int64_t>(depth, 0, kDepthMax));
      out.object[at] = texel.object;
    }
    const std::size_t first = out.clusters.size();
    if (texel.one_plane()) {
      out.clusters.push_back(cluster(x, y, texel.cover, texel.object));
      out.clusters.back().full = true;
    }
    if (!texel.has_list()) return;
    const SilhouetteBuffer& slb = unit_.slb();
    for (std::uint32_t i = texel.list; i != SilhouetteBuffer::kNone; i = slb[i].next) {
      const Cluster& stored = slb[i];
      TexelCluster c = cluster(x, y, stored.threshold, stored.object);
      c.corner = static_cast<std::uint32_t>(stored.corner);
      c.full = stored.full;
      slb.each_segment(stored, [&](const Segment& s) {
        c.segments.push_back({static_cast<std::uint32_t>(s.x0), static_cast<std::uint32_t>(s.y0),
                              static_cast<std::uint32_t>(s.x1), static_cast<std::uint32_t>(s.y1),
                              s.positive(), s.crosses_left()});
        return true;
      });
      std::sort(c.segments.begin(), c.segments.end(), [](const auto& a, const auto& b) {
        return std::tie(a.x0, a.y0, a.x1, a.y1, a.positive, a.crosses_left) <
               std::tie(b.x0, b.y0, b.x1, b.y1, b.positive, b.crosses_left);
      });
      out.clusters.push_back(std::move(c));
    }
    std::sort(out.clusters.begin() + static_cast<std::ptrdiff_t>(first), out.clusters.end(),
              [](const auto& a, const auto& b) {
                return std::tie(a.base, a.gradient_x, a.gradient_y, a.object) <
                       std::tie(b.base, b.gradient_x, b.gradient_y, b.object);
              });
  }

  static TexelCluster cluster(std::uint32_t x, std::uint32_t y, const Threshold& t,
                              std::uint32_t object) {
    TexelCluster c;
    c.texel_x = x;
    c.texel_y = y;
    c.object = object;
    c.base = t.base;
    c.gradient_x = t.gradient_x;
    c.gradient_y = t.gradient_y;
    return c;
  }

  void count_texel(const Texel& texel, StoredFigures& figures) const {
    if (!texel.has_list()) return;
    const SilhouetteBuffer& slb = unit_.slb();
    std::uint64_t records = 0;
    for (std::uint32_t at = texel.list; at != SilhouetteBuffer::kNone; at = slb[at].next) {
      figures.add_entry(slb[at].segment_count);
      records += slb.records_of(slb[at]);
    }
    figures.add_texel(records);
  }

  std::shared_ptr<ShadowUnit> own_;
  ShadowUnit& unit_;
};

}  // namespace

std::unique_ptr<Engine> make_golden_winding_engine(
    std::shared_ptr<unit::winding::ShadowUnit> unit) {
  return std::make_unique<WindingEngine>(std::move(unit));
}

}  // namespace kagesen
