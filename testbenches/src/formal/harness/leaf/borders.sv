// The boxes around the groups of a leaf. In any clock the harness can watch one photon that is present. From the clock in which the
// photon's group reaches the boxes, the photon is between the borders of its group on all axes: a leaf's first group is in the first
// box until the next leaf begins, and the group that came last is in the second.
`default_nettype none
module harness(input wire clock, input wire comes, input wire first, input wire watch, input wire [1:0] lane,
    input wire [3:0] present, input wire [4*`H-1:0] x, input wire [4*`H-1:0] y, input wire [4*`H-1:0] z,
    output wire cover_kept, output wire cover_wide);
  wire [6*`H-1:0] low, high;
  dut dut(.clock(clock), .comes(comes), .first_comes(comes & first), `BORDERS `LANES);

  wire [3*`H-1:0] photon = {z[lane*`H+:`H], y[lane*`H+:`H], x[lane*`H+:`H]};
  reg half_watched = 0, group_watched = 0, again = 0;
  reg [3*`H-1:0] half_photon = 0, group_photon = 0;
  // For each box, whether it has a watched photon, and the photon.
  reg [1:0] has = 0;
  reg [6*`H-1:0] held = 0;
  always @(posedge clock) begin
    half_watched <= watch & present[lane];
    half_photon <= photon;
    group_watched <= half_watched;
    group_photon <= half_photon;
    if (comes) begin
      has <= {group_watched, first ? group_watched : has[0]};
      held <= {group_photon, first ? group_photon : held[0+:3*`H]};
      again <= has[0] & ~first;
    end
  end
  integer i;
  always @(*)
    for (i = 0; i < 6; i = i + 1)
      assert (!has[i/3] || (low[i*`H+:`H] <= held[i*`H+:`H] && held[i*`H+:`H] <= high[i*`H+:`H]));
  assign cover_kept = has[0] & again;
  assign cover_wide = has[1] & low[3*`H+:`H] < held[3*`H+:`H] & held[3*`H+:`H] < high[3*`H+:`H];
endmodule
