#include "testbench/coverage/bins.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace kagesen {
namespace {

constexpr const char* kBy[] = {"definition", "outside", "nothing", "buffer", "lines", "tile"};
constexpr std::uint64_t kChains = 8;
constexpr unsigned kLeastFraction = 16, kMostFraction = 26;

const std::vector<std::string>& policy_keys(Profile profile) {
  static const std::vector<std::string> paper = {
      "own_id_rule", "vertex_rule", "table7", "depth_writes", "hidden_removal", "match_polygon_id"};
  static const std::vector<std::string> winding = {"semantics",       "skip_receiver_mask",
                                                   "skip_first_test", "skip_tiles",
                                                   "skip_edges",      "skip_fragments"};
  return profile == Profile::kPaper ? paper : winding;
}

std::string direction(const LineRecord& line) {
  return fmt::format("{}{}", line.x_major ? 'x' : 'y', line.x_positive ? '+' : '-');
}

/// The texels that fragments ask, a flag each.
class Asked {
 public:
  explicit Asked(const Frame& frame)
      : width_(frame.config.map_width),
        height_(frame.config.map_height),
        f_(frame.setup.fraction_bits),
        texels_(static_cast<std::size_t>(width_ * height_)) {
    for (const Fragment& fragment : frame.trace.all_fragments) {
      std::size_t at = 0;
      if (texel_of(fragment, at)) texels_[at] = 1;
    }
  }
  /// False: its verdict needs no texel.
  bool texel_of(const Fragment& fragment, std::size_t& at) const {
    if ((fragment.flags & (Fragment::kAverted | Fragment::kOutside)) != 0) return false;
    const std::int64_t x = place(fragment.position.x, width_);
    const std::int64_t y = place(fragment.position.y, height_);
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return false;
    at = static_cast<std::size_t>(y * width_ + x);
    return true;
  }
  bool at(std::uint32_t x, std::uint32_t y) const {
    return texels_[static_cast<std::size_t>(y * width_ + x)] != 0;
  }

 private:
  std::int64_t place(std::int64_t units, std::int64_t side) const {
    return (units >> f_) + side / 2;
  }
  std::int64_t width_, height_;
  std::uint32_t f_;
  std::vector<std::uint8_t> texels_;
};

}  // namespace

Bins::Bins(Profile profile) : profile_(profile) {
  declare("pass 1 cause",
          {"edge", "span", "other", "input", "setup", "walk", "texel", "record", "chain", "write"});
  declare("pass 2 cause", {"fragment", "input", "texel", "texel_port", "slb", "slb_port",
                           "decision", "verdict", "drain"});
  declare("verdict", {"dark by definition", "dark by buffer", "dark by lines", "lit by outside",
                      "lit by nothing"});
  declare("counter", {"lines_stored", "lines_cancelled", "lines_hidden", "emptied_covered",
                      "overflow_lines", "overflow_texels", "span_texels", "slb_lookups",
                      "entries_read", "lines_read", "averted", "outside"});
  declare("overflow", {"by records", "by chain"});
  for (std::uint64_t n = 1; n <= kChains; ++n) declare("chain", {fmt::format("{} records", n)});
  declare("chain", {"the limit"});
  for (const std::string& key : policy_keys(profile)) {
    for (const ConfigField& field : config_fields()) {
      if (field.key != key) continue;
      for (const std::string& choice : field.choices) {
        declare("policy", {fmt::format("{} = {}", key, choice)});
      }
    }
  }
  for (unsigned f = kLeastFraction; f <= kMostFraction; ++f) {
    declare("fraction bits", {std::to_string(f)});
  }
  declare("cut short", {"by abort", "by reset"});
  if (profile == Profile::kPaper) {
    declare_paper();
  } else {
    declare_winding();
  }
}

void Bins::declare_paper() {
  declare("counter", {"collisions"});
  const char* directions[] = {"x+", "x-", "y+", "y-"};
  for (const char* d : directions) {
    for (const char* cross : {"near", "far"})
      declare("tables 2, 3, 5", {fmt::format("{} {}", d, cross)});
    for (const char* left : {"left", "right"}) declare("table 6", {fmt::format("{} {}", d, left)});
    for (const char* other : directions) {
      for (const char* exp1 : {"equal", "unequal"}) {
        declare("table 7", {fmt::format("A {}, B {}, Exp1 {}", d, other, exp1)});
      }
    }
  }
  declare("ends", {"none", "start", "end", "both"});
  declare("table 4",
          {"buffer of the own ID", "buffer nearer", "buffer not nearer", "entry of the own ID",
           "entry nearer", "entry not nearer", "overflowed texel"});
}

void Bins::declare_winding() {
  declare("verdict", {"dark by tile", "lit by tile"});
  declare("skip", {"masked_visits", "hidden_visits", "inner_edge_texels", "known_fragments",
                   "tile_lit", "tile_dark", "first_test_dark"});
  declare("cluster",
          {"full", "corner count 0", "corner count above 0", "gradient x 0", "gradient x above 0",
           "gradient x below 0", "gradient y 0", "gradient y above 0", "gradient y below 0",
           "0 segments", "1 segment", "2 segments", "3 segments and more"});
  declare("segment",
          {"positive", "negative", "crosses the left border", "does not cross", "rising", "falling",
           "level", "upright", "end on the left border", "end on the right border",
           "end on the lower border", "end on the upper border"});
}

void Bins::declare(const std::string& group, const std::vector<std::string>& names) {
  for (const std::string& name : names) bins_.push_back({group, name});
}

void Bins::hit(const std::string& group, const std::string& name, std::uint64_t count) {
  if (count == 0) return;
  for (Bin& bin : bins_) {
    if (bin.group != group || bin.name != name) continue;
    bin.count += count;
    return;
  }
  if (group != "chain") throw std::logic_error("no bin " + group + ": " + name);
}

void Bins::add(const Frame& frame, const Expected& expected, const CycleReport& cycles,
               const bench::Events& events) {
  add_cycles(cycles);
  add_events(events);
  add_counters(frame, expected.counters);
  add_policies(frame.config);
  hit("fraction bits", std::to_string(frame.setup.fraction_bits));
  if (profile_ == Profile::kPaper) {
    add_lines(frame, expected.contents);
    add_sources(frame, expected.contents);
  } else {
    add_clusters(frame, expected.contents);
  }
}

void Bins::add_cut(bench::Bench::Cut how) {
  hit("cut short", how == bench::Bench::Cut::kAbort ? "by abort" : "by reset");
}

void Bins::add_cycles(const CycleReport& cycles) {
  for (const auto& [cause, count] : cycles.pass1->causes) hit("pass 1 cause", cause, count);
  for (const auto& [cause, count] : cycles.pass2->causes) hit("pass 2 cause", cause, count);
}

void Bins::add_events(const bench::Events& events) {
  for (unsigned dark = 0; dark < 2; ++dark) {
    for (unsigned by = 0; by < 8; ++by) {
      hit("verdict",
          fmt::format("{} by {}", dark ? "dark" : "lit", by < 6 ? kBy[by] : std::to_string(by)),
          events.verdicts[dark][by]);
    }
  }
}

void Bins::add_counters(const Frame& frame, const UnitCounters& c) {
  const std::pair<const char*, std::uint64_t> counters[] = {{"lines_stored", c.lines_stored},
                                                            {"lines_cancelled", c.lines_cancelled},
                                                            {"lines_hidden", c.lines_hidden},
                                                            {"emptied_covered", c.emptied_covered},
                                                            {"overflow_lines", c.overflow_lines},
                                                            {"overflow_texels", c.overflow_texels},
                                                            {"span_texels", c.span_texels},
                                                            {"slb_lookups", c.slb_lookups},
                                                            {"entries_read", c.entries_read},
                                                            {"lines_read", c.lines_read},
                                                            {"averted", c.averted},
                                                            {"outside", c.outside}};
  for (const auto& [name, count] : counters) hit("counter", name, count);
  for (std::size_t n = 1; n < c.chain_histogram.size(); ++n) {
    hit("chain", fmt::format("{} records", n), c.chain_histogram[n]);
  }
  const bool paper = profile_ == Profile::kPaper;
  const auto records =
      static_cast<std::uint64_t>(paper ? frame.config.slb_entries : frame.config.cluster_records);
  const auto chain =
      static_cast<std::uint64_t>(paper ? frame.config.link_depth : frame.config.chain_records);
  if (chain > 1 && c.max_chain == chain) hit("chain", "the limit");
  if (c.overflow_lines > 0 && c.peak_entries < records) hit("overflow", "by chain");
  if (c.overflow_lines > 0 && c.max_chain < chain && c.peak_entries >= records) {
    hit("overflow", "by records");
  }
  if (paper) {
    hit("counter", "collisions", c.collisions);
    return;
  }
  const SkipCounters& s = c.skips;
  const std::pair<const char*, std::uint64_t> skips[] = {{"masked_visits", s.masked_visits},
                                                         {"hidden_visits", s.hidden_visits},
                                                         {"inner_edge_texels", s.inner_edge_texels},
                                                         {"known_fragments", s.known_fragments},
                                                         {"tile_lit", s.tile_lit},
                                                         {"tile_dark", s.tile_dark},
                                                         {"first_test_dark", s.first_test_dark}};
  for (const auto& [name, count] : skips) hit("skip", name, count);
}

void Bins::add_policies(const UnitConfig& config) {
  for (const std::string& key : policy_keys(profile_)) {
    hit("policy", fmt::format("{} = {}", key, get_field(config, key)));
  }
}

/// Rows of Tables 2, 3 and 5 to 7, by the lines of texels that fragments ask.
void Bins::add_lines(const Frame& frame, const MapContents& contents) {
  const Asked asked(frame);
  const auto has_end = [](const LineRecord& line) { return line.start_here || line.end_here; };
  for (const TexelEntry& entry : contents.entries) {
    if (!asked.at(entry.texel_x, entry.texel_y)) continue;
    for (const LineRecord& a : entry.lines) {
      hit("tables 2, 3, 5", direction(a) + (a.cross ? " far" : " near"));
      hit("table 6", direction(a) + (a.left ? " left" : " right"));
      hit("ends", a.start_here ? (a.end_here ? "both" : "start") : a.end_here ? "end" : "none");
      for (const LineRecord& b : entry.lines) {
        if (&a == &b || !has_end(a) || !has_end(b)) continue;
        hit("table 7", fmt::format("A {}, B {}, Exp1 {}", direction(a), direction(b),
                                   b.left == a.end_here ? "equal" : "unequal"));
      }
    }
  }
}

/// Rows of Table 4: what fragments meet in their texels.
void Bins::add_sources(const Frame& frame, const MapContents& contents) {
  const Asked asked(frame);
  std::vector<std::vector<const TexelEntry*>> entries(contents.depth.size());
  for (const TexelEntry& entry : contents.entries) {
    entries[entry.texel_y * contents.width + entry.texel_x].push_back(&entry);
  }
  const auto shift = static_cast<unsigned>(24 - frame.config.depth_bits);
  for (const Fragment& fragment : frame.trace.all_fragments) {
    std::size_t at = 0;
    if (!asked.texel_of(fragment, at)) continue;
    const std::vector<std::uint32_t>& ids = frame.setup.unit_ids;
    const std::uint32_t own = fragment.object < ids.size() ? ids[fragment.object] : fragment.object;
    const std::uint32_t z = fragment.position.z >> shift;
    const auto meet = [&](const std::string& source, std::uint32_t object, std::uint32_t depth) {
      hit("table 4", source + (object == own ? " of the own ID"
                               : depth < z   ? " nearer"
                                             : " not nearer"));
    };
    if (contents.object[at] != kNoObject) meet("buffer", contents.object[at], contents.depth[at]);
    for (const TexelEntry* entry : entries[at]) meet("entry", entry->object, entry->nearest);
    if (contents.overflowed[at] != 0) hit("table 4", "overflowed texel");
  }
}

void Bins::add_clusters(const Frame& frame, const MapContents& contents) {
  const Asked asked(frame);
  const auto code_bits = static_cast<unsigned>(frame.config.gradient_bits + 5);
  const auto sign = [&](const char* axis, std::uint32_t code) {
    const bool zero = (code & ((1u << code_bits) - 1)) == 0;
    hit("cluster", fmt::format("gradient {} {}", axis,
                               zero                  ? "0"
                               : (code >> code_bits) ? "below 0"
                                                     : "above 0"));
  };
  const std::uint32_t one =
      1u << std::min<std::int64_t>(frame.config.fraction_bits + frame.config.end_guard_bits,
                                   frame.setup.fraction_bits);
  for (const TexelCluster& cluster : contents.clusters) {
    if (!asked.at(cluster.texel_x, cluster.texel_y)) continue;
    sign("x", cluster.gradient_x);
    sign("y", cluster.gradient_y);
    if (cluster.full) {
      hit("cluster", "full");
      continue;
    }
    hit("cluster", cluster.corner == 0 ? "corner count 0" : "corner count above 0");
    const std::size_t n = cluster.segments.size();
    hit("cluster", n == 1   ? "1 segment"
                   : n >= 3 ? "3 segments and more"
                            : fmt::format("{} segments", n));
    for (const SegmentRecord& s : cluster.segments) {
      hit("segment", s.positive ? "positive" : "negative");
      hit("segment", s.crosses_left ? "crosses the left border" : "does not cross");
      const bool level = s.y0 == s.y1, upright = s.x0 == s.x1;
      hit("segment", level                            ? "level"
                     : upright                        ? "upright"
                     : (s.x0 < s.x1) == (s.y0 < s.y1) ? "rising"
                                                      : "falling");
      if (s.x0 == 0 || s.x1 == 0) hit("segment", "end on the left border");
      if (s.x0 == one || s.x1 == one) hit("segment", "end on the right border");
      if (s.y0 == 0 || s.y1 == 0) hit("segment", "end on the lower border");
      if (s.y0 == one || s.y1 == one) hit("segment", "end on the upper border");
    }
  }
}

}  // namespace kagesen
