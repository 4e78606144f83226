#pragma once
/// Clock cycles of a frame, and what the unit did in them. docs/counters.md says what each figure means.
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace kagesen {

/// How full a queue was in a pass.
struct QueueCycles {
  std::string name;                   ///< its instance in the Verilog, from the unit
  std::vector<std::uint64_t> cycles;  ///< [n]: cycles in which n words stood in it

  std::uint64_t most() const { return cycles.empty() ? 0 : cycles.size() - 1; }
  double mean() const {
    double words = 0, all = 0;
    for (std::size_t n = 0; n < cycles.size(); ++n) {
      words += double(n) * double(cycles[n]);
      all += double(cycles[n]);
    }
    return all > 0 ? words / all : 0;
  }
  bool operator==(const QueueCycles& o) const { return name == o.name && cycles == o.cycles; }
};

/// Words of a memory that are kept nearer by.
struct CacheCounts {
  std::string name;
  std::uint64_t lookups = 0;  ///< words that were asked for
  std::uint64_t misses = 0;   ///< words, or lines, that were fetched

  double hit_rate() const { return lookups ? 1 - double(misses) / double(lookups) : 0; }
  bool operator==(const CacheCounts& o) const {
    return name == o.name && lookups == o.lookups && misses == o.misses;
  }
};

/// What a pass read of the memories, whole words.
struct MemoryTraffic {
  std::uint64_t texel_reads = 0, texel_bytes = 0;
  std::uint64_t slb_reads = 0, slb_bytes = 0;
};

/// Clock cycles of a pass, and where they went.
struct PassCycles {
  std::uint64_t total = 0;
  std::uint64_t items = 0;  ///< pass 1: texels of edges and spans; pass 2: fragments
  std::vector<std::pair<std::string, std::uint64_t>> causes;  ///< their sum is `total`
  std::vector<QueueCycles> queues;                            ///< by name
  std::vector<CacheCounts> caches;                            ///< by name
  std::optional<MemoryTraffic> traffic;
  static constexpr std::uint32_t kTile = 8;  ///< texels
  /// Pass 1: cycles that the store spent on the texels of each tile of the map, row by row; empty:
  /// not known.
  std::vector<std::uint64_t> tiles;

  double per_item() const { return items ? double(total) / double(items) : 0; }
  std::uint64_t of(const std::string& cause) const {
    for (const auto& [name, cycles] : causes) {
      if (name == cause) return cycles;
    }
    return 0;
  }
};

/// Of an engine that has a clock; what it does not time is absent. Pass 2's causes are those of the
/// first lane.
struct CycleReport {
  std::optional<std::uint64_t> clear;             ///< wiping the memories before the frame
  std::optional<std::uint64_t> announce, settle;  ///< winding profile: receiver mask; end of pass 1
  std::optional<PassCycles> pass1, pass2;
  std::uint64_t edge_texels = 0, span_texels = 0;  ///< of pass 1

  /// Of everything that was timed.
  std::uint64_t total() const {
    return clear.value_or(0) + announce.value_or(0) + settle.value_or(0) +
           (pass1 ? pass1->total : 0) + (pass2 ? pass2->total : 0);
  }
  /// Is nothing of a frame absent? @param winding  the profile
  bool whole_frame(bool winding) const {
    return clear && pass1 && pass2 && (!winding || (announce && settle));
  }
  /// Cycles of pass 1 but those that carried out spans. @pre pass1
  double per_edge_texel() const {
    return edge_texels ? double(pass1->total - pass1->of("span")) / double(edge_texels) : 0;
  }
  double per_span_texel() const {
    return span_texels ? double(pass1->of("span")) / double(span_texels) : 0;
  }
};

}  // namespace kagesen
