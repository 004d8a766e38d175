// The control block against a program counter of our own, which runs over the spec's listing: the steps in their
// order, waiting only where a stream is awaited, back to the iteration's first step or, after the last group, to
// the result. Words of the program are the spec's.
`default_nettype none
module harness(input wire clock, input wire reset, input wire query_valid, input wire group_valid,
    input wire group_last, input wire result_ready,
    output wire cover_result, output wire cover_waits, output wire cover_again);
  wire query_ready, group_ready, result_valid, write_query, write_photon, write_power, write_work, write_sum;
  wire [1:0] work_source;
  wire add_sum;
  wire [`DIMENSION-1:0] axis;
  wire [`ADDRESS-1:0] address_q;
  wire last_q, done_q;
  dut dut(.clock(clock), .reset(reset), .query_valid(query_valid), .query_ready(query_ready),
    .group_valid(group_valid), .group_last(group_last), .group_ready(group_ready),
    .result_valid(result_valid), .result_ready(result_ready), .write_query(write_query),
    .write_photon(write_photon), .write_power(write_power), .write_work(write_work), .write_sum(write_sum),
    .work_source(work_source), .add_sum(add_sum), .axis(axis),
    .address_q(address_q), .last_q(last_q), .done_q(done_q));

  reg [`ADDRESS-1:0] step = 0;
  reg last = 0, done = 0;
  reg [7:0] groups = 0, results = 0;
  reg [`WORD-1:0] word;
  always @(*) case (step)
    `STEPS
    default: word = 0;
  endcase

  wire query_awaited = word[`takes_query] & ~query_valid;
  wire group_awaited = word[`reads_group] & ~group_valid;
  wire goes = ~done & ~query_awaited & ~group_awaited;
  wire at_last_step = step == `LAST_STEP;
  always @(posedge clock) begin
    if (goes) begin
      step <= step + 1'b1;
      if (at_last_step) step <= last ? 0 : `FIRST_OF_ITERATION;
      if (at_last_step & last) done <= 1'b1;
      if (word[`takes_group]) last <= group_last;
      if (at_last_step) groups <= groups + 1'b1;
    end
    if (done & result_ready) begin
      done <= 1'b0;
      results <= results + 1'b1;
    end
    if (reset) begin
      step <= 0;
      last <= 1'b0;
      done <= 1'b0;
    end
  end

  always @(*) begin
    assert (address_q == step && last_q == last && done_q == done);
    assert (step <= `LAST_STEP);
    assert (!done || step == 0);
    assert (query_ready == (word[`takes_query] & ~done));
    assert (group_ready == (word[`takes_group] & ~done));
    assert (result_valid == done);
    assert (write_query == (word[`write_query] & goes));
    assert (write_photon == (word[`write_photon] & goes));
    assert (write_power == (word[`write_power] & goes));
    assert (write_work == (word[`write_work] & goes));
    assert (write_sum == (word[`write_sum] & goes));
    assert (work_source == word[`work_source+:2]);
    assert (add_sum == word[`add_sum]);
    assert (axis == word[`axis+:`DIMENSION]);
    // At most one axis drives the links.
    assert ((axis & (axis - 1'b1)) == 0);
  end
  assign cover_result = done & groups == 2;
  assign cover_waits = group_awaited & groups == 1;
  assign cover_again = results == 1 & step == `FIRST_OF_ITERATION;
endmodule
