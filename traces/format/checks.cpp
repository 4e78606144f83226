#include "traces/format/checks.h"

#include <fmt/format.h>

#include <string_view>

#include "traces/format/error.h"
#include "traces/format/header_codec.h"
#include "traces/format/trace_file.h"

namespace kagesen {
namespace {

template <typename Number>
std::string range_fault(std::string_view what, Number value, Number low, Number high) {
  if (value >= low && value <= high) return {};
  return fmt::format("{} {} is out of range ({} to {})", what, value, low, high);
}

std::string length_fault(std::string_view what, std::size_t bytes) {
  if (bytes <= kMaxStringBytes) return {};
  return fmt::format("{} is {} bytes long, more than {}", what, bytes, kMaxStringBytes);
}

bool is_sha256(const std::string& text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string image_fault(const TraceHeader& header) {
  if ((header.image_width == 0) != (header.image_height == 0)) {
    return fmt::format("image {} x {} has no pixels", header.image_width, header.image_height);
  }
  std::string fault = range_fault("image width", header.image_width, 0u, kMaxImageSide);
  if (fault.empty()) fault = range_fault("image height", header.image_height, 0u, kMaxImageSide);
  return fault;
}

std::string point_fault(const LightPoint& point) {
  std::string fault = range_fault("x", point.x, kCoordinateMin, kCoordinateMax);
  if (fault.empty()) fault = range_fault("y", point.y, kCoordinateMin, kCoordinateMax);
  if (fault.empty()) fault = range_fault("depth", point.z, 0u, kDepthMax);
  return fault;
}

std::string object_fault(std::uint32_t object, const TraceHeader& header) {
  if (object < header.objects.size()) return {};
  return fmt::format("object {} does not exist (the header lists {})", object,
                     header.objects.size());
}

std::string pixel_fault(const Fragment& fragment, const TraceHeader& header) {
  if (header.image_width == 0) return {};
  if (fragment.pixel_x < header.image_width && fragment.pixel_y < header.image_height) return {};
  return fmt::format("pixel ({}, {}) is outside the image of {} x {}", fragment.pixel_x,
                     fragment.pixel_y, header.image_width, header.image_height);
}

}  // namespace

std::string scalar_fault(const TraceHeader& header) {
  std::string fault = range_fault("map width", header.map_width, 1u, kMaxMapSide);
  if (fault.empty()) fault = range_fault("map height", header.map_height, 1u, kMaxMapSide);
  if (fault.empty()) {
    fault = range_fault<std::uint32_t>("fraction bits", header.fraction_bits, kMinFractionBits,
                                       kMaxFractionBits);
  }
  if (fault.empty()) fault = range_fault("scale x", header.scale_x, 1.0, kMaxScale);
  if (fault.empty()) fault = range_fault("scale y", header.scale_y, 1.0, kMaxScale);
  if (fault.empty()) fault = image_fault(header);
  if (fault.empty() && header.mode > FragmentMode::kAll) {
    fault = fmt::format("fragment mode {} is unknown", static_cast<int>(header.mode));
  }
  if (fault.empty()) fault = length_fault("source", header.source.size());
  if (fault.empty()) fault = length_fault("light", header.light.size());
  if (fault.empty() && !header.source_sha256.empty() && !is_sha256(header.source_sha256)) {
    fault = "source_sha256 is not 64 lower-case hexadecimal digits";
  }
  return fault;
}

std::string header_fault(const TraceHeader& header) {
  if (std::string fault = scalar_fault(header); !fault.empty()) return fault;
  if (header.warnings.size() > kMaxWarnings) {
    return fmt::format("{} warnings, more than {}", header.warnings.size(), kMaxWarnings);
  }
  if (header.objects.size() > kMaxObjects) {
    return fmt::format("{} objects, more than {}", header.objects.size(), kMaxObjects);
  }
  for (const std::string& warning : header.warnings) {
    if (std::string fault = length_fault("a warning", warning.size()); !fault.empty()) return fault;
  }
  for (const ObjectInfo& object : header.objects) {
    std::string fault = length_fault("an object's name", object.name.size());
    if (!fault.empty()) return fault;
  }
  if (encoded_header_bytes(header) > kMaxHeaderBytes) {
    return fmt::format("the header takes {} bytes, more than {}", encoded_header_bytes(header),
                       kMaxHeaderBytes);
  }
  return {};
}

std::string caster_fault(const Caster& caster, const TraceHeader& header) {
  for (const LightPoint& point : caster.vertex) {
    if (std::string fault = point_fault(point); !fault.empty()) return fault;
  }
  std::string fault = object_fault(caster.object, header);
  if (fault.empty() && !header.objects[caster.object].caster) {
    fault = fmt::format("object {} is a receiver and casts no shadow", caster.object);
  }
  return fault;
}

std::string fragment_fault(const Fragment& fragment, const TraceHeader& header) {
  constexpr int kAllFlags = Fragment::kAverted | Fragment::kVisible | Fragment::kOutside;
  std::string fault = point_fault(fragment.position);
  if (fault.empty()) fault = object_fault(fragment.object, header);
  if (fault.empty()) fault = pixel_fault(fragment, header);
  if (fault.empty()) fault = range_fault<int>("flags", fragment.flags, 0, kAllFlags);
  return fault;
}

void check_header(const TraceHeader& header, const std::string& name) {
  const std::string fault = header_fault(header);
  if (!fault.empty()) throw UserError(name, fault, "correct the header");
}

void check_caster(const Caster& caster, const TraceHeader& header, const std::string& where) {
  const std::string fault = caster_fault(caster, header);
  if (!fault.empty()) throw UserError(where, fault, "correct the caster");
}

void check_fragment(const Fragment& fragment, const TraceHeader& header, const std::string& where) {
  const std::string fault = fragment_fault(fragment, header);
  if (!fault.empty()) throw UserError(where, fault, "correct the fragment");
}

}  // namespace kagesen
