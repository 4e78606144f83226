#include "testbench/synthesis/fanout.h"

#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <vector>

namespace kagesen {
namespace {

using Json = nlohmann::json;

/// Pins of clock and reset trees, which are a layout's business.
bool of_a_tree(const std::string& type, const std::string& pin) {
  return pin == "clk_i" || (type.rfind("DFF", 0) == 0 && pin != "D");
}

class Buffering {
 public:
  explicit Buffering(Json& module) : module_(module) {
    for (const auto& [name, net] : module.at("netnames").items()) {
      for (const Json& bit : net.at("bits")) {
        if (bit.is_number()) last_bit_ = std::max(last_bit_, bit.get<std::size_t>());
      }
    }
  }

  std::size_t run() {
    std::map<std::size_t, std::vector<Json*>> readers;
    for (auto& [name, cell] : module_.at("cells").items()) {
      const std::string type = cell.at("type");
      for (auto& [pin, bits] : cell.at("connections").items()) {
        if (cell.at("port_directions").at(pin) != "input" || of_a_tree(type, pin)) continue;
        for (Json& bit : bits) {
          if (bit.is_number()) readers[bit.get<std::size_t>()].push_back(&bit);
        }
      }
    }
    for (auto& [net, pins] : readers) {
      if (pins.size() <= kMostReaders) continue;
      pins = level(net, pins, kMostBuffered);
      while (pins.size() > kMostBuffers) pins = level(net, pins, kMostBuffers);
    }
    for (std::size_t i = 0; i < buffers_.size(); ++i) {
      module_["cells"]["fanout_" + std::to_string(i)] = {
          {"hide_name", 0},
          {"type", kFanoutBuffer},
          {"parameters", Json::object()},
          {"attributes", Json::object()},
          {"port_directions", {{"A", "input"}, {"Y", "output"}}},
          {"connections", {{"A", {*buffers_[i].input}}, {"Y", {buffers_[i].output}}}}};
    }
    return buffers_.size();
  }

 private:
  struct Buffer {
    std::unique_ptr<Json> input;  ///< stays where it is
    std::size_t output;
  };

  /// Spreads the pins evenly over buffers that `net` drives. Returns the buffers' pins.
  std::vector<Json*> level(std::size_t net, const std::vector<Json*>& pins, std::size_t most) {
    const std::size_t groups = (pins.size() + most - 1) / most;
    std::vector<Json*> inputs;
    for (std::size_t group = 0; group < groups; ++group) {
      buffers_.push_back({std::make_unique<Json>(net), ++last_bit_});
      inputs.push_back(buffers_.back().input.get());
      for (std::size_t i = pins.size() * group / groups; i < pins.size() * (group + 1) / groups;
           ++i) {
        *pins[i] = last_bit_;
      }
    }
    return inputs;
  }

  Json& module_;
  std::size_t last_bit_ = 1;
  std::vector<Buffer> buffers_;
};

/// Registers that hold settings get names that the timing script knows: they stand still while
/// anything is timed.
void name_settings(Json& module) {
  static const std::regex setting(R"(\bsettings(_i)?(\[|$))");
  std::set<std::size_t> settings;
  for (const auto& [name, net] : module.at("netnames").items()) {
    if (!std::regex_search(name, setting)) continue;
    for (const Json& bit : net.at("bits")) {
      if (bit.is_number()) settings.insert(bit.get<std::size_t>());
    }
  }
  std::vector<std::string> names;
  for (const auto& [name, cell] : module.at("cells").items()) {
    if (cell.at("type").get<std::string>().rfind("DFF", 0) != 0) continue;
    const Json& bit = cell.at("connections").at("Q").at(0);
    if (bit.is_number() && settings.count(bit.get<std::size_t>())) names.push_back(name);
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    Json cell = module["cells"][names[i]];
    module["cells"].erase(names[i]);
    module["cells"]["setting_" + std::to_string(i)] = std::move(cell);
  }
}

}  // namespace

std::size_t buffer_fanout(const std::string& top, std::string& netlist) {
  Json design = Json::parse(netlist);
  Json& module = design.at("modules").at(top);
  name_settings(module);
  const std::size_t buffers = Buffering(module).run();
  Json small;  // the top alone
  small["creator"] = design.at("creator");
  small["modules"][top] = std::move(module);
  netlist = small.dump();
  return buffers;
}

}  // namespace kagesen
