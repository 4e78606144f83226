#pragma once
/// Records as columns of byte planes, which zstd packs well. Not for use outside this folder.
#include <vector>

#include "traces/format/layout.h"
#include "traces/format/records.h"

namespace kagesen {

/// Size of the encoded form of `count` records.
std::size_t caster_columns_bytes(std::size_t count);
std::size_t fragment_columns_bytes(std::size_t count);

Bytes encode_columns(const std::vector<Caster>& records);
Bytes encode_columns(const std::vector<Fragment>& records);

/// Fills `records`, whose size says how many; `columns` holds exactly their bytes.
/// False if a column's order of differences is unknown.
bool decode_columns(const Bytes& columns, std::vector<Caster>& records);
bool decode_columns(const Bytes& columns, std::vector<Fragment>& records);

}  // namespace kagesen
