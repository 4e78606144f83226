// The unit's registers behind AXI4-Lite. docs/rtl.md has the map; addresses here are word numbers.
//
// Timing: a write takes effect in the cycle after address and data have both arrived; one access
//         at a time. Settings are written while the unit is idle; writes to them are ignored else.
module unit_registers (
  input  logic        clk_i,
  input  logic        rst_ni,
  // AXI4-Lite
  input  logic        s_awvalid_i,
  output logic        s_awready_o,
  input  logic [7:0]  s_awaddr_i,
  input  logic        s_wvalid_i,
  output logic        s_wready_o,
  input  logic [31:0] s_wdata_i,
  output logic        s_bvalid_o,
  input  logic        s_bready_i,
  input  logic        s_arvalid_i,
  output logic        s_arready_o,
  input  logic [7:0]  s_araddr_i,
  output logic        s_rvalid_o,
  input  logic        s_rready_i,
  output logic [31:0] s_rdata_o,
  // to the unit
  output logic        start_o,        // one cycle, with pass_o and count_o
  output logic        abort_o,        // one cycle
  output logic [2:0]  pass_o,
  output logic [31:0] count_o,
  output logic [4:0]  fraction_bits_o,
  output logic [12:0] map_width_o,
  output logic [12:0] map_height_o,
  output logic [3:0]  pitch_log2_o,
  output logic [4:0]  buckets_log2_o,
  output logic [24:0] record_limit_o,
  output logic [24:0] chain_limit_o,
  output logic [16:0] plane_tolerance_o,
  output logic [6:0]  policy_o,
  output logic [5:0]  counter_select_o,
  output logic        counter_clear_o,  // one cycle: another event was selected
  // from the unit
  input  logic        busy_i,
  input  logic [2:0]  pass_i,
  input  logic        overflow_i,
  input  logic [31:0] cycles_i,
  input  logic [24:0] records_i,
  input  logic [31:0] counter_i
);
  localparam logic [5:0] Control = 6'h00, Status = 6'h01, Count = 6'h02, FractionBits = 6'h03,
    MapWidth = 6'h04, MapHeight = 6'h05, PitchLog2 = 6'h06, BucketsLog2 = 6'h07,
    RecordLimit = 6'h08, ChainLimit = 6'h09, PlaneTolerance = 6'h0a, Policy = 6'h0b,
    Cycles = 6'h0c, Records = 6'h0d, CounterSelect = 6'h0e, Counter = 6'h0f, Identity = 6'h10;
  localparam logic [31:0] IdentityValue = 32'h4b47_0001;  // "KG", version 1

  logic        write, settings_open;
  logic [5:0]  write_at, read_at;
  logic [31:0] read_data;
  logic        unused;

  assign unused = &{1'b0, s_awaddr_i[1:0], s_araddr_i[1:0]};  // words alone are addressed

  // Address and data are taken in one cycle, and only when the last answer has gone.
  assign write         = s_awvalid_i && s_wvalid_i && !s_bvalid_o;
  assign s_awready_o   = write;
  assign s_wready_o    = write;
  assign write_at      = s_awaddr_i[7:2];
  assign read_at       = s_araddr_i[7:2];
  assign s_arready_o   = s_arvalid_i && !s_rvalid_o;
  assign settings_open = write && !busy_i;

  always_comb begin
    read_data = '0;
    case (read_at)
      Status:         read_data = {23'd0, overflow_i, 1'b0, pass_i, 3'd0, busy_i};
      Count:          read_data = count_o;
      FractionBits:   read_data = 32'(fraction_bits_o);
      MapWidth:       read_data = 32'(map_width_o);
      MapHeight:      read_data = 32'(map_height_o);
      PitchLog2:      read_data = 32'(pitch_log2_o);
      BucketsLog2:    read_data = 32'(buckets_log2_o);
      RecordLimit:    read_data = 32'(record_limit_o);
      ChainLimit:     read_data = 32'(chain_limit_o);
      PlaneTolerance: read_data = 32'(plane_tolerance_o);
      Policy:         read_data = 32'(policy_o);
      Cycles:         read_data = cycles_i;
      Records:        read_data = 32'(records_i);
      CounterSelect:  read_data = 32'(counter_select_o);
      Counter:        read_data = counter_i;
      Identity:       read_data = IdentityValue;
      default:        read_data = '0;  // Control, and what is not there
    endcase
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      s_bvalid_o      <= 1'b0;
      s_rvalid_o      <= 1'b0;
      start_o         <= 1'b0;
      abort_o         <= 1'b0;
      counter_clear_o <= 1'b0;
    end else begin
      s_bvalid_o      <= write || (s_bvalid_o && !s_bready_i);
      s_rvalid_o      <= s_arready_o || (s_rvalid_o && !s_rready_i);
      start_o         <= settings_open && write_at == Control && !s_wdata_i[7] && s_wdata_i[2:0] != 3'd0;
      abort_o         <= write && write_at == Control && s_wdata_i[7];
      counter_clear_o <= write && write_at == CounterSelect;
    end
  end

  always_ff @(posedge clk_i) begin
    if (s_arready_o) s_rdata_o <= read_data;
    if (write && write_at == CounterSelect) counter_select_o <= s_wdata_i[5:0];
    if (settings_open) begin
      case (write_at)
        Control:        pass_o            <= s_wdata_i[2:0];
        Count:          count_o           <= s_wdata_i;
        FractionBits:   fraction_bits_o   <= s_wdata_i[4:0];
        MapWidth:       map_width_o       <= s_wdata_i[12:0];
        MapHeight:      map_height_o      <= s_wdata_i[12:0];
        PitchLog2:      pitch_log2_o      <= s_wdata_i[3:0];
        BucketsLog2:    buckets_log2_o    <= s_wdata_i[4:0];
        RecordLimit:    record_limit_o    <= s_wdata_i[24:0];
        ChainLimit:     chain_limit_o     <= s_wdata_i[24:0];
        PlaneTolerance: plane_tolerance_o <= s_wdata_i[16:0];
        Policy:         policy_o          <= s_wdata_i[6:0];
        default: ;
      endcase
    end
  end
endmodule
