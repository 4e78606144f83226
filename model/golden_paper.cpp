#include <algorithm>

#include "model/golden.h"
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

/// Bits of a stored entry and line, payload alone: 42 and 36 by default, as Table 8 implies.
struct RecordBits {
  explicit RecordBits(const UnitConfig& c) {
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

class PaperEngine : public Engine {
 public:
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
    const UnitConfig& config = unit_.config();
    const RecordBits bits(config);
    const std::uint64_t texels = static_cast<std::uint64_t>(config.map_width * config.map_height);
    const SilhouetteBuffer& slb = unit_.slb();
    c.chain_histogram.assign(1, 0);
    for (std::uint32_t bucket = 0; bucket < slb.buckets(); ++bucket) count_bucket(bucket, c);
    c.max_chain = c.chain_histogram.size() - 1;
    c.peak_entries = slb.peak();
    c.payload_bytes = (c.slb_entries * bits.entry + c.slb_lines * bits.line + 7) / 8;
    c.allocated_bytes = (c.peak_entries * bits.record + slb.buckets() * bits.bucket + 7) / 8;
    c.map_bytes = (texels * (config.depth_bits + config.id_bits + 2) + 7) / 8;
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
  void count_bucket(std::uint32_t bucket, UnitCounters& c) const {
    const SilhouetteBuffer& slb = unit_.slb();
    std::vector<std::pair<std::uint32_t, std::uint64_t>> chains;  // texel, records
    for (std::uint32_t at = slb.head(bucket); at != SilhouetteBuffer::kNone; at = slb[at].next) {
      ++c.slb_entries;
      c.slb_lines += slb.line_count(at);
      auto chain = std::find_if(chains.begin(), chains.end(),
                                [&](const auto& p) { return p.first == slb[at].texel; });
      if (chain == chains.end()) chain = chains.insert(chains.end(), {slb[at].texel, 0});
      for (std::uint32_t r = at; r != SilhouetteBuffer::kNone; r = slb[r].more) ++chain->second;
    }
    for (const auto& [texel, records] : chains) {
      if (c.chain_histogram.size() <= records) c.chain_histogram.resize(records + 1);
      ++c.chain_histogram[records];
    }
    c.slb_texels += chains.size();
    c.collisions += chains.empty() ? 0 : chains.size() - 1;
  }

  unit::ShadowUnit unit_;
};

}  // namespace

std::unique_ptr<Engine> make_golden_paper_engine() { return std::make_unique<PaperEngine>(); }

}  // namespace kagesen
