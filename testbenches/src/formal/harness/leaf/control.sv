// The entries of a set. The groups that are written come in, and three clocks after its last group the entry of each leaf is written
// once: to its place, with the facing of that group, and with a mark if the leaf has one group alone. Facing and mark of the first leaf
// of a pair are written for the second too, and once more with those of the second. A bank is full in the clock
// after the box of its last leaf was written, not sooner, until the set is freed. Assumed: only a full bank is freed.
`default_nettype none
module harness(input wire clock, input wire reset, input wire write_valid, input wire write_bank,
    input wire [`P-1:0] write_place, input wire write_last, input wire [`FACING-1:0] write_facing, input wire frees,
    input wire freed_bank, output wire cover_full, output wire cover_short);
  wire comes, first_comes, box_valid, box_bank, short_0, short_1, full_0, full_1;
  wire [`P-2:0] box_leaf, end_0, end_1;
  wire [`FACING-1:0] facing_0, facing_1;
  dut dut(.clock(clock), .reset(reset), .write_valid(write_valid), .write_bank(write_bank), .write_place(write_place),
    .write_last(write_last), .write_facing(write_facing), .frees(frees), .freed_bank(freed_bank), .comes(comes),
    .first_comes(first_comes), .box_valid_out(box_valid), .box_bank_out(box_bank), .box_leaf_out(box_leaf),
    .box_short_out_0(short_0), .box_short_out_1(short_1), .box_facing_out_0(facing_0), .box_facing_out_1(facing_1), .full_0_out(full_0), .full_1_out(full_1), .end_0_out(end_0),
    .end_1_out(end_1));

  // The groups of the last three clocks: valid, bank, place, last, facing.
  localparam G = `P + `FACING + 2;
  reg [2:0] valid = 0;
  reg [3*G-1:0] groups = 0;
  wire bank, last;
  wire [`P-1:0] place;
  wire [`FACING-1:0] facing;
  assign {bank, place, last, facing} = groups[2*G+:G];
  wire completes = valid[2] & (place[0] | last);
  // The facings and marks of the last group of a first leaf, and of the last group of either.
  wire [`P-1:0] next_place = groups[G+`FACING+1+:`P];
  wire [`FACING:0] note = {groups[G+:`FACING], ~next_place[0]};
  reg [`FACING:0] note_0 = 0, note_1 = 0;
  reg whole_0 = 0, whole_1 = 0;
  reg [`P-2:0] last_0 = 0, last_1 = 0;
  always @(posedge clock) begin
    valid <= {valid, write_valid};
    groups <= {groups, write_bank, write_place, write_last, write_facing};
    if (valid[1]) note_1 <= note;
    if (valid[1] & ~next_place[1]) note_0 <= note;
    whole_0 <= (whole_0 | (completes & last & ~bank)) & ~(frees & ~freed_bank);
    whole_1 <= (whole_1 | (completes & last & bank)) & ~(frees & freed_bank);
    if (completes & last & ~bank) last_0 <= place[`P-1:1];
    if (completes & last & bank) last_1 <= place[`P-1:1];
    if (reset) begin
      valid <= 0;
      {whole_0, whole_1} <= 0;
    end
  end
  always @(*) begin
    assume (!frees || (freed_bank ? full_1 : full_0));
    // For the borders: each group of a leaf, two clocks after it was written; the first begins a box.
    assert (comes == valid[1]);
    assert (first_comes == (comes & ~next_place[0]));
    assert (box_valid == completes);
    assert (!completes || (box_bank == bank && box_leaf == place[`P-1:1]));
    assert (!completes || {facing_1, short_1} == {facing, ~place[0]});
    assert (!completes || place[1] || {facing_0, short_0} == {facing, ~place[0]});
    assert ({facing_0, short_0} == note_0 && {facing_1, short_1} == note_1);
    // What is known of the notes.
    assert (!valid[2] || note_1 == {facing, ~place[0]});
    assert (!valid[2] || place[1] || note_0 == {facing, ~place[0]});
    assert (full_0 == whole_0 && full_1 == whole_1);
    assert ((!whole_0 || end_0 == last_0) && (!whole_1 || end_1 == last_1));
  end
  assign cover_full = full_0 & full_1 & end_0 != 0;
  assign cover_short = box_valid & box_leaf[0] & short_1 & ~short_0 & facing_0 != facing_1;
endmodule
