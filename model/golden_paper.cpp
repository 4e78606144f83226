#include <algorithm>

#include "model/golden.h"
#include "model/stored_figures.h"
#include "model/unit/shadow_unit.h"

namespace kagesen {
namespace {

using unit::Line;
using unit::SilhouetteBuffer;

LineRecord as_record(const Line& line) {
  LineRecord out;
  out.fraction = line.fraction;
  out.slope = line.slope;
  out.polygon = line.polygon;
  out.left = line.has(Line::kLeft);
  out.cross = line.has(Line::kCross);
  out.x_major = line.has(Line::kXMajor);
  out.x_positive = line.has(Line::kXPositive);
  out.start_here = line.has(Line::kStartHere);
  out.end_here = line.has(Line::kEndHere);
  return out;
}

class PaperEngine : public Engine {
 public:
  explicit PaperEngine(std::shared_ptr<unit::ShadowUnit> unit)
      : own_(unit ? std::move(unit) : std::make_shared<unit::ShadowUnit>()), unit_(*own_) {}
  std::string name() const override { return "golden"; }

  void begin(const UnitConfig& config, const FrameSetup& setup) override {
    unit_.begin(config, setup);
  }

  void announce(const Fragment*, std::size_t) override {}

  void draw(const Caster* casters, std::size_t count) override {
    for (std::size_t i = 0; i < count; ++i) unit_.draw(casters[i]);
  }

  void decide(const Fragment* fragments, std::size_t count, Verdict* verdicts) override {
    unit_.decide(fragments, count, verdicts);
  }

  MapContents contents() const override {
    const unit::TexelBuffers& texels = unit_.texels();
    MapContents out;
    out.width = texels.width();
    out.height = texels.height();
    const std::size_t count = std::size_t{out.width} * out.height;
    out.depth.reserve(count);
    out.object.reserve(count);
    out.overflowed.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      const unit::Texel& texel = texels[i];
      out.depth.push_back(texel.depth);
      out.object.push_back(texel.id() == unit::Texel::kNoId ? kNoObject : texel.id());
      out.overflowed.push_back(texel.overflow());
      if (texel.edge()) append_entries(i, out.entries);
    }
    return out;
  }

  UnitCounters counters() const override {
    UnitCounters c = unit_.counters();
    const SilhouetteBuffer& slb = unit_.slb();
    StoredFigures figures(c);
    for (std::uint32_t bucket = 0; bucket < slb.buckets(); ++bucket) {
      count_bucket(bucket, figures, c);
    }
    c.peak_entries = slb.peak();
    add_paper_bytes(unit_.config(), c);
    return c;
  }

 private:
  void append_entries(std::uint32_t texel, std::vector<TexelEntry>& out) const {
    const SilhouetteBuffer& slb = unit_.slb();
    std::vector<Line> lines;
    for (std::uint32_t at = slb.first_of(unit_.bucket_at(texel), texel);
         at != SilhouetteBuffer::kNone; at = slb.next_of(at)) {
      TexelEntry entry;
      entry.texel_x = texel % unit_.texels().width();
      entry.texel_y = texel / unit_.texels().width();
      entry.object = slb[at].object;
      entry.nearest = slb[at].nearest;
      entry.vertex = slb[at].vertex;
      slb.copy_lines(at, lines);
      for (const Line& line : lines) entry.lines.push_back(as_record(line));
      out.push_back(std::move(entry));
    }
  }

  /// Texels, entries, lines and chains of one bucket.
  void count_bucket(std::uint32_t bucket, StoredFigures& figures, UnitCounters& c) const {
    const SilhouetteBuffer& slb = unit_.slb();
    std::vector<std::pair<std::uint32_t, std::uint64_t>> chains;  // texel, records
    for (std::uint32_t at = slb.head(bucket); at != SilhouetteBuffer::kNone; at = slb[at].next) {
      figures.add_entry(slb.line_count(at));
      auto chain = std::find_if(chains.begin(), chains.end(),
                                [&](const auto& p) { return p.first == slb[at].texel; });
      if (chain == chains.end()) chain = chains.insert(chains.end(), {slb[at].texel, 0});
      for (std::uint32_t r = at; r != SilhouetteBuffer::kNone; r = slb[r].more) ++chain->second;
    }
    for (const auto& chain : chains) figures.add_texel(chain.second);
    c.collisions += chains.empty() ? 0 : chains.size() - 1;
  }

  std::shared_ptr<unit::ShadowUnit> own_;
  unit::ShadowUnit& unit_;
};

}  // namespace

std::unique_ptr<Engine> make_golden_paper_engine(std::shared_ptr<unit::ShadowUnit> unit) {
  return std::make_unique<PaperEngine>(std::move(unit));
}

}  // namespace kagesen
