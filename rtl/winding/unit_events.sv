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
  localparam int unsigned Flags = 7;  // one-bit events of a lane, above the segment count
  logic [15:0] flag, segments;
  logic [2:0]  flag_select;

  // 16 to 22: known, tile_lit, tile_dark, texel_lookup, first_test, slb_lookup, entry_read.
  assign flag_select = 3'(Flags - 1) - select_i[2:0];

  always_comb begin
    flag     = '0;
    segments = '0;
    for (int lane = 0; lane < shadow_pkg::Lanes; lane++) begin
      flag = flag + 16'(1'(lanes_i[lane*shadow_pkg::LaneEventBits+shadow_pkg::SegmentCountBits+:Flags] >> flag_select));
      segments = segments + 16'(lanes_i[lane*shadow_pkg::LaneEventBits+:shadow_pkg::SegmentCountBits]);
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
      6'd10:   increment_o = 16'(front_i.inner_texel);
      6'd11:   increment_o = 16'(store_i.texel_visits);
      6'd12:   increment_o = 16'(store_i.masked_visits);
      6'd13:   increment_o = 16'(store_i.hidden_visits);
      6'd14:   increment_o = 16'(store_i.tile_touched);
      6'd16, 6'd17, 6'd18, 6'd19, 6'd20, 6'd21, 6'd22: increment_o = flag;
      6'd23:   increment_o = segments;
      default: increment_o = 16'((select_i[5:4] == 2'd2 && store_active_i && store_cause_i == select_i[3:0]) ||
                                 (select_i[5:4] == 2'd3 && lane_active_i && lane_cause_i == select_i[3:0]));
    endcase
  end
endmodule
