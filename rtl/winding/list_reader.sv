// Reads lists of clusters record by record, each fragment's at its own pace, until one darkens it.
//
// Twins:   model/unit/winding/shadow_unit_pass2.cpp, read_texel (the loop over a list)
// Timing:  one record a cycle over all fragments, less what shadow_decision says. A fragment has one read
//          under way at most; between its response and the next read lie eight cycles. Responses are always taken.
`include "check.svh"
module list_reader #(
  localparam int unsigned SlotBits = shadow_pkg::SlotBits
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,
  input  logic                                  clear_i,
  input  logic                                  paper_semantics_i,
  // fragments, when they get their slots
  input  logic                                  frag_i,
  input  logic [SlotBits-1:0]                   frag_slot_i,
  input  logic [shadow_pkg::MaxFraction-1:0]    frag_x_i,   // in the texel
  input  logic [shadow_pkg::MaxFraction-1:0]    frag_y_i,
  input  logic [shadow_pkg::TraceDepthBits-1:0] frag_depth_i,
  input  logic [shadow_pkg::IdBits-1:0]         frag_object_i,
  // lists to read, a slot's only one
  input  logic                                  list_i,
  input  logic [SlotBits-1:0]                   list_slot_i,
  input  logic [shadow_pkg::RecordAddrBits-1:0] list_first_i,
  // what they say
  output logic                                  late_o,
  output logic [SlotBits-1:0]                   late_slot_o,
  output logic                                  late_dark_o,
  // SLB memory; a tag is a slot
  output logic                                  rd_valid_o,
  input  logic                                  rd_ready_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] rd_addr_o,
  output logic [SlotBits-1:0]                   rd_tag_o,
  input  logic                                  rsp_valid_i,
  input  logic [SlotBits-1:0]                   rsp_tag_i,
  input  logic [shadow_pkg::RecordBits-1:0]     rsp_data_i,
  // what happened
  output logic                                  entry_read_o,
  output logic [shadow_pkg::SegmentCountBits-1:0] lines_read_o,
  // where a slot's list is; all 0: it has none, or that is done
  input  logic [SlotBits-1:0]                   oldest_i,   // counts a cycle later
  output logic                                  waits_port_o,
  output logic                                  waits_memory_o,
  output logic                                  deciding_o
);
  localparam int unsigned Slots = shadow_pkg::FragmentSlots;
  localparam int unsigned AddrBits = shadow_pkg::RecordAddrBits;
  localparam int unsigned Most = shadow_pkg::MaxFraction;
  localparam int unsigned FragBits = 2 * Most + shadow_pkg::TraceDepthBits + shadow_pkg::IdBits;
  localparam int unsigned ContextBits = AddrBits + shadow_pkg::SegmentCountBits + 4;

  logic                                read, dark, lit, begins;
  logic [SlotBits-1:0]                 read_slot, record_slot_q;
  logic [AddrBits-1:0]                 next;
  logic [ContextBits-1:0]              context_out, context_in;
  logic [shadow_pkg::SegmentCountBits-1:0] count;

  // ---- Requests: begun lists go before new ones -----------------------------------------------------
  logic                   list_valid, list_ready, list_room, next_valid, next_ready, next_room;
  logic [SlotBits-1:0]    list_slot, next_slot;
  logic [AddrBits-1:0]    list_addr, next_addr;
  logic [ContextBits-1:0] next_context;
  logic                   choose_next, held_q, held_next_q;

  /* verilator lint_off PINCONNECTEMPTY */  // who is empty is nobody's business here
  fifo #(.Width(SlotBits + AddrBits), .Depth(Slots)) list_queue (
    .clk_i, .rst_ni, .clear_i, .valid_i(list_i), .ready_o(list_room),
    .data_i({list_slot_i, list_first_i}),
    .valid_o(list_valid), .ready_i(list_ready), .data_o({list_slot, list_addr}), .empty_o()
  );
  fifo #(.Width(SlotBits + AddrBits + ContextBits), .Depth(Slots)) next_queue (
    .clk_i, .rst_ni, .clear_i, .valid_i(read && !dark && !lit), .ready_o(next_room),
    .data_i({read_slot, next, context_out}),
    .valid_o(next_valid), .ready_i(next_ready), .data_o({next_slot, next_addr, next_context}), .empty_o()
  );
  /* verilator lint_on PINCONNECTEMPTY */
  // A request stays once it is offered.
  assign choose_next = held_q ? held_next_q : next_valid;
  assign rd_valid_o  = list_valid || next_valid;
  assign rd_addr_o   = choose_next ? next_addr : list_addr;
  assign rd_tag_o    = choose_next ? next_slot : list_slot;
  assign next_ready  = rd_ready_i && choose_next;
  assign list_ready  = rd_ready_i && !choose_next;

  // ---- Responses: with the fragment and what it has learnt so far ------------------------------------
  // They wait, if they must, where they came in: a slot has no other read under way.
  logic                              waiting, go, record_valid_q, decision_ready, response_room;
  logic [SlotBits-1:0]               waiting_slot;
  logic [shadow_pkg::RecordBits-1:0] record;
  logic [Most-1:0]                   x, y;
  logic [shadow_pkg::TraceDepthBits-1:0] depth;
  logic [shadow_pkg::IdBits-1:0]     object;

  /* verilator lint_off PINCONNECTEMPTY */
  fifo #(.Width(SlotBits), .Depth(Slots)) response_queue (
    .clk_i, .rst_ni, .clear_i, .valid_i(rsp_valid_i), .ready_o(response_room), .data_i(rsp_tag_i),
    .valid_o(waiting), .ready_i(go), .data_o(waiting_slot), .empty_o()
  );
  /* verilator lint_on PINCONNECTEMPTY */
  assign go = waiting && (!record_valid_q || decision_ready);
  ram_1r1w #(.Width(shadow_pkg::RecordBits), .Depth(Slots)) records (
    .clk_i, .write_i(rsp_valid_i), .write_addr_i(rsp_tag_i), .write_data_i(rsp_data_i),
    .read_i(go), .read_addr_i(waiting_slot), .read_data_o(record)
  );
  ram_1r1w #(.Width(FragBits), .Depth(Slots)) fragments (
    .clk_i, .write_i(frag_i), .write_addr_i(frag_slot_i),
    .write_data_i({frag_x_i, frag_y_i, frag_depth_i, frag_object_i}),
    .read_i(go), .read_addr_i(waiting_slot), .read_data_o({x, y, depth, object})
  );
  ram_1r1w #(.Width(ContextBits), .Depth(Slots)) contexts (
    .clk_i, .write_i(rd_valid_o && rd_ready_i), .write_addr_i(rd_tag_o),
    .write_data_i(choose_next ? next_context : '0),
    .read_i(go), .read_addr_i(waiting_slot), .read_data_o(context_in)
  );
  always_ff @(posedge clk_i) begin
    held_next_q <= choose_next;
    if (go) record_slot_q <= waiting_slot;
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      record_valid_q <= 1'b0;
      held_q         <= 1'b0;
    end else begin
      record_valid_q <= (go || (record_valid_q && !decision_ready)) && !clear_i;
      held_q         <= rd_valid_o && !rd_ready_i && !clear_i;
      `CHECK(room_for_every_list, !list_i || list_room)
      `CHECK(room_for_every_response, !rsp_valid_i || response_room)
      `CHECK(room_for_every_read, !read || next_room)
    end
  end

  shadow_decision decision (
    .clk_i, .rst_ni, .clear_i, .paper_semantics_i, .valid_i(record_valid_q),
    .ready_o(decision_ready),
    .slot_i(record_slot_q), .record_i(record), .context_i(context_in), .x_i(x), .y_i(y), .depth_i(depth),
    .object_i(object),
    .valid_o(read), .slot_o(read_slot), .dark_o(dark), .lit_o(lit), .next_o(next),
    .context_o(context_out), .begins_o(begins), .count_o(count)
  );
  assign late_o       = read && (dark || lit);
  assign late_slot_o  = read_slot;
  assign late_dark_o  = dark;
  assign entry_read_o = read && begins;
  assign lines_read_o = read ? count : '0;

  // ---- Where a slot is: 0 not here, 1 waits for the port, 2 for the memory, 3 is being decided -------
  logic [Slots-1:0]    low_d, low_q, high_d, high_q;
  logic [SlotBits-1:0] oldest_q;
  always_comb begin
    low_d  = low_q;
    high_d = high_q;
    if (list_i) low_d[list_slot_i] = 1'b1;  // from 0
    if (rd_valid_o && rd_ready_i) begin
      low_d[rd_tag_o]  = 1'b0;
      high_d[rd_tag_o] = 1'b1;
    end
    if (rsp_valid_i) low_d[rsp_tag_i] = 1'b1;  // from 2
    if (read) begin
      low_d[read_slot]  = !dark && !lit;
      high_d[read_slot] = 1'b0;
    end
    if (clear_i) begin
      low_d  = '0;
      high_d = '0;
    end
  end
  always_ff @(posedge clk_i) begin
    low_q    <= low_d;
    high_q   <= high_d;
    oldest_q <= oldest_i;
  end
  assign waits_port_o   = !high_q[oldest_q] && low_q[oldest_q];
  assign waits_memory_o = high_q[oldest_q] && !low_q[oldest_q];
  assign deciding_o     = high_q[oldest_q] && low_q[oldest_q];
endmodule
