#pragma once
/// Traces for the tests of the trace file, and ways to compare and damage them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "traces/format/error.h"
#include "traces/format/trace_file.h"

namespace kagesen {

/// A folder of its own for each test, gone when the test ends.
class TestFolder {
 public:
  TestFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "kagesen_XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = pattern;
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  bool empty() const { return std::filesystem::is_empty(path_); }

 private:
  std::filesystem::path path_;
};

inline void push(const Trace& trace, TraceSink& sink) {
  sink.begin(trace.header);
  sink.casters(trace.all_casters.data(), trace.all_casters.size());
  sink.fragments(trace.all_fragments.data(), trace.all_fragments.size());
  sink.end();
}

inline std::string file_bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::string written(const Trace& trace) {
  const TestFolder folder;
  TraceWriter writer(folder / "t");
  push(trace, writer);
  return file_bytes(folder / "t");
}

inline std::string dumped(const Trace& trace) {
  std::ostringstream out;
  TextDump dump(out);
  push(trace, dump);
  return out.str();
}

inline Trace read_bytes(const std::string& bytes) {
  std::istringstream in(bytes);
  Trace trace;
  read_trace(in, "file", trace);
  return trace;
}

inline Trace read_text(const std::string& text) {
  std::istringstream in(text);
  Trace trace;
  read_trace_text(in, "text", trace);
  return trace;
}

/// The message of the UserError that `action` throws; empty if it throws none.
template <typename Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const UserError& error) {
    return error.what();
  }
  return {};
}

inline bool equal(const LightPoint& a, const LightPoint& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

inline bool equal(const Caster& a, const Caster& b) {
  return equal(a.vertex[0], b.vertex[0]) && equal(a.vertex[1], b.vertex[1]) &&
         equal(a.vertex[2], b.vertex[2]) && a.object == b.object && a.polygon == b.polygon;
}

inline bool equal(const Fragment& a, const Fragment& b) {
  return equal(a.position, b.position) && a.object == b.object && a.pixel_x == b.pixel_x &&
         a.pixel_y == b.pixel_y && a.shade == b.shade && a.flags == b.flags;
}

inline bool equal(const ObjectInfo& a, const ObjectInfo& b) {
  return a.name == b.name && a.triangles == b.triangles && a.closed == b.closed &&
         a.caster == b.caster;
}

inline bool equal(const std::string& a, const std::string& b) { return a == b; }

template <typename Item>
bool equal(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Item& x, const Item& y) { return equal(x, y); });
}

inline bool equal(const TraceHeader& a, const TraceHeader& b) {
  return a.map_width == b.map_width && a.map_height == b.map_height &&
         a.fraction_bits == b.fraction_bits && a.scale_x == b.scale_x && a.scale_y == b.scale_y &&
         a.image_width == b.image_width && a.image_height == b.image_height && a.mode == b.mode &&
         a.source == b.source && a.source_sha256 == b.source_sha256 && a.light == b.light &&
         a.seed == b.seed && equal(a.warnings, b.warnings) && equal(a.objects, b.objects);
}

inline bool equal(const Trace& a, const Trace& b) {
  return equal(a.header, b.header) && equal(a.all_casters, b.all_casters) &&
         equal(a.all_fragments, b.all_fragments);
}

/// A few records with every field away from its default.
inline Trace small_trace() {
  Trace trace;
  TraceHeader& header = trace.header;
  header.map_width = 512;
  header.map_height = 256;
  header.fraction_bits = 20;
  header.scale_x = 1.5;
  header.scale_y = 1.0 / 3 + 1;
  header.image_width = 640;
  header.image_height = 480;
  header.mode = FragmentMode::kEarlyZ;
  header.source = "cube.obj";
  header.source_sha256 = std::string(64, 'a');
  header.light = "directional";
  header.seed = ~std::uint64_t{0};
  header.warnings = {"2 triangles of zero area dropped", ""};
  header.objects = {{"ground", 2, false, false}, {" a#b\\c\n", 12, true, true}};
  trace.all_casters = {
      {{{kCoordinateMin, 0, 0}, {kCoordinateMax, 5, kDepthMax}, {7, -9, 100}}, 1, 3},
      {{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, 1, ~0u}};
  trace.all_fragments = {{{-1, 1, 5}, 0, 639, 479, 128, Fragment::kVisible},
                         {{kCoordinateMax, kCoordinateMin, 0}, 1, 0, 0, 0, 7},
                         {{0, 0, kDepthMax}, 0, 3, 4, 255, 0}};
  return trace;
}

/// What tests/data/traces/version1.trace holds: columns best stored with each order of differences.
inline Trace version_1_trace() {
  Trace trace = small_trace();
  for (int i = 0; i < 200; ++i) {
    const auto u = static_cast<std::uint32_t>(i);
    const LightPoint point{i * i * 5 - 70000, i * i * i - i * 40000, u * u};
    trace.all_casters.push_back({{point, {point.y, -point.x, u}, {i % 7, i % 2, 9}}, 1, u});
    trace.all_fragments.push_back({point, u / 100, static_cast<std::uint16_t>(u % 64),
                                   static_cast<std::uint16_t>(u / 64),
                                   static_cast<std::uint8_t>(u * 37), Fragment::kVisible});
  }
  return trace;
}

}  // namespace kagesen
