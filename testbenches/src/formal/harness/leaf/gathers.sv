// Whether a batch gathers the facings of the two leaves of a pair: the bit of the leaf's facing, `CLOCKS clocks later, and 0 for
// a leaf that is not there.
`default_nettype none
module harness(input wire clock, input wire [`FACINGS-1:0] facings, input wire [`FACING-1:0] facing_0,
    input wire [`FACING-1:0] facing_1, input wire is_there_0, input wire is_there_1, output wire cover_both,
    output wire cover_one);
  wire gathered_0, gathered_1;
  dut dut(.clock(clock), .facings(facings), .facing_0(facing_0), .facing_1(facing_1), .is_there_0(is_there_0),
    .is_there_1(is_there_1), .gathered_0(gathered_0), .gathered_1(gathered_1));

  reg [`CLOCKS-1:0] due_0 = 0, due_1 = 0;
  always @(posedge clock) begin
    due_0 <= {due_0, is_there_0 & facings[facing_0]};
    due_1 <= {due_1, is_there_1 & facings[facing_1]};
  end
  always @(*) begin
    assert (gathered_0 == due_0[`CLOCKS-1]);
    assert (gathered_1 == due_1[`CLOCKS-1]);
  end
  assign cover_both = gathered_0 & gathered_1;
  assign cover_one = gathered_1 & ~gathered_0;
endmodule
