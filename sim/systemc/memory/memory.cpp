#include "sim/systemc/memory/memory.h"

#include "sim/systemc/common/clock.h"
#include "sim/systemc/common/memory_port.h"

namespace kagesen::tlm_model {

Memory::Memory(const sc_core::sc_module_name& name) : sc_module(name), socket("socket") {
  socket.register_b_transport(this, &Memory::transport);
  socket.register_get_direct_mem_ptr(this, &Memory::grant_direct);
}

void Memory::begin_pass(PassNumber pass, Channel channel, unsigned lane, unsigned word_bytes) {
  timing_.begin_pass(pass, channel, lane);
  word_bytes_ = word_bytes;
}

void Memory::transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  const Cycle now = cycles_of(sc_core::sc_time_stamp());
  const Cycle accepted = timing_.next_ready(now + cycles_of(delay));
  const Cycle responded = timing_.accept(accepted, payload.get_address() / word_bytes_);
  delay = time_of(responded - now);
  ReadAccepted* taken = nullptr;
  payload.get_extension(taken);
  if (taken) taken->delay = time_of(accepted - now);
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
}

/// Direct access to no data, but to the time that every read takes.
bool Memory::grant_direct(tlm::tlm_generic_payload&, tlm::tlm_dmi& direct) {
  if (!timing_.constant()) return false;
  direct.allow_read();
  direct.set_read_latency(time_of(timing_.timing().latency));
  return true;
}

}  // namespace kagesen::tlm_model
