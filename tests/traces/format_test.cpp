/// The trace file: what is written comes back, and what cannot be written leaves nothing behind.
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <future>
#include <random>
#include <stdexcept>

#include "tests/traces/trace_generators.h"
#include "tests/traces/trace_samples.h"

namespace kagesen {
namespace {

/// Hands the records over in portions of random size, after an empty one.
template <typename Record, typename Take>
void in_portions(const std::vector<Record>& records, Take take) {
  take(records.data(), 0);
  std::size_t done = 0;
  while (done < records.size()) {
    const std::size_t count = 1 + *rc::gen::inRange<std::size_t>(0, records.size() - done);
    take(records.data() + done, count);
    done += count;
  }
}

/// More records than two chunks hold: a wavy surface, with a jump now and then.
Trace long_trace() {
  Trace trace;
  trace.header = small_trace().header;
  std::minstd_rand engine(7);
  const auto random = [&] { return static_cast<std::uint32_t>(engine()); };
  for (int i = 0; i < 140000; ++i) {
    const auto jump = static_cast<std::int32_t>(random() % 1000 == 0 ? random() % 100000 : 0);
    const LightPoint point{i * 700 + jump, -i * 300 - jump, static_cast<std::uint32_t>(i * 100)};
    trace.all_casters.push_back({{point, {point.y, point.x, 5}, {jump, 0, 1}}, 1, random()});
    trace.all_fragments.push_back({point, random() % 2, static_cast<std::uint16_t>(i % 640),
                                   static_cast<std::uint16_t>(i / 640),
                                   static_cast<std::uint8_t>(i), 2});
  }
  return trace;
}

TEST(TraceFile, AnyTraceComesBackWhateverThePortions) {
  const TestFolder folder;
  EXPECT_TRUE(rc::check([&] {
    const Trace trace = any_trace();
    {
      TraceWriter writer(folder / "t");
      writer.begin(trace.header);
      in_portions(trace.all_casters, [&](auto* first, auto n) { writer.casters(first, n); });
      in_portions(trace.all_fragments, [&](auto* first, auto n) { writer.fragments(first, n); });
      writer.end();
    }
    Trace back;
    const TraceTotals totals = read_trace(folder / "t", back);
    RC_ASSERT(equal(back, trace));
    RC_ASSERT(equal(read_trace_header(folder / "t"), trace.header));
    RC_ASSERT(totals.casters == trace.all_casters.size());
    RC_ASSERT(totals.fragments == trace.all_fragments.size());
    RC_ASSERT(totals.file_bytes == std::filesystem::file_size(folder / "t"));
  }));
}

TEST(TraceFile, ManyChunksComeBackInOrder) {
  const TestFolder folder;
  const Trace trace = long_trace();
  TraceWriter writer(folder / "t");
  push(trace, writer);
  Trace back;
  const TraceTotals totals = read_trace(folder / "t", back);
  EXPECT_TRUE(equal(back, trace));
  EXPECT_EQ(totals.chunks, 1u + 3 + 3 + 1);
}

TEST(TraceFile, ReaderNeverHandsOverMoreThanAChunk) {
  struct Largest : TraceSink {
    std::size_t records = 0;
    void begin(const TraceHeader&) override {}
    void casters(const Caster*, std::size_t n) override { records = std::max(records, n); }
    void fragments(const Fragment*, std::size_t n) override { records = std::max(records, n); }
    void end() override {}
  } sink;
  std::istringstream in(written(long_trace()));
  read_trace(in, "file", sink);
  EXPECT_EQ(sink.records, 65536u);
}

TEST(TraceFile, SmoothSurfaceTakesFewBytes) {
  const Trace trace = long_trace();
  Trace fragments = trace;
  fragments.all_casters.clear();
  EXPECT_LT(written(fragments).size(), trace.all_fragments.size() * 2);
}

TEST(TraceFile, IsKnownByItsFirstBytes) {
  const TestFolder folder;
  TraceWriter writer(folder / "t");
  push(small_trace(), writer);
  std::ofstream(folder / "other") << "map 1 1\n";
  EXPECT_TRUE(is_trace_file(folder / "t"));
  EXPECT_FALSE(is_trace_file(folder / "other"));
  EXPECT_FALSE(is_trace_file(folder / "missing"));
}

TEST(TraceFile, MissingFileOrFolderIsRefused) {
  const TestFolder folder;
  Trace trace;
  EXPECT_NE(refusal([&] { read_trace(folder / "missing", trace); }).find("cannot be opened"),
            std::string::npos);
  EXPECT_NE(refusal([&] { read_trace(folder / ".", trace); }), "");
  EXPECT_NE(refusal([&] { TraceWriter(folder / "no/t"); }).find("make its folder"),
            std::string::npos);
  EXPECT_NE(refusal([&] { TraceWriter(folder / "."); }).find("is a folder"), std::string::npos);
}

TEST(TraceWriter, AppearsOnlyWhenWhole) {
  const TestFolder folder;
  TraceWriter writer(folder / "t");
  writer.begin(small_trace().header);
  EXPECT_TRUE(std::filesystem::exists(folder / "t.part"));
  EXPECT_FALSE(std::filesystem::exists(folder / "t"));
  writer.end();
  EXPECT_FALSE(std::filesystem::exists(folder / "t.part"));
  EXPECT_TRUE(std::filesystem::exists(folder / "t"));
}

TEST(TraceWriter, LeavesNothingWhenDropped) {
  const TestFolder folder;
  {
    const Trace trace = long_trace();
    TraceWriter writer(folder / "t");
    writer.begin(trace.header);
    writer.casters(trace.all_casters.data(), trace.all_casters.size());
  }
  EXPECT_TRUE(folder.empty());
}

TEST(TraceWriter, KeepsTheOldFileWhenDropped) {
  const TestFolder folder;
  std::ofstream(folder / "t") << "old";
  { TraceWriter(folder / "t").begin(small_trace().header); }
  EXPECT_EQ(file_bytes(folder / "t"), "old");
}

TEST(TraceWriter, ReplacesWhatALinkPointsTo) {
  const TestFolder folder;
  std::ofstream(folder / "t") << "old";
  std::filesystem::create_symlink(folder / "t", folder / "link");
  TraceWriter writer(folder / "link");
  push(small_trace(), writer);
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_TRUE(is_trace_file(folder / "t"));
}

TEST(TraceWriter, LeavesNothingOnAFullDisk) {
  const TestFolder folder;
  const Trace trace = long_trace();
  struct rlimit before;
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const struct rlimit small = {10000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = refusal([&] {
    TraceWriter writer(folder / "t");
    try {
      push(trace, writer);
    } catch (const UserError&) {
      EXPECT_TRUE(folder.empty());
      throw;
    }
  });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(message.find((folder / "t") + ": writing failed (File too large)"), 0u) << message;
}

TEST(TraceWriter, WritesDevicesAndPipesInPlace) {
  const TestFolder folder;
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  auto received = std::async(std::launch::async, [&] { return file_bytes(pipe); });
  {
    TraceWriter writer(pipe);
    push(small_trace(), writer);
  }
  // With the pipe replaced its reader waits for ever, and so would every way out but this one.
  if (!std::filesystem::is_fifo(pipe)) std::abort();
  EXPECT_TRUE(equal(read_bytes(received.get()), small_trace()));

  // Only now: a writer that renamed would replace the device of the whole machine.
  const std::string message = refusal([] {
    TraceWriter writer("/dev/full");
    push(small_trace(), writer);
  });
  EXPECT_EQ(message.find("/dev/full: writing failed (No space left"), 0u) << message;
  EXPECT_NE(message.find("free some space"), std::string::npos) << message;
}

TEST(TraceWriter, RefusesRecordsOutOfRange) {
  const TestFolder folder;
  const Trace good = small_trace();
  const auto writes = [&](const Trace& trace) {
    return refusal([&] {
      TraceWriter writer(folder / "t");
      push(trace, writer);
    });
  };
  Trace bad = good;
  bad.all_casters[1].vertex[2].x = kCoordinateMax + 1;
  EXPECT_NE(writes(bad).find("caster 1: x 134217728 is out of range"), std::string::npos);
  bad = good;
  bad.all_casters[0].object = 0;
  EXPECT_NE(writes(bad).find("is a receiver"), std::string::npos);
  bad = good;
  bad.all_fragments[2].object = 2;
  EXPECT_NE(writes(bad).find("fragment 2: object 2 does not exist"), std::string::npos);
  bad = good;
  bad.all_fragments[0].position.z = kDepthMax + 1;
  EXPECT_NE(writes(bad).find("depth"), std::string::npos);
  bad = good;
  bad.all_fragments[0].pixel_x = 640;
  EXPECT_NE(writes(bad).find("outside the image"), std::string::npos);
  bad = good;
  bad.all_fragments[0].flags = 8;
  EXPECT_NE(writes(bad).find("flags"), std::string::npos);
  EXPECT_TRUE(folder.empty());
}

TEST(TraceWriter, RefusesCallsOutOfOrder) {
  const TestFolder folder;
  TraceWriter writer(folder / "t");
  const Trace trace = small_trace();
  EXPECT_THROW(writer.casters(trace.all_casters.data(), 1), std::logic_error);
  writer.begin(trace.header);
  writer.fragments(trace.all_fragments.data(), 1);
  EXPECT_THROW(writer.casters(trace.all_casters.data(), 1), std::logic_error);
}

TEST(CheckHeader, RefusesEveryFieldOutOfRange) {
  const auto fault = [](auto change) {
    TraceHeader header = small_trace().header;
    change(header);
    return refusal([&] { check_header(header, "here"); });
  };
  EXPECT_EQ(fault([](auto&) {}), "");
  EXPECT_EQ(fault([](auto& h) { h.map_width = 0; }),
            "here: map width 0 is out of range (1 to 4096); correct the header");
  EXPECT_NE(fault([](auto& h) { h.map_height = kMaxMapSide + 1; }), "");
  EXPECT_NE(fault([](auto& h) { h.fraction_bits = 15; }), "");
  EXPECT_NE(fault([](auto& h) { h.fraction_bits = 27; }), "");
  EXPECT_NE(fault([](auto& h) { h.scale_x = 0.999; }), "");
  EXPECT_NE(fault([](auto& h) { h.scale_y = std::nan(""); }), "");
  EXPECT_NE(fault([](auto& h) { h.scale_y = 1025; }), "");
  EXPECT_NE(fault([](auto& h) { h.image_width = 0; }), "");
  EXPECT_NE(fault([](auto& h) { h.image_height = 65537; }), "");
  EXPECT_NE(fault([](auto& h) { h.mode = static_cast<FragmentMode>(3); }), "");
  EXPECT_NE(fault([](auto& h) { h.source_sha256 = "12"; }), "");
  EXPECT_NE(fault([](auto& h) { h.source = std::string(65536, 'x'); }), "");
  EXPECT_NE(fault([](auto& h) { h.objects[0].name = std::string(65536, 'x'); }), "");
  EXPECT_NE(fault([](auto& h) { h.warnings.assign(65537, ""); }), "");
  EXPECT_NE(fault([](auto& h) { h.warnings.assign(600, std::string(65535, 'x')); }), "");
  EXPECT_NE(fault([](auto& h) { h.objects.resize((1u << 20) + 1); }), "");
}

}  // namespace
}  // namespace kagesen
