#pragma once
/// A cycle of work on a texel's list: what is looked up, what is written, and what that ends.
/// Twin: the ports of rtl/winding/silhouette_buffer.sv and cluster_update.sv.
///
/// Golden has said what is found (TexelVisit); records' links say how long that takes.
#include "model/unit/config.h"
#include "model/unit/winding/store_trail.h"
#include "sim/systemc/winding/record_cache.h"
#include "sim/systemc/winding/record_pool.h"

namespace kagesen::tlm_model::winding {

/// What may happen to the texel besides what golden said of the visit.
struct ListVisit {
  unit::winding::TexelVisit texel;
  bool settles = false, span = false;
  std::uint32_t object = 0;   ///< of the facet
  std::uint32_t emptied = 0;  ///< settling: clusters without segments
  bool nothing() const { return !span && !texel.corner && !texel.segment; }
};

/// A texel of the buffers, as far as it takes time.
struct TexelState {
  enum Kind : std::uint8_t { kEmpty, kPlane, kList, kOverflow } kind = kEmpty;
  bool covered = false, bare = false;
  std::uint32_t marks = 0;  ///< of the planes in a list that is not covered
  WordAddress first = 0;    ///< the list's first record
};

/// The cycle's requests of the records.
class ListStep {
 public:
  ListStep(const RecordCache& cache, Cycle now) : cache_(cache), now_(now) {}

  bool hit() const { return cache_.hit(); }
  void look_up(WordAddress at) {
    lookup = true;
    address = at;
  }
  /// Is a record written in this cycle? Else it waits.
  bool write(WordAddress at) {
    update = true;
    update_address = at;
    return written = cache_.update_ready(at, now_);
  }

  bool lookup = false, update = false, written = false;
  WordAddress address = 0, update_address = 0;

 private:
  const RecordCache& cache_;
  Cycle now_;
};

}  // namespace kagesen::tlm_model::winding
