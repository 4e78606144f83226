/// What the store counts: causes, queues, tiles.
#include <stdexcept>
#include <string>

#include "sim/systemc/paper/store.h"

namespace kagesen::tlm_model::paper {

std::array<std::size_t, Store::kQueueCount> Store::words() const {
  return {coming_.words(), emptied_.words(), soon_.words(), visits_.words(), links_.words()};
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
  causes_.add(cause, now_, cycles);
  const std::array<std::size_t, kQueueCount> now = words();
  for (std::size_t q = 0; q < kQueueCount; ++q) meters_[q].stand(now[q], cycles);
  if (!walk_.busy()) return;
  constexpr std::uint32_t kTile = PassCycles::kTile;
  const Operation& o = walk_.operation();
  tile_meter_.add(static_cast<std::uint32_t>(o.x) / kTile, static_cast<std::uint32_t>(o.y) / kTile,
                  cycles);
}

void Store::trace(Timeline* timeline) {
  causes_.trace(timeline);
  texels.port.trace(timeline, "store.texel_port");
  records.port.trace(timeline, "store.slb_port");
  for (std::size_t q = 0; q < kQueueCount; ++q) meters_[q].trace(timeline, kQueues[q]);
}

void Store::report(PassCycles& pass) const {
  pass.causes = causes_.meter().figures();
  for (std::size_t q = 0; q < kQueueCount; ++q) pass.queues.push_back(meters_[q].figures(kQueues[q]));
  pass.tiles = tile_meter_.cycles();
}

}  // namespace kagesen::tlm_model::paper
