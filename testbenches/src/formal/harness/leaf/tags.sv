// The tags of results. Of all tokens one is watched, by its number: the result with that number has the tag of the token if it is a
// query; the result of a filler is taken from the chain and not given. A batch leaves with the result of its last engine. The memory
// is taken out: at the watched place it gives what was written there last. Assumed: the chain gives one result for each token, in
// order, at the earliest two clocks after it took the token, and no more tokens are under way than the memory has places.
`default_nettype none
module harness(input wire clock, input wire reset, input wire takes_token, input wire takes_query,
    input wire [`TAG-1:0] query_tag, input wire chain_valid, input wire result_ready, input wire [`TAG:0] word_read,
    output wire cover_query, output wire cover_filler);
  localparam P = $clog2(`PLACES);
  wire chain_ready, result_valid, batch_leaves, word_write, has_oldest;
  wire [`TAG-1:0] result_tag;
  wire [`TAG:0] word_written, oldest;
  wire [P-1:0] tag_write, tag_read, write_place, read_place;
  wire [`RESULT-1:0] tag_result;
  dut dut(.clock(clock), .reset(reset), .takes_token(takes_token), .takes_query(takes_query), .query_tag(query_tag),
    .chain_valid(chain_valid), .result_ready(result_ready), .chain_ready(chain_ready), .result_valid(result_valid),
    .result_tag(result_tag), .batch_leaves(batch_leaves), .tag_write_q(tag_write), .tag_read_q(tag_read),
    .has_oldest_q(has_oldest), .oldest_q(oldest), .tag_result_q(tag_result), .\tag_ram.clock (), .\tag_ram.write (word_write), .\tag_ram.write_place (write_place),
    .\tag_ram.write_word (word_written), .\tag_ram.read_place (read_place), .\tag_ram.read_word (word_read));

  // The tokens whose tags were written, loaded, and taken with their results; and those written before the clock before.
  reg [P:0] write_number = 0, load_number = 0, read_number = 0, write_before = 0;
  reg [P:0] watched;
  reg [7:0] of_batch = 0;
  reg [`TAG-1:0] value = 0;
  reg [`TAG:0] stored = 0;
  reg is_query = 0, pending = 0;
  wire [P:0] inside = write_number - read_number;
  wire [P:0] after_read = read_number + has_oldest;
  wire [P:0] after_before = write_before + 1'b1;
  wire [P:0] ahead = watched - read_number;
  wire taken = chain_valid & chain_ready;
  wire loads = write_number != load_number & (taken | ~has_oldest);
  wire is_watched = read_number == watched & pending;
  always @(posedge clock) begin
    watched <= watched;
    write_before <= write_number;
    load_number <= load_number + loads;
    if (takes_token) write_number <= write_number + 1'b1;
    if (taken) begin
      read_number <= read_number + 1'b1;
      of_batch <= of_batch == `ENGINES - 1 ? 0 : of_batch + 1'b1;
    end
    if (taken & read_number == watched) pending <= 1'b0;
    if (takes_token & write_number == watched) begin
      value <= query_tag;
      is_query <= takes_query;
      pending <= 1'b1;
    end
    if (word_write & write_place == watched[P-1:0]) stored <= word_written;
    if (reset) begin
      write_number <= 0;
      load_number <= 0;
      write_before <= 0;
      read_number <= 0;
      of_batch <= 0;
      pending <= 1'b0;
    end
  end
  always @(*) begin
    assume (!takes_query || takes_token);
    assume (!chain_valid || write_before != read_number);
    assume (!takes_token || inside < `PLACES);
    assume (read_place != watched[P-1:0] || word_read == stored);
    assert (!(chain_valid && is_watched) || result_valid == is_query);
    assert (!(chain_valid && is_watched && is_query) || (result_tag == value && chain_ready == result_ready));
    assert (!(chain_valid && is_watched && !is_query) || chain_ready);
    assert (!result_valid || chain_valid);
    assert (batch_leaves == (taken && of_batch == `ENGINES - 1));
    assert (pending == (ahead < inside));
    // What is known of the registers.
    assert (inside <= `PLACES && of_batch < `ENGINES && tag_result == of_batch);
    assert (tag_write == write_number[P-1:0] && tag_read == load_number[P-1:0]);
    assert (has_oldest == (write_before != read_number) && load_number == after_read);
    assert (has_oldest || inside < 2);
    assert (write_before - read_number <= inside);
    assert (write_number == write_before || write_number == after_before);
    assert (!(has_oldest && is_watched) || oldest == {value, is_query});
    assert (word_write == takes_token && write_place == tag_write && read_place == tag_read);
    assert (!pending || stored == {value, is_query});
  end
  assign cover_query = taken & is_watched & is_query & watched == 2 & value != 0;
  assign cover_filler = taken & is_watched & ~is_query & watched == 1;
endmodule
