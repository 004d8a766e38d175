// What the head of a leaf machine admits: every group, and a query where its batch has room for it or the batch before begins. Assumed:
// a batch begins only when all its queries were taken, as the memory of leaves sees to.
`default_nettype none
module harness(input wire clock, input wire reset, input wire query_valid, input wire group_valid,
    input wire group_last, input wire batch_read, output wire cover_full, output wire cover_second);
  wire query_ready, group_ready, taken, first_taken, last_taken, token_valid, is_full, has_room;
  wire [15:0] clocks_to_last;
  wire open;
  wire [$clog2(`ENGINES):0] loaded;
  dut dut(.clock(clock), .reset(reset), .query_valid(query_valid), .group_valid(group_valid),
    .group_last(group_last), .batch_read(batch_read), .query_ready(query_ready), .group_ready(group_ready),
    .taken(taken), .first_taken(first_taken), .last_taken(last_taken), .token_valid(token_valid),
    .is_full(is_full), .has_room(has_room), .clocks_to_last(clocks_to_last), .loaded(loaded), .open(open));

  wire query_taken = query_valid & query_ready;
  // Queries taken of the batch that did not begin; whether groups of one are still to come.
  reg [15:0] queries = 0;
  reg begun = 0;
  reg [1:0] ended = 0;
  wire starts = group_valid & ~begun;
  wire ends = group_valid & group_last;
  always @(posedge clock) begin
    queries <= (starts ? 0 : queries) + query_taken;
    if (group_valid) begun <= ~group_last;
    if (ends & ~&ended) ended <= ended + 1'b1;
    if (reset) begin
      queries <= 0;
      {begun, ended} <= 0;
    end
  end
  always @(*) begin
    assume (!starts || queries == `ENGINES);
    assert (query_ready == (queries < `ENGINES || starts));
    assert (group_ready && taken == group_valid && first_taken == starts && last_taken == ends);
    assert (token_valid == (query_taken && !reset));
    // What is known of the registers.
    assert (queries <= `ENGINES && loaded == queries && open == begun);
  end
  assign cover_full = queries == `ENGINES & query_valid & ~query_ready;
  assign cover_second = ended == 2 & queries == `ENGINES & group_valid;
endmodule
