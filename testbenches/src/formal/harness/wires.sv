// The wires of the top, whose parts are taken out: each input of a part is the one output that it must be.
`default_nettype none
module harness(`INPUTS output wire cover_moves);
  `OUTPUTS
  dut dut(`PORTS);
  always @(*) begin
    `EQUALITIES
  end
  assign cover_moves = `SOME;
endmodule
