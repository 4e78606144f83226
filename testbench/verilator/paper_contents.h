#pragma once
/// What the memories of the paper profile hold, as an engine reports it.
#include <cstdint>
#include <functional>

#include "model/engine.h"
#include "testbench/verilator/paper_layout.h"

namespace kagesen::rtl {

using ReadWord = std::function<Word(std::uint64_t address)>;

/// Texel by texel, entries in the order of their chains. Throws std::runtime_error where a chain does
/// not end or holds what belongs elsewhere.
MapContents paper_contents(const UnitConfig& config, const PaperLayout& layout,
                           const ReadWord& texel_word, const ReadWord& record);

/// Records that the buckets' chains hold, continuation records included.
std::uint64_t paper_records(const UnitConfig& config, const PaperLayout& layout,
                            const ReadWord& record);

}  // namespace kagesen::rtl
