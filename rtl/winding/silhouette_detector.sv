// Which segments of a record meet a new one: the other piece of an inner edge, or the same point.
//
// Twins:   model/unit/winding/segment.h, dot and opposes; silhouette_buffer.cpp, add
// Timing:  combinational.
module silhouette_detector (
  input  logic [shadow_pkg::SegmentBits-1:0]                                segment_i,   // segment_t
  input  logic [shadow_pkg::SegmentsPerRecord*shadow_pkg::SegmentBits-1:0]  segments_i,
  input  logic [shadow_pkg::SegmentCountBits-1:0]                           count_i,     // of segments_i in use
  output logic                                                              may_meet_o,  // some segment could
  output logic                                                              same_dot_o,  // one is the same point
  output logic                                                              opposes_o,   // one cancels it:
  output logic [shadow_pkg::SegmentCountBits-1:0]                           slot_o
);
  localparam int unsigned EndsBits = 4 * shadow_pkg::EndWidth;

  localparam int unsigned W = shadow_pkg::EndWidth;

  // Ends alike and no crossing of the left border: segment_t from its end on is y1, x1, y0, x0, positive,
  // crosses_left, inner.
  function automatic logic is_dot(input logic [EndsBits-1:0] ends, input logic crosses_left);
    is_dot = ends[2*W-1:0] == ends[4*W-1:2*W] && !crosses_left;
  endfunction

  logic dot, inner;
  assign dot        = is_dot(segment_i[EndsBits-1:0], segment_i[EndsBits+1]);
  assign inner      = segment_i[EndsBits+2];
  assign may_meet_o = inner || dot;

  always_comb begin
    same_dot_o = 1'b0;
    opposes_o  = 1'b0;
    slot_o     = '0;
    for (int i = 0; i < shadow_pkg::SegmentsPerRecord; i++) begin
      if (shadow_pkg::SegmentCountBits'(i) < count_i
          && segments_i[i*shadow_pkg::SegmentBits+:EndsBits] == segment_i[EndsBits-1:0]) begin
        if (dot && !segments_i[i*shadow_pkg::SegmentBits+EndsBits+1]) same_dot_o = 1'b1;
        // inner, crosses_left, positive: alike but for the last.
        if (inner && (segments_i[i*shadow_pkg::SegmentBits+EndsBits+:3] ^ segment_i[EndsBits+:3]) == 3'd1) begin
          opposes_o = 1'b1;
          slot_o    = shadow_pkg::SegmentCountBits'(i);
        end
      end
    end
  end
endmodule
