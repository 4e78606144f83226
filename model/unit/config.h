#pragma once
/// The one configuration of the shadow unit: every width, capacity and policy, once.
#include <cstdint>
#include <string>
#include <vector>

namespace kagesen {

/// How the unit combines sources when an ID equals the fragment's (Table 4, row 1).
enum class OwnIdRule : std::uint8_t {
  kPerSource,  ///< the source of that ID is passed over
  kLiteral,    ///< as printed: ID buffer equal to the fragment's object decides "lit" at once
};
/// What tells that two lines of an entry meet in a vertex.
enum class VertexRule : std::uint8_t {
  kPerLine,   ///< start-here and end-here of each line
  kPerEntry,  ///< as printed: one Vertex Flag an entry, one End Flag a line
};
enum class Table7 : std::uint8_t {
  kCorrected,  ///< ordered by angle, symmetric in A and B
  kPrinted,    ///< as printed, with its last row and its gaps
};
/// Which texels get a depth and an ID in pass 1.
enum class DepthWrites : std::uint8_t {
  kCovered,  ///< wholly covered ones: span interior and emptied entries
  kAll,      ///< outline texels too
};

/// When a nearer polygon that covers a texel removes lines (3.3.3).
enum class HiddenRemoval : std::uint8_t {
  kOff,
  kCentre,    ///< its depth at the texel's centre is nearer than the lines; later lines are refused
              ///< alike
  kFarthest,  ///< its farthest depth in the texel is; refuses nothing
};

/// Which unit: the published one, or the one that is exact within its quantisation.
enum class Profile : std::uint8_t {
  kPaper,    ///< lines, AND/OR, Tables 5 to 7
  kWinding,  ///< segments and winding numbers (docs/unit.md)
};

/// Who may shadow a fragment.
enum class Semantics : std::uint8_t {
  kPaper,     ///< any object but the fragment's own
  kPhysical,  ///< any surface strictly nearer the light
};

/// Defaults are the unit that docs/results.md measures. Limits and help texts: config_fields().
struct UnitConfig {
  Profile profile = Profile::kPaper;
  std::int64_t map_width = 1024, map_height = 1024;  // texels
  std::int64_t fraction_bits = 8;                    // UQ0.n of Fraction
  std::int64_t slope_bits = 8;                       // UQ0.n of Slope
  std::int64_t depth_bits = 24;                      // of the shadow buffer and the SLB
  std::int64_t id_bits = 16;                         // object ID
  std::int64_t polygon_id_bits = 14;                 // Polygon ID of a line
  std::int64_t position_bits = 0;                    // of Mx and My; 0: all the trace has
  std::int64_t lines_per_entry = 3;
  std::int64_t link_depth = 1024;     // linked records a texel may hold
  std::int64_t slb_buckets = 65536;   // of the address hash, a power of two
  std::int64_t slb_entries = 262144;  // capacity of the SLB
  OwnIdRule own_id_rule = OwnIdRule::kPerSource;
  VertexRule vertex_rule = VertexRule::kPerLine;
  Table7 table7 = Table7::kCorrected;
  DepthWrites depth_writes = DepthWrites::kCovered;
  HiddenRemoval hidden_removal = HiddenRemoval::kCentre;
  bool match_polygon_id = true;  // lines of one polygon never cancel each other

  // Winding profile alone.
  Semantics semantics = Semantics::kPhysical;
  std::int64_t end_guard_bits = 3;    // of a segment's ends, beyond fraction_bits
  std::int64_t gradient_bits = 7;     // mantissa of a plane's gradient
  std::int64_t plane_step_bits = 4;   // log2 of the depth step of stored planes
  std::int64_t plane_tolerance = 16;  // depth units within which facets share a plane
  std::int64_t corner_bits = 8;       // of a cluster's corner count
  std::int64_t segments_per_record = 2;
  std::int64_t cluster_records = 1 << 22;  // capacity of the SLB
  std::int64_t chain_records = 1 << 20;    // of one texel's list
  bool skip_receiver_mask = true;
  bool skip_first_test = true;
  bool skip_tiles = true;
  bool skip_edges = true;
  bool skip_fragments = true;

  // RTL and SystemC: what is built, and the memories behind it. Verdicts do not depend on them.
  std::int64_t lanes = 1;              // of pass 2
  std::int64_t fragment_slots = 128;    // fragments in flight a lane
  std::int64_t visit_fifo_depth = 32;  // visits ahead of the store
  std::int64_t texel_lines = 64;       // texel words kept on chip in pass 1
  std::int64_t record_lines = 128;      // SLB records kept on chip in pass 1
  std::int64_t memory_latency = 20;    // cycles from a request to its response
  std::int64_t memory_spread = 0;      // up to so many more, at random
  std::int64_t memory_stall = 0;       // per cent of the cycles in which a port takes nothing
  std::int64_t memory_interval = 1;    // cycles from a port's request to its next
  std::int64_t memory_outstanding = 0; // reads a port has under way at most; 0: any number
  std::int64_t memory_banks = 1;       // behind a port
  std::int64_t memory_bank_busy = 1;   // cycles from a bank's read to its next
  std::int64_t memory_row_words = 0;   // words of a bank's row; 0: no rows
  std::int64_t memory_row_miss = 0;    // more cycles where another row is open
  std::int64_t texel_cache_lines = 0;  // of a cache behind each texel port; 0: none
  std::int64_t texel_cache_ways = 2;
  std::int64_t texel_cache_line_words = 4;
  std::int64_t slb_cache_lines = 0;  // of a cache behind each SLB port; 0: none
  std::int64_t slb_cache_ways = 2;
  std::int64_t slb_cache_line_words = 1;
  std::int64_t cache_latency = 2;      // cycles from a request to the response of what is there
  std::int64_t memory_seed = 1;        // of what is random
};

/// One field of UnitConfig as text: what a configuration file, `--set` and the help need.
struct ConfigField {
  std::string key;
  std::string help;                       ///< one line, unit and source
  std::int64_t minimum = 0, maximum = 0;  ///< of an integer
  bool power_of_two = false;
  std::vector<std::string> choices;  ///< of an enumeration or a boolean; empty for an integer
};
/// Every field, in the order of the struct.
const std::vector<ConfigField>& config_fields();
/// The value as it stands in a configuration file: an integer, a choice, or true/false.
std::string get_field(const UnitConfig& config, const std::string& key);
/// Sets a field from text. Throws UserError, naming the nearest key or the nearest valid value.
void set_field(UnitConfig& config, const std::string& key, const std::string& value);
/// Throws UserError where fields that are each in range do not fit together.
void check_fields(const UnitConfig& config);

}  // namespace kagesen
