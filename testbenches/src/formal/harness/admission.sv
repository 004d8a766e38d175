// What is admitted: a query where none waits or the one that waits begins; groups only of a query that has begun or
// begins with them; a last group only where the queue has room for its result, counted here. Assumed: no more results
// are read than last groups were taken.
`default_nettype none
module harness(input wire clock, input wire reset, input wire query_valid, input wire group_valid,
    input wire group_last, input wire batch_read, output wire cover_full, output wire cover_second);
  wire query_ready, group_ready, taken, first_taken, last_taken, token_valid, is_full, has_room;
  wire [15:0] clocks_to_last;
  wire loaded, open, has_batch;
  wire [`PLACES-1:0] promised;
  dut dut(.clock(clock), .reset(reset), .query_valid(query_valid), .group_valid(group_valid),
    .group_last(group_last), .batch_read(batch_read), .query_ready(query_ready), .group_ready(group_ready),
    .taken(taken), .first_taken(first_taken), .last_taken(last_taken), .token_valid(token_valid),
    .is_full(is_full), .has_room(has_room), .clocks_to_last(clocks_to_last), .loaded(loaded), .open(open),
    .has_batch(has_batch), .promised(promised));

  wire query_taken = query_valid & query_ready;
  wire group_taken = group_valid & group_ready;
  // Queries taken whose first group was not; whether groups of one are still to come; results not read yet.
  reg waiting = 0, begun = 0;
  reg [7:0] results = 0;
  reg [2:0] queries = 0;
  wire starts = group_taken & ~begun;
  always @(posedge clock) begin
    waiting <= (waiting & ~starts) | query_taken;
    if (group_taken) begun <= ~group_last;
    results <= results + (group_taken & group_last) - batch_read;
    if (query_taken & ~&queries) queries <= queries + 1'b1;
    if (reset) begin
      waiting <= 1'b0;
      begun <= 1'b0;
      results <= 0;
    end
  end
  always @(*) begin
    assume (!batch_read || results != 0);
    // No drop and no duplicate: one query waits at most, and a group has one.
    assert (!query_taken || !waiting || starts);
    assert (!group_taken || begun || waiting);
    assert (taken == group_taken && first_taken == starts && last_taken == (group_taken && group_last));
    assert (token_valid == (query_taken && !reset));
    // The queue never gets more than it holds.
    assert (results <= `PLACES);
    assert (!(group_taken && group_last) || results < `PLACES);
    // What is known of the registers.
    assert (loaded == waiting && open == begun && has_batch == (begun || waiting));
    assert (promised == (({{`PLACES{1'b0}}, 1'b1} << results) - 1'b1));
    assert (is_full == waiting);
  end
  assign cover_full = results == `PLACES;
  assign cover_second = queries == 2 & group_taken & group_last;
endmodule
