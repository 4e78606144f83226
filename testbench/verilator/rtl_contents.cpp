#include "testbench/verilator/rtl_contents.h"

#include <stdexcept>

#include "testbench/verilator/package.h"
#include "testbench/verilator/paper_contents.h"
#include "testbench/verilator/winding_contents.h"

namespace kagesen {
namespace {

rtl::ReadWord reader_of(const bench::MemoryWords& memory) {
  return [&memory](std::uint64_t address) {
    if (address >= memory.count) throw std::runtime_error("an address beyond the memory's end");
    const std::uint32_t* first = memory.words + address * memory.stride;
    return rtl::Word(first, first + memory.stride);
  };
}

}  // namespace

MapContents rtl_contents(const UnitConfig& config, const bench::MemoryWords& texels,
                         const bench::MemoryWords& records) {
  const PackageWidths widths(config);
  const auto map_bits = static_cast<std::size_t>(widths.map_bits);
  const auto address_bits = static_cast<std::size_t>(widths.record_addr_bits);
  try {
    if (config.profile == Profile::kPaper) {
      const rtl::PaperLayout layout(config, {map_bits, address_bits});
      return rtl::paper_contents(config, layout, reader_of(texels), reader_of(records));
    }
    const rtl::WindingLayout layout(config, {map_bits, address_bits});
    return rtl::winding_contents(config, layout, reader_of(texels), reader_of(records));
  } catch (const std::runtime_error& error) {
    throw bench::Failure(error.what());
  }
}

}  // namespace kagesen
