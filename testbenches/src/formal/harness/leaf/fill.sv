// Reading in sets. The harness counts the groups of the set by itself: a set ends with a last group or at the last place of its
// bank; a bank that has a whole set takes no group until the set is freed; each group is written once, at its place, with its
// facing. Assumed: only the set of a bank that has a whole one is freed, which leaves::player and leaves::scan show.
`default_nettype none
module harness(input wire clock, input wire reset, input wire group_valid, input wire group_last,
    input wire [`FACING-1:0] group_facing, input wire frees, input wire freed_bank, output wire cover_full,
    output wire cover_freed);
  localparam LAST = `PLACES - 1;
  localparam P = $clog2(`PLACES);
  wire group_ready, write_valid, write_bank, write_last, fill_bank, fill_ready, filled_0, filled_1;
  wire [P-1:0] write_place, fill_place;
  wire [`FACING-1:0] write_facing;
  dut dut(.clock(clock), .reset(reset), .group_valid(group_valid), .group_last(group_last), .group_facing(group_facing),
    .frees(frees), .freed_bank(freed_bank), .group_ready(group_ready), .write_valid_out(write_valid),
    .write_bank_out(write_bank), .write_place_out(write_place), .write_last_out(write_last),
    .write_facing_out(write_facing), .fill_bank_q(fill_bank), .fill_place_q(fill_place), .fill_ready_q(fill_ready),
    .filled_0_q(filled_0), .filled_1_q(filled_1));

  // The bank that is filled, the groups in it, and which banks have a whole set.
  reg into = 0, whole_0 = 0, whole_1 = 0;
  reg [P-1:0] count = 0;
  wire taken = group_valid & group_ready;
  wire ends = taken & (group_last | count == LAST);
  // The group that was taken in the clock before.
  reg was_taken = 0, was_bank = 0, was_end = 0, freed = 0, unmarked = 0;
  reg [P-1:0] was_place = 0;
  reg [`FACING-1:0] was_facing = 0;
  always @(posedge clock) begin
    if (taken) count <= ends ? 0 : count + 1'b1;
    if (ends) into <= ~into;
    whole_0 <= (whole_0 & ~(frees & ~freed_bank)) | (ends & ~into);
    whole_1 <= (whole_1 & ~(frees & freed_bank)) | (ends & into);
    was_taken <= taken;
    was_bank <= into;
    was_place <= count;
    was_end <= ends;
    was_facing <= group_facing;
    if (frees) freed <= 1'b1;
    if (ends & ~group_last) unmarked <= 1'b1;
    if (reset) begin
      {into, whole_0, whole_1, was_taken, freed, unmarked} <= 0;
      count <= 0;
    end
  end
  always @(*) begin
    assume (!frees || (freed_bank ? whole_1 : whole_0));
    assert (!group_ready || !(into ? whole_1 : whole_0));
    assert (write_valid == was_taken);
    assert (!was_taken || (write_bank == was_bank && write_place == was_place && write_last == was_end && write_facing == was_facing));
    // What is known of the registers.
    assert (fill_bank == into && fill_place == count && group_ready == fill_ready);
    assert (filled_0 == whole_0 && filled_1 == whole_1);
    assert (!(into ? whole_1 : whole_0) || count == 0);
  end
  assign cover_full = whole_0 & whole_1;
  assign cover_freed = freed & was_taken & ~was_bank & was_place == 1 & whole_1;
endmodule
