// Register fields to the winding profile's settings.
module unit_settings (
  input  logic [4:0]  fraction_bits_i,
  input  logic [12:0] map_width_i,
  input  logic [12:0] map_height_i,
  input  logic [3:0]  pitch_log2_i,
  input  logic [4:0]  buckets_log2_i,
  input  logic [24:0] record_limit_i,
  input  logic [24:0] chain_limit_i,
  input  logic [16:0] plane_tolerance_i,
  input  logic [6:0]  policy_i,
  output shadow_pkg::settings_t settings_o
);
  logic unused;
  assign unused = &{1'b0, map_width_i[12:shadow_pkg::MapBits], map_height_i[12:shadow_pkg::MapBits],
                    pitch_log2_i, buckets_log2_i, policy_i};

  assign settings_o.texel_bits         = fraction_bits_i;
  assign settings_o.map_width          = map_width_i[shadow_pkg::MapBits:0];
  assign settings_o.map_height         = map_height_i[shadow_pkg::MapBits:0];
  assign settings_o.record_limit       = record_limit_i;
  assign settings_o.chain_limit        = chain_limit_i;
  assign settings_o.plane_tolerance    = plane_tolerance_i;
  assign settings_o.paper_semantics    = policy_i[0];
  assign settings_o.skip_receiver_mask = policy_i[1];
  assign settings_o.skip_first_test    = policy_i[2];
  assign settings_o.skip_tiles         = policy_i[3];
  assign settings_o.skip_edges         = policy_i[4];
  assign settings_o.skip_fragments     = policy_i[5];
endmodule
