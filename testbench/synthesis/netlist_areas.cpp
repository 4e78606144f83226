#include "testbench/synthesis/netlist_areas.h"

#include <nlohmann/json.hpp>
#include <set>

namespace kagesen {
namespace {

using Json = nlohmann::json;

std::uint64_t bits_value(const Json& bits) {
  std::uint64_t value = 0;
  for (const char bit : bits.get<std::string>()) value = 2 * value + (bit == '1');
  return value;
}

class Adder {
 public:
  Adder(const Json& modules, const CellLibrary& library, GateReport& report)
      : modules_(modules), library_(library), report_(report) {}

  struct Sum {
    double ge = 0;
    std::uint64_t bits = 0;
  };
  /// @param enclosing  blocks around this instance; one that holds itself is counted once
  Sum add(const std::string& module, const std::string& path, std::set<std::string> enclosing) {
    const std::string name = source_name(module);
    Sum all;
    double own = 0;
    const bool outermost = enclosing.insert(name).second;
    for (const auto& [instance, cell] : modules_.at(module).at("cells").items()) {
      const std::string type = cell.at("type");
      const std::string place = path.empty() ? instance : path + "." + instance;
      if (source_name(type) == "ram_1r1w") {
        const Json& parameters = cell.at("parameters");
        MemoryReport memory{place, bits_value(parameters.at("Width")),
                            bits_value(parameters.at("Depth"))};
        all.bits += memory.bits();
        report_.memory_bits += memory.bits();
        report_.memories.push_back(memory);
      } else if (const auto area = library_.areas.find(type); area != library_.areas.end()) {
        own += add_cell(type, area->second);
      } else if (modules_.contains(type) &&
                 !modules_.at(type).at("attributes").contains("blackbox")) {
        const Sum sum = add(type, place, enclosing);
        all.ge += sum.ge;
        all.bits += sum.bits;
      } else {
        ++report_.unmapped[type];
      }
    }
    all.ge += own;
    BlockReport& block = report_.blocks[name];
    ++block.instances;
    block.own_ge += own;
    if (outermost) {
      block.ge += all.ge;
      block.memory_bits += all.bits;
    }
    return all;
  }

 private:
  double add_cell(const std::string& type, double area) {
    const double ge = area / library_.nand2_area;
    ++report_.cells;
    if (CellLibrary::is_latch(type)) ++report_.unmapped[type];
    if (type.rfind("DFF", 0) == 0) {
      ++report_.flops;
      report_.flop_ge += ge;
    }
    return ge;
  }

  const Json& modules_;
  const CellLibrary& library_;
  GateReport& report_;
};

}  // namespace

std::string source_name(const std::string& module) {
  if (module.rfind("$paramod", 0) != 0) return module;
  const std::size_t begin = module.find('\\');
  return module.substr(begin + 1, module.find('\\', begin + 1) - begin - 1);
}

void add_areas(const std::string& netlist, const std::string& top, const CellLibrary& library,
               GateReport& report) {
  const Json design = Json::parse(netlist);
  report.total_ge = Adder(design.at("modules"), library, report).add(top, "", {}).ge;
}

}  // namespace kagesen
