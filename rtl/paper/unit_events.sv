// What the selected event counted in this cycle. docs/rtl.md lists the selections.
module unit_events (
  input  logic [5:0]                     select_i,
  input  shadow_pkg::front_events_t      front_i,
  input  shadow_pkg::store_events_t      store_i,
  input  logic [shadow_pkg::Lanes*shadow_pkg::LaneEventBits-1:0] lanes_i,  // lane_events_t side by side
  input  logic [3:0]                     store_cause_i,
  input  logic                           store_active_i,  // the cycle is of pass 1
  input  logic [3:0]                     lane_cause_i,    // of lane 0
  input  logic                           lane_active_i,   // the cycle is of pass 2
  output logic [15:0]                    increment_o
);
  logic [15:0] lookups, entries, lines;

  always_comb begin
    lookups = '0;
    entries = '0;
    lines   = '0;
    for (int lane = 0; lane < shadow_pkg::Lanes; lane++) begin
      lookups = lookups + 16'(lanes_i[lane*shadow_pkg::LaneEventBits+shadow_pkg::LineCountBits+1]);
      entries = entries + 16'(lanes_i[lane*shadow_pkg::LaneEventBits+shadow_pkg::LineCountBits]);
      lines   = lines + 16'(lanes_i[lane*shadow_pkg::LaneEventBits+:shadow_pkg::LineCountBits]);
    end
  end

  always_comb begin
    case (select_i)
      6'd0:    increment_o = 16'(front_i.caster);
      6'd1:    increment_o = 16'(front_i.edge_begun);
      6'd2:    increment_o = 16'(front_i.edge_texel);
      6'd3:    increment_o = 16'(front_i.span_texels);
      6'd4:    increment_o = 16'(store_i.line_stored);
      6'd5:    increment_o = 16'(store_i.line_cancelled);
      6'd6:    increment_o = 16'(store_i.emptied_covered);
      6'd7:    increment_o = store_i.lines_hidden;
      6'd8:    increment_o = store_i.overflow_lines;
      6'd9:    increment_o = 16'(store_i.overflow_texel);
      6'd10:   increment_o = lookups;
      6'd11:   increment_o = entries;
      6'd12:   increment_o = lines;
      default: increment_o = 16'((select_i[5:4] == 2'd2 && store_active_i && store_cause_i == select_i[3:0]) ||
                                 (select_i[5:4] == 2'd3 && lane_active_i && lane_cause_i == select_i[3:0]));
    endcase
  end
endmodule
