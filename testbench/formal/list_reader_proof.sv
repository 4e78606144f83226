// Each fragment's list is read record by record from where it begins: a slot that has one asks once for each
// record, at the address that the answer before gave; its request stays until it is taken; a record meets its
// own fragment, and what that has learnt so far; the verdict leaves once, as it was decided. Nothing waits
// while the port, the memory and the decision go on; where the oldest slot stands is told rightly. The
// decision is any block that keeps its contract. Two slots.
//
// long run
// profile: winding
// package: FragmentSlots=2 RecordAddrBits=2 SegmentCountBits=2
// broken: list_reader.sv: `choose_next = held_q ? held_next_q : next_valid` => `choose_next = next_valid`
// broken: list_reader.sv: `.write_data_i(choose_next ? next_context : '0)` => `.write_data_i(next_context)`
// broken: list_reader.sv: `waiting && (!record_valid_q || decision_ready)` => `waiting`
// broken: list_reader.sv: `if (go) record_slot_q <= waiting_slot;` => `record_slot_q <= waiting_slot;`
// broken: list_reader.sv: `assign late_o       = read && (dark || lit);` => `assign late_o       = read && dark;`
// broken: list_reader.sv: `assign rd_addr_o   = choose_next ? next_addr : list_addr;` => `assign rd_addr_o   = next_valid ? next_addr : list_addr;`
// broken: list_reader.sv: `if (rsp_valid_i) low_d[rsp_tag_i] = 1'b1;` => ``
module list_reader_proof (
  input logic       clk_i,
  input logic       frag_i, frag_slot_i, list_i, list_slot_i, rd_ready_i, rsp_valid_i, rsp_tag_i, oldest_i,
  input logic [1:0] list_first_i,
  input logic       dark_i, lit_i,  // what the record that comes will say
  input logic [1:0] next_i
);
  logic running_q = 1'b0, settled_q = 1'b0, passing_q = 1'b0;
  always_ff @(posedge clk_i) {running_q, settled_q, passing_q} <= {1'b1, running_q, settled_q};

  // A slot: without fragment (0), without list (1), asks (2), waits for its record (3), is decided on (4).
  logic [2:0] at0_q = '0, at1_q = '0;
  logic       lap0_q = 1'b0, lap1_q = 1'b0;  // of the slot's fragments: tells one from the next
  logic       step0_q, step1_q;              // of its records: 0 the first, then 1
  logic [1:0] addr0_q, addr1_q;              // of the record that is due
  logic       dark0_q, dark1_q, lit0_q, lit1_q;
  wire [2:0]  at_list = list_slot_i ? at1_q : at0_q;
  wire [2:0]  at_frag = frag_slot_i ? at1_q : at0_q;
  wire [2:0]  at_rsp  = rsp_tag_i ? at1_q : at0_q;
  wire        lap     = frag_slot_i ? !lap1_q : !lap0_q;

  logic       late_o, late_slot_o, late_dark_o, rd_valid_o, rd_tag_o, entry_read_o;
  logic       waits_port_o, waits_memory_o, deciding_o;
  logic [1:0] rd_addr_o, lines_read_o;
  list_reader dut (
    .rst_ni(running_q), .clear_i(!settled_q), .paper_semantics_i(1'b0),
    .frag_x_i(shadow_pkg::MaxFraction'({lap, frag_slot_i})),
    .frag_y_i(shadow_pkg::MaxFraction'({lap, frag_slot_i})),
    .frag_depth_i(shadow_pkg::TraceDepthBits'({lap, frag_slot_i})),
    .frag_object_i(shadow_pkg::IdBits'({lap, frag_slot_i})),
    .rsp_data_i(shadow_pkg::RecordBits'({next_i, dark_i, lit_i, rsp_tag_i ? step1_q : step0_q,
                                         rsp_tag_i ? lap1_q : lap0_q, rsp_tag_i})),
    .*
  );
  // As the decision below tells: it answers, of which slot, and whether all that it was given belongs together.
  wire        answered = entry_read_o;
  wire        answer_slot = lines_read_o[0];
  wire        fits     = lines_read_o[1];
  wire        read     = rd_valid_o && rd_ready_i;
  wire [2:0]  at_read  = rd_tag_o ? at1_q : at0_q;
  wire        decided  = answer_slot ? dark1_q || lit1_q : dark0_q || lit0_q;

  function automatic logic [2:0] next(input logic slot, input logic [2:0] now);
    next = now;
    if (frag_i && frag_slot_i == slot) next = 3'd1;
    if (list_i && list_slot_i == slot) next = 3'd2;
    if (read && rd_tag_o == slot) next = 3'd3;
    if (rsp_valid_i && rsp_tag_i == slot) next = 3'd4;
    if (answered && answer_slot == slot) next = decided ? 3'd0 : 3'd2;
  endfunction

  logic       held_q = 1'b0, held_tag_q, oldest_q;
  logic [1:0] held_addr_q;
  logic [3:0] quiet_q = '0;
  wire [2:0]  at_oldest = oldest_q ? at1_q : at0_q;

  always_ff @(posedge clk_i) begin
    oldest_q <= oldest_i;
    if (running_q) begin
      assume (settled_q || !(frag_i || list_i || rsp_valid_i));  // every pass begins with a clear
      assume (!frag_i || at_frag == 3'd0);
      assume (!list_i || at_list == 3'd1);
      assume (!rsp_valid_i || at_rsp == 3'd3);
      assume (!(dark_i && lit_i));
      if (rd_valid_o) assert (at_read == 3'd2 && rd_addr_o == (rd_tag_o ? addr1_q : addr0_q));
      if (held_q) assert (rd_valid_o && rd_tag_o == held_tag_q && rd_addr_o == held_addr_q);
      if (answered) assert (fits && (answer_slot ? at1_q : at0_q) == 3'd4);
      assert (late_o == (answered && decided));
      if (late_o) assert (late_slot_o == answer_slot && late_dark_o == (late_slot_o ? dark1_q : dark0_q));
      if (passing_q) begin
        assert (waits_port_o == (at_oldest == 3'd2));
        assert (waits_memory_o == (at_oldest == 3'd3));
        assert (deciding_o == (at_oldest == 3'd4));
      end
      // A slot asks and nothing is offered, or is decided on and nothing is answered.
      quiet_q <= ((at0_q == 3'd2 || at1_q == 3'd2) && !rd_valid_o) ||
                 ((at0_q == 3'd4 || at1_q == 3'd4) && !answered) ? quiet_q + 4'd1 : '0;
      assert (quiet_q != 4'd12);

      held_q      <= rd_valid_o && !rd_ready_i;
      held_tag_q  <= rd_tag_o;
      held_addr_q <= rd_addr_o;
      at0_q       <= next(1'b0, at0_q);
      at1_q       <= next(1'b1, at1_q);
      if (frag_i && !frag_slot_i) {lap0_q, step0_q} <= {!lap0_q, 1'b0};
      if (frag_i && frag_slot_i) {lap1_q, step1_q} <= {!lap1_q, 1'b0};
      if (list_i && !list_slot_i) addr0_q <= list_first_i;
      if (list_i && list_slot_i) addr1_q <= list_first_i;
      if (rsp_valid_i && !rsp_tag_i) {addr0_q, dark0_q, lit0_q} <= {next_i, dark_i, lit_i};
      if (rsp_valid_i && rsp_tag_i) {addr1_q, dark1_q, lit1_q} <= {next_i, dark_i, lit_i};
      if (answered && !answer_slot) step0_q <= 1'b1;
      if (answered && answer_slot) step1_q <= 1'b1;
    end
  end
endmodule

// In place of the winding profile's: takes a record at least every other cycle, answers in order.
module shadow_decision #(
  localparam int unsigned WindingBits = shadow_pkg::RecordAddrBits + shadow_pkg::SegmentCountBits + 1,
  localparam int unsigned ContextBits = WindingBits + 3
) (
  input  logic                                    clk_i,
  input  logic                                    rst_ni,
  input  logic                                    clear_i,
  input  logic                                    paper_semantics_i,
  input  logic                                    valid_i,
  output logic                                    ready_o,
  input  logic [shadow_pkg::SlotBits-1:0]         slot_i,
  input  logic [shadow_pkg::RecordBits-1:0]       record_i,
  input  logic [ContextBits-1:0]                  context_i,
  input  logic [shadow_pkg::MaxFraction-1:0]      x_i,
  input  logic [shadow_pkg::MaxFraction-1:0]      y_i,
  input  logic [shadow_pkg::TraceDepthBits-1:0]   depth_i,
  input  logic [shadow_pkg::IdBits-1:0]           object_i,
  output logic                                    valid_o,
  output logic [shadow_pkg::SlotBits-1:0]         slot_o,
  output logic                                    dark_o,
  output logic                                    lit_o,
  output logic [shadow_pkg::RecordAddrBits-1:0]   next_o,
  output logic [ContextBits-1:0]                  context_o,
  output logic                                    begins_o,
  output logic [shadow_pkg::SegmentCountBits-1:0] count_o
);
  (* anyseq *) logic free;
  logic       refused_q = 1'b0, valid_q = 1'b0, slot_q, fits_q;
  logic [6:0] record_q;
  wire        step = record_i[2];
  wire [1:0]  who = record_i[1:0];  // lap and slot
  // What a fragment learns: whose it is, and that it is not its first record.
  wire [2:0]  learnt = context_i[2:0];
  assign ready_o = free || refused_q;
  always_ff @(posedge clk_i) begin
    refused_q <= rst_ni && !ready_o;
    valid_q   <= rst_ni && valid_i && ready_o;
    slot_q    <= slot_i;
    record_q  <= record_i[6:0];
    fits_q    <= who[0] == slot_i && x_i[1:0] == who && y_i[1:0] == who && depth_i[1:0] == who &&
                 object_i[1:0] == who && learnt == (step ? {1'b1, who} : 3'd0);
  end
  assign valid_o   = valid_q;
  assign slot_o    = slot_q;
  assign lit_o     = record_q[3];
  assign dark_o    = record_q[4];
  assign next_o    = record_q[6:5];
  assign context_o = ContextBits'({1'b1, record_q[1:0]});
  assign begins_o  = 1'b1;
  assign count_o   = {fits_q, slot_q};
endmodule
