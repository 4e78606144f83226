#pragma once
/// What visits do to the texels of a word: four at a time, or one after the other in the silhouette
/// buffer.
/// Twin: rtl/winding/texel_buffers.sv.
#include <algorithm>
#include <array>
#include <deque>
#include <systemc>
#include <vector>

#include "model/unit/config.h"
#include "sim/systemc/winding/memory_window.h"
#include "sim/systemc/winding/silhouette_buffer.h"

namespace kagesen::tlm_model::winding {

class TexelBuffers : public sc_core::sc_module {
 public:
  static constexpr unsigned kTexels = 4;
  struct Inputs {
    bool write_ready = false;  ///< the memory's
    bool keep_ready = false;   ///< the window's
    bool sum_ready = false;    ///< the tile buffer's
  };

  MemoryWindow window;
  SilhouetteBuffer silhouettes;

  explicit TexelBuffers(const sc_core::sc_module_name& name)
      : sc_module(name), window("texel_window"), silhouettes("silhouette_buffer") {}

  void reset(const UnitConfig& config, unsigned map_bits);
  void clear();
  /// What golden says of texels to come, in order.
  void add_visit(const ListVisit& visit) { visits_.push_back(visit); }
  void add_settled(const unit::winding::SettleTrail& trail);
  /// Such a tile has texels, all empty.
  void touch(std::uint32_t slot);

  // Of this cycle, by registers alone:
  bool writes() const { return dirty_ != 0 && back(); }
  bool sum_valid() const { return tile_ends_; }
  bool clean() const { return dirty_ == 0 && !unkept_; }
  bool idle() const { return clean() && !window.valid() && !tile_ends_; }
  bool running() const { return running_; }

  /// What this cycle does.
  void step(Cycle now, const Inputs& in);
  bool load() const { return load_; }
  bool pop() const { return pop_; }
  bool done() const { return done_; }
  /// The clock's edge. @return did anything change?
  bool clock(Cycle now);

 private:
  /// Nothing changes in this cycle.
  bool asleep() const { return idle() && !flush_ && !running_ && silhouettes.asleep(); }
  bool back() const { return flush_ || (window.valid() && window.fresh()); }
  void classify(const Work& work);
  void evaluate(const Work& work);
  static bool all_held(const TexelState* word);

  std::vector<TexelState> texels_;  // of tiles as they are touched
  std::deque<ListVisit> visits_;
  std::deque<unit::winding::SettleTrail::Texel> settled_;
  std::array<ListVisit, kTexels> at_{};  // the word's
  unsigned slow_ = 0, put_ = 0;          // of these

  unsigned dirty_ = 0, todo_ = 0, lane_ = 0, sum_lane_ = 0;
  bool unkept_ = false, flush_ = false, running_ = false, resumed_ = false, sums_ = false,
       tile_ends_ = false, all_ = true;
  WordAddress held_ = 0;
  // Of this cycle.
  Inputs in_;
  bool asleep_ = false, load_ = false, pop_ = false, done_ = false, change_ = false, start_ = false;
  bool next_resumed_ = false, next_sums_ = false;
  unsigned next_todo_ = 0, next_lane_ = 0, put_now_ = 0;
};

}  // namespace kagesen::tlm_model::winding
