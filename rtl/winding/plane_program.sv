// Plane program: the sums of products of a triangle's setup, term by term and digit by digit.
//
// Numbers: factors and digits as plane_sums has them. A digit above a factor's topmost is told as 4 or more.
// Timing:  combinational.
module plane_program (
  input  logic [4:0] pc_i,       // sum
  input  logic [1:0] term_i,     // its product
  input  logic [2:0] digit_i,    // digit of the sum
  input  logic [1:0] longest_i,  // edge
  output logic       last_term_o,
  output logic       last_digit_o,
  output logic       minus_o,
  output logic       by_area_o,  // the other way round if the area is negative
  output logic [3:0] to_o,       // where the sum goes
  output logic [1:0] index_o,    // corner, length; division
  // factors
  output logic [2:0] a_kind_o,
  output logic [1:0] a_axis_o,
  output logic [1:0] a_index_o,
  output logic [1:0] b_kind_o,
  output logic       b_axis_o,
  output logic [1:0] b_index_o,
  output logic [2:0] b_digit_o
);
  localparam int unsigned F = shadow_pkg::FractionBits;
  // The radius squared is worked with without so many digits.
  localparam logic [2:0] PowerDigits = F <= 3 ? 3'd2 : 3'd1;

  // Sums, in this order but for the jumps of plane_setup.
  localparam logic [4:0] Area = 5'd0, Corner0 = 5'd1, GradX = 5'd2, GradY = 5'd3, Corner1 = 5'd4, StepX = 5'd5,
                         Corner2 = 5'd6, Length0 = 5'd7, Length1 = 5'd8, Length2 = 5'd9, Square = 5'd10,
                         StepY = 5'd11, Start = 5'd12, NarrowX = 5'd16, NarrowY = 5'd17, Along = 5'd18;
  localparam logic [2:0] AEdge = 3'd0, ACorner = 3'd1, ACentre = 3'd2, ATexel = 3'd3, ARadius = 3'd4,
                         AAreaLow = 3'd5, AAreaHigh = 3'd6;
  localparam logic [1:0] BEdge = 2'd0, BGradient = 2'd1, BBest = 2'd2, BArea = 2'd3;
  localparam logic [1:0] X = 2'd0, Y = 2'd1, Z = 2'd2;
  localparam logic [3:0] ToArea = 4'd1, ToCorner = 4'd2, ToGradX = 4'd3, ToGradY = 4'd4, ToLength = 4'd5,
                         ToSquare = 4'd6, ToAlong = 4'd7, ToDivider = 4'd8;
  localparam logic [1:0] DivStepX = 2'd0, DivStepY = 2'd1, DivStart = 2'd2, DivNarrow = 2'd3;

  logic       second;
  logic [1:0] edge_before;  // the longest one
  logic [2:0] digits, terms;
  assign second       = term_i[0];
  assign edge_before  = longest_i == 2'd0 ? 2'd2 : longest_i - 2'd1;
  assign last_term_o  = {1'b0, term_i} + 3'd1 == terms;
  assign last_digit_o = digit_i + 3'd1 == digits;

  always_comb begin
    terms     = 3'd2;
    digits    = 3'd2;
    minus_o   = second;
    by_area_o = 1'b0;
    index_o   = 2'd0;
    a_kind_o  = AEdge;
    a_axis_o  = second ? Y : X;
    a_index_o = 2'd0;
    b_kind_o  = BEdge;
    b_axis_o  = second;
    b_index_o = 2'd0;
    b_digit_o = digit_i;
    unique case (pc_i)
      Area: begin
        a_axis_o  = X;
        a_index_o = second ? 2'd0 : 2'd2;
        b_axis_o  = 1'b1;
        b_index_o = second ? 2'd2 : 2'd0;
        to_o      = ToArea;
      end
      Corner0, Corner1, Corner2: begin
        index_o   = pc_i == Corner0 ? 2'd0 : pc_i == Corner1 ? 2'd1 : 2'd2;
        a_kind_o  = ACorner;
        a_axis_o  = second ? X : Y;
        b_index_o = index_o;
        to_o      = ToCorner;
      end
      GradX: begin
        a_axis_o  = Z;
        a_index_o = second ? 2'd0 : 2'd2;
        b_axis_o  = 1'b1;
        b_index_o = second ? 2'd2 : 2'd0;
        by_area_o = 1'b1;
        to_o      = ToGradX;
      end
      GradY: begin
        a_axis_o  = Z;
        a_index_o = second ? 2'd2 : 2'd0;
        b_axis_o  = 1'b0;
        b_index_o = second ? 2'd0 : 2'd2;
        by_area_o = 1'b1;
        to_o      = ToGradY;
      end
      StepX, StepY: begin
        terms    = 3'd1;
        digits   = 3'd4;
        index_o  = pc_i == StepX ? DivStepX : DivStepY;
        a_kind_o = ATexel;
        b_kind_o = BGradient;
        b_axis_o = pc_i == StepY;
        to_o     = ToDivider;
      end
      Length0, Length1, Length2: begin
        minus_o   = 1'b0;
        index_o   = pc_i == Length0 ? 2'd0 : pc_i == Length1 ? 2'd1 : 2'd2;
        a_index_o = index_o;
        b_index_o = index_o;
        to_o      = ToLength;
      end
      // The longest edge's square times the radius's, less 16 times the area's.
      Square: begin
        terms     = 3'd3;
        digits    = 3'd6;
        minus_o   = term_i != 2'd0;
        a_kind_o  = term_i == 2'd0 ? ARadius : term_i == 2'd1 ? AAreaLow : AAreaHigh;
        b_kind_o  = term_i == 2'd0 ? BBest : BArea;
        b_digit_o = digit_i - (term_i == 2'd0 ? PowerDigits : term_i == 2'd1 ? 3'd0 : 3'd2);
        to_o      = ToSquare;
      end
      Start: begin
        digits   = 3'd4;
        minus_o  = 1'b0;
        index_o  = DivStart;
        a_kind_o = ACentre;
        b_kind_o = BGradient;
        to_o     = ToDivider;
      end
      NarrowX, NarrowY: begin
        terms     = 3'd1;
        a_axis_o  = Z;
        a_index_o = longest_i;
        b_axis_o  = pc_i == NarrowY;
        b_index_o = longest_i;
        to_o      = pc_i == NarrowX ? ToGradX : ToGradY;
      end
      Along: begin
        minus_o   = 1'b1;
        a_index_o = longest_i;
        b_index_o = edge_before;
        to_o      = ToAlong;
      end
      default: begin  // depth along the longest edge
        terms     = 3'd1;
        digits    = 3'd4;
        index_o   = DivNarrow;
        a_axis_o  = Z;
        a_index_o = longest_i;
        b_kind_o  = BBest;
        to_o      = ToDivider;
      end
    endcase
  end
endmodule
