#include "traces/format/chunk_reader.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <new>
#include <utility>

#include "traces/format/checks.h"
#include "traces/format/columns.h"
#include "traces/format/error.h"

namespace kagesen {
namespace {

constexpr const char* kMend = "copy the file again or capture it anew";

/// Read in steps, so that a lying size takes no more memory than the file has bytes.
constexpr std::size_t kReadStep = 1u << 20;

}  // namespace

ChunkReader::ChunkReader(std::istream& in, std::string name)
    : in_(in), name_(std::move(name)), decompressor_(ZSTD_createDCtx(), ZSTD_freeDCtx) {
  if (!decompressor_) throw std::bad_alloc();
  read(kPreambleBytes);
  if (!std::equal(std::begin(kMagic), std::end(kMagic), buffer_.begin())) {
    throw UserError(name_ + " at byte 0", "is not a trace file", "give a file made by kagesen");
  }
  const auto version = get<std::uint32_t>(buffer_.data() + sizeof kMagic);
  if (version != kFormatVersion) {
    throw UserError(
        name_ + " at byte 8",
        fmt::format("has version {} of the trace format, not {}", version, kFormatVersion),
        "use the kagesen that wrote it, or a newer one");
  }
}

const ChunkReader::Chunk& ChunkReader::next() {
  chunk_offset_ = offset_;
  ++chunks_;
  buffer_.clear();
  read(kChunkHeaderBytes);
  chunk_.type = get<std::uint32_t>(buffer_.data());
  chunk_.records = get<std::uint32_t>(buffer_.data() + 4);
  const auto raw = get<std::uint32_t>(buffer_.data() + 8);
  const auto stored = get<std::uint32_t>(buffer_.data() + 12);
  check_sizes(raw, stored);
  read(stored);
  read(kChecksumBytes);
  const std::size_t covered = kChunkHeaderBytes + stored;
  const auto expected = get<std::uint64_t>(buffer_.data() + covered);
  if (XXH64(buffer_.data(), covered, chunks_ - 1) != expected) refuse("the checksum is wrong");
  chunk_.payload.resize(raw);
  const std::size_t got = ZSTD_decompressDCtx(decompressor_.get(), chunk_.payload.data(), raw,
                                              buffer_.data() + kChunkHeaderBytes, stored);
  if (ZSTD_isError(got)) refuse(fmt::format("cannot be unpacked ({})", ZSTD_getErrorName(got)));
  if (got != raw) refuse(fmt::format("holds {} bytes where it says {}", got, raw));
  raw_bytes_ += raw;
  return chunk_;
}

void ChunkReader::expect_end() {
  if (in_.peek() == std::istream::traits_type::eof()) return;
  throw UserError(fmt::format("{} at byte {}", name_, offset_), "bytes follow the end chunk",
                  kMend);
}

void ChunkReader::refuse(const std::string& what) const {
  throw UserError(fmt::format("{} at byte {}, chunk {}", name_, chunk_offset_, chunks_ - 1), what,
                  kMend);
}

void ChunkReader::read(std::size_t bytes) {
  while (bytes > 0) {
    const std::size_t step = std::min(bytes, kReadStep), start = buffer_.size();
    buffer_.resize(start + step);
    in_.read(reinterpret_cast<char*>(buffer_.data() + start), static_cast<std::streamsize>(step));
    const auto got = static_cast<std::size_t>(in_.gcount());
    offset_ += got;
    bytes -= got;
    if (got < step) {
      const char* what = in_.bad() ? "reading failed" : "the file ends too soon";
      throw UserError(
          fmt::format("{} at byte {}, chunk {}", name_, offset_, chunks_ == 0 ? 0 : chunks_ - 1),
          what, kMend);
    }
  }
}

void ChunkReader::check_sizes(std::uint64_t raw, std::uint64_t stored) const {
  const std::uint32_t records = chunk_.records;
  bool fits = false;
  switch (chunk_.type) {
    case kHeaderChunk:
      fits = records == 1 && raw <= kMaxHeaderBytes;
      break;
    case kCasterChunk:
      fits = records >= 1 && records <= kMaxChunkRecords && raw == caster_columns_bytes(records);
      break;
    case kFragmentChunk:
      fits = records >= 1 && records <= kMaxChunkRecords && raw == fragment_columns_bytes(records);
      break;
    case kEndChunk:
      fits = records == 1 && raw == kEndBytes;
      break;
    default:
      refuse("the chunk's type is unknown");
  }
  if (!fits || stored > max_stored_bytes(raw)) refuse("the chunk's sizes do not agree");
}

}  // namespace kagesen
