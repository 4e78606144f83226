#pragma once
/// Counters that follow from what a frame stored: the same in every engine.
#include <cstdint>

#include "model/engine.h"

namespace kagesen {

/// Adds texels to the counters' SLB figures, which start from nothing.
class StoredFigures {
 public:
  explicit StoredFigures(UnitCounters& counters) : c_(counters) {
    c_.slb_texels = c_.slb_entries = c_.slb_lines = c_.collisions = c_.max_chain = 0;
    c_.chain_histogram.assign(1, 0);
  }
  void add_entry(std::uint64_t lines) {
    ++c_.slb_entries;
    c_.slb_lines += lines;
  }
  /// A texel that has entries. @param records  of its chain
  void add_texel(std::uint64_t records) {
    ++c_.slb_texels;
    if (c_.chain_histogram.size() <= records) c_.chain_histogram.resize(records + 1);
    ++c_.chain_histogram[records];
    c_.max_chain = c_.chain_histogram.size() - 1;
  }

 private:
  UnitCounters& c_;
};

/// Bytes of the memories, once the counts above and the peak are known.
void add_paper_bytes(const UnitConfig& config, UnitCounters& counters);
/// @pre skips.cleared_texels is known
/// @param fraction_bits  of the frame
void add_winding_bytes(const UnitConfig& config, std::uint32_t fraction_bits,
                       UnitCounters& counters);

/// The SLB figures of contents that were read back.
void add_stored_figures(const UnitConfig& config, const MapContents& contents,
                        UnitCounters& counters);

}  // namespace kagesen
