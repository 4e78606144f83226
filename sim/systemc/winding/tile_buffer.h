#pragma once
/// Tiles of 8 x 8 texels: receiver mask, allocation of texels, nearest depth, sums.
/// Twin: rtl/winding/tile_buffer.sv.
#include <systemc>
#include <vector>

#include "model/unit/config.h"
#include "sim/systemc/winding/memory_window.h"

namespace kagesen::tlm_model::winding {

class TileBuffer : public sc_core::sc_module {
 public:
  static constexpr unsigned kWords = 16;  // of a tile's texels
  struct Inputs {
    bool write_ready = false;  ///< the memory's, for a tile; and for an empty word:
    bool touch_ready = false;
    bool keep_ready = false;   ///< the window's
    bool out_ready = false;    ///< the texels'
    bool sum_valid = false;
    bool settling = false;
  };

  MemoryWindow window;

  explicit TileBuffer(const sc_core::sc_module_name& name)
      : sc_module(name), window("tile_window") {}

  void reset(const UnitConfig& config, unsigned map_bits);
  void clear();

  // Of this cycle, by registers alone:
  bool writes(bool sum_valid) const { return (dirty_ && back()) || sum_valid; }
  bool touches() const { return touching_; }
  std::size_t pending() const { return pending_.words(); }  ///< tiles whose sums are due
  bool clean() const { return !dirty_ && !unkept_; }
  bool idle() const { return clean() && !window.valid() && !touching_ && pending_.empty(); }

  /// What this cycle does.
  void step(const Inputs& in);
  bool load() const { return load_; }
  bool pop() const { return pop_; }
  /// Work goes on to the texels: for this word, or none.
  bool out_valid() const { return out_valid_; }
  const Work& out() const { return out_; }
  WordAddress out_address() const { return out_address_; }
  bool touched() const { return touched_; }  ///< a tile gets texels:
  std::uint32_t slot() const { return slot_; }
  /// The clock's edge. @return did anything change?
  bool clock();

 private:
  static constexpr unsigned kPending = 4;  // settled tiles whose sums are due
  struct Tile {
    bool touched = false;
    std::uint32_t slot = 0;
  };
  struct Nothing {};

  bool back() const { return flush_ || (window.valid() && window.fresh()); }

  std::vector<Tile> tiles_;  // by address
  Fifo<Nothing> pending_;
  bool dirty_ = false, unkept_ = false, flush_ = false, touching_ = false;
  unsigned word_ = 0, first_ = 0, written_ = 0;
  std::uint32_t slot_ = 0;
  // Of this cycle.
  Inputs in_;
  Work out_;
  WordAddress out_address_ = 0;
  bool load_ = false, pop_ = false, out_valid_ = false, touched_ = false, change_ = false,
       pends_ = false;
  unsigned next_word_ = 0;
};

}  // namespace kagesen::tlm_model::winding
