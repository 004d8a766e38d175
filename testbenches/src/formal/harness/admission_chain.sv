// What a chain of `ENGINES engines admits: a query where its batch has room for it, or where the batch before begins; groups only of
// a batch whose queries were all taken; a last group only `SPACING clocks after the one before, so that results do not collide, and
// only where the queue has room for the results of the batch. Assumed: no more batches are read than had a last group.
`default_nettype none
module harness(input wire clock, input wire reset, input wire query_valid, input wire group_valid,
    input wire group_last, input wire batch_read, output wire cover_full, output wire cover_second);
  wire query_ready, group_ready, taken, first_taken, last_taken, token_valid, is_full, has_room;
  wire [15:0] clocks_to_last;
  wire open, has_batch, waits, gives_back;
  wire [$clog2(`ENGINES):0] loaded;
  wire [`SPACING_BITS-1:0] spacing;
  wire [`MOST-1:0] promised;
  dut dut(.clock(clock), .reset(reset), .query_valid(query_valid), .group_valid(group_valid),
    .group_last(group_last), .batch_read(batch_read), .query_ready(query_ready), .group_ready(group_ready),
    .taken(taken), .first_taken(first_taken), .last_taken(last_taken), .token_valid(token_valid),
    .is_full(is_full), .has_room(has_room), .clocks_to_last(clocks_to_last), .loaded(loaded), .open(open),
    .has_batch(has_batch), .spacing(spacing), .waits(waits), .gives_back(gives_back), .promised(promised));

  wire query_taken = query_valid & query_ready;
  wire group_taken = group_valid & group_ready;
  wire ends = group_taken & group_last;
  // Queries taken of the batch that did not begin; whether groups of one are still to come; clocks since a last group; batches
  // whose last group was taken and whose results were not all read.
  reg [15:0] queries = 0, since = `SPACING, batches = 0;
  reg begun = 0, was_read = 0;
  reg [1:0] ended = 0;
  wire starts = group_taken & ~begun;
  always @(posedge clock) begin
    queries <= (starts ? 0 : queries) + query_taken;
    if (group_taken) begun <= ~group_last;
    since <= ends ? 1 : since + (since < `SPACING);
    batches <= batches + ends - batch_read;
    was_read <= batch_read;
    if (ends & ~&ended) ended <= ended + 1'b1;
    if (reset) begin
      queries <= 0;
      since <= `SPACING;
      batches <= 0;
      {begun, was_read, ended} <= 0;
    end
  end
  always @(*) begin
    assume (!batch_read || batches != 0);
    assert (!query_taken || queries < `ENGINES || starts);
    assert (!group_taken || begun || queries == `ENGINES);
    assert (!ends || (since >= `SPACING && batches < `MOST));
    assert (taken == group_taken && first_taken == starts && last_taken == ends);
    assert (token_valid == (query_taken && !reset));
    // For a photon memory.
    assert (is_full == (queries == `ENGINES) && (!has_room || batches < `MOST));
    assert (clocks_to_last == `SPACING - since);
    // What is known of the registers.
    assert (queries <= `ENGINES && batches + was_read <= `MOST && since >= 1 && since <= `SPACING);
    assert (loaded == queries && open == begun && has_batch == (begun || queries == `ENGINES));
    assert (waits == (since < `SPACING) && gives_back == was_read);
    assert (promised == (({{`MOST{1'b0}}, 1'b1} << (batches + was_read)) - 1'b1));
  end
  assign cover_full = batches == `MOST;
  assign cover_second = ended == 2 & queries == `ENGINES & group_taken;
endmodule
