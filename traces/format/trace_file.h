#pragma once
/// The trace file (docs/trace-format.md): versioned, chunked, zstd-compressed, checksummed.
#include <cstdint>
#include <istream>
#include <memory>
#include <ostream>
#include <string>

#include "traces/format/records.h"

namespace kagesen {

/// Writes a trace file as a stream in bounded memory.
///
/// The file appears under its name only when end() succeeded (it grows as NAME.part); a writer that
/// is destroyed before end() removes the part. A device or a pipe is written in place, without a
/// part. Throws UserError when the disk is full or unwritable or a value is out of range, and
/// std::logic_error when called in another order than begin, casters, fragments, end.
class TraceWriter : public TraceSink {
 public:
  explicit TraceWriter(const std::string& path);
  ~TraceWriter() override;
  void begin(const TraceHeader& header) override;
  void casters(const Caster* first, std::size_t count) override;
  void fragments(const Fragment* first, std::size_t count) override;
  void end() override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What a trace file held. `raw_bytes` counts the chunks' payloads before compression.
struct TraceTotals {
  std::uint64_t casters = 0, fragments = 0, chunks = 0, file_bytes = 0, raw_bytes = 0;
};

/// Pushes a trace file into `sink`, checking every byte on the way; bounded memory.
///
/// Throws UserError naming the byte offset and chunk at the first damage: truncation, checksum,
/// version, a value out of range (coordinates, map size, object index, ...).
TraceTotals read_trace(const std::string& path, TraceSink& sink);
/// The same from an open stream; `name` is used in messages.
TraceTotals read_trace(std::istream& in, const std::string& name, TraceSink& sink);
/// Reads only the header; the rest of the file is not looked at.
TraceHeader read_trace_header(const std::string& path);
/// True if the file begins with the trace file's magic number; false also if it cannot be read.
bool is_trace_file(const std::string& path);

/// A TraceSink that prints plain text: one line a header field, object, caster and fragment.
class TextDump : public TraceSink {
 public:
  explicit TextDump(std::ostream& out) : out_(out) {}
  void begin(const TraceHeader& header) override;
  void casters(const Caster* first, std::size_t count) override;
  void fragments(const Fragment* first, std::size_t count) override;
  void end() override;

 private:
  std::ostream& out_;
};

/// Reads that text back, from a dump or written by hand. Throws UserError naming the line.
///
/// Where no objects are listed, the records wait in memory until the last has told how many there
/// are; otherwise memory is bounded.
void read_trace_text(std::istream& in, const std::string& name, TraceSink& sink);

/// Throws UserError unless every field of the header is in its range.
void check_header(const TraceHeader& header, const std::string& name);
/// Throws UserError unless the record's values are in range for the header.
void check_caster(const Caster& caster, const TraceHeader& header, const std::string& where);
void check_fragment(const Fragment& fragment, const TraceHeader& header, const std::string& where);

}  // namespace kagesen
