#include "traces/format/header_codec.h"

#include <fmt/format.h>

#include <cstring>
#include <utility>

#include "traces/format/checks.h"

namespace kagesen {
namespace {

constexpr std::uint8_t kClosedBit = 1, kCasterBit = 2;
constexpr std::size_t kFixedBytes = 3 * 4 + 2 * 8 + 2 * 4 + 1 + 8;

static_assert(sizeof(double) == 8, "scales are stored as IEEE 754 binary64");

void put_double(Bytes& out, double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  put(out, bits);
}

void put_string(Bytes& out, const std::string& text) {
  put(out, static_cast<std::uint32_t>(text.size()));
  out.insert(out.end(), text.begin(), text.end());
}

/// Takes fields off the front of the payload; after the first that does not fit, all are zero.
class Cursor {
 public:
  explicit Cursor(const Bytes& bytes) : next_(bytes.data()), left_(bytes.size()) {}

  template <typename Unsigned>
  Unsigned take() {
    if (!fits(sizeof(Unsigned))) return 0;
    const auto value = get<Unsigned>(next_);
    advance(sizeof(Unsigned));
    return value;
  }

  double take_double() {
    const auto bits = take<std::uint64_t>();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

  std::string take_string() {
    const auto length = take<std::uint32_t>();
    if (!fits(length)) return {};
    std::string text(reinterpret_cast<const char*>(next_), length);
    advance(length);
    return text;
  }

  bool ok() const { return ok_; }
  std::size_t left() const { return left_; }

 private:
  bool fits(std::size_t bytes) { return ok_ = ok_ && bytes <= left_; }
  void advance(std::size_t bytes) {
    next_ += bytes;
    left_ -= bytes;
  }

  const std::uint8_t* next_;
  std::size_t left_;
  bool ok_ = true;
};

std::string decode_objects(Cursor& cursor, TraceHeader& header) {
  const auto count = cursor.take<std::uint32_t>();
  if (count > kMaxObjects) return fmt::format("{} objects, more than {}", count, kMaxObjects);
  for (std::uint32_t i = 0; i < count && cursor.ok(); ++i) {
    ObjectInfo object;
    object.name = cursor.take_string();
    object.triangles = cursor.take<std::uint32_t>();
    const auto bits = cursor.take<std::uint8_t>();
    if (bits > (kClosedBit | kCasterBit)) return fmt::format("object {} has unknown bits", i);
    object.closed = (bits & kClosedBit) != 0;
    object.caster = (bits & kCasterBit) != 0;
    header.objects.push_back(std::move(object));
  }
  return {};
}

}  // namespace

std::size_t encoded_header_bytes(const TraceHeader& header) {
  std::size_t bytes = kFixedBytes + std::size_t{5} * 4 + header.source.size() +
                      header.source_sha256.size() + header.light.size();
  for (const std::string& warning : header.warnings) bytes += 4 + warning.size();
  for (const ObjectInfo& object : header.objects) bytes += 4 + object.name.size() + 4 + 1;
  return bytes;
}

Bytes encode_header(const TraceHeader& header) {
  Bytes out;
  out.reserve(encoded_header_bytes(header));
  put(out, header.map_width);
  put(out, header.map_height);
  put(out, header.fraction_bits);
  put_double(out, header.scale_x);
  put_double(out, header.scale_y);
  put(out, header.image_width);
  put(out, header.image_height);
  put(out, static_cast<std::uint8_t>(header.mode));
  put(out, header.seed);
  put_string(out, header.source);
  put_string(out, header.source_sha256);
  put_string(out, header.light);
  put(out, static_cast<std::uint32_t>(header.warnings.size()));
  for (const std::string& warning : header.warnings) put_string(out, warning);
  put(out, static_cast<std::uint32_t>(header.objects.size()));
  for (const ObjectInfo& object : header.objects) {
    put_string(out, object.name);
    put(out, object.triangles);
    put(out, static_cast<std::uint8_t>((object.closed ? kClosedBit : 0) |
                                       (object.caster ? kCasterBit : 0)));
  }
  return out;
}

std::string decode_header(const Bytes& payload, TraceHeader& header) {
  Cursor cursor(payload);
  header = {};
  header.map_width = cursor.take<std::uint32_t>();
  header.map_height = cursor.take<std::uint32_t>();
  header.fraction_bits = cursor.take<std::uint32_t>();
  header.scale_x = cursor.take_double();
  header.scale_y = cursor.take_double();
  header.image_width = cursor.take<std::uint32_t>();
  header.image_height = cursor.take<std::uint32_t>();
  header.mode = static_cast<FragmentMode>(cursor.take<std::uint8_t>());
  header.seed = cursor.take<std::uint64_t>();
  header.source = cursor.take_string();
  header.source_sha256 = cursor.take_string();
  header.light = cursor.take_string();
  const auto warnings = cursor.take<std::uint32_t>();
  if (warnings > kMaxWarnings)
    return fmt::format("{} warnings, more than {}", warnings, kMaxWarnings);
  for (std::uint32_t i = 0; i < warnings && cursor.ok(); ++i) {
    header.warnings.push_back(cursor.take_string());
  }
  if (std::string fault = decode_objects(cursor, header); !fault.empty()) return fault;
  if (!cursor.ok()) return "the header ends in the middle of a field";
  if (cursor.left() != 0)
    return fmt::format("{} bytes follow the header's last field", cursor.left());
  return {};
}

}  // namespace kagesen
