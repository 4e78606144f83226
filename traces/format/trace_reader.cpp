#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <vector>

#include "traces/format/checks.h"
#include "traces/format/chunk_reader.h"
#include "traces/format/columns.h"
#include "traces/format/error.h"
#include "traces/format/header_codec.h"
#include "traces/format/layout.h"
#include "traces/format/trace_file.h"

namespace kagesen {
namespace {

std::ifstream open_trace(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    throw UserError(path, fmt::format("cannot be opened ({})", std::strerror(errno)),
                    "give the name of a trace file");
  }
  return in;
}

TraceHeader take_header(ChunkReader& chunks) {
  const ChunkReader::Chunk& chunk = chunks.next();
  if (chunk.type != kHeaderChunk) chunks.refuse("the first chunk is not the header");
  TraceHeader header;
  std::string fault = decode_header(chunk.payload, header);
  if (fault.empty()) fault = header_fault(header);
  if (!fault.empty()) chunks.refuse(fault);
  return header;
}

/// Decodes and checks the records of one chunk into `records`.
template <typename Record, typename Fault>
void take_records(const ChunkReader& chunks, const ChunkReader::Chunk& chunk, const char* kind,
                  std::uint64_t first, const TraceHeader& header, Fault fault_of,
                  std::vector<Record>& records) {
  records.resize(chunk.records);
  if (!decode_columns(chunk.payload, records)) {
    chunks.refuse("a column's order of differences is unknown");
  }
  for (const Record& record : records) {
    const std::string fault = fault_of(record, header);
    if (fault.empty()) continue;
    chunks.refuse(fmt::format("{} {}: {}", kind, first + (&record - records.data()), fault));
  }
}

void check_totals(const ChunkReader& chunks, const Bytes& payload, const TraceTotals& totals) {
  const auto casters = get<std::uint64_t>(payload.data());
  const auto fragments = get<std::uint64_t>(payload.data() + 8);
  const auto before = get<std::uint64_t>(payload.data() + 16);
  if (casters != totals.casters || fragments != totals.fragments || before != chunks.chunks() - 1) {
    chunks.refuse(fmt::format("{} casters and {} fragments were read where {} and {} were written",
                              totals.casters, totals.fragments, casters, fragments));
  }
}

}  // namespace

TraceTotals read_trace(std::istream& in, const std::string& name, TraceSink& sink) {
  ChunkReader chunks(in, name);
  const TraceHeader header = take_header(chunks);
  sink.begin(header);
  TraceTotals totals;
  std::vector<Caster> casters;
  std::vector<Fragment> fragments;
  for (bool ended = false; !ended;) {
    const ChunkReader::Chunk& chunk = chunks.next();
    switch (chunk.type) {
      case kCasterChunk:
        if (totals.fragments != 0) chunks.refuse("casters follow fragments");
        take_records(chunks, chunk, "caster", totals.casters, header, caster_fault, casters);
        totals.casters += casters.size();
        sink.casters(casters.data(), casters.size());
        break;
      case kFragmentChunk:
        take_records(chunks, chunk, "fragment", totals.fragments, header, fragment_fault,
                     fragments);
        totals.fragments += fragments.size();
        sink.fragments(fragments.data(), fragments.size());
        break;
      case kEndChunk:
        check_totals(chunks, chunk.payload, totals);
        chunks.expect_end();
        ended = true;
        break;
      default:
        chunks.refuse("a second header");
    }
  }
  totals.chunks = chunks.chunks();
  totals.file_bytes = chunks.file_bytes();
  totals.raw_bytes = chunks.raw_bytes();
  sink.end();
  return totals;
}

TraceTotals read_trace(const std::string& path, TraceSink& sink) {
  std::ifstream in = open_trace(path);
  return read_trace(in, path, sink);
}

TraceHeader read_trace_header(const std::string& path) {
  std::ifstream in = open_trace(path);
  ChunkReader chunks(in, path);
  return take_header(chunks);
}

bool is_trace_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  char first[sizeof kMagic];
  return in.read(first, sizeof first) && std::memcmp(first, kMagic, sizeof first) == 0;
}

}  // namespace kagesen
