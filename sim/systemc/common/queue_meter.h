#pragma once
/// How full a queue is, cycle by cycle: from what goes in and out of it, or as it stands in steps.
/// Twin: what bench_probes.h reads of fifo.sv and lane_slots.sv.
#include <string>
#include <vector>

#include "model/cycle_report.h"
#include "sim/common/timeline.h"
#include "sim/systemc/common/clock.h"

namespace kagesen::tlm_model {

class QueueMeter {
 public:
  /// A frame begins.
  void clear() { cycles_.clear(); }
  void begin_pass() {
    now_ = 0;
    first_ = words_ = 0;
    out_.assign(16, 0);
  }
  /// @param timeline  takes how full it is; or null
  void trace(Timeline* timeline, const std::string& name) {
    timeline_ = timeline;
    if (timeline != nullptr) track_ = timeline->track(name, Timeline::Kind::kAmount);
  }

  /// A word goes in in cycle `in` and leaves in cycle `out`. Words come in their order.
  void word(Cycle in, Cycle out) {
    forget_until(in + 1);
    pass_until(in + 1);
    if (words_ == out_.size()) grow();
    out_[(first_ + words_++) & (out_.size() - 1)] = out;
  }
  /// So many words stand in it in so many cycles.
  void stand(std::size_t words, Cycle cycles) {
    if (cycles_.size() <= words) cycles_.resize(words + 1);
    cycles_[words] += cycles;
    if (timeline_ != nullptr) timeline_->state(track_, "words", now_, now_ + cycles, words);
    now_ += cycles;
  }
  /// The pass took so many cycles.
  void end_pass(Cycle cycles) {
    forget_until(cycles);
    pass_until(cycles);
  }
  QueueCycles figures(const std::string& name) const { return {name, cycles_}; }

 private:
  /// Words that leave before this cycle.
  void forget_until(Cycle at) {
    while (words_ != 0 && out_[first_] < at) {
      pass_until(out_[first_] + 1);
      first_ = (first_ + 1) & (out_.size() - 1);
      --words_;
    }
  }
  void pass_until(Cycle at) {
    if (at > now_) stand(words_, at - now_);
  }
  void grow() {
    std::vector<Cycle> more(2 * out_.size());
    for (std::size_t i = 0; i < words_; ++i) more[i] = out_[(first_ + i) & (out_.size() - 1)];
    out_ = std::move(more);
    first_ = 0;
  }

  std::vector<std::uint64_t> cycles_;
  Cycle now_ = 0;  // the first one that is not counted
  std::vector<Cycle> out_ = std::vector<Cycle>(16);  // a ring: when each word inside leaves
  std::size_t first_ = 0, words_ = 0;
  Timeline* timeline_ = nullptr;
  std::uint32_t track_ = 0;
};

}  // namespace kagesen::tlm_model
