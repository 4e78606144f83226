// Lets the requests that are already offered on a set of channels go through, and no new ones: what
// an abort needs, since valid must stay once it is high.
//
// Channel i closes in the first cycle of close_i in which it offers nothing or is taken.
// closed_o: nothing is offered any more; it stays until close_i falls.
module abort_guard #(
  parameter int unsigned Channels = 1
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  input  logic                close_i,
  input  logic [Channels-1:0] valid_i,   // inside
  output logic [Channels-1:0] ready_o,
  output logic [Channels-1:0] valid_o,   // outside
  input  logic [Channels-1:0] ready_i,
  output logic                closed_o
);
  logic [Channels-1:0] closed_q;

  assign valid_o  = valid_i & ~closed_q;
  assign ready_o  = ready_i & ~closed_q;
  assign closed_o = &closed_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) closed_q <= '0;
    else closed_q <= {Channels{close_i}} & (closed_q | ~valid_i | ready_i);
  end
endmodule
