// List control: what follows what while the silhouette buffer works on a texel.
//
// Twins:   model/unit/winding/shadow_unit_store.cpp (hidden, find, open_list, add, cover, drop_hidden, overflow)
// Timing:  as silhouette_buffer; list_walk and cluster_update work while walk_o and work_o are high, until an end.
`include "check.svh"
module list_control (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  clear_i,
  input  logic                                  paper_i,
  input  logic                                  start_i,
  output logic                                  ready_o,
  output logic                                  done_o,
  // the visit
  input  logic                                  settle_i,
  input  logic                                  span_i,
  input  logic                                  nothing_i,      // of an edge, with neither corner nor segment
  // the texel, in the cycle of start_i; a list:
  input  logic [1:0]                            start_kind_i,
  input  logic                                  start_covered_i,
  input  logic                                  start_absent_i, // no cluster of the plane, and room for one
  input  logic [shadow_pkg::RecordAddrBits-1:0] start_first_i,
  // and from then on
  input  logic [1:0]                            kind_i,
  input  logic                                  behind_i,       // the visit does not lie before the cover
  input  logic                                  own_i,          // that decides, whatever the objects
  input  logic                                  covered_next_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] first_i,
  output logic                                  load_o,
  output logic                                  open_o,         // writes the texel's plane to the spare record
  output logic                                  insert_o,       // the visit's
  output logic                                  spill_o,
  output logic                                  keep_o,         // an overflow's depth
  // records
  input  logic                                  spare_ready_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] spare_i,
  input  logic                                  free_valid_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] free_i,
  input  logic                                  full_memory_i,
  output logic                                  take_o,
  input  logic                                  hit_i,
  input  logic                                  written_i,      // an update of this cycle is taken
  output logic                                  lookup_o,
  output logic [shadow_pkg::RecordAddrBits-1:0] lookup_addr_o,
  // list_walk
  output logic                                  begin_o,
  output logic [2:0]                            mode_o,
  output logic                                  walk_o,
  input  logic                                  long_i,
  input  logic                                  found_i,
  input  logic                                  missed_i,
  input  logic                                  walk_done_i,
  input  logic                                  settled_i,
  input  logic                                  freed_i,
  input  logic                                  counted_i,
  input  logic                                  too_long_i,
  input  logic                                  walk_ends_i,
  // cluster_update
  output logic                                  work_o,
  input  logic                                  work_done_i,
  input  logic                                  work_ends_i,
  input  logic                                  covers_i,
  input  logic                                  grown_i,
  input  logic                                  spills_i,
  output logic                                  hidden_o        // the visit is, with no look at the list
);
  localparam logic [3:0] Idle = 4'd0, Take = 4'd1, Taken = 4'd2, Check = 4'd3, Walk = 4'd4, Open = 4'd5, Insert = 4'd6,
                         Work = 4'd7, Spill = 4'd8, Keep = 4'd9, Done = 4'd10;
  localparam logic [2:0] Find = 3'd0, Covers = 3'd1, CoversDrop = 3'd2, Drop = 3'd3, Settle = 3'd4, Free = 3'd5,
                         Count = 3'd6;  // of list_walk
  logic [3:0] state_d, state_q;
  logic       insert_q;  // after Take: Insert, else Check
  logic       drops;     // the visit, or settling, has made a cover: clusters that it hides go next
  assign drops = (insert_o && written_i && span_i) || covers_i || (settled_i && covered_next_i);

  always_comb begin
    state_d = state_q;
    load_o = 1'b0; take_o = 1'b0; hidden_o = 1'b0;
    begin_o = 1'b0; mode_o = Find;
    lookup_o = 1'b0; lookup_addr_o = first_i;
    case (state_q)
      Idle: if (start_i) begin
        load_o  = 1'b1;
        state_d = Check;
        if (!spare_ready_i) begin
          state_d = Take;
        end else begin
          case (start_kind_i)
            shadow_pkg::TexelEmpty:    state_d = Insert;
            shadow_pkg::TexelPlane:    state_d = Open;
            shadow_pkg::TexelOverflow: state_d = Keep;
            shadow_pkg::TexelList: begin
              lookup_o      = settle_i || !start_absent_i;
              lookup_addr_o = start_first_i;
              if (!settle_i && !start_covered_i && !nothing_i) state_d = start_absent_i ? Insert : Walk;
              begin_o       = state_d == Walk;
            end
          endcase
        end
      end

      // ---- A spare record ------------------------------------------------------------------------
      Take: begin
        state_d = insert_q ? Insert : Check;
        if (!spare_ready_i && free_valid_i) begin
          lookup_o      = 1'b1;
          lookup_addr_o = free_i;
          state_d       = Taken;
        end
      end
      Taken: if (hit_i) begin
        take_o  = 1'b1;
        state_d = insert_q ? Insert : Check;
      end

      // ---- What the texel calls for ----------------------------------------------------------------
      Check: begin
        case (kind_i)
          shadow_pkg::TexelEmpty: state_d = Insert;
          shadow_pkg::TexelPlane: state_d = Open;
          shadow_pkg::TexelOverflow: state_d = Keep;
          shadow_pkg::TexelList: begin
            lookup_o = settle_i || (behind_i ? !own_i : !nothing_i);
            state_d  = lookup_o ? Walk : Done;
            begin_o  = lookup_o;
            mode_o   = settle_i ? Settle : behind_i ? Covers : Find;
            hidden_o = !settle_i && behind_i && own_i;
          end
        endcase
      end
      Open: if (full_memory_i) state_d = Spill;
            else if (written_i) state_d = Take;
      Insert: if (long_i || full_memory_i) state_d = Spill;
              else if (written_i) state_d = Done;
      Walk: begin
        if (found_i) state_d = Work;
        if (missed_i) state_d = Insert;
        if (freed_i) state_d = Keep;
        if (too_long_i) state_d = Spill;
        if (walk_done_i || settled_i || counted_i) state_d = Done;
        if (walk_ends_i) state_d = Idle;
      end
      Work: begin
        if (work_done_i) state_d = Done;
        if (work_ends_i) state_d = Idle;
        if (spills_i) state_d = Spill;
        if (grown_i) begin  // is the list too long now?
          begin_o  = 1'b1;
          mode_o   = Count;
          state_d  = Walk;
          lookup_o = 1'b1;
        end
      end
      // No room: the texel keeps the nearest depth.
      Spill: begin
        state_d = Keep;
        if (kind_i == shadow_pkg::TexelList) begin
          begin_o  = 1'b1;
          mode_o   = Free;
          state_d  = Walk;
          lookup_o = 1'b1;
        end
      end
      Keep: state_d = Done;
      default: state_d = Idle;
    endcase
    if (drops) begin
      begin_o       = 1'b1;
      mode_o        = paper_i ? CoversDrop : Drop;
      state_d       = Walk;
      lookup_o      = 1'b1;
      lookup_addr_o = insert_o ? spare_i : first_i;
    end
  end
  assign ready_o  = state_q == Idle;
  assign done_o   = state_q != Idle && state_d == Idle;
  assign open_o   = state_q == Open && !full_memory_i;
  assign insert_o = state_q == Insert && !long_i && !full_memory_i;
  assign walk_o   = state_q == Walk;
  assign work_o   = state_q == Work;
  assign spill_o  = state_q == Spill;
  assign keep_o   = state_q == Keep;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Idle;
    end else begin
      state_q <= clear_i ? Idle : state_d;
      `CHECK(starts_when_ready, !start_i || ready_o)
      `CHECK(settles_lists, !(start_i && settle_i) || start_kind_i == shadow_pkg::TexelList)
    end
  end
  always_ff @(posedge clk_i) if (load_o || open_o) insert_q <= open_o;
endmodule
