#pragma once
/// Takes a trace file apart into checked chunks. Not for use outside this folder.
#include <zstd.h>

#include <istream>
#include <memory>
#include <string>

#include "traces/format/layout.h"

namespace kagesen {

/// Reads chunk after chunk; every size is checked before memory is taken for it.
class ChunkReader {
 public:
  struct Chunk {
    std::uint32_t type = 0;
    std::uint32_t records = 0;
    Bytes payload;  ///< decompressed
  };

  /// Reads the magic number and the version. `name` is used in messages.
  ChunkReader(std::istream& in, std::string name);

  /// The next chunk; valid until the next call. Throws UserError at any damage.
  const Chunk& next();
  /// Throws UserError if bytes are left.
  void expect_end();
  /// Throws the UserError that says what is wrong with the chunk last read.
  [[noreturn]] void refuse(const std::string& what) const;

  std::uint64_t chunks() const { return chunks_; }        ///< read so far
  std::uint64_t file_bytes() const { return offset_; }    ///< read so far
  std::uint64_t raw_bytes() const { return raw_bytes_; }  ///< of the payloads read so far

 private:
  void read(std::size_t bytes);  ///< appends to buffer_, or refuses a file that ends too soon
  void check_sizes(std::uint64_t raw, std::uint64_t stored) const;

  std::istream& in_;
  std::string name_;
  std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> decompressor_;
  Bytes buffer_;  ///< the chunk as it stands in the file
  Chunk chunk_;
  std::uint64_t offset_ = 0, chunk_offset_ = 0, chunks_ = 0, raw_bytes_ = 0;
};

}  // namespace kagesen
