// Address generator (ADRG): where the memories keep a texel.
// Twin:    model/unit/address_generator.h.
// Timing:  combinational.
module address_generator (
  input  shadow_pkg::settings_t                 settings_i,
  input  logic [shadow_pkg::MapBits-1:0]        x_i,
  input  logic [shadow_pkg::MapBits-1:0]        y_i,
  output logic [shadow_pkg::RecordAddrBits-1:0] bucket_o,  // (x + 181 y) mod 2^buckets_log2
  output logic [shadow_pkg::TexelAddrBits-1:0]  texel_o    // its word: {y, x / 4} at the map's pitch
);
  localparam int unsigned Bits = shadow_pkg::RecordAddrBits;

  logic [Bits-1:0] x, y, y_5, y_45, mask;
  // 181 = 4 * 5 * 9 + 1: four adders with that of x.
  assign x    = Bits'(x_i);
  assign y    = Bits'(y_i);
  assign y_5  = y + (y << 2);
  assign y_45 = y_5 + (y_5 << 3);
  assign mask = ~({Bits{1'b1}} << settings_i.buckets_log2);
  assign bucket_o = (x + (y_45 << 2) + y) & mask;
  assign texel_o  = (shadow_pkg::TexelAddrBits'(y_i) << settings_i.pitch_log2)
                  | shadow_pkg::TexelAddrBits'(x_i[shadow_pkg::MapBits-1:2]);

  logic unused;
  assign unused = &{1'b0, settings_i, x_i[1:0]};
endmodule
