#pragma once
/// The store of pass 1: carries out visits strictly in order on the texel memory and the SLB; also
/// wipes, announces fragments and settles.
/// Twin: rtl/winding/store.sv.
///
/// It is stepped cycle by cycle, for what is on chip hangs on what meets in a cycle; cycles in which
/// it only waits are passed over.
#include <systemc>
#include <vector>

#include "model/unit/winding/triangle_trail.h"
#include "sim/systemc/common/store_meter.h"
#include "sim/systemc/winding/texel_buffers.h"
#include "sim/systemc/winding/texel_port.h"
#include "sim/systemc/winding/tile_buffer.h"
#include "sim/systemc/winding/visit.h"

namespace kagesen::tlm_model::winding {

class Store : public sc_core::sc_module, public VisitTaker {
 public:
  TileBuffer tiles;
  TexelBuffers texels;
  TexelPort texel_port;

  explicit Store(const sc_core::sc_module_name& name);
  MemoryPort& record_port() { return texels.silhouettes.records.port; }

  /// As after reset, for a configuration.
  void reset(const UnitConfig& config, unsigned map_bits);
  /// @param draws  its causes count
  void begin_pass(bool draws, unsigned texel_bytes, const Stalls& texel_writes,
                  unsigned record_bytes, const Stalls& record_writes);
  /// The wipe pass. Returns its cycles.
  Cycle wipe();
  /// A fragment whose verdict is not known, in this texel. Returns the cycle in which it is taken.
  Cycle announce(const unit::winding::TriangleTrail::Texel& texel, Cycle offered);
  /// Visits to come are of this triangle, until the next.
  void begin(const unit::winding::TriangleTrail& triangle);
  Cycle take(const Visit& visit, Cycle offered) override;
  bool ready(Cycle at) override;
  /// Everything was taken; who offered it is idle from a cycle on. Returns the pass's cycles.
  Cycle finish(Cycle idle);
  /// The settle pass. Returns its cycles.
  Cycle settle(const unit::winding::SettleTrail& trail);
  /// Tells cycles without a visit, before one whose cause is known, from the front's causes.
  void tell(FrontCauses& front, Cycle until) { meter_.causes.tell(front, until); }
  /// @param timeline  takes what the store does in draw passes; or null
  void trace(Timeline* timeline) { meter_.trace(timeline, texel_port.port, record_port()); }
  /// Fills in causes, queues and tiles of draw passes.
  void report(PassCycles& pass) const { meter_.report(pass); }

 private:
  struct Offer {
    Work work;
    WordAddress tile = 0;
  };

  WordAddress tile_of(std::int32_t x, std::int32_t y) const {
    return static_cast<WordAddress>(y >> 3) << (map_bits_ - 3) | static_cast<WordAddress>(x >> 3);
  }
  void offer_visit(const Visit& visit);
  Cycle enter(Cycle offered);
  TexelPort::Wants wants() const;
  bool idle() const;
  StoreCause cause(const TexelPort::Does& does, bool offered) const;
  bool step(bool offered);
  void pass_over(Cycle until);
  void count(StoreCause cause, Cycle cycles);
  StoreMeter::Words words() const {
    return {texels.window.lines(), texels.window.payloads(), tiles.pending(), tiles.window.lines(),
            tiles.window.payloads()};
  }

  unsigned map_bits_ = 10;
  std::uint32_t columns_ = 0, rows_ = 0;  // tiles of the map
  bool settling_ = false, drawing_ = false;
  const unit::winding::TriangleTrail* triangle_ = nullptr;
  std::size_t next_visit_ = 0;  // in triangle_
  Offer offer_;

  Stalls texel_writes_;
  Cycle now_ = 0;           // the next cycle
  bool unchanged_ = false;  // the last one changed nothing
  StoreCause cause_ = StoreCause::kInput;  // of the last one
  StoreMeter meter_{{"store.texel_window.lines", "store.texel_window.payloads",
                     "store.tile_buffer.tiles", "store.tile_window.lines",
                     "store.tile_window.payloads"}};
};

}  // namespace kagesen::tlm_model::winding
