// The borders on one axis around intervals that come one after another. In any clock the harness can watch a place in the
// interval that comes. The place stays between the borders until an interval comes that is the first of another box.
`default_nettype none
module harness(input wire clock, input wire comes, input wire first, input wire watch, input wire [`W-1:0] low_in,
    input wire [`W-1:0] high_in, input wire [`W-1:0] place, output wire cover_kept, output wire cover_wide);
  wire [`W-1:0] low, high;
  dut dut(.clock(clock), .comes(comes), .first(first), .low_in(low_in), .high_in(high_in), .low_out(low), .high_out(high));

  wire watched = watch & low_in <= place & place <= high_in;
  reg has = 0, again = 0;
  reg [`W-1:0] held = 0;
  always @(posedge clock) begin
    if (comes) begin
      has <= watched | (has & ~first);
      again <= has & ~first & ~watched;
      if (watched) held <= place;
    end
  end
  always @(*) assert (!has || (low <= held && held <= high));
  assign cover_kept = has & again;
  assign cover_wide = has & low < held & held < high;
endmodule
