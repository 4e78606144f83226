#include "testbench/mutation/blocks.h"

namespace kagesen {

const std::vector<MutationBlock>& mutation_blocks() {
  static const std::vector<MutationBlock> blocks{
      {"fifo", "fifo_test", "fifo_test_dut", 60},
      {"abort_guard", "abort_guard_test", "abort_guard_test_dut", 20},
      {"unit_registers", "unit_registers_test", "unit_registers_test_dut", 60},
      {"divider", "divider_test", "divider_test_dut", 60, {}, 400000},
      {"multiplier", "multiplier_test", "multiplier_test_dut", 20},
      {"line_cache", "line_cache_test", "line_cache_test_dut", 100, {{"data_o", "hit_o"}}},
      {"line_cache_ways", "line_cache_test", "line_cache_ways_dut", 60, {{"data_o", "hit_o"}}},
      {"lane_slots", "lane_slots_test", "lane_slots_test_dut", 80},
      {"corner_functions", "corner_functions_test", "corner_functions_test_dut", 60},
      {"visited_rows", "visited_rows_test", "visited_rows_test_dut", 60},
      {"plane_ramp", "plane_ramp_test", "plane_ramp_test_dut", 60},
      {"paper_address_generator", "address_generator_rtl_test", "address_generator_rtl_test_dut",
       10},
      {"paper_silhouette_detector", "silhouette_detector_rtl_test",
       "silhouette_detector_rtl_test_dut", 30},
      {"paper_shadow_decision",
       "shadow_decision_rtl_test",
       "shadow_decision_rtl_test_dut",
       100,
       {},
       400000},
      {"paper_front", "front_test", "front_test_dut", 100},
      {"paper_store", "store_test", "store_test_dut", 100},
      {"paper_lane", "shadow_lane_test", "shadow_lane_test_dut", 100},
      {"winding_plane_setup", "plane_setup_test", "plane_setup_test_dut", 60},
      {"winding_shadow_decision",
       "winding_decision_test",
       "winding_decision_test_dut",
       80,
       {},
       400000},
      {"winding_front", "winding_front_test", "winding_front_test_dut", 100},
      {"winding_store", "winding_store_test", "winding_store_test_dut", 100},
      {"winding_lane", "winding_lane_test", "winding_lane_test_dut", 100}};
  return blocks;
}

}  // namespace kagesen
