#pragma once
/// Looks inside the unit: how full each queue is, and what is looked up on chip. What can be seen is
/// probes.vlt's to say; everything is found by name when the model is made.
#include <algorithm>
#include <string>
#include <vector>

#include "model/cycle_report.h"
#include "sim/common/timeline.h"
#include "testbench/verilator/bench.h"
#include "verilated.h"
#include "verilated_sym_props.h"
#include "verilated_syms.h"

namespace kagesen::bench {

/// A register or wire of up to 16 bits.
class Signal {
 public:
  Signal() = default;
  explicit Signal(const VerilatedVar* var)
      : data_(var->datap()), wide_(var->entSize() == 2), bits_(unsigned(var->packed().elements())) {}
  unsigned value() const {
    return wide_ ? *static_cast<const SData*>(data_) : *static_cast<const CData*>(data_);
  }
  unsigned bits() const { return bits_; }

 private:
  const void* data_ = nullptr;
  bool wide_ = false;
  unsigned bits_ = 0;
};

class Probes {
 public:
  void find(VerilatedContext& context) {
    for (const auto& [path, scope] : *context.scopeNameMap()) {
      const auto signal = [of = scope](const char* name) { return of->varFind(name); };
      if (const VerilatedVar* head = signal("head_q")) {
        Queue q;
        q.name = name_of(path);
        q.pass = pass_of(q.name);
        q.head = Signal(head);
        q.tail = Signal(signal("tail_q"));
        q.out_valid = Signal(signal("out_valid_q"));
        q.cycles.assign((std::size_t{1} << q.head.bits()) / 2 + 2, 0);
        queues_.push_back(q);
      } else if (const VerilatedVar* lookup = signal("lookup_i")) {
        caches_.push_back({name_of(path), Pass::kDraw, Signal(lookup)});
      }
    }
    const auto by_name = [](const auto& a, const auto& b) { return a.name < b.name; };
    std::sort(queues_.begin(), queues_.end(), by_name);
    std::sort(caches_.begin(), caches_.end(), by_name);
  }
  void clear() {
    for (Queue& q : queues_) std::fill(q.cycles.begin(), q.cycles.end(), 0);
    for (Cache& c : caches_) c.lookups = 0;
  }
  void trace(Timeline* timeline) {
    timeline_ = timeline;
    if (timeline == nullptr) return;
    for (Queue& q : queues_) q.track = timeline->track(q.name, Timeline::Kind::kAmount);
  }

  /// A cycle of a pass, `at` from its first.
  void sample(Pass pass, Cycle at) {
    const bool traced = timeline_ != nullptr && timeline_->open(at);
    for (Queue& q : queues_) {
      if (q.pass != pass) continue;
      const unsigned words = q.words();
      ++q.cycles[words];
      if (traced) timeline_->state(q.track, "words", at, at + 1, words);
    }
    if (pass != Pass::kDraw) return;
    for (Cache& c : caches_) c.lookups += c.lookup.value();
  }

  std::vector<QueueCycles> queues(Pass pass) const {
    std::vector<QueueCycles> out;
    for (const Queue& q : queues_) {
      if (q.pass != pass) continue;
      out.push_back({q.name, q.cycles});
      std::vector<std::uint64_t>& cycles = out.back().cycles;
      while (!cycles.empty() && cycles.back() == 0) cycles.pop_back();
    }
    return out;
  }
  /// Look-ups of the words that are kept on chip; misses are the ports' to say.
  std::vector<CacheCounts> lookups(Pass pass) const {
    std::vector<CacheCounts> out;
    for (const Cache& c : caches_) {
      if (c.pass == pass) out.push_back({c.name, c.lookups, 0});
    }
    return out;
  }
  /// "store.places 3, ..."
  std::string text() const {
    std::string text;
    for (const Queue& q : queues_) {
      text += (text.empty() ? "" : ", ") + q.name + " " + std::to_string(q.words());
    }
    return text;
  }

 private:
  struct Queue {
    std::string name;
    Pass pass;
    Signal head, tail, out_valid;
    std::uint32_t track = 0;
    std::vector<std::uint64_t> cycles;

    unsigned words() const {
      const unsigned mask = (1u << head.bits()) - 1;
      return ((tail.value() - head.value()) & mask) + out_valid.value();
    }
  };
  struct Cache {
    std::string name;
    Pass pass;
    Signal lookup;
    std::uint64_t lookups = 0;
  };

  /// From the unit on, "lane0" for "g_lane[0].lane".
  static std::string name_of(const std::string& path) {
    const std::string top = ".unit.";
    std::string name = path.substr(path.find(top) + top.size());
    const std::string lane = "g_lane[", end = "].lane";
    if (name.compare(0, lane.size(), lane) == 0) {
      const std::size_t close = name.find(end);
      name = "lane" + name.substr(lane.size(), close - lane.size()) + name.substr(close + end.size());
    }
    return name;
  }
  static Pass pass_of(const std::string& name) {
    return name.compare(0, 4, "lane") == 0 ? Pass::kDecide : Pass::kDraw;
  }

  std::vector<Queue> queues_;
  std::vector<Cache> caches_;
  Timeline* timeline_ = nullptr;
};

}  // namespace kagesen::bench
