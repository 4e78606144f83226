#pragma once
/// What the memories of the winding profile hold, as an engine reports it.
#include <cstdint>
#include <functional>

#include "model/engine.h"
#include "testbench/verilator/winding_layout.h"

namespace kagesen::rtl {

using ReadWord = std::function<Word(std::uint64_t address)>;

/// After pass 1 is settled. Throws std::runtime_error where a list does not end or a record cannot be.
/// @param records  if not null: is set to the number of records that the lists hold
MapContents winding_contents(const UnitConfig& config, const WindingLayout& layout,
                             const ReadWord& texel_word, const ReadWord& record,
                             std::uint64_t* records = nullptr);

}  // namespace kagesen::rtl
