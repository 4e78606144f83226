#include <fmt/format.h>
#include <xxhash.h>
#include <zstd.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "traces/format/checks.h"
#include "traces/format/columns.h"
#include "traces/format/error.h"
#include "traces/format/header_codec.h"
#include "traces/format/layout.h"
#include "traces/format/output_file.h"
#include "traces/format/trace_file.h"

namespace kagesen {
namespace {

constexpr int kCompressionLevel = 3;

enum class Stage { kNew, kCasters, kFragments, kEnded };

}  // namespace

struct TraceWriter::Impl {
  explicit Impl(const std::string& file_path)
      : path(file_path), file(file_path), compressor(ZSTD_createCCtx(), ZSTD_freeCCtx) {
    if (!compressor) throw std::bad_alloc();
  }

  void write_chunk(std::uint32_t type, std::size_t records, const Bytes& payload) {
    Bytes chunk;
    chunk.reserve(kChunkHeaderBytes + ZSTD_compressBound(payload.size()) + kChecksumBytes);
    chunk.resize(kChunkHeaderBytes + ZSTD_compressBound(payload.size()));
    const std::size_t stored = ZSTD_compressCCtx(compressor.get(), chunk.data() + kChunkHeaderBytes,
                                                 chunk.size() - kChunkHeaderBytes, payload.data(),
                                                 payload.size(), kCompressionLevel);
    if (ZSTD_isError(stored)) throw std::runtime_error(ZSTD_getErrorName(stored));
    Bytes head;
    put(head, type);
    put(head, static_cast<std::uint32_t>(records));
    put(head, static_cast<std::uint32_t>(payload.size()));
    put(head, static_cast<std::uint32_t>(stored));
    std::copy(head.begin(), head.end(), chunk.begin());
    chunk.resize(kChunkHeaderBytes + stored);
    put(chunk, static_cast<std::uint64_t>(XXH64(chunk.data(), chunk.size(), chunks)));
    file.write(chunk.data(), chunk.size());
    ++chunks;
  }

  template <typename Record>
  void flush(std::uint32_t type, std::vector<Record>& pending) {
    if (pending.empty()) return;
    write_chunk(type, pending.size(), encode_columns(pending));
    pending.clear();
  }

  template <typename Record, typename Fault>
  void add(const Record* first, std::size_t count, std::uint32_t type, const char* kind,
           std::vector<Record>& pending, std::uint64_t& total, Fault fault_of) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::string fault = fault_of(first[i], header);
      if (!fault.empty()) {
        throw UserError(fmt::format("{}, {} {}", path, kind, total), fault,
                        "correct the scene or the capture");
      }
      pending.push_back(first[i]);
      ++total;
      if (pending.size() == kMaxChunkRecords) flush(type, pending);
    }
  }

  void enter(Stage next, bool allowed) {
    if (!allowed) throw std::logic_error("a trace is begin, casters, fragments, end in this order");
    stage = next;
  }

  std::string path;
  OutputFile file;
  std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> compressor;
  TraceHeader header;
  Stage stage = Stage::kNew;
  std::vector<Caster> pending_casters;
  std::vector<Fragment> pending_fragments;
  std::uint64_t casters = 0, fragments = 0, chunks = 0;
};

TraceWriter::TraceWriter(const std::string& path) : impl_(std::make_unique<Impl>(path)) {}
TraceWriter::~TraceWriter() = default;

void TraceWriter::begin(const TraceHeader& header) {
  impl_->enter(Stage::kCasters, impl_->stage == Stage::kNew);
  check_header(header, impl_->path);
  impl_->header = header;
  Bytes preamble(std::begin(kMagic), std::end(kMagic));
  put(preamble, kFormatVersion);
  impl_->file.write(preamble.data(), preamble.size());
  impl_->write_chunk(kHeaderChunk, 1, encode_header(header));
}

void TraceWriter::casters(const Caster* first, std::size_t count) {
  impl_->enter(Stage::kCasters, impl_->stage == Stage::kCasters);
  impl_->add(first, count, kCasterChunk, "caster", impl_->pending_casters, impl_->casters,
             caster_fault);
}

void TraceWriter::fragments(const Fragment* first, std::size_t count) {
  impl_->enter(Stage::kFragments,
               impl_->stage == Stage::kCasters || impl_->stage == Stage::kFragments);
  impl_->flush(kCasterChunk, impl_->pending_casters);
  impl_->add(first, count, kFragmentChunk, "fragment", impl_->pending_fragments, impl_->fragments,
             fragment_fault);
}

void TraceWriter::end() {
  impl_->enter(Stage::kEnded, impl_->stage == Stage::kCasters || impl_->stage == Stage::kFragments);
  impl_->flush(kCasterChunk, impl_->pending_casters);
  impl_->flush(kFragmentChunk, impl_->pending_fragments);
  Bytes totals;
  put(totals, impl_->casters);
  put(totals, impl_->fragments);
  put(totals, impl_->chunks);
  impl_->write_chunk(kEndChunk, 1, totals);
  impl_->file.commit();
}

}  // namespace kagesen
