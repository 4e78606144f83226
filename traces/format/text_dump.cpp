#include <fmt/format.h>

#include <iterator>
#include <string_view>

#include "traces/format/error.h"
#include "traces/format/text_form.h"
#include "traces/format/text_string.h"
#include "traces/format/trace_file.h"

namespace kagesen {
namespace {

void check_written(const std::ostream& out) {
  if (out) return;
  throw UserError("text of the trace", "writing failed", "free some space or choose another place");
}

void print(std::ostream& out, const fmt::memory_buffer& text) {
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  check_written(out);
}

void add_string(fmt::memory_buffer& text, std::string_view key, const std::string& value) {
  auto to = std::back_inserter(text);
  if (!value.empty()) fmt::format_to(to, "{} {}\n", key, escape_text(value));
}

}  // namespace

void TextDump::begin(const TraceHeader& header) {
  check_header(header, "text of the trace");
  fmt::memory_buffer text;
  auto to = std::back_inserter(text);
  fmt::format_to(to, "kagesen-trace {}\n", kTextVersion);
  fmt::format_to(to, "map {} {}\n", header.map_width, header.map_height);
  fmt::format_to(to, "fraction_bits {}\n", header.fraction_bits);
  fmt::format_to(to, "scale {} {}\n", header.scale_x, header.scale_y);
  fmt::format_to(to, "image {} {}\n", header.image_width, header.image_height);
  fmt::format_to(to, "mode {}\n", kModeNames[static_cast<std::size_t>(header.mode)]);
  add_string(text, "source", header.source);
  add_string(text, "source_sha256", header.source_sha256);
  add_string(text, "light", header.light);
  fmt::format_to(to, "seed {}\n", header.seed);
  for (const std::string& warning : header.warnings) {
    fmt::format_to(to, "warning {}\n", escape_text(warning));
  }
  for (std::size_t i = 0; i < header.objects.size(); ++i) {
    const ObjectInfo& object = header.objects[i];
    fmt::format_to(to, "object {} {} {} {} {}\n", i, object.closed ? "closed" : "open",
                   object.caster ? "caster" : "receiver", object.triangles,
                   escape_text(object.name));
  }
  print(out_, text);
}

void TextDump::casters(const Caster* first, std::size_t count) {
  fmt::memory_buffer text;
  auto to = std::back_inserter(text);
  for (const Caster* caster = first; caster != first + count; ++caster) {
    fmt::format_to(to, "caster");
    for (const LightPoint& v : caster->vertex) fmt::format_to(to, " {} {} {}", v.x, v.y, v.z);
    fmt::format_to(to, " {} {}\n", caster->object, caster->polygon);
  }
  print(out_, text);
}

void TextDump::fragments(const Fragment* first, std::size_t count) {
  fmt::memory_buffer text;
  auto to = std::back_inserter(text);
  for (const Fragment* f = first; f != first + count; ++f) {
    fmt::format_to(to, "fragment {} {} {} {} {} {} {} {}\n", f->pixel_x, f->pixel_y, f->position.x,
                   f->position.y, f->position.z, f->object, f->shade, f->flags);
  }
  print(out_, text);
}

void TextDump::end() {
  out_ << "end\n" << std::flush;
  check_written(out_);
}

}  // namespace kagesen
