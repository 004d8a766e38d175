// Playing the wanted groups of pairs. The harness keeps the groups of the pair by itself: they are played in order, one a clock, each
// once; a pair without wanted groups, which ends its batch, is played as one blank group. The last group of a batch waits for the
// spacing of last groups and for room in the chain's queue of results. A set is freed with the last group of the batch that releases
// it. What is played comes out two clocks later. Assumed: no batch leaves that did not end.
`default_nettype none
module harness(input wire clock, input wire reset, input wire has_pair, input wire [`K-1:0] pair, input wire [3:0] mask,
    input wire [2:0] flags, input wire batch_leaves, output wire cover_four, output wire cover_blank,
    output wire cover_most);
  wire takes_pair, plays, play_bank, frees, word_valid, word_last, word_blank;
  wire [`K+1:0] play_place;
  wire entry_valid, entry_last, entry_bank, entry_end, entry_release, may_end;
  wire [3:0] entry_mask;
  wire [`K-1:0] entry_pair;
  wire [`SPACING-1:0] spacing;
  wire [$clog2(`MOST+1)-1:0] outstanding;
  dut dut(.clock(clock), .reset(reset), .has_pair(has_pair), .pair(pair), .mask(mask), .flags(flags),
    .batch_leaves(batch_leaves), .takes_pair(takes_pair), .plays(plays), .play_bank(play_bank),
    .play_place(play_place), .frees(frees), .word_valid_out(word_valid), .word_last_out(word_last),
    .word_blank_out(word_blank), .entry_valid_q(entry_valid), .entry_mask_q(entry_mask), .entry_last_q(entry_last),
    .entry_pair_q(entry_pair), .entry_bank_q(entry_bank), .entry_end_q(entry_end), .entry_release_q(entry_release),
    .spacing_q(spacing), .may_end_q(may_end), .outstanding_q(outstanding));

  // The pair that is played, the groups that are still to be played, and what comes out in two clocks.
  reg busy = 0, bank = 0, ends = 0, goes = 0;
  reg [`K-1:0] number = 0;
  reg [3:0] todo = 0;
  wire [1:0] group = todo[0] ? 0 : todo[1] ? 1 : todo[2] ? 2 : todo[3] ? 3 : 0;
  wire is_last = todo == 0 | todo == 4'b0001 << group;
  wire ends_batch = plays & ends & is_last;
  reg [1:0] valid = 0, last = 0, blank = 0;
  // Clocks since a batch ended, at most the spacing; batches that ended and did not leave.
  reg [7:0] since = `SPACED, under_way = 0;
  reg [2:0] played = 0;
  always @(posedge clock) begin
    if (plays) begin
      todo <= todo & ~(4'b0001 << group);
      if (is_last) busy <= 1'b0;
    end
    if (takes_pair) begin
      busy <= 1'b1;
      number <= pair;
      todo <= mask;
      {goes, ends, bank} <= flags;
    end
    played <= takes_pair ? 0 : played + plays;
    valid <= {valid, plays};
    last <= {last, ends_batch};
    blank <= {blank, todo == 0};
    if (ends_batch) since <= 1;
    else if (since < `SPACED) since <= since + 1'b1;
    under_way <= under_way + ends_batch - batch_leaves;
    if (reset) begin
      busy <= 1'b0;
      valid <= 0;
      since <= `SPACED;
      under_way <= 0;
    end
  end
  always @(*) begin
    assume (!batch_leaves || under_way != 0);
    // A pair is taken where there is one and the pair before is done.
    assert (!takes_pair || (has_pair && (!busy || (plays && is_last))));
    assert (!plays || (busy && play_bank == bank && play_place == {number, group}));
    // Only the end of a batch waits.
    assert (plays || !busy || (ends && is_last));
    assert (!ends_batch || (since >= `SPACED && under_way < `MOST));
    assert (frees == (ends_batch & goes));
    assert (word_valid == valid[1] && (!valid[1] || (word_last == last[1] && word_blank == blank[1])));
    // What is known of the registers.
    assert (entry_valid == busy);
    assert (!busy || (entry_mask == todo && entry_last == is_last && entry_pair == number));
    assert (!busy || (entry_bank == bank && entry_end == ends && entry_release == goes));
    assert (outstanding == under_way && under_way <= `MOST);
    assert (since >= 1 && since <= `SPACED);
    assert (!may_end || (since >= `SPACED && under_way < `MOST));
    assert (spacing == (`SPACED - since > 1 ? `SPACED - since - 1 : 0));
  end
  assign cover_four = word_valid & word_last & played == 0 & number == 1 & mask == 4'b1111;
  assign cover_blank = word_valid & word_last & word_blank;
  assign cover_most = under_way == `MOST;
endmodule
