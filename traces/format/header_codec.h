#pragma once
/// The header chunk's payload (docs/trace-format.md). Not for use outside this folder.
#include <cstddef>

#include "traces/format/layout.h"
#include "traces/format/records.h"

namespace kagesen {

/// Of encode_header's result, without making it.
std::size_t encoded_header_bytes(const TraceHeader& header);
Bytes encode_header(const TraceHeader& header);

/// Returns what is wrong, or an empty string and the header. Ranges are header_fault's to check.
std::string decode_header(const Bytes& payload, TraceHeader& header);

}  // namespace kagesen
