// With one axis selected each link has the word of the neighbour on that axis, and no other; with none it is 0.
// The control block is proven to select one at most.
`default_nettype none
module harness(input wire [`DIMENSION-1:0] axis, input wire [`NODES*`WORK-1:0] work,
    output wire cover_none, output wire cover_last);
  wire [`NODES*`WORK-1:0] link;
  dut dut(.axis(axis) `PORTS);
  always @(*) assume ((axis & (axis - 1'b1)) == 0);
  genvar node, bit_of_axis;
  generate
    for (node = 0; node < `NODES; node = node + 1) begin: nodes
      wire [`WORK-1:0] received = link[node*`WORK+:`WORK];
      always @(*) assert (axis != 0 || received == 0);
      for (bit_of_axis = 0; bit_of_axis < `DIMENSION; bit_of_axis = bit_of_axis + 1) begin: axes
        always @(*) assert (!axis[bit_of_axis] || received == work[(node^(1<<bit_of_axis))*`WORK+:`WORK]);
      end
    end
  endgenerate
  assign cover_none = axis == 0 & work != 0;
  assign cover_last = axis[`DIMENSION-1] & link != 0;
endmodule
