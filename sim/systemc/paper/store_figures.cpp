/// What the store counts: causes and queues.
#include "sim/systemc/paper/store.h"

namespace kagesen::tlm_model::paper {

void Store::count(StoreCause cause, Cycle cycles) {
  causes_.add(cause, now_, cycles);
  const std::size_t words[] = {coming_.words(), emptied_.words(), soon_.words(), visits_.words(),
                               links_.words()};
  for (std::size_t q = 0; q < kQueueCount; ++q) meters_[q].stand(words[q], cycles);
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
}

}  // namespace kagesen::tlm_model::paper
