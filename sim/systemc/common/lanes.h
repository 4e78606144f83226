#pragma once
/// The lanes of pass 2, each with the memories behind its ports, and a pass through them.
///
/// Timing: a pass's first cycle is 0; it ends in the cycle after the one in which the last verdict
///         was taken, that one counted.
#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/cycle_causes.h"
#include "model/engine.h"
#include "sim/systemc/common/memory_port.h"
#include "sim/systemc/memory/memory.h"

namespace kagesen::tlm_model {

/// @tparam ShadowLane  of a profile
template <typename ShadowLane>
class Lanes {
 public:
  explicit Lanes(unsigned lanes) {
    for (unsigned l = 0; l < lanes; ++l) lanes_.push_back(std::make_unique<Lane>(l));
  }

  void begin_frame(const Timing& timing) {
    timing_ = timing;
    for (auto& l : lanes_) {
      l->texel_memory.configure(timing);
      l->slb_memory.configure(timing);
      l->lane.clear();
    }
    caches_.clear();
    passes_ = 0;
    total_ = fragments_ = 0;
    traffic_ = {};
  }

  /// @param timeline  takes what the lanes do; or null
  void trace(Timeline* timeline) {
    for (unsigned l = 0; l < lanes_.size(); ++l) lanes_[l]->lane.trace(timeline, name_of(l));
    timeline_ = timeline;
  }

  /// @param pass    what all lanes have in common
  /// @param decide  (fragment, trail) -> verdict
  template <typename Decide>
  void run(typename ShadowLane::Pass pass, const Fragment* fragments, std::size_t count,
           Verdict* verdicts, FragmentCycles* cycles, Decide decide) {
    const PassNumber number{kDecide, passes_++};
    if (timeline_) timeline_->begin(2, total_);
    pass.stride = lanes_.size();
    for (unsigned l = 0; l < lanes_.size(); ++l) begin_pass(l, pass, number, cycles);
    std::size_t turn = 0;
    for (std::size_t i = 0; i < count; ++i) {
      ShadowLane& lane = lanes_[turn]->lane;
      verdicts[i] = decide(fragments[i], lane.open());
      lane.take();
      if (++turn == lanes_.size()) turn = 0;
    }
    Cycle taken = 0, total = 1;
    for (auto& l : lanes_) {
      if (l->lane.fragments() == 0) continue;
      l->lane.drain();
      taken = std::max(taken, l->lane.last_accepted() + 1);
      total = std::max(total, l->lane.last_retired() + 2);
    }
    for (auto& l : lanes_) l->lane.end_pass(taken, total);
    total_ += total;
    fragments_ += count;
    for (auto& l : lanes_) {
      const MemoryPort &texels = l->lane.texel_port(), &slb = l->lane.slb_port();
      traffic_.texel_reads += texels.reads();
      traffic_.texel_bytes += texels.reads() * texels.word_bytes();
      traffic_.slb_reads += slb.reads();
      traffic_.slb_bytes += slb.reads() * slb.word_bytes();
    }
    for (unsigned l = 0; l < lanes_.size(); ++l) {
      count_cache(name_of(l) + ".texel_cache", lanes_[l]->texel_memory);
      count_cache(name_of(l) + ".slb_cache", lanes_[l]->slb_memory);
    }
  }

  /// Of the frame's passes; causes of the first lane.
  PassCycles cycles() const {
    PassCycles out;
    out.total = total_;
    out.items = fragments_;
    out.causes = lanes_[0]->lane.causes().figures();
    for (unsigned l = 0; l < lanes_.size(); ++l) lanes_[l]->lane.add_queues(name_of(l), out.queues);
    std::sort(out.queues.begin(), out.queues.end(),
              [](const QueueCycles& a, const QueueCycles& b) { return a.name < b.name; });
    for (const auto& [name, counts] : caches_) out.caches.push_back(counts);
    out.traffic = traffic_;
    return out;
  }

 private:
  static constexpr std::uint32_t kDecide = 5;  // shadow_pkg::PassDecide

  static std::string name_of(unsigned lane) { return "lane" + std::to_string(lane); }
  void count_cache(const std::string& name, const Memory& memory) {
    const ReadCache& cache = memory.cache();
    if (cache.lookups() == 0) return;
    CacheCounts& counts = caches_[name];
    counts.name = name;
    counts.lookups += cache.lookups();
    counts.misses += cache.misses();
  }

  struct Lane {
    ShadowLane lane;
    Memory texel_memory, slb_memory;

    explicit Lane(unsigned number)
        : lane(("shadow_lane" + std::to_string(number)).c_str()),
          texel_memory(("texel_memory" + std::to_string(number)).c_str()),
          slb_memory(("slb_memory" + std::to_string(number)).c_str()) {
      lane.texel_port().socket.bind(texel_memory.socket);
      lane.slb_port().socket.bind(slb_memory.socket);
    }
  };

  void begin_pass(unsigned l, typename ShadowLane::Pass& pass, const PassNumber& number,
                  FragmentCycles* cycles) {
    Lane& lane = *lanes_[l];
    lane.texel_memory.begin_pass(number, Channel::kTexelReads, l, pass.texel_bytes);
    lane.slb_memory.begin_pass(number, Channel::kSlbReads, l, pass.slb_bytes);
    const auto stalls = [&](Channel channel) {
      return Stalls(timing_.stream_stall, Chance(timing_.seed, number, channel, l));
    };
    pass.offers = stalls(Channel::kFragments);
    pass.verdicts = stalls(Channel::kVerdicts);
    pass.cycles = cycles ? cycles + l : nullptr;
    lane.lane.begin_pass(pass);
  }

  std::vector<std::unique_ptr<Lane>> lanes_;
  Timing timing_;
  std::uint32_t passes_ = 0;  // of this frame
  std::uint64_t total_ = 0, fragments_ = 0;
  MemoryTraffic traffic_;
  std::map<std::string, CacheCounts> caches_;  // behind the ports, by name
  Timeline* timeline_ = nullptr;
};

}  // namespace kagesen::tlm_model
