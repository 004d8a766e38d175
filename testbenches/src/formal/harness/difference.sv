// |a - b|, in words without a subtraction: the smaller and the magnitude make the larger.
`default_nettype none
module harness(input wire [`COORDINATE-1:0] a, input wire [`COORDINATE-1:0] b,
    output wire cover_below, output wire cover_above);
  wire [`COORDINATE-1:0] magnitude;
  dut dut(.a(a), .b(b), .magnitude(magnitude));
  wire [`COORDINATE:0] from_a = {1'b0, a} + {1'b0, magnitude};
  wire [`COORDINATE:0] from_b = {1'b0, b} + {1'b0, magnitude};
  always @(*) assert (a > b ? from_b == {1'b0, a} : from_a == {1'b0, b});
  assign cover_below = a < b;
  assign cover_above = a > b && magnitude == {`COORDINATE{1'b1}};
endmodule
