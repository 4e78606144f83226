// Register fields to the paper profile's settings.
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
                    plane_tolerance_i, policy_i};

  assign settings_o.texel_bits       = fraction_bits_i;
  assign settings_o.map_width        = map_width_i[shadow_pkg::MapBits:0];
  assign settings_o.map_height       = map_height_i[shadow_pkg::MapBits:0];
  assign settings_o.pitch_log2       = pitch_log2_i;
  assign settings_o.buckets_log2     = buckets_log2_i;
  assign settings_o.record_limit     = record_limit_i;
  assign settings_o.chain_limit      = chain_limit_i;
  assign settings_o.own_id_literal   = policy_i[0];
  assign settings_o.vertex_per_entry = policy_i[1];
  assign settings_o.table7_printed   = policy_i[2];
  assign settings_o.depth_writes_all = policy_i[3];
  assign settings_o.hidden_removal   = policy_i[5:4];
  assign settings_o.match_polygon_id = policy_i[6];
endmodule
