#include "sim/cli/cycles/rows.h"

#include <fstream>

#include "traces/format/error.h"

namespace kagesen {
namespace {

using nlohmann::json;

json json_of(const PassCycles& pass) {
  json causes = json::object();
  for (const auto& [name, cycles] : pass.causes) causes[name] = cycles;
  return {{"total", pass.total}, {"items", pass.items}, {"causes", causes}};
}

PassCycles pass_of(const json& value) {
  PassCycles pass;
  value.at("total").get_to(pass.total);
  value.at("items").get_to(pass.items);
  for (const auto& [name, cycles] : value.at("causes").items()) {
    pass.causes.emplace_back(name, cycles.get<std::uint64_t>());
  }
  return pass;
}

CyclesRow row_of(const json& value) {
  CyclesRow row;
  value.at("profile").get_to(row.profile);
  value.at("scene").get_to(row.scene);
  value.at("scale").get_to(row.scale);
  value.at("rtl").get_to(row.rtl);
  row.engine = value.value("engine", "rtl");
  value.at("fragments").get_to(row.fragments);
  value.at("seconds").get_to(row.seconds);
  CycleReport& c = row.cycles;
  c.clear = value.at("clear").get<std::uint64_t>();
  c.announce = value.at("announce").get<std::uint64_t>();
  c.settle = value.at("settle").get<std::uint64_t>();
  value.at("edge_texels").get_to(c.edge_texels);
  value.at("span_texels").get_to(c.span_texels);
  c.pass1 = pass_of(value.at("pass1"));
  c.pass2 = pass_of(value.at("pass2"));
  return row;
}

}  // namespace

json cycles_json(const std::vector<CyclesRow>& rows) {
  json out = json::array();
  for (const CyclesRow& r : rows) {
    const CycleReport& c = r.cycles;
    out.push_back({{"profile", r.profile},
                   {"scene", r.scene},
                   {"scale", r.scale},
                   {"rtl", r.rtl},
                   {"engine", r.engine},
                   {"fragments", r.fragments},
                   {"seconds", r.seconds},
                   {"clear", *c.clear},
                   {"announce", *c.announce},
                   {"settle", *c.settle},
                   {"edge_texels", c.edge_texels},
                   {"span_texels", c.span_texels},
                   {"pass1", json_of(*c.pass1)},
                   {"pass2", json_of(*c.pass2)}});
  }
  return out;
}

std::vector<CyclesRow> read_cycles(const std::string& path) {
  std::ifstream in(path);
  if (!in) return {};
  std::vector<CyclesRow> rows;
  try {
    for (const json& value : json::parse(in)) rows.push_back(row_of(value));
  } catch (const json::exception& error) {
    throw UserError(path, std::string("is no table of cycles: ") + error.what(),
                    "remove it, or call with --fresh");
  }
  return rows;
}

}  // namespace kagesen
