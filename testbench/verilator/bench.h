#pragma once
/// A Verilated unit with its memories, as the program sees it: one shared object a build (build.h).
///
/// Twin: testbench/verilator/bench.cpp. Everything is in clock cycles; nothing knows of traces.
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "model/cycle_report.h"
#include "model/fragment_cycles.h"
#include "sim/common/timeline.h"
#include "sim/memory/timing.h"

namespace kagesen::bench {

enum class Register : std::uint8_t {  // byte addresses; docs/rtl.md
  kControl = 0x00,
  kStatus = 0x04,
  kCount = 0x08,
  kFractionBits = 0x0c,
  kMapWidth = 0x10,
  kMapHeight = 0x14,
  kPitchLog2 = 0x18,
  kBucketsLog2 = 0x1c,
  kRecordLimit = 0x20,
  kChainLimit = 0x24,
  kPlaneTolerance = 0x28,
  kPolicy = 0x2c,
  kCycles = 0x30,
  kRecords = 0x34,
  kCounterSelect = 0x38,
  kCounter = 0x3c,
  kIdentity = 0x40,
};

enum class Pass : std::uint8_t { kIdle, kWipe, kAnnounce, kDraw, kSettle, kDecide };
inline constexpr std::size_t kPasses = 6;
inline constexpr std::size_t kCauses = 16;

/// A beat of the triangle stream. A plane's beat comes before the triangle that shares it.
struct Triangle {
  std::int32_t x[3], y[3];
  std::uint32_t z[3];
  std::uint32_t object, polygon;
  std::uint8_t inner;
  bool is_plane, shares;
};

struct Fragment {
  std::int32_t x, y;
  std::uint32_t z, object;
  bool averted, outside, unshadowable;
};

struct Verdict {
  std::uint8_t dark : 1, by : 3;
};
/// By what a verdict came about: shadow_pkg::By*.
enum By : std::uint8_t { kByDefinition, kByOutside, kByNothing, kByBuffer, kByLines, kByTile };

struct PassCycles {
  std::uint64_t total = 0;
  std::uint64_t items = 0;             ///< triangles or fragments
  std::uint64_t causes[kCauses] = {};  ///< their sum is `total`; of pass 2, of lane 0
};

/// What the unit's event outputs told since the last clear().
struct Events {
  // front
  std::uint64_t casters, edges, edge_texels, inner_texels, span_texels;
  // store
  std::uint64_t lines_stored, lines_cancelled, emptied_covered, lines_hidden;
  std::uint64_t overflow_lines, overflow_texels;
  std::uint64_t texel_visits, masked_visits, hidden_visits, tiles_touched;
  std::uint64_t peak_records;
  // lanes
  std::uint64_t known, tile_lit, tile_dark, texel_lookups, first_test;
  std::uint64_t slb_lookups, entries_read, lines_read;
  std::uint64_t verdicts[2][8];  ///< [dark][by]
};

/// A memory's words, each `stride` 32-bit words, lowest first.
struct MemoryWords {
  const std::uint32_t* words;
  std::uint32_t stride;
  std::uint32_t bits;  ///< of a word
  std::uint64_t count;
};

/// An assertion of the unit failed, or the unit broke a rule of its ports, or made no progress.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Every function may throw Failure.
class Bench {
 public:
  static constexpr std::uint64_t kResetCycles = 5;  ///< that reset() takes
  virtual ~Bench() = default;

  /// Reset, as after power-up: memories keep what they hold, responses under way are lost.
  virtual void reset() = 0;
  /// Forgets events and cycles. The clock goes on.
  virtual void clear() = 0;
  virtual void set_timing(const Timing& timing) = 0;

  virtual void write(Register at, std::uint32_t value) = 0;
  virtual std::uint32_t read(Register at) = 0;

  // Passes. False: it was cut short (cut_next_pass).
  virtual bool wipe() = 0;
  virtual bool announce(const Fragment* fragments, std::size_t count) = 0;
  /// `count` beats, of which planes are no items.
  /// @param taken  if not null: when each item was, from the pass's first cycle on
  virtual bool draw(const Triangle* beats, std::size_t count, std::uint64_t* taken = nullptr) = 0;
  virtual bool settle() = 0;
  /// @param cycles  if not null: of each fragment, from the pass's first cycle on
  virtual bool decide(const Fragment* fragments, std::size_t count, Verdict* verdicts,
                      FragmentCycles* cycles = nullptr) = 0;
  enum class Cut : std::uint8_t { kAbort, kReset };
  /// Ends the next pass by force after so many cycles, unless it is done by then.
  virtual void cut_next_pass(Cut how, std::uint64_t after_cycles) = 0;

  virtual const Events& events() const = 0;
  virtual const PassCycles& cycles(Pass pass) const = 0;
  /// Of kDraw those of the store, of kDecide those of the lanes; by name.
  virtual std::vector<QueueCycles> queues(Pass pass) const = 0;
  virtual std::vector<CacheCounts> caches(Pass pass) = 0;
  virtual std::uint64_t texel_reads(Pass pass) const = 0;  ///< words, of all ports
  virtual std::uint64_t slb_reads(Pass pass) const = 0;
  virtual std::uint64_t now() const = 0;  ///< cycles since the bench was made
  virtual std::uint64_t pass_began() const = 0;  ///< now() in the first cycle of the last pass
  virtual MemoryWords texel_memory() const = 0;
  virtual MemoryWords slb_memory() const = 0;

  /// What the unit does in passes to come goes here too; null: no more.
  virtual void record(Timeline* timeline) = 0;
  /// Writes an FST wave of the cycles from `first` to `last`; only in a build with waves. A null
  /// path ends it early.
  virtual void trace(const char* path, std::uint64_t first, std::uint64_t last) = 0;
  /// The same of cycles of a pass, `first` and `last` counting from the first of all such passes.
  virtual void trace_pass(const char* path, Pass pass, std::uint64_t first, std::uint64_t last) = 0;
  /// Adds this run's coverage to a file; only in a build with coverage.
  virtual void write_coverage(const char* path) = 0;
};

/// What a shared object exports.
using MakeBench = Bench* (*)();
inline constexpr const char* kMakeBenchName = "kagesen_make_bench";

}  // namespace kagesen::bench
