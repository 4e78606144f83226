#pragma once
/// What the fuzzer and the replay of its corpus do with an input.
#include <xxhash.h>
#include <zstd.h>

#include <cstdlib>
#include <sstream>
#include <string>

#include "traces/format/error.h"
#include "traces/format/layout.h"
#include "traces/format/trace_file.h"

namespace kagesen {

/// Begins an input that `assembled` turns into a trace file.
inline const std::string kPartsMark = "PARTS";

/// Packs and seals parts, since no mutation finds a checksum or a zstd frame by itself.
///
/// After the mark: chunks of type (4 bytes), records, size (both 2 bytes) and so many bytes.
inline std::string assembled(const std::string& input) {
  Bytes out(std::begin(kMagic), std::end(kMagic));
  put(out, kFormatVersion);
  std::size_t at = kPartsMark.size();
  for (std::uint64_t number = 0; at + 8 <= input.size(); ++number) {
    const auto* part = reinterpret_cast<const std::uint8_t*>(input.data()) + at;
    const std::size_t size =
        std::min<std::size_t>(get<std::uint16_t>(part + 6), input.size() - at - 8);
    Bytes packed(ZSTD_compressBound(size));
    packed.resize(ZSTD_compress(packed.data(), packed.size(), part + 8, size, 1));
    const std::size_t start = out.size();
    out.insert(out.end(), part, part + 4);
    put(out, static_cast<std::uint32_t>(get<std::uint16_t>(part + 4)));
    put(out, static_cast<std::uint32_t>(size));
    put(out, static_cast<std::uint32_t>(packed.size()));
    out.insert(out.end(), packed.begin(), packed.end());
    put(out, static_cast<std::uint64_t>(XXH64(out.data() + start, out.size() - start, number)));
    at += 8 + size;
  }
  return {out.begin(), out.end()};
}

inline std::string text_of(const Trace& trace) {
  std::ostringstream out;
  TextDump dump(out);
  dump.begin(trace.header);
  dump.casters(trace.all_casters.data(), trace.all_casters.size());
  dump.fragments(trace.all_fragments.data(), trace.all_fragments.size());
  dump.end();
  return out.str();
}

/// Reads the input with the reader its first bytes call for. True if it was accepted.
///
/// Anything else than acceptance or a UserError of one line is a crash; so is an accepted trace
/// that its own text does not give back.
inline bool exercise(const std::string& input) {
  const bool parts = input.compare(0, kPartsMark.size(), kPartsMark) == 0;
  const bool binary = !input.empty() && static_cast<std::uint8_t>(input[0]) == kMagic[0];
  Trace trace;
  try {
    std::istringstream in(parts ? assembled(input) : input);
    if (parts || binary) {
      read_trace(in, "input", trace);
    } else {
      read_trace_text(in, "input", trace);
    }
  } catch (const UserError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    return false;
  }
  const std::string text = text_of(trace);
  std::istringstream in(text);
  Trace back;
  read_trace_text(in, "text", back);
  if (text_of(back) != text) std::abort();
  return true;
}

}  // namespace kagesen
