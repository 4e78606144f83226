// Tile scan: the tiles of the map one after the other, to wipe or to settle them.
//
// Timing:  the first tile a cycle after run_i; step_i in a cycle of tile_valid_o goes on to the next.
module tile_scan #(
  localparam int unsigned M = shadow_pkg::MapBits
) (
  input  logic         clk_i,
  input  logic         rst_ni,
  input  logic         clear_i,
  input  logic [M:0]   map_width_i,
  input  logic [M:0]   map_height_i,
  input  logic         run_i,         // held until the last tile was taken, and longer
  output logic         started_o,
  output logic         tile_valid_o,
  input  logic         step_i,
  output logic [M-4:0] column_o,
  output logic [M-4:0] row_o,
  output logic         done_o
);
  logic [M-3:0] column_q, row_q, columns, rows;
  logic         last_column, last, started_q, done_q;
  assign columns     = (M-2)'((M + 2)'(map_width_i) + (M + 2)'(7) >> 3);
  assign rows        = (M-2)'((M + 2)'(map_height_i) + (M + 2)'(7) >> 3);
  assign last_column = column_q == columns - 1'b1;
  assign last        = last_column && row_q == rows - 1'b1;
  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      started_q <= 1'b0;
      done_q    <= 1'b0;
    end else begin
      started_q <= run_i && !clear_i;
      done_q    <= run_i && !clear_i && (done_q || (step_i && last));
    end
  end
  always_ff @(posedge clk_i) begin
    if (!started_q) begin
      column_q <= '0;
      row_q    <= '0;
    end else if (step_i) begin
      column_q <= last_column ? '0 : column_q + 1'b1;
      if (last_column) row_q <= row_q + 1'b1;
    end
  end
  assign started_o    = started_q;
  assign tile_valid_o = started_q && !done_q;
  assign column_o     = column_q[M-4:0];
  assign row_o        = row_q[M-4:0];
  assign done_o       = done_q;
endmodule
