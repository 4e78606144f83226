#pragma once
/// A memory of the configured timing behind a TLM-2.0 socket; the same as the Verilated bench's.
///
/// It holds no data: what a read returns is golden's to say.
#include <tlm_utils/simple_target_socket.h>

#include <systemc>
#include <tlm>

#include "sim/memory/timing.h"

namespace kagesen::tlm_model {

class Memory : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<Memory> socket;

  explicit Memory(const sc_core::sc_module_name& name);

  void configure(const Timing& timing) { timing_.configure(timing); }
  const ReadCache& cache() const { return timing_.cache(); }
  void begin_pass(PassNumber pass, Channel channel, unsigned lane, unsigned word_bytes);

 private:
  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  bool grant_direct(tlm::tlm_generic_payload& payload, tlm::tlm_dmi& direct);

  ReadTiming timing_;
  unsigned word_bytes_ = 4;
};

}  // namespace kagesen::tlm_model
