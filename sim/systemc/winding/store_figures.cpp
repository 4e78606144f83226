/// What the store counts in draw passes: causes, queues, tiles.
#include <stdexcept>
#include <string>

#include "sim/systemc/winding/store.h"

namespace kagesen::tlm_model::winding {

std::array<std::size_t, Store::kQueueCount> Store::words() const {
  return {texels.window.lines(), texels.window.payloads(), tiles.pending(), tiles.window.lines(), tiles.window.payloads()};
}

/// Nothing is under way that could move it.
void Store::stuck() const {
  std::string text = std::string(name()) + ": stuck in cycle " + std::to_string(now_) + ", cause " +
                     kStoreCauses[static_cast<std::size_t>(cause_)] + "; words in queues:";
  const std::array<std::size_t, kQueueCount> now = words();
  for (std::size_t q = 0; q < kQueueCount; ++q) {
    text += std::string(" ") + kQueues[q] + " " + std::to_string(now[q]);
  }
  throw std::logic_error(text);
}

void Store::count(StoreCause cause, Cycle cycles) {
  if (!drawing_) return;
  causes_.add(cause, now_, cycles);
  const std::array<std::size_t, kQueueCount> now = words();
  for (std::size_t q = 0; q < kQueueCount; ++q) meters_[q].stand(now[q], cycles);
  const MemoryWindow& window = texels.window.holds_work() ? texels.window : tiles.window;
  if (!window.holds_work() || window.work().kind == Work::kBegin) return;
  const WordAddress tile = window.work().tile;
  tile_meter_.add(tile & ((1u << (map_bits_ - 3)) - 1), tile >> (map_bits_ - 3), cycles);
}

void Store::trace(Timeline* timeline) {
  causes_.trace(timeline);
  texel_port.port.trace(timeline, "store.texel_port");
  record_port().trace(timeline, "store.slb_port");
  for (std::size_t q = 0; q < kQueueCount; ++q) meters_[q].trace(timeline, kQueues[q]);
}

void Store::report(PassCycles& pass) const {
  pass.causes = causes_.meter().figures();
  for (std::size_t q = 0; q < kQueueCount; ++q) pass.queues.push_back(meters_[q].figures(kQueues[q]));
  pass.tiles = tile_meter_.cycles();
}

}  // namespace kagesen::tlm_model::winding
