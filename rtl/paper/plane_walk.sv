// Plane walk: a plane's value at texel centres, exact, moved by one texel or two a cycle.
//
// Twins:   ExactRamp in model/unit/fixed.h, Polygon::centre_ramp in model/unit/span_filler.h.
// Numbers: value = whole + rest / base, 0 <= rest < base. What is kept of the rest is itself or rest - base:
//          so the next sum needs no correction, and its sign is the carry into the whole part.
//          A step is whole + (rest + less) / base, downwards where less is set. Two of them along x are
//          2 whole + 1 + twice_rest / base, again signed: -base <= twice_rest <= base.
// Timing:  load, reload and move in cycle n, rest_o of the new texel in n + 1, whole_o in n + 2. A reload
//          may move at once. Nothing happens without ready_i.
module plane_walk #(
  parameter int unsigned WholeBits = 81,  // signed
  parameter int unsigned RestBits  = 56,
  parameter int unsigned DepthBits = 24
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  logic                 clear_i,
  input  logic                 ready_i,
  input  logic                 load_i,
  input  logic [RestBits:0]    rest_i,         // as kept
  input  logic [WholeBits-1:0] whole_i,        // in the cycle after load_i, until loaded_o
  input  logic [DepthBits-1:0] depth_i,        // adds to whole_i
  output logic                 loading_o,      // whole_i is wanted
  input  logic                 reload_i,       // from these instead of where it stands:
  input  logic [RestBits:0]    reload_rest_i,
  input  logic [DepthBits-1:0] reload_whole_i, // a cycle later; bits above it keep
  input  logic                 move_x_i,       // along x
  input  logic                 move_y_i,       // or up along y, never both
  input  logic                 back_i,         // down along x
  input  logic                 two_i,          // up along x, two texels; of whole_o only DepthBits are right then
  input  logic                 prepare_i,      // in a cycle before the first such, with no move by two
  input  logic                 x_less_i,       // steps, and base; constant between a load and the last move
  input  logic [WholeBits-2:0] x_whole_i,
  input  logic [RestBits-1:0]  x_rest_i,
  input  logic                 y_less_i,
  input  logic [WholeBits-2:0] y_whole_i,
  input  logic [RestBits-1:0]  y_rest_i,
  input  logic [RestBits-1:0]  base_i,
  output logic [RestBits:0]    rest_o,
  output logic [WholeBits-1:0] whole_o,
  output logic [DepthBits-1:0] next_whole_o    // with whole_o: after the first of two texels
);
  localparam int unsigned R = RestBits + 1;
  logic [R-1:0] rest_q, from, step, base, sum, major, one_from, one_step, one_base, one, one_major, twice_rest_q;
  logic         move, down, inverse, back, move_q, move_x_q, inverse_q, two_q, one_carry_q, load_q, reload_q;

  // ---- Rest ----
  // With the step, base is added or subtracted so that the sum is in range; back: the sum would fall.
  assign move    = move_x_i || move_y_i;
  assign down    = move_x_i && back_i;
  assign inverse = down != (move_x_i ? x_less_i : y_less_i);
  assign back    = inverse != (two_i && twice_rest_q[R-1]);
  assign from    = reload_i ? reload_rest_i : rest_q;
  assign step    = (two_i ? twice_rest_q : {1'b0, move_x_i ? x_rest_i : y_rest_i}) ^ {R{inverse}};
  assign base    = ({1'b0, base_i} ^ {R{!back}}) & {R{back == from[R-1]}};
  assign major   = (from & step) | (from & base) | (step & base);
  assign sum     = (from ^ step ^ base) + {major[R-2:0], two_i ? x_less_i : down} + {{(R-1){1'b0}}, !back && !from[R-1]};

  // One texel up along x, for its carry. Before: twice (rest + less) - base.
  logic one_less, one_more;  // base is subtracted or added
  assign one_less  = prepare_i || (!x_less_i && !rest_q[R-1]);
  assign one_more  = x_less_i && rest_q[R-1];
  assign one_from  = prepare_i ? {x_rest_i, x_less_i} : rest_q;
  assign one_step  = prepare_i ? R'(x_less_i) : {1'b0, x_rest_i} ^ {R{x_less_i}};
  assign one_base  = ({1'b0, base_i} ^ {R{one_less}}) & {R{one_less || one_more}};
  assign one_major = (one_from & one_step) | (one_from & one_base) | (one_step & one_base);
  assign one       = (one_from ^ one_step ^ one_base) + {one_major[R-2:0], 1'b0} + {{(R-1){1'b0}}, one_less};

  always_ff @(posedge clk_i) begin
    if (ready_i) begin
      if (load_i) rest_q <= rest_i;
      else if (move) rest_q <= sum;
      else rest_q <= from;
      move_q      <= move;
      move_x_q    <= move_x_i;
      inverse_q   <= inverse;
      two_q       <= two_i;
      one_carry_q <= !one[R-1];
    end
    if (prepare_i) twice_rest_q <= one;
  end
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      load_q   <= 1'b0;
      reload_q <= 1'b0;
    end else if (clear_i) begin
      load_q   <= 1'b0;
      reload_q <= 1'b0;
    end else if (ready_i) begin
      load_q   <= load_i;
      reload_q <= reload_i;
    end
  end
  assign loading_o = load_q;
  assign rest_o    = rest_q;

  // ---- Whole part ----
  logic [WholeBits-1:0] whole_q, whole_from, whole_step;
  logic [DepthBits-1:0] low_step;
  assign whole_from = load_q ? whole_i
                    : {whole_q[WholeBits-1:DepthBits], reload_q ? reload_whole_i : whole_q[DepthBits-1:0]};
  assign low_step   = two_q ? {x_whole_i[DepthBits-2:0], !twice_rest_q[R-1]}
                    : move_x_q ? x_whole_i[DepthBits-1:0] : y_whole_i[DepthBits-1:0];
  assign whole_step = load_q ? WholeBits'(depth_i)
                    : ({1'b0, move_x_q ? x_whole_i[WholeBits-2:DepthBits] : y_whole_i[WholeBits-2:DepthBits], low_step}
                       ^ {WholeBits{inverse_q}}) & {WholeBits{move_q}};
  // Its upper half with either carry, so that the sum is no longer than the rest's.
  localparam int unsigned Half = WholeBits / 2;
  localparam int unsigned U    = WholeBits - Half;
  logic [Half:0]  lower;
  logic [U-1:0]   upper, upper_one;
  assign lower     = {1'b0, whole_from[Half-1:0]} + {1'b0, whole_step[Half-1:0]}
                   + (Half + 1)'(move_q && !load_q && !rest_q[R-1]);
  assign upper     = whole_from[WholeBits-1:Half] + whole_step[WholeBits-1:Half];
  assign upper_one = whole_from[WholeBits-1:Half] + whole_step[WholeBits-1:Half] + 1'b1;
  always_ff @(posedge clk_i) begin
    if (ready_i) whole_q <= {lower[Half] ? upper_one : upper, lower[Half-1:0]};
  end
  assign whole_o      = whole_q;
  assign next_whole_o = whole_q[DepthBits-1:0] + (x_whole_i[DepthBits-1:0] ^ {DepthBits{x_less_i}})
                      + DepthBits'(one_carry_q);

  logic unused;
  assign unused = &{1'b0, major[R-1], one_major[R-1]};
endmodule
