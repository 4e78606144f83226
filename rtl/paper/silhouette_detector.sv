// Silhouette detector (SLD, 3.3.2): which of a record's lines is the other side of a new one's edge.
// Twin:    model/unit/silhouette_detector.h.
// Timing:  combinational.
module silhouette_detector (
  input  logic                    match_polygon_id_i,  // lines of one polygon never cancel each other
  input  shadow_pkg::line_t       line_i,              // the new line
  input  logic [shadow_pkg::LinesPerRecord*shadow_pkg::LineBits-1:0] lines_i,  // the record's, oldest first
  input  logic [shadow_pkg::LineCountBits-1:0]       count_i,
  output logic                    found_o,             // some line cancels it
  output logic [shadow_pkg::LinesPerRecord-1:0]      from_first_o  // bit i: the first such line is i or before
);
  localparam int unsigned Lines    = shadow_pkg::LinesPerRecord;
  localparam int unsigned LineBits = shadow_pkg::LineBits;

  logic seen;
  shadow_pkg::line_t other;

  always_comb begin
    seen  = 1'b0;
    other = '0;
    for (int unsigned i = 0; i < Lines; i++) begin
      other = lines_i[i*LineBits +: LineBits];
      // Opposite L/R, all else equal. Start-here is not part of the published record.
      if (shadow_pkg::LineCountBits'(i) < count_i
          && other.left != line_i.left && other.cross_flag == line_i.cross_flag
          && other.x_major == line_i.x_major && other.x_positive == line_i.x_positive
          && other.end_here == line_i.end_here
          && other.slope == line_i.slope && other.fraction == line_i.fraction
          && !(match_polygon_id_i && other.polygon == line_i.polygon)) seen = 1'b1;
      from_first_o[i] = seen;
    end
    found_o = seen;
  end

  logic unused;
  assign unused = &{1'b0, line_i.start_here, other.start_here};
endmodule
