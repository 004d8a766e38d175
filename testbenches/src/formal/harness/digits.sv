// The square as three products of the magnitude's digits, for every magnitude.
`default_nettype none
module harness(input wire [7:0] root, output wire cover_largest);
  wire [15:0] squares;
  wire [5:0] low_product, high_product;
  dut dut(.root(root), .squares(squares), .low_product(low_product), .high_product(high_product));
  wire [15:0] wide = root;
  always @(*) assert ({1'b0, squares} + 32 * low_product + 128 * high_product == wide * wide);
  assign cover_largest = root == 8'hff & low_product != 0 & high_product != 0;
endmodule
