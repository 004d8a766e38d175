// The square of one number, or m (m + 1) where a half is left over; the reference is a product, which a search can decide
// since there is one input.
`default_nettype none
module harness(input wire [`DIFFERENCE-1:0] root, output wire cover_largest);
  wire [2*`DIFFERENCE-1:0] square;
  dut dut(.root(root), .square(square));
  wire [2*`DIFFERENCE-1:0] wide = root;
  always @(*) assert (square == wide * wide + (`HALF ? wide : 0));
  assign cover_largest = root == {`DIFFERENCE{1'b1}} && square != 0;
endmodule
