// A sum of the spatial machine, closed by its register: it is exact for the declared photons at full scale. `bound`
// grows by what the group may hold at most, for each of its photons that is there.
`default_nettype none
module harness(input wire clock, input wire [`GROUP-1:0] group, input wire first, input wire [`SUM:0] photons_full_scale,
    output wire cover_sums);
  wire [`SUM-1:0] next_sum;
  reg [`SUM-1:0] sum = 0;
  reg [`SUM:0] bound = 0;
  dut dut(.group(group), .sum(sum), .first(first), .next_sum(next_sum));
  wire [`SUM:0] next_bound = (first ? 0 : bound) + photons_full_scale;
  wire [`SUM:0] exact = (first ? 0 : {1'b0, sum}) + group;
  reg before = 0;
  always @(posedge clock) begin
    sum <= next_sum;
    bound <= next_bound;
    before <= ~first & group != 0;
  end
  always @(*) begin
    assume (`ONE_OF_THE_COUNTS);
    assume (group <= photons_full_scale);
    assume (next_bound <= `LARGEST);
    assert (next_sum == exact);
    assert (sum <= bound && bound <= `LARGEST);
  end
  assign cover_sums = before & sum == `COVERED;
endmodule
