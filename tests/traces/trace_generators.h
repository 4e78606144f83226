#pragma once
/// Random traces, for RapidCheck.
#include <rapidcheck.h>

#include <string>
#include <vector>

#include "traces/format/records.h"

namespace kagesen {

inline std::uint32_t any_below(std::uint64_t end) {
  return *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(end));
}

inline std::uint32_t any_between(std::uint32_t low, std::uint32_t high) {
  return *rc::gen::inRange<std::uint32_t>(low, high + 1);
}

/// Any bytes, blanks and backslashes among them.
inline std::string any_string() {
  const auto bytes = *rc::gen::resize(
      12, rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>()));
  const auto marks = *rc::gen::container<std::string>(*rc::gen::inRange<std::size_t>(0, 4),
                                                      rc::gen::element(' ', '#', '\\', '\n', 'x'));
  return marks + std::string(bytes.begin(), bytes.end()) + marks;
}

inline double any_scale() {
  const double share = any_below(1u << 31) / static_cast<double>(1u << 31);
  return 1 + share * *rc::gen::element(0.0, 1.0, 1023.0);
}

inline LightPoint any_point() {
  const auto side =
      rc::gen::oneOf(rc::gen::inRange<std::int32_t>(kCoordinateMin, kCoordinateMax + 1),
                     rc::gen::element(kCoordinateMin, kCoordinateMax, 0, -1));
  return {*side, *side, any_between(0, kDepthMax)};
}

inline TraceHeader any_header() {
  TraceHeader header;
  header.map_width = any_between(1, kMaxMapSide);
  header.map_height = any_between(1, kMaxMapSide);
  header.fraction_bits = any_between(kMinFractionBits, kMaxFractionBits);
  header.scale_x = any_scale();
  header.scale_y = any_scale();
  if (*rc::gen::arbitrary<bool>()) {
    header.image_width = any_between(1, 65536);
    header.image_height = any_between(1, 65536);
  }
  header.mode = static_cast<FragmentMode>(any_below(3));
  header.source = any_string();
  if (*rc::gen::arbitrary<bool>()) {
    header.source_sha256 =
        *rc::gen::container<std::string>(64, rc::gen::element('0', '9', 'a', 'f'));
  }
  header.light = any_string();
  header.seed = *rc::gen::arbitrary<std::uint64_t>();
  for (auto count = any_below(3); count > 0; --count) header.warnings.push_back(any_string());
  // Object 0 casts, so that casters have something to belong to.
  header.objects.push_back({any_string(), any_below(1000), *rc::gen::arbitrary<bool>(), true});
  for (auto count = any_below(4); count > 0; --count) {
    header.objects.push_back({any_string(), *rc::gen::arbitrary<std::uint32_t>(),
                              *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>()});
  }
  return header;
}

inline Caster any_caster(const TraceHeader& header) {
  Caster caster{{any_point(), any_point(), any_point()}, 0, *rc::gen::arbitrary<std::uint32_t>()};
  const auto object = any_below(header.objects.size());
  if (header.objects[object].caster) caster.object = object;
  return caster;
}

inline Fragment any_fragment(const TraceHeader& header) {
  Fragment fragment;
  fragment.position = any_point();
  fragment.object = any_below(header.objects.size());
  fragment.pixel_x =
      static_cast<std::uint16_t>(any_below(header.image_width != 0 ? header.image_width : 65536));
  fragment.pixel_y =
      static_cast<std::uint16_t>(any_below(header.image_height != 0 ? header.image_height : 65536));
  fragment.shade = static_cast<std::uint8_t>(any_below(256));
  fragment.flags = static_cast<std::uint8_t>(any_below(8));
  return fragment;
}

inline Trace any_trace() {
  Trace trace;
  trace.header = any_header();
  for (auto count = any_below(6); count > 0; --count) {
    trace.all_casters.push_back(any_caster(trace.header));
  }
  for (auto count = any_below(10); count > 0; --count) {
    trace.all_fragments.push_back(any_fragment(trace.header));
  }
  return trace;
}

}  // namespace kagesen
