#include "sim/systemc/winding/store.h"

#include <algorithm>

namespace kagesen::tlm_model::winding {
namespace {

/// Of work that leaves a stage.
StoreCause cause_of(Work::Kind kind) {
  return kind == Work::kEdge   ? StoreCause::kEdge
         : kind == Work::kSpan ? StoreCause::kSpan
                               : StoreCause::kOther;
}

}  // namespace

Store::Store(const sc_core::sc_module_name& name)
    : sc_module(name), tiles("tile_buffer"), texels("texel_buffers"), texel_port("texel_port") {}

void Store::reset(const UnitConfig& config, unsigned map_bits) {
  map_bits_ = map_bits;
  columns_ = static_cast<std::uint32_t>((config.map_width + 7) / 8);
  rows_ = static_cast<std::uint32_t>((config.map_height + 7) / 8);
  tiles.reset(config, map_bits);
  texels.reset(config, map_bits);
  texel_port.reset(map_bits);
  meter_.reset(config);
}

void Store::begin_pass(bool draws, unsigned texel_bytes, const Stalls& texel_writes,
                       unsigned record_bytes, const Stalls& record_writes) {
  texel_port.begin_pass(texel_bytes, texel_writes);
  texels.silhouettes.records.begin_pass(record_bytes, record_writes);
  texel_writes_ = texel_writes;
  now_ = 0;
  unchanged_ = settling_ = false;
  drawing_ = draws;
  meter_.begin_pass();
}

/// The first cycle clears what is on chip; then a tile is written each cycle.
Cycle Store::wipe() {
  Cycle at = 1;
  for (std::uint32_t tile = 0; tile < columns_ * rows_; ++tile) at = texel_writes_.next(at) + 1;
  return at + 1;
}

Cycle Store::announce(const unit::winding::TriangleTrail::Texel& texel, Cycle offered) {
  offer_ = {{}, tile_of(texel.x, texel.y)};
  offer_.work.kind = Work::kTile;
  return enter(offered);
}

void Store::begin(const unit::winding::TriangleTrail& triangle) {
  triangle_ = &triangle;
  next_visit_ = 0;
  texels.silhouettes.walk.add_dropped(triangle.dropped);
}

void Store::offer_visit(const Visit& visit) {
  offer_ = {};
  Work& work = offer_.work;
  if (visit.kind == Visit::kBegin) return;
  const bool span = visit.kind == Visit::kSpan;
  const auto x = static_cast<std::uint32_t>(visit.x), y = static_cast<std::uint32_t>(visit.y);
  work.kind = span ? Work::kSpan : Work::kEdge;
  work.place = static_cast<std::uint8_t>((y & 7) << 1 | (x >> 2 & 1));
  work.texels = static_cast<std::uint8_t>(span ? visit.mask : 1u << (x & 3));
  offer_.tile = work.tile = tile_of(visit.x, visit.y);
  for (unsigned i = 0; i < TexelBuffers::kTexels; ++i) {
    if ((work.texels >> i & 1) == 0) continue;
    const unit::winding::TexelVisit& texel = triangle_->visits[next_visit_++];
    if (texel.masked) continue;
    work.passing = static_cast<std::uint8_t>(work.passing | 1u << i);
    work.nearest = work.nearest || texel.nearest;
    ListVisit list;
    list.texel = texel;
    list.span = span;
    list.object = triangle_->object;
    texels.add_visit(list);
  }
}

Cycle Store::take(const Visit& visit, Cycle offered) {
  offer_visit(visit);
  return enter(offered);
}

Cycle Store::enter(Cycle offered) {
  pass_over(offered);
  while (!step(true)) {
    if (unchanged_) pass_over(kNever);
  }
  return now_ - 1;
}

bool Store::ready(Cycle at) {
  pass_over(at);
  return tiles.window.in_ready(texel_port.does(now_, wants()).tile_fetched);
}

Cycle Store::finish(Cycle from) {
  pass_over(from);
  while (!idle()) {
    step(false);
    if (unchanged_) pass_over(kNever);
  }
  step(false);
  return now_;
}

/// The first cycle begins; then the tiles of the map enter.
Cycle Store::settle(const unit::winding::SettleTrail& trail) {
  settling_ = true;
  texels.add_settled(trail);
  Cycle at = 1;
  for (std::uint32_t row = 0; row < rows_; ++row) {
    for (std::uint32_t column = 0; column < columns_; ++column) {
      offer_ = {{}, row << (map_bits_ - 3) | column};
      offer_.work.kind = Work::kTile;
      at = enter(at) + 1;
    }
  }
  return finish(at);
}

bool Store::idle() const {
  return tiles.window.empty() && tiles.idle() && texels.window.empty() && texels.idle() &&
         texels.silhouettes.idle();
}

/// Cycles up to `until` in which nothing is offered; if the last one changed nothing, to the next
/// in which a memory does something at once. kNever: only that.
void Store::pass_over(Cycle until) {
  while (now_ < until) {
    if (unchanged_) {
      const Cycle next =
          std::min({until, texel_port.next(now_), texels.silhouettes.records.next(now_)});
      if (next == kNever) meter_.stuck(name(), now_, cause_, words());
      count(cause_, next - now_);
      now_ = next;
      unchanged_ = false;
      if (until == kNever) return;
    } else if (until == kNever) {
      return;
    } else {
      step(false);
    }
  }
}

TexelPort::Wants Store::wants() const {
  TexelPort::Wants wants;
  wants.word_read = texels.window.reads();
  wants.word_address = texels.window.read_address();
  wants.word_line = texels.window.read_line();
  wants.tile_read = tiles.window.reads();
  wants.tile_address = tiles.window.read_address();
  wants.tile_line = tiles.window.read_line();
  wants.tile_write = tiles.writes(texels.sum_valid());
  wants.touch = tiles.touches();
  wants.word_write = texels.writes();
  return wants;
}

/// Why this cycle is spent.
StoreCause Store::cause(const TexelPort::Does& does, bool offered) const {
  if (texels.running() && !texels.done()) {
    switch (texels.silhouettes.cause()) {
      case SilhouetteBuffer::Cause::kRecord: return StoreCause::kRecord;
      case SilhouetteBuffer::Cause::kWrite: return StoreCause::kWrite;
      default: return StoreCause::kChain;
    }
  }
  if (texels.pop()) {
    const StoreCause done = cause_of(texels.window.work().kind);
    if (done != StoreCause::kOther) return done;
  }
  if (texels.pop() || texels.window.valid()) {
    return texels.writes() && !does.word_ready ? StoreCause::kWrite : StoreCause::kOther;
  }
  if (texels.window.waits()) return StoreCause::kTexel;
  if (tiles.pop()) {
    const StoreCause done = cause_of(tiles.window.work().kind);
    if (done != StoreCause::kOther) return done;
  }
  if (tiles.pop() || tiles.window.valid()) {
    return tiles.writes(texels.sum_valid()) && !does.tile_ready ? StoreCause::kWrite : StoreCause::kOther;
  }
  if (tiles.window.waits()) return StoreCause::kTexel;
  return !offered && idle() ? StoreCause::kInput : StoreCause::kOther;
}

/// One cycle. @param offered  there is an offer_  @return is it taken?
bool Store::step(bool offered) {
  const TexelPort::Wants wanted = wants();
  const TexelPort::Does does = texel_port.does(now_, wanted);
  const bool tile_response = does.response && does.of_tile;
  const bool word_response = does.response && !does.of_tile;

  TexelBuffers::Inputs texel;
  texel.write_ready = does.word_ready;
  texel.keep_ready = !word_response;
  texel.sum_ready = does.tile_ready;
  texels.step(now_, texel);
  TileBuffer::Inputs tile;
  tile.write_ready = does.tile_ready;
  tile.touch_ready = does.touch_ready;
  tile.keep_ready = !tile_response;
  tile.out_ready = texels.window.in_ready(does.word_fetched);
  tile.sum_valid = texels.sum_valid();
  tile.settling = settling_;
  tiles.step(tile);
  const bool taken = offered && tiles.window.in_ready(does.tile_fetched);
  cause_ = cause(does, offered);
  count(cause_, 1);

  // ---- The clock's edge ----
  MemoryWindow::Inputs word_window, tile_window;
  if (tiles.out_valid() && tile.out_ready) {
    word_window.work = &tiles.out();
    word_window.bare = tiles.out().kind == Work::kBegin;
    word_window.address = tiles.out_address();
  }
  word_window.fetched = does.word_fetched;
  word_window.response = word_response;
  tile_window.response = tile_response;
  word_window.line = tile_window.line = does.line;
  word_window.load = texels.load();
  word_window.pop = texels.pop();
  word_window.clean = texels.clean();
  if (taken) {
    tile_window.work = &offer_.work;
    tile_window.bare = offer_.work.kind == Work::kBegin;
    tile_window.address = offer_.tile;
  }
  tile_window.fetched = does.tile_fetched;
  tile_window.load = tiles.load();
  tile_window.pop = tiles.pop();
  tile_window.clean = tiles.clean();
  if (tiles.touched()) texels.touch(tiles.slot());
  bool changed = texels.clock(now_);
  changed |= tiles.clock();
  changed |= texels.window.step(word_window);
  changed |= tiles.window.step(tile_window);
  changed |= texel_port.clock(wanted, does);
  unchanged_ = !changed;
  ++now_;
  return taken;
}

void Store::count(StoreCause cause, Cycle cycles) {
  if (!drawing_) return;
  meter_.count(cause, now_, cycles, words());
  const MemoryWindow& window = texels.window.holds_work() ? texels.window : tiles.window;
  if (!window.holds_work() || window.work().kind == Work::kBegin) return;
  const WordAddress tile = window.work().tile;
  meter_.tiles.add(tile & ((1u << (map_bits_ - 3)) - 1), tile >> (map_bits_ - 3), cycles);
}

}  // namespace kagesen::tlm_model::winding
