// A photon memory of `PLACES groups a bank, with a head that says anything at any time. The harness counts by itself the
// groups of the set that is filled and the words of the batch that is played, from the spec's words: a set ends with a
// last group or at the bank's last place, and no sooner; a bank that has a whole set is not filled; a batch begins
// where its bank has one and the head is ready for it; its words are those of the set, each in its place, as they
// were; the last one is marked; the set goes with the batch that releases it. Of all groups one place of one bank is
// watched. The block RAM is taken out: at the watched place it gives what was written there last.
`default_nettype none
module harness(input wire clock, input wire reset, input wire group_valid, input wire group_last,
    input wire [`WORD-1:0] data, input wire release_in, input wire query_taken, input wire is_full,
    input wire has_room, input wire [15:0] clocks_to_last, input wire [`WORD-1:0] ram_data,
    output wire cover_kept, output wire cover_second, output wire cover_full);
  localparam P = $clog2(`PLACES);
  localparam LAST = `PLACES - 1;
  wire group_ready, word_valid, word_last;
  wire [`WORD-1:0] word, write_word, read_word;
  wire fill_bank, fill_ready, write_valid, write_bank, full_0, full_1, play_bank, play_full, at_end, may_start;
  wire playing, releases, release_taken, release_next, read_valid, read_last;
  wire [P-1:0] fill_place, write_place, end_place_0, end_place_1, play_end, before_end, play_place;
  wire [P:0] ram_read, ram_write;
  wire [`WORD-1:0] ram_enable, ram_written;
  dut dut(.clock(clock), .reset(reset), .group_valid(group_valid), .group_last(group_last), .group_ready(group_ready),
    .release_in(release_in), .query_taken(query_taken), .is_full(is_full), .has_room(has_room),
    .clocks_to_last(clocks_to_last), .word_valid(word_valid), .word_last(word_last), `GROUP_PORTS
    .fill_bank(fill_bank), .fill_place(fill_place), .fill_ready(fill_ready), .write_valid(write_valid),
    .write_bank(write_bank), .write_place(write_place), .full_0(full_0), .full_1(full_1),
    .end_place_0(end_place_0), .end_place_1(end_place_1), .play_bank(play_bank), .play_full(play_full),
    .play_end(play_end), .before_end(before_end), .play_place(play_place), .at_end(at_end), .may_start(may_start),
    .playing(playing), .releases(releases), .release_taken(release_taken), .release_next(release_next),
    .read_valid(read_valid), .read_last(read_last), .write_word(write_word), .read_word(read_word),
    .\groups.RD_ADDR (ram_read), .\groups.RD_DATA (ram_data), .\groups.WR_ADDR (ram_write),
    .\groups.WR_EN (ram_enable), .\groups.WR_DATA (ram_written));

  // The set that is filled: its bank and its groups so far; which banks have a whole set, and the number of its last.
  reg into = 0, whole_0 = 0, whole_1 = 0;
  reg [P-1:0] count = 0, last_0 = 0, last_1 = 0;
  wire taken = group_valid & group_ready;
  wire ends = taken & (group_last | count == LAST);
  // The batch that is read: from which bank, the number of its next word, and whether its set goes with it.
  reg from = 0, active = 0, goes = 0, goes_next = 0, heard = 0, could = 0;
  reg [P-1:0] number = 0;
  wire [P-1:0] last = from ? last_1 : last_0;
  wire whole = from ? whole_1 : whole_0;
  wire reads = active | may_start;
  wire at_last = reads & number == last;
  wire released = at_last & (may_start ? goes_next : goes);
  reg valid_1 = 0, last_read = 0, valid_2 = 0, last_given = 0;
  // The watched group, and what the RAM has at its place.
  reg watched_bank, has = 0, watched_1 = 0, watched_2 = 0;
  reg [P-1:0] watched;
  reg [`WORD-1:0] value = 0, stored = 0, expected_1 = 0, expected_2 = 0;
  wire takes_watched = taken & into == watched_bank & count == watched;
  // Batches of the first set, up to 3.
  reg [1:0] batches = 0;
  reg full_unmarked = 0;
  always @(posedge clock) begin
    watched_bank <= watched_bank;
    watched <= watched;
    if (taken) count <= ends ? 0 : count + 1'b1;
    if (ends) begin
      into <= ~into;
      if (into) begin
        whole_1 <= 1'b1;
        last_1 <= count;
      end else begin
        whole_0 <= 1'b1;
        last_0 <= count;
      end
    end
    could <= is_full & has_room & clocks_to_last <= last & whole & ~reads;
    if (reads) begin
      active <= ~at_last;
      number <= at_last ? 0 : number + 1'b1;
    end
    if (released) begin
      from <= ~from;
      if (from) whole_1 <= 1'b0;
      else whole_0 <= 1'b0;
    end
    if (may_start) begin
      goes <= goes_next;
      goes_next <= 1'b0;
    end
    heard <= query_taken & release_in;
    if (heard) goes_next <= 1'b1;
    valid_1 <= reads;
    last_read <= at_last;
    valid_2 <= valid_1;
    last_given <= last_read;
    watched_1 <= reads & from == watched_bank & number == watched;
    watched_2 <= watched_1;
    expected_1 <= value;
    expected_2 <= expected_1;
    if (released & from == watched_bank) has <= 1'b0;
    if (takes_watched) begin
      value <= data;
      has <= 1'b1;
    end
    if (ram_enable[0] & ram_write == {watched_bank, watched}) stored <= ram_written;
    if (at_last & ~&batches) batches <= batches + 1'b1;
    if (ends & ~group_last) full_unmarked <= 1'b1;
    if (reset) begin
      {into, whole_0, whole_1, from, active, goes, goes_next, heard, could} <= 0;
      {valid_1, last_read, valid_2, last_given, has, batches, full_unmarked} <= 0;
      count <= 0;
      last_0 <= 0;
      last_1 <= 0;
      number <= 0;
    end
  end
  wire [P-1:0] end_place = play_bank ? end_place_1 : end_place_0;
  wire writes_played = write_valid & write_bank == play_bank;
  wire after_end = read_valid & read_last;
  always @(*) begin
    assume (ram_read != {watched_bank, watched} || ram_data == stored);
    // Filling: no bank with a whole set; a set ends where it must.
    assert (!group_ready || !(into ? whole_1 : whole_0));
    assert (fill_bank == into && fill_place == count && group_ready == fill_ready);
    assert (full_0 == whole_0 && full_1 == whole_1);
    assert (!(into ? whole_1 : whole_0) || count == 0);
    assert ((!whole_0 || end_place_0 == last_0) && (!whole_1 || end_place_1 == last_1));
    // Playing: of a whole set, when the head is ready, one batch after the other, to the set's last word.
    assert (!may_start || (could && whole && !active));
    assert (!active || whole);
    assert (word_valid == valid_2 && word_last == last_given);
    assert (!(word_valid && watched_2) || word == expected_2);
    // What is known of the registers.
    assert (play_bank == from && playing == active && play_place == number);
    assert (releases == goes && release_next == goes_next && release_taken == heard);
    assert (read_valid == valid_1 && read_last == last_read);
    assert (after_end || !play_full || (whole && play_end == end_place && before_end + 1'b1 == {1'b0, end_place} + (end_place == 0 ? `PLACES : 0)));
    assert (!reads || (at_end == (number == last) && number <= last));
    assert (!reads || before_end + 1'b1 == {1'b0, last} + (last == 0 ? `PLACES : 0));
    assert (active || number == 0);
    // The block RAM's wires, and what is there.
    assert (ram_read == {play_bank, play_place} && ram_enable == {`WORD{write_valid}});
    assert (!write_valid || (ram_write == {write_bank, write_place} && ram_written == write_word));
    assert (!writes_played || after_end || !play_full);
    assert (!writes_played || !reads);
    assert (has || !(watched_bank ? whole_1 && watched <= last_1 : whole_0 && watched <= last_0));
    assert (has || !(into == watched_bank && watched < count));
    assert (!has || (write_valid && {write_bank, write_place} == {watched_bank, watched} ? write_word == value : stored == value));
    assert (!watched_1 || read_word == expected_1);
    assert (!watched_2 || word == expected_2);
  end
  assign cover_kept = word_valid & word_last & watched_2 & watched == 1 & batches == 2 & ~from;
  assign cover_second = word_valid & word_last & from & whole_1 & last == 1;
  assign cover_full = word_valid & watched_2 & watched == LAST & full_unmarked;
endmodule
