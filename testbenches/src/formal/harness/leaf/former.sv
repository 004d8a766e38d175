// Forming batches. The harness counts the tokens of the batch by itself: a batch is the queries up to a last one, at most one for
// each engine; fillers follow until each engine has a token; no query is taken between the end of a batch and its start. The
// batch gathers the facings of its first query, and releases the set if one of its queries does. Assumed: a batch starts only
// when it is complete, which leaves::scan shows.
`default_nettype none
module harness(input wire clock, input wire reset, input wire query_valid, input wire query_last,
    input wire query_release, input wire [`FACINGS-1:0] query_facings, input wire chain_ready, input wire starts,
    output wire cover_filled, output wire cover_second);
  wire query_ready, token_valid, takes_token, takes_query, first, offers_query, fills, complete, release_out, closed;
  wire [`FACINGS-1:0] facings;
  wire [$clog2(`ENGINES+1)-1:0] loaded;
  dut dut(.clock(clock), .reset(reset), .query_valid(query_valid), .query_last(query_last),
    .query_release(query_release), .query_facings(query_facings), .chain_ready(chain_ready), .starts(starts),
    .query_ready(query_ready), .token_valid(token_valid), .takes_token(takes_token), .takes_query(takes_query),
    .first(first), .offers_query(offers_query), .fills(fills), .complete(complete), .release_out(release_out),
    .facings_out(facings), .loaded_q(loaded), .closed_q(closed));

  wire query_taken = query_valid & query_ready;
  wire token_taken = token_valid & chain_ready;
  // The tokens and queries of the batch, whether its last query was taken, and what its queries said.
  reg [7:0] tokens = 0, queries = 0;
  reg ended = 0, releases = 0, started = 0, had_fillers = 0, second = 0;
  reg [`FACINGS-1:0] gathered = 0;
  always @(posedge clock) begin
    if (token_taken) tokens <= tokens + 1'b1;
    if (query_taken) begin
      queries <= queries + 1'b1;
      ended <= query_last | queries == `ENGINES - 1;
      releases <= query_release | (releases & queries != 0);
      if (queries == 0) gathered <= query_facings;
    end
    started <= starts;
    if (starts) begin
      tokens <= 0;
      queries <= 0;
      ended <= 1'b0;
      had_fillers <= queries != tokens;
      second <= 1'b1;
    end
    if (reset) begin
      tokens <= 0;
      queries <= 0;
      {ended, started, had_fillers, second} <= 0;
    end
  end
  always @(*) begin
    assume (!starts || complete);
    // No query is lost or repeated: each that is taken is a token, and a token is a filler only after the last query.
    assert (takes_query == query_taken && takes_token == token_taken);
    assert (!query_taken || token_taken);
    assert (!query_taken || !ended);
    assert (!token_taken || query_taken || ended);
    assert (!token_taken || fills == !query_taken);
    assert (tokens <= `ENGINES && (!token_taken || tokens < `ENGINES));
    assert (complete == (ended && tokens == `ENGINES));
    // The box of the batch gets each query that is taken; the first begins a box.
    assert (!query_taken || (offers_query && first == (queries == 0)));
    assert (!complete || (facings == gathered && release_out == releases));
    assert (!started || facings == gathered);
    // What is known of the registers.
    assert (loaded == tokens && closed == ended);
    assert (ended || (queries == tokens && queries < `ENGINES));
    assert (queries <= tokens && (!ended || queries != 0));
    assert (queries == 0 || facings == gathered);
    assert (queries == 0 || release_out == releases);
  end
  assign cover_filled = had_fillers & complete;
  assign cover_second = second & complete & queries == `ENGINES;
endmodule
