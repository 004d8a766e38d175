// What is squared, from the two middles: a photon stands for the middle of its cell, 2^EXTRA fine steps wide, a query for
// that of its fine step, in halves of which all is a whole number. Half a step that is left is not part of the magnitude,
// and what is too large for it is clamped; of plain numbers, where EXTRA is 0, neither is ever so.
`default_nettype none
module harness(input wire [`COORDINATE-1:0] a, input wire [`PHOTON-1:0] b,
    output wire cover_below, output wire cover_largest);
  wire [`DIFFERENCE-1:0] magnitude;
  dut dut(.a(a), .b(b), .magnitude(magnitude));
  wire [`COORDINATE+1:0] query = {1'b0, a, 1'b1};
  wire [`COORDINATE+1:0] photon = {b, 1'b1} << `EXTRA;
  wire [`COORDINATE+1:0] halves = query > photon ? query - photon : photon - query;
  wire [`COORDINATE:0] distance = halves[`COORDINATE+1:1];
  wire [`DIFFERENCE-1:0] largest = {`DIFFERENCE{1'b1}};
  always @(*) assert (magnitude == (distance > largest ? largest : distance));
  assign cover_below = query < photon && magnitude != 0 && magnitude != largest;
  assign cover_largest = query > photon && magnitude == largest;
endmodule
