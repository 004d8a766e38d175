// A unit of the spatial machine by its formula.
`default_nettype none
module harness(`INPUTS output wire cover_one, output wire cover_two);
  wire [`OUT-1:0] result;
  `SECOND
  dut dut(`PORTS);
  always @(*) begin
    `CLAIMS
  end
  assign cover_one = `COVER_ONE;
  assign cover_two = `COVER_TWO;
endmodule
