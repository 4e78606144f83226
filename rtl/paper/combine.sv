// How two lines of an entry combine: AND or OR (Table 7, 4.2.1).
// Twin:    ShadowDecision::combine in model/unit/shadow_decision.h, in the order of its arguments:
//          Table 7 as printed is not symmetric.
// Numbers: exact; the points are those where the lines take their Fractions.
// Timing:  combinational: a line_test of FractionBits each way, then a few gates.
module combine (
  input  logic              vertex_per_entry_i,  // policies
  input  logic              table7_printed_i,
  input  shadow_pkg::line_t a_i,
  input  shadow_pkg::line_t b_i,
  input  logic [shadow_pkg::FractionBits:0] a_complement_i,  // 1 - Fraction of a, of b
  input  logic [shadow_pkg::FractionBits:0] b_complement_i,
  input  logic              vertex_i,            // the entry's Vertex Flag
  output logic              and_o
);
  localparam int unsigned S = shadow_pkg::SlopeBits;
  localparam int unsigned F = shadow_pkg::FractionBits;
  localparam logic [F:0] One = {1'b1, {F{1'b0}}};

  // ---- 4.2.1: does each line hold the point where the other takes its Fraction? ----
  logic [F:0] ax, anx, ay, bx, bnx, by;  // of those points
  logic a_holds, b_holds, both_through, fractions_and;

  // Along the major axis it is 0 or 1, along the minor one the Fraction.
  logic [F:0] au, anu, bu, bnu;  // along the direction of travel, and 1 less that
  assign au  = !a_i.x_major ? {1'b0, a_i.fraction} : a_i.cross_flag ? One : '0;
  assign anu = !a_i.x_major ? a_complement_i : a_i.cross_flag ? '0 : One;
  assign ay  = a_i.x_major ? {1'b0, a_i.fraction} : a_i.cross_flag ? One : '0;
  assign bu  = !b_i.x_major ? {1'b0, b_i.fraction} : b_i.cross_flag ? One : '0;
  assign bnu = !b_i.x_major ? b_complement_i : b_i.cross_flag ? '0 : One;
  assign by  = b_i.x_major ? {1'b0, b_i.fraction} : b_i.cross_flag ? One : '0;
  assign ax  = a_i.x_positive ? au : anu;
  assign anx = a_i.x_positive ? anu : au;
  assign bx  = b_i.x_positive ? bu : bnu;
  assign bnx = b_i.x_positive ? bnu : bu;

  line_test #(.PointBits(F)) a_test (
    .line_i(a_i), .x_i(bx), .nx_i(bnx), .y_i(by), .holds_o(a_holds)
  );
  line_test #(.PointBits(F)) b_test (
    .line_i(b_i), .x_i(ax), .nx_i(anx), .y_i(ay), .holds_o(b_holds)
  );
  assign both_through  = !(a_i.start_here || a_i.end_here || b_i.start_here || b_i.end_here);
  assign fractions_and = both_through ? a_holds && b_holds : a_holds || b_holds;

  // ---- Table 7, ordered by angle ----
  // Octants x+, y+, y-, x-; the angle falls with the slope in the odd ones.
  logic         a_odd, b_odd;
  logic [S+1:0] a_angle, b_angle;
  assign a_odd   = a_i.x_major ^ a_i.x_positive;
  assign b_odd   = b_i.x_major ^ b_i.x_positive;
  assign a_angle = {!a_i.x_positive, a_odd, a_i.slope ^ {S{a_odd}}};
  assign b_angle = {!b_i.x_positive, b_odd, b_i.slope ^ {S{b_odd}}};

  logic a_first, parallel;
  logic low_left, low_start, low_end, high_left, high_start, high_end;
  logic low_both, high_both, goes_on, end_seen_from_high, end_of_low, cannot_meet, angle_and;

  always_comb begin
    a_first    = a_angle < b_angle;
    parallel   = a_angle == b_angle;
    low_left   = a_first ? a_i.left : b_i.left;
    low_start  = a_first ? a_i.start_here : b_i.start_here;
    low_end    = a_first ? a_i.end_here : b_i.end_here;
    high_left  = a_first ? b_i.left : a_i.left;
    high_start = a_first ? b_i.start_here : a_i.start_here;
    high_end   = a_first ? b_i.end_here : a_i.end_here;

    low_both   = low_start && low_end;
    high_both  = high_start && high_end;
    // Outlines that go on from one line into the other have equal L/R.
    goes_on            = low_left == high_left;
    end_seen_from_high = high_end != goes_on;
    end_of_low         = low_end;
    cannot_meet        = 1'b0;
    if (!vertex_per_entry_i) begin
      if (low_both) end_of_low = end_seen_from_high;
      cannot_meet = low_both ? high_both : !high_both && low_end != end_seen_from_high;
    end
    angle_and = parallel || cannot_meet ? fractions_and : high_left != end_of_low;
  end

  // ---- Table 7 as printed, A before B ----
  logic exp1_or, same_kind, printed_first, printed_and;
  always_comb begin
    exp1_or   = b_i.left == a_i.end_here;
    same_kind = a_i.x_major == b_i.x_major && a_i.x_positive == b_i.x_positive;
    if (same_kind) printed_first = a_i.slope <= b_i.slope;
    else if (a_i.x_major) printed_first = a_i.x_positive;
    // The pairs (y+, x+) and (y-, x-) are not printed; they follow the order of the angles.
    else if (b_i.x_major && a_i.x_positive == b_i.x_positive) printed_first = !a_i.x_positive;
    else printed_first = a_i.x_positive;
    printed_and = exp1_or != printed_first;
  end

  logic meet;
  assign meet = vertex_per_entry_i ? vertex_i
                                   : (a_i.start_here || a_i.end_here)
                                     && (b_i.start_here || b_i.end_here);
  assign and_o = !meet ? fractions_and : table7_printed_i ? printed_and : angle_and;

  logic unused_polygon;
  assign unused_polygon = ^{a_i.polygon, b_i.polygon};
endmodule
