/// Damaged and hostile trace files: each is refused in one line that names the place.
#include <xxhash.h>
#include <zstd.h>

#include <cstdlib>
#include <new>

#include "tests/traces/trace_samples.h"
#include "traces/format/header_codec.h"
#include "traces/format/layout.h"

namespace {

std::size_t largest_allocation = 0;

}  // namespace

// Counts what the reader asks for: a lying size must not become memory.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  largest_allocation = std::max(largest_allocation, bytes);
  if (void* memory = std::malloc(bytes)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace kagesen {
namespace {

std::string refusal_of(const std::string& bytes) {
  return refusal([&] { read_bytes(bytes); });
}

std::string preamble() {
  Bytes out(std::begin(kMagic), std::end(kMagic));
  put(out, kFormatVersion);
  return {out.begin(), out.end()};
}

/// A chunk with a right checksum, whatever else it says.
std::string chunk(const char (&type)[5], std::uint32_t records, std::uint32_t raw,
                  const Bytes& payload, std::uint64_t number, const Bytes& padding = {}) {
  Bytes packed(ZSTD_compressBound(payload.size()));
  packed.resize(ZSTD_compress(packed.data(), packed.size(), payload.data(), payload.size(), 1));
  packed.insert(packed.end(), padding.begin(), padding.end());
  Bytes out;
  put(out, chunk_type(type));
  put(out, records);
  put(out, raw);
  put(out, static_cast<std::uint32_t>(packed.size()));
  out.insert(out.end(), packed.begin(), packed.end());
  put(out, static_cast<std::uint64_t>(XXH64(out.data(), out.size(), number)));
  return {out.begin(), out.end()};
}

std::string chunk(const char (&type)[5], std::uint32_t records, const Bytes& payload,
                  std::uint64_t number) {
  return chunk(type, records, static_cast<std::uint32_t>(payload.size()), payload, number);
}

std::string header_chunk(const TraceHeader& header) {
  return chunk("HEAD", 1, encode_header(header), 0);
}

Bytes totals(std::uint64_t casters, std::uint64_t fragments, std::uint64_t chunks) {
  Bytes out;
  put(out, casters);
  put(out, fragments);
  put(out, chunks);
  return out;
}

/// One fragment at the origin of object 0, all columns of order 0.
const Bytes kOneFragment(8 + 22, 0);
const Bytes kOneCaster(11 + 44, 0);

TraceHeader casting_header() {
  TraceHeader header;
  header.objects = {{"cube", 12, true, true}};
  return header;
}

TEST(Damage, TruncationAtEveryByteIsRefusedWithItsOffset) {
  const std::string whole = written(small_trace());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string message = refusal_of(whole.substr(0, size));
    EXPECT_EQ(message.find("file at byte " + std::to_string(size) + ", chunk "), 0u) << message;
    EXPECT_NE(message.find("ends too soon"), std::string::npos) << message;
  }
}

TEST(Damage, EveryBitOfEveryByteCounts) {
  const std::string whole = written(small_trace());
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
      const std::string message = refusal_of(damaged);
      EXPECT_EQ(message.find("file at byte "), 0u) << "bit " << bit << " of byte " << at;
    }
  }
}

TEST(Damage, BytesAfterTheEndAreRefused) {
  EXPECT_NE(refusal_of(written(small_trace()) + '\0').find("follow the end"), std::string::npos);
}

TEST(Damage, AVersionFromTheFutureIsNamed) {
  std::string bytes = written(small_trace());
  bytes[8] = 9;
  const std::string message = refusal_of(bytes);
  EXPECT_NE(message.find("version 9"), std::string::npos) << message;
  EXPECT_NE(message.find("newer"), std::string::npos) << message;
}

TEST(Damage, HandMadeFileIsRead) {
  const std::string bytes = preamble() + header_chunk(casting_header()) +
                            chunk("CAST", 1, kOneCaster, 1) + chunk("FRAG", 1, kOneFragment, 2) +
                            chunk("DONE", 1, totals(1, 1, 3), 3);
  const Trace trace = read_bytes(bytes);
  EXPECT_EQ(trace.all_casters.size(), 1u);
  EXPECT_EQ(trace.all_fragments.size(), 1u);
}

TEST(Damage, AFileOfVersion1IsReadForEver) {
  Trace trace;
  read_trace(KAGESEN_TEST_DATA "/traces/version1.trace", trace);
  EXPECT_TRUE(equal(trace, version_1_trace()));
}

TEST(Damage, ChunksOutOfPlaceAreRefused) {
  const std::string head = preamble() + header_chunk(casting_header());
  EXPECT_NE(refusal_of(preamble() + chunk("CAST", 1, kOneCaster, 0)).find("not the header"),
            std::string::npos);
  EXPECT_NE(refusal_of(head + chunk("FRAG", 1, kOneFragment, 1) + chunk("CAST", 1, kOneCaster, 2))
                .find("casters follow"),
            std::string::npos);
  EXPECT_NE(
      refusal_of(head + chunk("HEAD", 1, encode_header(casting_header()), 1)).find("second header"),
      std::string::npos);
  EXPECT_NE(refusal_of(head + chunk("WHAT", 1, {}, 1)).find("type is unknown"), std::string::npos);
  // A chunk repeated or moved keeps its bytes; the number it is hashed with gives it away.
  const std::string first = chunk("FRAG", 1, kOneFragment, 1);
  EXPECT_NE(refusal_of(head + first + first).find("checksum"), std::string::npos);
}

TEST(Damage, WrongTotalsAreRefused) {
  const std::string head =
      preamble() + header_chunk(casting_header()) + chunk("FRAG", 1, kOneFragment, 1);
  EXPECT_EQ(refusal_of(head + chunk("DONE", 1, totals(0, 1, 2), 2)), "");
  EXPECT_NE(refusal_of(head + chunk("DONE", 1, totals(1, 1, 2), 2)), "");
  EXPECT_NE(refusal_of(head + chunk("DONE", 1, totals(0, 2, 2), 2)), "");
  EXPECT_NE(refusal_of(head + chunk("DONE", 1, totals(0, 1, 3), 2)), "");
}

TEST(Damage, ValuesOutOfRangeBehindARightChecksumAreRefused) {
  const std::string head = preamble() + header_chunk(casting_header());
  Bytes bad = kOneFragment;
  bad[0] = 3;  // order of differences of the first column
  EXPECT_NE(refusal_of(head + chunk("FRAG", 1, bad, 1)).find("order of differences"),
            std::string::npos);
  bad = kOneFragment;
  bad.back() = 16;  // zigzag of 8: a flag that does not exist
  EXPECT_NE(refusal_of(head + chunk("FRAG", 1, bad, 1)).find("fragment 0: flags 8"),
            std::string::npos);
  TraceHeader header = casting_header();
  header.fraction_bits = 30;
  EXPECT_NE(refusal_of(preamble() + header_chunk(header)).find("fraction bits 30"),
            std::string::npos);
  Bytes longer = encode_header(casting_header());
  longer.push_back(0);
  EXPECT_NE(refusal_of(preamble() + chunk("HEAD", 1, longer, 0)).find("follow the header's last"),
            std::string::npos);
}

TEST(Damage, AHeaderCutAnywhereIsRefused) {
  const Bytes whole = encode_header(small_trace().header);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_NE(refusal_of(preamble() + chunk("HEAD", 1, cut, 0)), "") << size;
  }
}

TEST(Damage, LyingSizesTakeNoMemory) {
  const std::string head = preamble() + header_chunk(casting_header());
  const auto lie = [](std::uint32_t records, std::uint32_t raw, std::uint32_t stored) {
    Bytes out;
    put(out, kFragmentChunk);
    put(out, records);
    put(out, raw);
    put(out, stored);
    return std::string(out.begin(), out.end());
  };
  const std::uint32_t most = 0xFFFFFFFF, full = 8 + 22 * 65536;
  Bytes huge_header;
  put(huge_header, chunk_type("HEAD"));
  put(huge_header, 1u);
  put(huge_header, 32u << 20);
  put(huge_header, 32u << 20);
  const std::string lies[] = {head + lie(most, most, most),
                              head + lie(1, 30, most),
                              head + lie(65537, 8 + 22 * 65537, 100),
                              head + lie(0, 8, 20),
                              head + lie(65536, full, full),
                              preamble() + std::string(huge_header.begin(), huge_header.end())};
  for (const std::string& bytes : lies) {
    largest_allocation = 0;
    EXPECT_NE(refusal_of(bytes), "");
    EXPECT_LE(largest_allocation, 2u << 20);
  }
}

TEST(Damage, AChunkOfTooManyRecordsIsRefused) {
  const std::string head = preamble() + header_chunk(casting_header());
  const auto of = [&](std::uint32_t records) {
    return refusal_of(head + chunk("FRAG", records, Bytes(8 + 22 * records, 0), 1) +
                      chunk("DONE", 1, totals(0, records, 2), 2));
  };
  EXPECT_EQ(of(65536), "");
  EXPECT_NE(of(65537).find("sizes do not agree"), std::string::npos);
  EXPECT_NE(of(0).find("sizes do not agree"), std::string::npos);
}

TEST(Damage, AChunkStuffedWithASkippableFrameIsRefused) {
  Bytes padding;
  put(padding, 0x184D2A50u);
  put(padding, 4000u);
  padding.resize(padding.size() + 4000);
  const std::string bytes =
      preamble() + header_chunk(casting_header()) + chunk("FRAG", 1, 30, kOneFragment, 1, padding);
  EXPECT_NE(refusal_of(bytes).find("sizes do not agree"), std::string::npos);
}

TEST(Damage, AChunkThatUnpacksToAnotherSizeIsRefused) {
  const std::string head = preamble() + header_chunk(casting_header());
  const Bytes two(8 + 44, 0), bomb(1u << 24, 0);
  EXPECT_NE(refusal_of(head + chunk("FRAG", 2, 8 + 44, kOneFragment, 1)).find("holds 30 bytes"),
            std::string::npos);
  EXPECT_NE(refusal_of(head + chunk("FRAG", 1, 30, two, 1)).find("unpacked"), std::string::npos);
  const std::string bombed = head + chunk("FRAG", 1, 30, bomb, 1);
  largest_allocation = 0;
  EXPECT_NE(refusal_of(bombed), "");
  EXPECT_LE(largest_allocation, 2u << 20);
}

}  // namespace
}  // namespace kagesen
