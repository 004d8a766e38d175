// The box around a leaf. In any clock the harness can watch one photon that is present. From the clock in which the photon's
// group reaches the leaf's box until the next leaf begins, the photon is between the borders on all axes.
`default_nettype none
module harness(input wire clock, input wire comes, input wire first, input wire watch, input wire [1:0] lane,
    input wire [3:0] present, input wire [4*`H-1:0] x, input wire [4*`H-1:0] y, input wire [4*`H-1:0] z,
    output wire cover_kept, output wire cover_wide);
  wire [`H-1:0] low_x, low_y, low_z, high_x, high_y, high_z;
  dut dut(.clock(clock), .comes(comes), .first(first), `LANES
    .low_0(low_x), .low_1(low_y), .low_2(low_z), .high_0(high_x), .high_1(high_y), .high_2(high_z));

  wire [3*`H-1:0] photon = {x[lane*`H+:`H], y[lane*`H+:`H], z[lane*`H+:`H]};
  reg half_watched = 0, group_watched = 0, has = 0, again = 0;
  reg [3*`H-1:0] half_photon = 0, group_photon = 0, held = 0;
  always @(posedge clock) begin
    half_watched <= watch & present[lane];
    half_photon <= photon;
    group_watched <= half_watched;
    group_photon <= half_photon;
    if (comes) begin
      has <= group_watched | (has & ~first);
      again <= has & ~first & ~group_watched;
      if (group_watched) held <= group_photon;
    end
  end
  wire [`H-1:0] held_x, held_y, held_z;
  assign {held_x, held_y, held_z} = held;
  always @(*) begin
    assert (!has || (low_x <= held_x && held_x <= high_x));
    assert (!has || (low_y <= held_y && held_y <= high_y));
    assert (!has || (low_z <= held_z && held_z <= high_z));
  end
  assign cover_kept = has & again;
  assign cover_wide = has & low_x < held_x & held_x < high_x;
endmodule
