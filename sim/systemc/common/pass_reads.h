#pragma once
/// What pass 1 reads of the memories, and how often it need not: words kept on chip, and caches behind
/// the ports.
#include <string>

#include "model/cycle_report.h"
#include "sim/systemc/common/memory_port.h"
#include "sim/systemc/memory/memory.h"

namespace kagesen::tlm_model {

struct PassReads {
  MemoryTraffic traffic;
  CacheCounts texels, records;                                 ///< kept on chip
  CacheCounts texel_cache{"store.texel_cache"}, slb_cache{"store.slb_cache"};  ///< behind the ports

  /// What ports and memories counted in a pass that is over.
  void add(const MemoryPort& texel_port, const Memory& texel_memory, const MemoryPort& slb_port,
           const Memory& slb_memory) {
    traffic.texel_reads += texel_port.reads();
    traffic.texel_bytes += texel_port.reads() * texel_port.word_bytes();
    traffic.slb_reads += slb_port.reads();
    traffic.slb_bytes += slb_port.reads() * slb_port.word_bytes();
    add(texel_memory.cache(), texel_cache);
    add(slb_memory.cache(), slb_cache);
  }
  /// @param records_name, texels_name  instances in the Verilog; empty: nothing is counted there
  void report(const std::string& records_name, const std::string& texels_name,
              PassCycles& pass) const {
    pass.traffic = traffic;
    const auto put = [&](CacheCounts counts, const std::string& name) {
      counts.name = name;
      if (!name.empty() && counts.lookups != 0) pass.caches.push_back(counts);
    };
    put(records, records_name);
    put(slb_cache, slb_cache.name);
    put(texel_cache, texel_cache.name);
    put(texels, texels_name);
  }

 private:
  static void add(const ReadCache& cache, CacheCounts& counts) {
    counts.lookups += cache.lookups();
    counts.misses += cache.misses();
  }
};

}  // namespace kagesen::tlm_model
