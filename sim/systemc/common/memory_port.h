#pragma once
/// A read port of the unit: one request a cycle, one response a cycle (docs/rtl.md, Handshakes).
///
/// TLM-2.0, loosely timed: a read is one b_transport, its annotated delay the time of the response.
/// A memory that also says when it took the request does so with ReadAccepted. A memory that grants
/// direct access says by it that each read takes the same time; then reads cost no call.
#include <tlm_utils/simple_initiator_socket.h>

#include <string>
#include <systemc>
#include <tlm>
#include <vector>

#include "sim/systemc/common/clock.h"
#include "sim/common/timeline.h"

namespace kagesen::tlm_model {

/// When a memory took a request; without it: at once.
struct ReadAccepted : tlm::tlm_extension<ReadAccepted> {
  sc_core::sc_time delay;  ///< as b_transport's
  tlm::tlm_extension_base* clone() const override { return new ReadAccepted(*this); }
  void copy_from(const tlm::tlm_extension_base& other) override {
    *this = static_cast<const ReadAccepted&>(other);
  }
};

class MemoryPort : public sc_core::sc_module {
 public:
  struct Read {
    Cycle accepted, responded;
  };

  tlm_utils::simple_initiator_socket<MemoryPort> socket;

  explicit MemoryPort(const sc_core::sc_module_name& name);
  ~MemoryPort() override;

  /// @param word_bytes  of a word, the unit of addresses
  void begin_pass(unsigned word_bytes);
  /// A request that is offered from `asked` on. Calls come in the order of time.
  Read read(Cycle asked, std::uint64_t word) {
    ++reads_;
    const Read read = latency_ != 0 ? Read{asked, asked + latency_} : transport(asked, word);
    if (timeline_ != nullptr) note(asked, word, read);
    return read;
  }
  /// @param timeline  takes every read; or null
  void trace(Timeline* timeline, const std::string& track) {
    timeline_ = timeline;
    if (timeline != nullptr) track_ = timeline->track(track, Timeline::Kind::kWork);
  }
  std::uint64_t reads() const { return reads_; }  ///< of this pass
  unsigned word_bytes() const { return word_bytes_; }

 private:
  Read transport(Cycle asked, std::uint64_t word);
  void note(Cycle asked, std::uint64_t word, const Read& read);
  void invalidate(sc_dt::uint64 first, sc_dt::uint64 last);

  tlm::tlm_generic_payload payload_;
  ReadAccepted accepted_;
  std::vector<unsigned char> data_;
  Cycle latency_ = 0;  // of every read; 0: the memory has to be asked
  std::uint64_t reads_ = 0;
  unsigned word_bytes_ = 4;
  Timeline* timeline_ = nullptr;
  std::uint32_t track_ = 0;
};

}  // namespace kagesen::tlm_model
