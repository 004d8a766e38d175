// No photon in range is skipped. A query anywhere in the batch's box and a photon anywhere in the box of group `GROUP of the pair:
// if the photon is in range of the query, by the sum of the squares of their differences, the group is in range `CLOCKS clocks
// later. One such pair in one clock is watched, which is any. Where a photon is between the steps of queries (`HALF), its distance is
// n steps and a half, and the square is that of the distance less a quarter: n (n + 1).
`default_nettype none
module harness(input wire clock, input wire watch, input wire [3*`C-1:0] query, input wire [3*`H-1:0] photon,
    input wire [3*`C-1:0] query_low, input wire [3*`C-1:0] query_high, input wire [12*`H-1:0] group_low,
    input wire [12*`H-1:0] group_high, output wire cover_far, output wire cover_near);
  wire [3:0] in_range;
  wire [3*2*`R-1:0] group_square;
  wire [2:0] group_far;
  dut dut(.clock(clock), `BORDERS `SQUARES .in_range_0(in_range[0]), .in_range_1(in_range[1]), .in_range_2(in_range[2]),
    .in_range_3(in_range[3]));

  wire [2:0] inside, near;
  wire [3*2*`R-1:0] square;
  genvar axis;
  generate
    for (axis = 0; axis < 3; axis = axis + 1) begin : of
      wire [`C-1:0] a = query[axis*`C+:`C];
      wire [`H-1:0] b = photon[axis*`H+:`H];
      wire [`H-1:0] low = group_low[(3*`GROUP+axis)*`H+:`H];
      wire [`H-1:0] high = group_high[(3*`GROUP+axis)*`H+:`H];
      wire [`C-1:0] distance = a < `LINE ? `LINE - a - `HALF : a - `LINE;
      wire [`R-1:0] counted = distance;
      assign inside[axis] = query_low[axis*`C+:`C] <= a && a <= query_high[axis*`C+:`C] && low <= b && b <= high;
      assign near[axis] = distance < (1 << `R);
      assign square[axis*2*`R+:2*`R] = counted * (counted + `HALF);
    end
  endgenerate
  // The pairs on their way: whether one is watched, and its squares.
  localparam W = 3*2*`R + 1;
  reg watched = 0;
  reg [`CLOCKS*W-1:0] pairs = 0;
  wire watches = watch & ~watched & &inside & &near;
  always @(posedge clock) begin
    watched <= watched | watch;
    pairs <= {pairs, watches, square};
  end
  // When the squares of the gaps are there: none is more than that of the pair.
  wire [W-1:0] middle = pairs[(`SQUARE-1)*W+:W];
  wire [W-1:0] pair = pairs[(`CLOCKS-1)*W+:W];
  wire [2*`R+1:0] sum = pair[0+:2*`R] + pair[2*`R+:2*`R] + pair[4*`R+:2*`R];
  wire found = pair[W-1] & sum <= `LIMIT;
  integer i;
  always @(*) begin
    for (i = 0; i < 3; i = i + 1)
      assert (!middle[W-1] || (!group_far[i] && group_square[i*2*`R+:2*`R] <= middle[i*2*`R+:2*`R]));
    assert (!found || in_range[`GROUP]);
  end
  assign cover_far = ~in_range[`GROUP];
  assign cover_near = found;
endmodule
