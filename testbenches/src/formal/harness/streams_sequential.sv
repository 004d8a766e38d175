// The streams of the control block, in words of queries: one is in the machine at most, its result comes once, after
// its last group was taken, and waits unchanged; a group is taken once an iteration, and only of a query that is
// there.
`default_nettype none
module harness(input wire clock, input wire reset, input wire query_valid, input wire group_valid,
    input wire group_last, input wire result_ready, output wire cover_second, output wire cover_stalled);
  wire query_ready, group_ready, result_valid, write_query, write_photon, write_power, write_work, write_sum;
  wire [`ADDRESS-1:0] address_q;
  wire last_q, done_q;
  dut dut(.clock(clock), .reset(reset), .query_valid(query_valid), .query_ready(query_ready),
    .group_valid(group_valid), .group_last(group_last), .group_ready(group_ready),
    .result_valid(result_valid), .result_ready(result_ready), .write_query(write_query),
    .write_photon(write_photon), .write_power(write_power), .write_work(write_work), .write_sum(write_sum),
    .address_q(address_q), .last_q(last_q), .done_q(done_q));

  wire query_taken = query_valid & query_ready;
  wire group_taken = group_valid & group_ready;
  wire given = result_valid & result_ready;
  reg [1:0] inside = 0;
  reg ended = 0, stalled = 0;
  reg [1:0] pending = 0;
  reg [2:0] taken = 0;
  reg [1:0] queries = 0;
  always @(posedge clock) begin
    inside <= inside + query_taken - given;
    pending <= pending + group_taken - write_sum;
    ended <= (ended | (group_taken & group_last)) & ~given;
    stalled <= result_valid & ~result_ready;
    if (query_taken & ~&queries) queries <= queries + 1'b1;
    if (reset) begin
      inside <= 0;
      pending <= 0;
      ended <= 1'b0;
      stalled <= 1'b0;
    end
  end
  always @(*) begin
    assert (inside <= 1 && pending <= 1);
    // What is known of the registers, without which the induction would begin in states that there are not.
    assert (address_q <= `LAST_STEP);
    assert (!done_q || address_q == 0);
    assert ((inside == 1) == (address_q != 0 || done_q));
    assert ((pending == 1) == (address_q > `TAKING_STEP));
    assert (ended == ((last_q && address_q > `TAKING_STEP) || done_q));
    // No drop and no duplicate.
    assert (!query_taken || inside == 0);
    assert (!group_taken || (inside == 1 && pending == 0 && !ended));
    assert (!write_sum || pending == 1);
    assert (!result_valid || (inside == 1 && ended && pending == 0));
    // Stalled: the result stays, and nothing is written into any cell.
    assert (!stalled || result_valid);
    assert (!result_valid || !(write_query | write_photon | write_power | write_work | write_sum));
  end
  assign cover_second = queries == 2 & result_valid;
  assign cover_stalled = stalled;
endmodule
