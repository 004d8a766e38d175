// a + b, modulo the width.
`default_nettype none
module harness(input wire [`SUM-1:0] a, input wire [`SUM-1:0] b, output wire cover_wraps);
  wire [`SUM-1:0] sum;
  dut dut(.a(a), .b(b), .sum(sum));
  wire [`SUM:0] exact = {1'b0, a} + {1'b0, b};
  always @(*) begin
    assert (sum == exact[`SUM-1:0]);
    assert (a == sum - b);
  end
  assign cover_wraps = exact[`SUM];
endmodule
