#pragma once
/// What may stand in a trace. Not for use outside this folder; see trace_file.h for the checks
/// that throw.
#include <cstddef>
#include <cstdint>
#include <string>

#include "traces/format/records.h"

namespace kagesen {

inline constexpr std::uint32_t kMaxImageSide = 65536;  ///< pixel numbers have 16 bits
inline constexpr double kMaxScale = 1024;
inline constexpr std::size_t kMaxStringBytes = 65535;
inline constexpr std::size_t kMaxWarnings = 65536;
inline constexpr std::size_t kMaxObjects = 1u << 20;
inline constexpr std::size_t kMaxHeaderBytes = 32u << 20;  ///< as encoded in the file

/// Each returns what is wrong, or an empty string.
std::string scalar_fault(const TraceHeader& header);  ///< all but warnings, objects and total size
std::string header_fault(const TraceHeader& header);
std::string caster_fault(const Caster& caster, const TraceHeader& header);
std::string fragment_fault(const Fragment& fragment, const TraceHeader& header);

}  // namespace kagesen
