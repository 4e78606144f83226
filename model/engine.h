#pragma once
/// What golden, SystemC and RTL have in common: a configuration and a trace in, verdicts, buffers
/// and counters out.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/cycle_report.h"
#include "model/fragment_cycles.h"
#include "model/unit/config.h"
#include "traces/format/records.h"

namespace kagesen {

enum class Verdict : std::uint8_t { kLit = 0, kDark = 1 };

/// What a mesh's adjacency tells of one caster (winding profile; see facets.h).
struct Facet {
  static constexpr std::uint32_t kOwnPlane = 0xffffffffu;
  std::uint32_t plane = kOwnPlane;  ///< index into FrameSetup::planes: the plane it shares
  std::uint8_t inner_edges = 0;     ///< bit i: edge i to i + 1 is shared with a facet of that plane
};

/// Light space as the unit's registers see it.
struct FrameSetup {
  std::uint32_t fraction_bits = kMinFractionBits;  ///< units a texel = 2^fraction_bits
  /// The ID under which the unit knows each object (see unit_ids.h); empty: its number.
  std::vector<std::uint32_t> unit_ids;
  std::vector<Facet> facets;   ///< a caster each, in the order they are drawn; empty: nothing known
  std::vector<Caster> planes;  ///< triangles whose plane several facets share
  std::vector<std::uint8_t> unshadowable;  ///< an object each: 1 if nothing can shadow it; or empty
};

/// A silhouette line as stored. fraction, slope: UQ0.n, saturated.
struct LineRecord {
  std::uint32_t fraction = 0, slope = 0, polygon = 0;
  bool left = false;  ///< 1: the polygon lies to the right of the direction of travel
  bool cross =
      false;  ///< 0: Fraction at the texel's near side along the major axis, 1: at the far side
  bool x_major = false;
  bool x_positive = false;
  bool start_here = false, end_here = false;  ///< lower, upper end lies in this texel
};

/// What one texel holds of one object.
struct TexelEntry {
  std::uint32_t texel_x = 0, texel_y = 0, object = 0;
  std::uint32_t nearest = 0;  ///< depth
  bool vertex = false;        ///< some line since the entry was last empty had an end here
  std::vector<LineRecord> lines;
};

/// A piece of a facet's outline in one texel (winding profile). Ends: UQ1.n texel,
/// n = fraction_bits + end_guard_bits (no more than the trace has), 0 to 1 inclusive.
struct SegmentRecord {
  std::uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool positive = false;      ///< counts +1 to what lies right of it, if crossing: above it
  bool crosses_left = false;  ///< its first end is where it crosses the texel's left border
};

/// The facets of one plane in one texel (winding profile).
struct TexelCluster {
  std::uint32_t texel_x = 0, texel_y = 0, object = 0;  ///< object: paper semantics alone
  std::int32_t base = 0;  ///< threshold at the texel's centre, units of 2^plane_step_bits, modular
  std::uint32_t gradient_x = 0, gradient_y = 0;  ///< codes: sign, 5 exponent bits, mantissa
  std::uint32_t corner = 0;
  bool full = false;  ///< wholly covers the texel: no corner count, no segments
  std::vector<SegmentRecord> segments;
};

/// Final contents of the buffers. Images are row-major, map_width x map_height.
struct MapContents {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint32_t>
      depth;  ///< kDepthMax's depth_bits equivalent where nothing was written
  std::vector<std::uint32_t> object;     ///< kNoObject where nothing was written
  std::vector<std::uint8_t> overflowed;  ///< 1: capacity ran out here; the plain-map verdict holds
  std::vector<TexelEntry> entries;       ///< by texel (row, column), from the light outwards
  std::vector<TexelCluster> clusters;    ///< winding: by texel, then by their fields
};
inline constexpr std::uint32_t kNoObject = 0xffffffffu;

/// What the winding profile's skips saved, and out of how much.
struct SkipCounters {
  std::uint64_t texel_visits = 0;             ///< pass 1: facets times texels they touch
  std::uint64_t masked_visits = 0;            ///< of these: no fragment there, or none far enough
  std::uint64_t hidden_visits = 0;            ///< of these: behind what covers the texel
  std::uint64_t inner_edge_texels = 0;        ///< edge texels not walked, beside edge_texels
  std::uint64_t cleared_texels = 0;           ///< of the whole map
  std::uint64_t known_fragments = 0;          ///< averted, outside the map, or unshadowable
  std::uint64_t tile_lit = 0, tile_dark = 0;  ///< fragments decided by their tile
  std::uint64_t texel_lookups = 0;            ///< fragments that read a texel
  std::uint64_t first_test_dark = 0;  ///< of those with clusters: decided without reading them
};

/// Counters mean the same in every engine.
struct UnitCounters {
  // pass 1
  std::uint64_t casters = 0, edges = 0, edge_texels = 0, span_texels = 0;
  std::uint64_t lines_stored = 0, lines_cancelled = 0, lines_hidden = 0, emptied_covered = 0;
  // SLB at the end of pass 1
  std::uint64_t slb_texels = 0, slb_entries = 0, slb_lines = 0;
  std::uint64_t peak_entries = 0;  ///< records in use at once, continuation records included
  std::uint64_t collisions = 0;    ///< texels whose bucket another texel holds too
  std::uint64_t overflow_lines = 0, overflow_texels = 0;
  std::uint64_t payload_bytes = 0;    ///< entries and lines alone (docs/unit.md)
  std::uint64_t allocated_bytes = 0;  ///< peak records with tags and links, and the bucket table
  std::uint64_t map_bytes = 0;        ///< shadow, ID and edge buffers
  std::uint64_t max_chain = 0;        ///< records walked in the longest texel
  std::vector<std::uint64_t> chain_histogram;  ///< [n]: texels with n records; [0] is 0
  // pass 2
  std::uint64_t fragments = 0, averted = 0, outside = 0;
  std::uint64_t dark_by_buffer = 0, dark_by_lines = 0, lit = 0;
  std::uint64_t slb_lookups = 0, entries_read = 0, lines_read = 0;
  std::uint64_t aliased_objects =
      0;  ///< objects that share a unit ID with another one they may shadow
  // Winding profile. Its segments count as lines, its clusters as entries.
  SkipCounters skips;
};

class Engine {
 public:
  virtual ~Engine() = default;
  virtual std::string name() const = 0;
  /// Clears everything and takes the frame's parameters.
  virtual void begin(const UnitConfig& config, const FrameSetup& setup) = 0;
  /// Fragments that pass 2 will decide, before pass 1; any number of calls. With the receiver mask
  /// every fragment must be announced; without it, and in the paper profile, nothing happens.
  virtual void announce(const Fragment* fragments, std::size_t count) = 0;
  /// Pass 1; any number of calls.
  virtual void draw(const Caster* casters, std::size_t count) = 0;
  /// Pass 2; any number of calls, after the last draw.
  virtual void decide(const Fragment* fragments, std::size_t count, Verdict* verdicts) = 0;
  virtual MapContents contents() const = 0;
  virtual UnitCounters counters() const = 0;
  /// Of the frame so far; nothing where there is no clock.
  virtual std::optional<CycleReport> cycles() const { return std::nullopt; }
  /// Of each fragment since begin(), pass 2's first cycle being 0; empty where they are not kept.
  virtual const std::vector<FragmentCycles>& fragment_cycles() const {
    static const std::vector<FragmentCycles> none;
    return none;
  }
};

std::unique_ptr<Engine> make_golden_engine();

}  // namespace kagesen
