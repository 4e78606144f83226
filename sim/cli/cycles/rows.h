#pragma once
/// What the clock says of one frame, as a row of docs/cycles.json and of the page made from it.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/engine.h"

namespace kagesen {

struct CyclesRow {
  std::string profile, scene;
  std::uint64_t scale = 1;
  std::string rtl;  ///< hash of the Verilog and the bench: another one makes the row stale
  std::string engine;  ///< systemc or rtl
  std::uint64_t fragments = 0;
  CycleReport cycles;
  double seconds = 0;  ///< of simulation

  bool same_frame(const CyclesRow& o) const {
    return profile == o.profile && scene == o.scene && scale == o.scale && rtl == o.rtl &&
           engine == o.engine;
  }
};

nlohmann::json cycles_json(const std::vector<CyclesRow>& rows);
/// Throws UserError naming the file where it is not of that form; no file: no rows.
std::vector<CyclesRow> read_cycles(const std::string& path);
/// docs/cycles.md. @param rows  of one engine and of one RTL a profile, scenes in order
std::string cycles_page(const std::vector<CyclesRow>& rows);

}  // namespace kagesen
