#pragma once
/// The memories behind the unit's ports, and when each port moves.
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "model/cycle_report.h"
#include "sim/common/timeline.h"
#include "testbench/verilator/bench_memory.h"
#include "testbench/verilator/bench_top.h"

namespace kagesen::bench {

using TexelMemory = WordMemory<widths::texel_wr_data_o, widths::texel_wr_addr_o>;
using SlbMemory = WordMemory<widths::slb_wr_data_o, widths::slb_wr_addr_o>;

/// The read ports of all lanes to one memory, and what they were asked for.
template <typename Memory, unsigned kWordBits, unsigned kAddrBits>
class ReadPorts {
 public:
  Memory memory;

  /// @param channel  kTexelReads or kSlbReads  @param name  "texel" or "slb"
  ReadPorts(Channel channel, const char* name) : channel_(channel), name_(name) {}

  void configure(const Timing& timing) {
    for (Port& p : ports_) p.configure(timing);
  }
  void begin_pass(Pass pass, PassNumber number, Cycle first) {
    for (unsigned l = 0; l < kLanes; ++l) keep_counts(l);
    pass_ = pass;
    for (unsigned l = 0; l < kLanes; ++l) {
      ports_[l].begin_pass(number, channel_, l, first);
      if (timeline_ != nullptr) {
        track_[l] = timeline_->track(owner(pass, l) + "." + name_ + "_port", Timeline::Kind::kWork);
      }
    }
    offered_.fill(kNever);
    first_ = first;
  }
  /// Reads under way are lost.
  void drop() {
    for (Port& p : ports_) p.drop();
  }
  void clear() {
    reads_ = {};
    caches_.clear();
  }
  void trace(Timeline* timeline) { timeline_ = timeline; }

  /// The cycle's inputs: responses, and which ports take a request.
  template <typename Tag, typename Data>
  void offer(Cycle now, std::uint8_t& valid, Tag& tags, Data& data, std::uint8_t& ready) {
    unsigned responds = 0, takes = 0;
    for (unsigned l = 0; l < kLanes; ++l) {
      if (const auto* r = ports_[l].take(now)) {
        responds |= 1u << l;
        set_field(tags, 8 * l, 8, r->tag);
        set_words<kWordBits, (kLanes > 1)>(data, kWordBits * l, r->words);
      }
      takes |= unsigned{ports_[l].ready(now)} << l;
    }
    valid = static_cast<std::uint8_t>(responds);
    ready = static_cast<std::uint8_t>(takes);
  }
  /// Takes the cycle's requests. Returns whether there were any.
  template <typename Tag, typename Address>
  bool take(Cycle now, unsigned valid, unsigned ready, const Tag& tags, const Address& addresses) {
    if (timeline_ != nullptr) note_offers(now, valid);
    if ((valid & ready) == 0) return false;
    for (unsigned l = 0; l < kLanes; ++l) {
      if (((valid & ready) >> l & 1) == 0) continue;
      const std::uint64_t address = field(addresses, kAddrBits * l, kAddrBits);
      const Cycle responds = ports_[l].accept(now, std::uint8_t(field(tags, 8 * l, 8)), address,
                                              memory.at(address));
      ++reads_[std::size_t(pass_)];
      if (timeline_ == nullptr) continue;
      const Cycle asked = offered_[l] - first_, taken = now - first_;
      if (taken > asked) timeline_->work(track_[l], "waits", address, asked, taken);
      timeline_->work(track_[l], "read", address, taken, responds - first_);
      offered_[l] = kNever;
    }
    return true;
  }

  std::uint64_t reads(Pass pass) const { return reads_[std::size_t(pass)]; }
  /// Of the caches behind the ports, by name; nothing where there are none.
  void add_caches(Pass pass, std::vector<CacheCounts>& out) {
    for (unsigned l = 0; l < kLanes; ++l) keep_counts(l);
    for (const CacheOf& c : caches_) {
      if (c.pass == pass) out.push_back(c.counts);
    }
  }
  /// "texel reads 0: valid 1 ready 0, 3 under way; ..."
  std::string text(unsigned valid, unsigned ready) const {
    std::string text;
    for (unsigned l = 0; l < kLanes; ++l) {
      text += std::string(name_) + " reads " + std::to_string(l) + ": valid " +
              std::to_string(valid >> l & 1) + " ready " + std::to_string(ready >> l & 1) + ", " +
              std::to_string(ports_[l].outstanding()) + " under way; ";
    }
    return text;
  }

 private:
  using Port = ReadPort<Memory::kStride>;
  static constexpr Cycle kNever = ~Cycle{0};
  struct CacheOf {
    Pass pass;
    CacheCounts counts;
  };

  /// Who uses a port: lanes in pass 2, else the store.
  static std::string owner(Pass pass, unsigned lane) {
    return pass == Pass::kDecide ? "lane" + std::to_string(lane) : "store";
  }
  void note_offers(Cycle now, unsigned valid) {
    for (unsigned l = 0; l < kLanes; ++l) {
      if ((valid >> l & 1) != 0 && offered_[l] == kNever) offered_[l] = now;
    }
  }
  /// What a port's cache counted since the last call.
  void keep_counts(unsigned l) {
    ReadCache& cache = ports_[l].cache();
    if (cache.none() || cache.lookups() == 0) return;
    const std::string name = owner(pass_, l) + "." + name_ + "_cache";
    const auto found = std::find_if(caches_.begin(), caches_.end(), [&](const CacheOf& c) {
      return c.pass == pass_ && c.counts.name == name;
    });
    CacheOf& of = found != caches_.end() ? *found : caches_.emplace_back(CacheOf{pass_, {name, 0, 0}});
    of.counts.lookups += cache.lookups();
    of.counts.misses += cache.misses();
    cache.forget_counts();
  }

  Channel channel_;
  const char* name_;
  std::array<Port, kLanes> ports_;
  std::array<Cycle, kLanes> offered_{};  // since when a request is, in a traced pass
  std::array<std::uint32_t, kLanes> track_{};
  std::array<std::uint64_t, kPasses> reads_{};
  std::vector<CacheOf> caches_;
  Pass pass_ = Pass::kIdle;
  Cycle first_ = 0;
  Timeline* timeline_ = nullptr;
};

/// All memories and their ports.
class Memories {
 public:
  ReadPorts<TexelMemory, widths::texel_wr_data_o, widths::texel_wr_addr_o> texels{
      Channel::kTexelReads, "texel"};
  ReadPorts<SlbMemory, widths::slb_wr_data_o, widths::slb_wr_addr_o> records{Channel::kSlbReads,
                                                                             "slb"};

  Memories() {
    for (unsigned mask = 0; mask < masks_.size(); ++mask) {
      masks_[mask].fill(0);
      for (unsigned bit = 0; bit < kTexelsPerWord * kTexelBits; ++bit) {
        if ((mask >> (bit / kTexelBits) & 1) != 0) masks_[mask][bit / 32] |= 1u << (bit % 32);
      }
    }
  }
  void configure(const Timing& timing) {
    try {
      texels.configure(timing);
      records.configure(timing);
    } catch (const std::invalid_argument& error) {
      throw Failure(error.what());
    }
  }
  void offer(Cycle now, Vshadow_bench& top) {
    texels.offer(now, top.texel_rsp_valid_i, top.texel_rsp_tag_i, top.texel_rsp_data_i,
                 top.texel_rd_ready_i);
    records.offer(now, top.slb_rsp_valid_i, top.slb_rsp_tag_i, top.slb_rsp_data_i,
                  top.slb_rd_ready_i);
  }
  /// A read that is accepted with a write of the same word has the old one: reads come first.
  /// Returns whether anything moved.
  bool take(Cycle now, Vshadow_bench& top) {
    bool moved = texels.take(now, top.texel_rd_valid_o, top.texel_rd_ready_i, top.texel_rd_tag_o,
                             top.texel_rd_addr_o);
    moved |= records.take(now, top.slb_rd_valid_o, top.slb_rd_ready_i, top.slb_rd_tag_o,
                          top.slb_rd_addr_o);
    if (top.texel_wr_valid_o && top.texel_wr_ready_i) {
      write_texels(top);
      moved = true;
    }
    if (top.slb_wr_valid_o && top.slb_wr_ready_i) {
      get_words<widths::slb_wr_data_o>(top.slb_wr_data_o, 0, records.memory.at(top.slb_wr_addr_o));
      moved = true;
    }
    return moved;
  }
  /// @param on_chip  look-ups of what the unit keeps; what it does not find it reads
  std::vector<CacheCounts> caches(Pass pass, std::vector<CacheCounts> on_chip) {
    for (CacheCounts& c : on_chip) {
      const bool is_texels = c.name.find("texel") != std::string::npos;
      c.misses = is_texels ? texels.reads(pass) : records.reads(pass);
    }
    texels.add_caches(pass, on_chip);
    records.add_caches(pass, on_chip);
    std::sort(on_chip.begin(), on_chip.end(),
              [](const CacheCounts& a, const CacheCounts& b) { return a.name < b.name; });
    return on_chip;
  }

 private:
  void write_texels(Vshadow_bench& top) {
    std::uint32_t* word = texels.memory.at(top.texel_wr_addr_o);
    constexpr unsigned kBits = widths::texel_wr_data_o;
    if (top.texel_wr_mask_o == (1u << kTexelsPerWord) - 1) {
      get_words<kBits>(top.texel_wr_data_o, 0, word);
      return;
    }
    std::uint32_t data[TexelMemory::kStride];
    get_words<kBits>(top.texel_wr_data_o, 0, data);
    const auto& mask = masks_[top.texel_wr_mask_o];
    for (unsigned i = 0; i < TexelMemory::kStride; ++i) {
      word[i] = (word[i] & ~mask[i]) | (data[i] & mask[i]);
    }
  }

  std::array<std::array<std::uint32_t, TexelMemory::kStride>, 1u << kTexelsPerWord> masks_;
};

}  // namespace kagesen::bench
