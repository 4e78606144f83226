#include "testbench/verilator/package.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "model/golden.h"
#include "model/unit/winding/plane.h"

namespace kagesen {
namespace {

std::map<std::string, std::string> values(const UnitConfig& c) {
  const PackageWidths widths(c);
  const unit::winding::Widths winding(c, kMaxFractionBits);
  const std::int64_t position =
      c.position_bits == 0 ? kMaxFractionBits : std::max(c.position_bits, c.fraction_bits);
  std::map<std::string, std::string> out;
  for (const char* key : {"fraction_bits", "slope_bits", "depth_bits", "id_bits", "polygon_id_bits",
                          "lines_per_entry", "end_guard_bits", "plane_step_bits", "corner_bits",
                          "segments_per_record", "lanes", "fragment_slots", "visit_fifo_depth",
                          "texel_lines", "record_lines"}) {
    out[key] = get_field(c, key);
  }
  out["gradient_bits"] = std::to_string(winding.gradient_bits);
  out["position_bits_or_26"] = std::to_string(position);
  out["map_bits"] = std::to_string(widths.map_bits);
  out["record_addr_bits"] = std::to_string(widths.record_addr_bits);
  out["GENERATED"] = "// Generated from shadow_pkg.sv.in by `kagesen rtl`; do not edit.";
  return out;
}

}  // namespace

PackageWidths::PackageWidths(const UnitConfig& c)
    : map_bits(kagesen::map_bits(c)),
      record_addr_bits(kagesen::record_addr_bits(c)) {
  if (c.profile == Profile::kPaper) {
    texel_bits = static_cast<int>(3 + c.id_bits + c.depth_bits);
    return;
  }
  const unit::winding::Widths w(c, kMaxFractionBits);
  const int threshold = w.base_bits() + 2 * w.gradient_code_bits();
  const int list = 2 + 32 + record_addr_bits;  // texel_list_t
  texel_bits = static_cast<int>(2 + c.id_bits) + std::max(threshold, list);
}

const std::string& embedded_source(const std::string& path) {
  for (const SourceText& source : embedded_sources()) {
    if (source.path == path) return source.text;
  }
  throw std::logic_error("no embedded source " + path);
}

std::string profile_folder(Profile profile) {
  return profile == Profile::kWinding ? "rtl/winding" : "rtl/paper";
}

std::vector<SourceText> rtl_sources(Profile profile) {
  const std::string folder = profile_folder(profile) + "/";
  std::vector<SourceText> out;
  for (const SourceText& source : embedded_sources()) {
    const bool common = source.path.compare(0, 11, "rtl/common/") == 0;
    const bool own = source.path.compare(0, folder.size(), folder) == 0 &&
                     source.path.find("shadow_pkg.sv") == std::string::npos;
    if (common || own) out.push_back(source);
  }
  return out;
}

std::string shadow_package(const UnitConfig& config) {
  const std::string& text = embedded_source(profile_folder(config.profile) + "/shadow_pkg.sv.in");
  const std::map<std::string, std::string> known = values(config);
  std::string out;
  std::size_t at = 0;
  for (std::size_t open; (open = text.find('@', at)) != std::string::npos;) {
    const std::size_t close = text.find('@', open + 1);
    if (close == std::string::npos) throw std::logic_error("shadow_pkg.sv.in: @ without an end");
    out.append(text, at, open - at);
    out += known.at(text.substr(open + 1, close - open - 1));
    at = close + 1;
  }
  return out.append(text, at, std::string::npos);
}

}  // namespace kagesen
