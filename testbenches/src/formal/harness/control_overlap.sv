// The overlapped machine's control block against a plan of our own: a query starts the kernel at its first clock;
// the kernel repeats; the declared number of clocks after the last group's the epilogue follows, then the result.
// The words at work are the spec's of the clock before; a group is taken where its word asks for one.
`default_nettype none
module harness(input wire clock, input wire reset, input wire query_valid, input wire group_valid,
    input wire group_last, input wire result_ready,
    output wire cover_result, output wire cover_stalled, output wire cover_second);
  wire query_ready, group_ready, result_valid, write_query, group_taken;
  wire [`WORD-1:0] to_x, to_y, to_z, to_d;
  wire [`ADDRESS-1:0] address_q;
  wire occupied_q, last_q, done_q;
  wire [`DRAIN-1:0] drain_q;
  dut dut(.clock(clock), .reset(reset), .query_valid(query_valid), .query_ready(query_ready),
    .group_valid(group_valid), .group_last(group_last), .group_ready(group_ready),
    .result_valid(result_valid), .result_ready(result_ready), .write_query(write_query),
    .group_taken(group_taken), .to_x(to_x), .to_y(to_y), .to_z(to_z), .to_d(to_d),
    .address_q(address_q), .occupied_q(occupied_q), .last_q(last_q), .drain_q(drain_q), .done_q(done_q));

  // Words by their address; past the end they do nothing.
  reg [`WORD-1:0] x, y, z, d;
  always @(*) case (place) `STEPS_X default: x = 0; endcase
  always @(*) case (place) `STEPS_Y default: y = 0; endcase
  always @(*) case (place) `STEPS_Z default: z = 0; endcase
  always @(*) case (place) `STEPS_D default: d = 0; endcase

  reg [`ADDRESS-1:0] place = 0;
  reg busy = 0, ended = 0, done = 0;
  reg [`DRAIN-1:0] since = 0;
  reg [`WORD-1:0] at_x = 0, at_y = 0, at_z = 0, at_d = 0;
  reg stalled = 0;
  reg [1:0] queries = 0;
  wire query_taken = query_valid & ~busy;
  wire works = query_taken | (busy & ~done);
  wire asks = at_x[`write_power] & ~ended;
  wire takes = asks & group_valid;
  // From the clock in which the last group is taken to that in which the epilogue's first word is at work: one clock
  // until the group counts as taken, one until the place is the epilogue's, one until its word is fetched.
  wire to_epilogue = ended & since == `DRAIN_CLOCKS - 3;
  wire [`DRAIN-1:0] gone = since - (`DRAIN_CLOCKS - 2);
  always @(posedge clock) begin
    stalled <= done & ~result_ready & ~reset;
    {at_x, at_y, at_z, at_d} <= 0;
    if (ended) since <= since + 1'b1;
    if (takes & group_last) begin
      ended <= 1'b1;
      since <= 0;
    end
    if (works) begin
      busy <= 1'b1;
      {at_x, at_y, at_z, at_d} <= {x, y, z, d};
      place <= place == `INTERVAL - 1 ? 0 : place + 1'b1;
      if (to_epilogue) place <= `INTERVAL;
      if (place == `END) begin
        place <= 0;
        ended <= 1'b0;
        done <= 1'b1;
      end
    end
    if (done & result_ready) begin
      busy <= 1'b0;
      done <= 1'b0;
    end
    if (query_taken & ~&queries) queries <= queries + 1'b1;
    if (reset) begin
      place <= 0;
      {busy, ended, done} <= 0;
      since <= 0;
      {at_x, at_y, at_z, at_d} <= 0;
    end
  end
  always @(*) begin
    assert (address_q == place && occupied_q == busy && last_q == ended && done_q == done);
    assert (drain_q == since);
    assert ({to_x, to_y, to_z, to_d} == {at_x, at_y, at_z, at_d});
    assert (query_ready == ~busy && write_query == ~busy);
    assert (group_ready == asks && group_taken == takes);
    assert (result_valid == done);
    // What is known of the plan: the kernel as long as not all is drained; then straight on to the end.
    assert (place <= `END);
    assert (busy || (place == 0 && !ended && !done && {at_x, at_y, at_z, at_d} == 0));
    assert (!done || (place == 0 && !ended && {at_x, at_y, at_z, at_d} == 0));
    assert (place < `INTERVAL || ended);
    assert (!ended || place >= `INTERVAL || since <= `DRAIN_CLOCKS - 3);
    assert (place < `INTERVAL || gone == place - `INTERVAL);
    // Stalled: the result stays, and no word is at work.
    assert (!stalled || (result_valid && {to_x, to_y, to_z, to_d} == 0 && !write_query));
    // One operand at most for each adder: one axis, or the gate.
    `ONE_OPERAND
    // The words at work are such of the program.
    `WORDS
  end
  assign cover_result = done & queries == 1;
  assign cover_stalled = stalled;
  assign cover_second = queries == 2 & done;
endmodule
