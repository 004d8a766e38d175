// if a > b, 0, else the power.
`default_nettype none
module harness(input wire [`WORK-1:0] a, input wire [`RADIUS_SQ-1:0] b, input wire [`POWER-1:0] power,
    output wire cover_edge, output wire cover_out);
  wire [`WORK-1:0] gated;
  dut dut(.a(a), .b(b), .power(power), .gated(gated));
  always @(*) begin
    if (a > b) assert (gated == 0);
    else assert (gated == power);
  end
  assign cover_edge = a == b && gated != 0;
  assign cover_out = a > b && power != 0;
endmodule
