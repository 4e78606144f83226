#include "sim/systemc/common/memory_port.h"

#include <stdexcept>
#include <string>

namespace kagesen::tlm_model {

MemoryPort::MemoryPort(const sc_core::sc_module_name& name) : sc_module(name), socket("socket") {
  socket.register_invalidate_direct_mem_ptr(this, &MemoryPort::invalidate);
  payload_.set_extension(&accepted_);
}

MemoryPort::~MemoryPort() { payload_.clear_extension(&accepted_); }

void MemoryPort::begin_pass(unsigned word_bytes) {
  word_bytes_ = word_bytes;
  data_.resize(word_bytes);
  latency_ = 0;
  reads_ = 0;
  payload_.set_command(tlm::TLM_READ_COMMAND);
  payload_.set_address(0);
  tlm::tlm_dmi direct;
  if (socket->get_direct_mem_ptr(payload_, direct) && direct.is_read_allowed()) {
    latency_ = cycles_of(direct.get_read_latency());
  }
}

void MemoryPort::invalidate(sc_dt::uint64, sc_dt::uint64) { latency_ = 0; }

MemoryPort::Read MemoryPort::transport(Cycle asked, std::uint64_t word) {
  const Cycle now = cycles_of(sc_core::sc_time_stamp());
  sc_core::sc_time delay = time_of(asked - now);
  accepted_.delay = delay;
  payload_.set_command(tlm::TLM_READ_COMMAND);
  payload_.set_address(word * word_bytes_);
  payload_.set_data_ptr(data_.data());
  payload_.set_data_length(word_bytes_);
  payload_.set_streaming_width(word_bytes_);
  payload_.set_byte_enable_ptr(nullptr);
  payload_.set_dmi_allowed(false);
  payload_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  socket->b_transport(payload_, delay);
  if (payload_.is_response_error()) {
    throw std::runtime_error(std::string(name()) + ": " + payload_.get_response_string());
  }
  return {now + cycles_of(accepted_.delay), now + cycles_of(delay)};
}

void MemoryPort::note(Cycle asked, std::uint64_t word, const Read& read) {
  if (read.accepted > asked) timeline_->work(track_, "waits", word, asked, read.accepted);
  timeline_->work(track_, "read", word, read.accepted, read.responded);
}

}  // namespace kagesen::tlm_model
