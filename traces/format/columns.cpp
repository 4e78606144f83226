#include "traces/format/columns.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace kagesen {
namespace {

constexpr unsigned kMaxOrder = 2;  ///< second differences: straight lines become noise about zero

/// Calls visit(field) for every column in the file's order; field(record) is the member.
template <typename Visit>
void for_each_column(const Caster*, Visit visit) {
  for (int i = 0; i < 3; ++i) {
    visit([i](auto& r) -> auto& { return r.vertex[i].x; });
    visit([i](auto& r) -> auto& { return r.vertex[i].y; });
    visit([i](auto& r) -> auto& { return r.vertex[i].z; });
  }
  visit([](auto& r) -> auto& { return r.object; });
  visit([](auto& r) -> auto& { return r.polygon; });
}

template <typename Visit>
void for_each_column(const Fragment*, Visit visit) {
  visit([](auto& r) -> auto& { return r.pixel_x; });
  visit([](auto& r) -> auto& { return r.pixel_y; });
  visit([](auto& r) -> auto& { return r.position.x; });
  visit([](auto& r) -> auto& { return r.position.y; });
  visit([](auto& r) -> auto& { return r.position.z; });
  visit([](auto& r) -> auto& { return r.object; });
  visit([](auto& r) -> auto& { return r.shade; });
  visit([](auto& r) -> auto& { return r.flags; });
}

/// What has to be added to the last two values to predict the next one.
template <typename Unsigned>
Unsigned predict(unsigned order, Unsigned last, Unsigned before) {
  if (order == 0) return 0;
  if (order == 1) return last;
  return static_cast<Unsigned>(2u * last - before);
}

template <typename Unsigned>
Unsigned to_zigzag(Unsigned residual) {
  const bool negative = (residual >> (8 * sizeof(Unsigned) - 1)) != 0;
  const auto doubled = static_cast<Unsigned>(residual << 1);
  return negative ? static_cast<Unsigned>(~doubled) : doubled;
}

template <typename Unsigned>
Unsigned from_zigzag(Unsigned code) {
  const auto half = static_cast<Unsigned>(code >> 1);
  return (code & 1) != 0 ? static_cast<Unsigned>(~half) : half;
}

/// The order whose residuals have the fewest significant bits in all.
template <typename Unsigned>
unsigned best_order(const std::vector<Unsigned>& values) {
  std::array<std::uint64_t, kMaxOrder + 1> bits{};
  Unsigned last = 0, before = 0;
  for (const Unsigned value : values) {
    for (unsigned order = 0; order <= kMaxOrder; ++order) {
      const auto prediction = predict(order, last, before);
      const unsigned code = to_zigzag(static_cast<Unsigned>(value - prediction));
      bits[order] += code == 0 ? 0 : 32 - __builtin_clz(code);
    }
    before = last;
    last = value;
  }
  return static_cast<unsigned>(std::min_element(bits.begin(), bits.end()) - bits.begin());
}

template <typename Unsigned>
void encode_column(const std::vector<Unsigned>& values, Bytes& out) {
  const unsigned order = best_order(values);
  out.push_back(static_cast<std::uint8_t>(order));
  const std::size_t start = out.size(), count = values.size();
  out.resize(start + count * sizeof(Unsigned));
  Unsigned last = 0, before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto prediction = predict(order, last, before);
    const Unsigned code = to_zigzag(static_cast<Unsigned>(values[i] - prediction));
    for (std::size_t plane = 0; plane < sizeof(Unsigned); ++plane) {
      out[start + plane * count + i] = static_cast<std::uint8_t>(code >> (8 * plane));
    }
    before = last;
    last = values[i];
  }
}

/// Calls store(i, value) for each value of a column whose planes begin at `planes`.
template <typename Unsigned, typename Store>
void decode_column(unsigned order, const std::uint8_t* planes, std::size_t count, Store store) {
  Unsigned last = 0, before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    unsigned code = 0;
    for (std::size_t plane = 0; plane < sizeof(Unsigned); ++plane) {
      code |= static_cast<unsigned>(planes[plane * count + i]) << (8 * plane);
    }
    const auto residual = from_zigzag(static_cast<Unsigned>(code));
    const auto value = static_cast<Unsigned>(predict(order, last, before) + residual);
    store(i, value);
    before = last;
    last = value;
  }
}

template <typename Field, typename Record>
using FieldOf = std::remove_reference_t<std::invoke_result_t<Field, Record&>>;

template <typename Record>
std::size_t columns_bytes(std::size_t count) {
  std::size_t bytes = 0;
  for_each_column(static_cast<const Record*>(nullptr), [&](auto field) {
    bytes += 1 + count * sizeof(FieldOf<decltype(field), Record>);
  });
  return bytes;
}

template <typename Record>
Bytes encode(const std::vector<Record>& records) {
  Bytes out;
  out.reserve(columns_bytes<Record>(records.size()));
  for_each_column(records.data(), [&](auto field) {
    using Unsigned = std::make_unsigned_t<FieldOf<decltype(field), Record>>;
    std::vector<Unsigned> values(records.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
      values[i] = static_cast<Unsigned>(field(records[i]));
    }
    encode_column(values, out);
  });
  return out;
}

template <typename Record>
bool decode(const Bytes& columns, std::vector<Record>& records) {
  const std::uint8_t* next = columns.data();
  bool known = true;
  for_each_column(records.data(), [&](auto field) {
    using Value = FieldOf<decltype(field), Record>;
    using Unsigned = std::make_unsigned_t<Value>;
    const unsigned order = *next++;
    const std::uint8_t* planes = next;
    next += records.size() * sizeof(Value);
    const auto store = [&](std::size_t i, Unsigned v) {
      field(records[i]) = static_cast<Value>(v);
    };
    // A constant order lets the compiler unroll the prediction away.
    switch (order) {
      case 0:
        return decode_column<Unsigned>(0, planes, records.size(), store);
      case 1:
        return decode_column<Unsigned>(1, planes, records.size(), store);
      case 2:
        return decode_column<Unsigned>(2, planes, records.size(), store);
      default:
        known = false;
    }
  });
  return known;
}

}  // namespace

std::size_t caster_columns_bytes(std::size_t count) { return columns_bytes<Caster>(count); }
std::size_t fragment_columns_bytes(std::size_t count) { return columns_bytes<Fragment>(count); }

Bytes encode_columns(const std::vector<Caster>& records) { return encode(records); }
Bytes encode_columns(const std::vector<Fragment>& records) { return encode(records); }

bool decode_columns(const Bytes& columns, std::vector<Caster>& records) {
  return decode(columns, records);
}
bool decode_columns(const Bytes& columns, std::vector<Fragment>& records) {
  return decode(columns, records);
}

}  // namespace kagesen
