#include "testbench/synthesis/fanout.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

namespace kagesen {
namespace {

using Json = nlohmann::json;

Json cell(const std::string& type, const Json& connections) {
  Json directions;
  for (const auto& [pin, bits] : connections.items()) {
    directions[pin] = pin == "Y" || pin == "Q" ? "output" : "input";
  }
  return {{"type", type}, {"port_directions", directions}, {"connections", connections}};
}

/// Registers 1 to 3 of settings and of anything else; register 1 drives `readers` inverters and, by
/// its clock pins, clocks `readers` more registers.
Json design(std::size_t readers) {
  Json cells, nets;
  cells["source"] = cell("DFFPOSX1", {{"D", {"0"}}, {"Q", {2}}, {"CLK", {3}}});
  cells["held"] = cell("DFFPOSX1", {{"D", {"0"}}, {"Q", {4}}, {"CLK", {3}}});
  for (std::size_t i = 0; i < readers; ++i) {
    cells["reader" + std::to_string(i)] = cell("INVX1", {{"A", {2}}, {"Y", {100 + i}}});
    cells["clocked" + std::to_string(i)] =
        cell("DFFSR", {{"D", {"1"}}, {"Q", {100000 + i}}, {"R", {2}}, {"S", {"1"}}, {"CLK", {2}}});
  }
  nets["some"]["bits"] = {2};
  nets["front.settings_i[0]"]["bits"] = {4};
  nets["readers"]["bits"] = {99 + std::max<std::size_t>(readers, 1)};
  return {{"creator", "test"}, {"modules", {{"top", {{"cells", cells}, {"netnames", nets}}}}}};
}

/// What drives the buffers of each net they drive.
std::map<std::size_t, std::size_t> sources_of(const Json& cells) {
  std::map<std::size_t, std::size_t> sources;
  for (const auto& [name, cell] : cells.items()) {
    const Json& connections = cell.at("connections");
    if (cell.at("type") == kFanoutBuffer)
      sources[connections.at("Y").at(0)] = connections.at("A").at(0);
  }
  return sources;
}

TEST(Fanout, EveryReaderKeepsItsDriverAndNobodyHasTooMany) {
  for (const std::size_t readers : {0u, 1u, 8u, 9u, 16u, 17u, 96u, 97u, 600u, 1000u}) {
    std::string text = design(readers).dump();
    const std::size_t buffers = buffer_fanout("top", text);
    const Json built = Json::parse(text);
    const Json& cells = built.at("modules").at("top").at("cells");
    std::map<std::size_t, std::size_t> loads, buffers_of;
    std::map<std::size_t, std::size_t> sources = sources_of(cells);
    std::size_t found = 0, inverters = 0;
    for (const auto& [name, cell] : cells.items()) {
      const Json& connections = cell.at("connections");
      if (cell.at("type") == "DFFSR") {
        EXPECT_EQ(connections.at("CLK").at(0), 2);
      }
      if (!connections.contains("A")) continue;
      const std::size_t net = connections.at("A").at(0);
      if (cell.at("type") == kFanoutBuffer) {
        ++found;
        ++buffers_of[net];
      } else {
        ++inverters;
        ++loads[net];
        std::size_t driver = net;
        while (sources.count(driver)) driver = sources[driver];
        EXPECT_EQ(driver, 2u) << readers;
      }
    }
    EXPECT_EQ(inverters, readers);
    EXPECT_EQ(found, buffers);
    EXPECT_EQ(buffers == 0, readers <= kMostReaders) << readers;
    for (const auto& [net, count] : loads) {
      EXPECT_LE(count, net == 2 ? kMostReaders : kMostBuffered) << readers;
    }
    for (const auto& [net, count] : buffers_of) EXPECT_LE(count, kMostBuffers) << readers;
    EXPECT_LE(buffers, 1 + readers / (kMostBuffered / 2)) << readers;
  }
}

TEST(Fanout, RegistersOfSettingsAreNamed) {
  std::string text = design(3).dump();
  buffer_fanout("top", text);
  const Json built = Json::parse(text);
  const Json& cells = built.at("modules").at("top").at("cells");
  EXPECT_TRUE(cells.contains("setting_0"));
  EXPECT_FALSE(cells.contains("held"));
  EXPECT_TRUE(cells.contains("source"));
  EXPECT_FALSE(cells.contains("setting_1"));
}

}  // namespace
}  // namespace kagesen
