// Scanning a set for a batch. The harness counts the pairs by itself: a batch that starts was complete and its bank full; each pair
// of the bank, from 0 to that of the last leaf, is issued once, in order, before the next batch starts; the bank changes after a
// batch that releases it. A pair is found two clocks after it is issued, beside the facings of its batch, with a mark if it is the
// last, if its batch releases the set, and if it has a second leaf. No more pairs are under way than the queue has places. Assumed:
// a complete batch stays until it starts, and its facings one clock more (leaves::former); a full bank stays until it is
// released (leaves::control, leaves::player); a pair that is issued leaves once, after it was found (leaves::queue); a batch is
// complete only after the batch before it has begun, so what earlier batches released is freed (the admission of the chain).
`default_nettype none
module harness(input wire clock, input wire reset, input wire complete, input wire releases,
    input wire [`FACINGS-1:0] facings, input wire full_0, input wire full_1, input wire [`K:0] end_0,
    input wire [`K:0] end_1, input wire drops, input wire takes_pair, output wire cover_second, output wire cover_bank,
    output wire cover_full);
  wire starts, takes_box, issues, issue_bank, found_valid, found_bank, found_end, found_release, found_second;
  wire [`K-1:0] issue_pair, found_pair;
  wire [`FACINGS-1:0] facings_out;
  wire [1:0] compared, returned;
  wire starting, started, scanning, scan_bank, scan_release;
  wire [`K-1:0] scan_pair;
  wire [`K:0] scan_end;
  wire [$clog2(`QUEUE+1)-1:0] used;
  dut dut(.clock(clock), .reset(reset), .complete(complete), .releases(releases), .facings(facings), .full_0(full_0),
    .full_1(full_1), .end_0(end_0), .end_1(end_1), .drops(drops), .takes_pair(takes_pair), .starts(starts),
    .takes_box(takes_box), .issues(issues), .issue_bank(issue_bank), .issue_pair(issue_pair),
    .facings_out(facings_out), .found_valid_out(found_valid), .found_pair_out(found_pair),
    .found_bank_out(found_bank), .found_end_out(found_end), .found_release_out(found_release),
    .found_second_out(found_second), .compared(compared), .starting_q(starting), .started_q(started),
    .scanning_q(scanning), .scan_bank_q(scan_bank), .scan_pair_q(scan_pair), .scan_end_q(scan_end),
    .scan_release_q(scan_release), .used_q(used), .returned_q(returned));

  // The batch that is scanned: whether pairs are still to come, the next of them, the last leaf, and what the batch said.
  reg busy = 0, bank = 0, goes = 0, was_started = 0, waits = 0;
  reg [`K-1:0] next = 0;
  reg [`K:0] last_leaf = 0;
  reg [`FACINGS-1:0] gathered = 0;
  wire is_last = next == last_leaf[`K:1];
  wire lets_go = issues & is_last & goes;
  // The pairs of the last two clocks: number, bank, last, releases, has a second leaf, facings of the batch.
  localparam W = `K + 4 + `FACINGS;
  reg [1:0] valid = 0;
  reg [2*W-1:0] pairs = 0;
  wire [W-1:0] found = {found_pair, found_bank, found_end, found_release, found_second, facings_out};
  // Pairs that were issued and did not leave.
  reg [7:0] inside = 0;
  // Which banks were full, and which of them are released and not freed yet. The bank of the next batch.
  reg was_full_0 = 0, was_full_1 = 0, released_0 = 0, released_1 = 0;
  wire uses = bank ^ (busy & goes);
  reg [1:0] batches = 0;
  always @(posedge clock) begin
    was_started <= starts;
    waits <= complete & ~starts;
    if (issues) begin
      next <= next + 1'b1;
      if (is_last) busy <= 1'b0;
    end
    if (lets_go) bank <= ~bank;
    if (starts) begin
      busy <= 1'b1;
      next <= 0;
      last_leaf <= bank ? end_1 : end_0;
      goes <= releases;
      gathered <= facings;
      if (~&batches) batches <= batches + 1'b1;
    end
    valid <= {valid, issues};
    pairs <= {pairs, issue_pair, issue_bank, is_last, goes, ~is_last | last_leaf[0], gathered};
    inside <= inside + issues - drops - takes_pair;
    was_full_0 <= full_0;
    was_full_1 <= full_1;
    released_0 <= full_0 & (released_0 | (lets_go & ~bank));
    released_1 <= full_1 & (released_1 | (lets_go & bank));
    if (reset) begin
      {busy, bank, was_started, waits, was_full_0, was_full_1, released_0, released_1, batches} <= 0;
      valid <= 0;
      inside <= 0;
    end
  end
  always @(*) begin
    assume (!waits || complete);
    assume (!was_started || facings == gathered);
    assume (!was_full_0 || released_0 || full_0);
    assume (!was_full_1 || released_1 || full_1);
    assume (!complete || !(uses ? released_1 : released_0));
    assume (drops + takes_pair <= inside - valid[0] - valid[1]);
    // A batch starts where nothing of the batch before is to be issued, complete, on a full bank.
    assert (!starts || (!busy && complete && (bank ? full_1 : full_0)));
    assert (takes_box == was_started);
    assert (!issues || (busy && issue_pair == next && issue_bank == bank && inside < `QUEUE));
    assert (found_valid == valid[1]);
    assert (!found_valid || found == pairs[W+:W]);
    assert (compared == (found_valid ? (found_second ? 2 : 1) : 0));
    // What is known of the registers.
    assert (scanning == busy && starts == starting && started == was_started && scan_bank == bank);
    assert (!busy || (scan_pair == next && scan_end == last_leaf && scan_release == goes && next <= last_leaf[`K:1]));
    assert (used == inside + returned && used <= `QUEUE);
    assert (inside <= `QUEUE && inside >= valid[0] + valid[1]);
    assert (!starting || (waits && !busy && (bank ? was_full_1 && !released_1 : was_full_0 && !released_0)));
    assert (!busy || was_started || facings_out == gathered);
    assert (!valid[0] || (!was_started && facings_out == pairs[`FACINGS-1:0]));
    assert (!valid[1] || facings_out == pairs[W+:`FACINGS]);
    assert (!(busy && starting));
  end
  assign cover_second = batches == 2 & found_valid & found_end & found_pair == 1;
  assign cover_bank = found_valid & found_bank & ~found_second;
  assign cover_full = inside == `QUEUE;
endmodule
