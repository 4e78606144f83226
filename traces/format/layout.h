#pragma once
/// Numbers of the trace file's layout (docs/trace-format.md). Not for use outside this folder.
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kagesen {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::uint8_t kMagic[8] = {0x89, 'K', 'G', 'S', '\r', '\n', 0x1A, '\n'};
inline constexpr std::uint32_t kFormatVersion = 1;
inline constexpr std::size_t kPreambleBytes = 12;     ///< magic and version
inline constexpr std::size_t kChunkHeaderBytes = 16;  ///< type, records, raw size, stored size
inline constexpr std::size_t kChecksumBytes = 8;      ///< XXH64, after the stored bytes

/// Four letters, read as a little-endian integer.
constexpr std::uint32_t chunk_type(const char (&letters)[5]) {
  std::uint32_t type = 0;
  for (int i = 3; i >= 0; --i) type = type << 8 | static_cast<std::uint8_t>(letters[i]);
  return type;
}
inline constexpr std::uint32_t kHeaderChunk = chunk_type("HEAD");
inline constexpr std::uint32_t kCasterChunk = chunk_type("CAST");
inline constexpr std::uint32_t kFragmentChunk = chunk_type("FRAG");
inline constexpr std::uint32_t kEndChunk = chunk_type("DONE");

inline constexpr std::uint32_t kMaxChunkRecords = 65536;
inline constexpr std::size_t kEndBytes = 24;  ///< casters, fragments, chunks before this one

/// The most that `raw` bytes may take once compressed: never less than zstd's own bound.
constexpr std::uint64_t max_stored_bytes(std::uint64_t raw) { return raw + raw / 128 + 512; }

/// Appends an unsigned integer, low byte first.
template <typename Unsigned>
void put(Bytes& out, Unsigned value) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    out.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i)));
  }
}

/// Reads an unsigned integer, low byte first; the caller has checked that the bytes are there.
template <typename Unsigned>
Unsigned get(const std::uint8_t* from) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    value |= static_cast<std::uint64_t>(from[i]) << (8 * i);
  }
  return static_cast<Unsigned>(value);
}

}  // namespace kagesen
