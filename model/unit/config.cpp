#include "model/unit/config.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "traces/format/error.h"
#include "traces/format/records.h"

namespace kagesen {
namespace {

/// A field and how to reach it.
struct Binding {
  ConfigField field;
  std::function<std::string(const UnitConfig&)> get;
  std::function<void(UnitConfig&, std::int64_t)> set;  // an integer, or the index of a choice
};

Binding integer(const char* key, std::int64_t UnitConfig::*member, std::int64_t minimum,
                std::int64_t maximum, const char* help, bool power_of_two = false) {
  return {{key, help, minimum, maximum, power_of_two, {}},
          [=](const UnitConfig& c) { return std::to_string(c.*member); },
          [=](UnitConfig& c, std::int64_t value) { c.*member = value; }};
}

template <typename Enum>
Binding choice(const char* key, Enum UnitConfig::*member, std::vector<std::string> names,
               const char* help) {
  return {{key, help, 0, static_cast<std::int64_t>(names.size()) - 1, false, names},
          [=](const UnitConfig& c) { return names[static_cast<std::size_t>(c.*member)]; },
          [=](UnitConfig& c, std::int64_t value) { c.*member = static_cast<Enum>(value); }};
}

const std::vector<Binding>& bindings() {
  using C = UnitConfig;
  static const std::vector<Binding> all = {
      choice("profile", &C::profile, {"paper", "winding"},
             "The published unit, or the one that is exact within its quantisation"),
      integer("map_width", &C::map_width, 1, kMaxMapSide, "Width of the map, texels"),
      integer("map_height", &C::map_height, 1, kMaxMapSide, "Height of the map, texels"),
      integer("fraction_bits", &C::fraction_bits, 1, 15,
              "Bits of a line's Fraction, UQ0.n texel (3.1); winding: exact beyond 2^-n texel, 12 "
              "at most"),
      integer("slope_bits", &C::slope_bits, 1, 15, "Bits of a line's Slope, UQ0.n (3.1)"),
      integer("depth_bits", &C::depth_bits, 8, kDepthBits, "Bits of a stored depth"),
      integer("id_bits", &C::id_bits, 1, 24, "Bits of an object ID (3.2: 8 or more)"),
      integer("polygon_id_bits", &C::polygon_id_bits, 1, 24,
              "Bits of a line's Polygon ID; wraps (3.1)"),
      integer("position_bits", &C::position_bits, 0, kMaxFractionBits,
              "Bits of Mx and My in the decision; 0: all that the trace has (4.2)"),
      integer("lines_per_entry", &C::lines_per_entry, 1, 15, "Lines an SLB record holds (3.2)"),
      integer("link_depth", &C::link_depth, 1, 4096, "Linked SLB records a texel may hold"),
      integer("slb_buckets", &C::slb_buckets, 1, 1 << 22, "Buckets of the address hash", true),
      integer("slb_entries", &C::slb_entries, 1, 1 << 24, "Records the SLB has room for"),
      choice("own_id_rule", &C::own_id_rule, {"per_source", "literal"},
             "Table 4, row 1: pass over the source of the fragment's ID, or as printed"),
      choice("vertex_rule", &C::vertex_rule, {"per_line", "per_entry"},
             "What tells that lines meet in a vertex: flags of each line, or one of the entry as "
             "printed"),
      choice("table7", &C::table7, {"corrected", "printed"},
             "Table 7: ordered by angle, or as printed with its gaps"),
      choice("depth_writes", &C::depth_writes, {"covered", "all"},
             "Texels that get a depth and an ID: wholly covered ones, or outline texels too"),
      choice("hidden_removal", &C::hidden_removal, {"off", "centre", "farthest"},
             "Remove lines behind a covering polygon, by its depth at the texel's centre or its "
             "farthest (3.3.3)"),
      choice("match_polygon_id", &C::match_polygon_id, {"false", "true"},
             "Lines of one polygon never cancel each other (3.3.2)"),
      choice("semantics", &C::semantics, {"paper", "physical"},
             "Winding: who shadows, any object but the fragment's own or any surface nearer the "
             "light"),
      integer("end_guard_bits", &C::end_guard_bits, 2, 4,
              "Winding: bits of a segment's ends beyond fraction_bits"),
      integer("gradient_bits", &C::gradient_bits, 3, 10,
              "Winding: mantissa bits of a plane's gradient; never less than fraction_bits - 1"),
      integer("plane_step_bits", &C::plane_step_bits, 0, 12,
              "Winding: log2 of the depth step of a stored plane"),
      integer("plane_tolerance", &C::plane_tolerance, 0, 1 << 16,
              "Winding: depth units within which neighbouring facets share a plane"),
      integer("corner_bits", &C::corner_bits, 2, 16, "Winding: bits of a cluster's corner count"),
      integer("segments_per_record", &C::segments_per_record, 1, 15,
              "Winding: segments an SLB record holds"),
      integer("cluster_records", &C::cluster_records, 1, 1 << 24,
              "Winding: records the SLB has room for"),
      integer("chain_records", &C::chain_records, 1, 1 << 20,
              "Winding: records a texel's list may hold"),
      choice("skip_receiver_mask", &C::skip_receiver_mask, {"false", "true"},
             "Winding: store nothing that no fragment can see"),
      choice("skip_first_test", &C::skip_first_test, {"false", "true"},
             "Winding: decide by what covers the texel before its clusters are read"),
      choice("skip_tiles", &C::skip_tiles, {"false", "true"},
             "Winding: decide by the 8 x 8 tile before its texels are read"),
      choice("skip_edges", &C::skip_edges, {"false", "true"},
             "Winding: do not walk edges inside a plane that several facets share"),
      choice("skip_fragments", &C::skip_fragments, {"false", "true"},
             "Winding: look nothing up for fragments whose verdict is known"),
      integer("lanes", &C::lanes, 1, 4, "RTL: lanes of pass 2, a fragment a cycle each"),
      integer("fragment_slots", &C::fragment_slots, 1, 128, "RTL: fragments in flight a lane",
              true),
      integer("visit_fifo_depth", &C::visit_fifo_depth, 1, 256,
              "RTL: visits that wait for the store, whose memory is fetched ahead", true),
      integer("texel_lines", &C::texel_lines, 8, 128, "RTL: texel words that pass 1 keeps on chip",
              true),
      integer("record_lines", &C::record_lines, 8, 128,
              "RTL: SLB records that pass 1 keeps on chip", true),
      integer("memory_latency", &C::memory_latency, 1, 1000,
              "Memory: cycles from a request to its response"),
      integer("memory_spread", &C::memory_spread, 0, 1000,
              "Memory: up to so many cycles more, at random"),
      integer("memory_stall", &C::memory_stall, 0, 99,
              "Memory: per cent of the cycles in which a port takes no request"),
      integer("memory_interval", &C::memory_interval, 1, 64,
              "Memory: cycles from one request of a read port to its next, at least"),
      integer("memory_outstanding", &C::memory_outstanding, 0, 256,
              "Memory: reads that a port has under way at most; 0: any number"),
      integer("memory_banks", &C::memory_banks, 1, 256,
              "Memory: banks behind a port; rows go to them in turn", true),
      integer("memory_bank_busy", &C::memory_bank_busy, 1, 16,
              "Memory: cycles from one read of a bank to its next, at least"),
      integer("memory_row_words", &C::memory_row_words, 0, 1 << 16,
              "Memory: words of a bank's row; 0: no rows"),
      integer("memory_row_miss", &C::memory_row_miss, 0, 32,
              "Memory: cycles more where another row of the bank is open"),
      integer("texel_cache_lines", &C::texel_cache_lines, 0, 1 << 16,
              "Memory: lines of a cache behind each texel port; 0: none"),
      integer("texel_cache_ways", &C::texel_cache_ways, 1, 16, "Memory: its ways"),
      integer("texel_cache_line_words", &C::texel_cache_line_words, 1, 64,
              "Memory: words of its line, which come one after the other"),
      integer("slb_cache_lines", &C::slb_cache_lines, 0, 1 << 16,
              "Memory: lines of a cache behind each SLB port; 0: none"),
      integer("slb_cache_ways", &C::slb_cache_ways, 1, 16, "Memory: its ways"),
      integer("slb_cache_line_words", &C::slb_cache_line_words, 1, 64,
              "Memory: records of its line, which come one after the other"),
      integer("cache_latency", &C::cache_latency, 1, 64,
              "Memory: cycles from a request to the response of a word that a cache has"),
      integer("memory_seed", &C::memory_seed, 0, 1 << 30, "Memory: seed of what is random"),
  };
  return all;
}

/// Levenshtein distance.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])});
      diagonal = above;
    }
  }
  return row.back();
}

template <typename Range, typename Name>
std::string nearest(const Range& range, const std::string& wanted, Name name) {
  return name(*std::min_element(range.begin(), range.end(), [&](const auto& a, const auto& b) {
    return distance(name(a), wanted) < distance(name(b), wanted);
  }));
}

const Binding& find(const std::string& key) {
  for (const Binding& b : bindings()) {
    if (b.field.key == key) return b;
  }
  throw UserError(key, "no such configuration key",
                  "the nearest is '" +
                      nearest(bindings(), key, [](const Binding& b) { return b.field.key; }) + "'");
}

std::int64_t parse_integer(const ConfigField& field, const std::string& text) {
  std::int64_t value = 0;
  std::size_t used = 0;
  try {
    value = std::stoll(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used == 0 || used != text.size()) {
    throw UserError(
        field.key, "'" + text + "' is not an integer",
        "give one from " + std::to_string(field.minimum) + " to " + std::to_string(field.maximum));
  }
  std::int64_t valid = std::clamp(value, field.minimum, field.maximum);
  if (field.power_of_two) {
    std::int64_t power = field.minimum;
    while (power * 2 <= valid) power *= 2;
    if (power * 2 <= field.maximum && power * 2 - valid < valid - power) power *= 2;
    valid = power;
  }
  if (valid != value) {
    throw UserError(field.key, "'" + text + "' is out of range",
                    "the nearest valid value is " + std::to_string(valid));
  }
  return value;
}

}  // namespace

const std::vector<ConfigField>& config_fields() {
  static const std::vector<ConfigField> fields = [] {
    std::vector<ConfigField> out;
    for (const Binding& b : bindings()) out.push_back(b.field);
    return out;
  }();
  return fields;
}

std::string get_field(const UnitConfig& config, const std::string& key) {
  return find(key).get(config);
}

void set_field(UnitConfig& config, const std::string& key, const std::string& value) {
  const Binding& binding = find(key);
  const std::vector<std::string>& choices = binding.field.choices;
  if (choices.empty()) {
    binding.set(config, parse_integer(binding.field, value));
    return;
  }
  const auto it = std::find(choices.begin(), choices.end(), value);
  if (it == choices.end()) {
    throw UserError(
        key, "'" + value + "' is not a choice",
        "the nearest is '" + nearest(choices, value, [](const std::string& s) { return s; }) + "'");
  }
  binding.set(config, it - choices.begin());
}

void check_fields(const UnitConfig& config) {
  // Steeper planes than 12 bits of radius leave would leave the range that thresholds are kept in.
  if (config.profile == Profile::kWinding && config.fraction_bits > 12) {
    throw UserError("fraction_bits",
                    std::to_string(config.fraction_bits) + " are too many for the winding profile",
                    "the nearest valid value is 12");
  }
}

}  // namespace kagesen
