// The queue of results: of all words written one is watched, by its number. It comes out once, under the same number,
// as it was; so nothing is dropped, repeated or put in another order. A result that is not taken stays. Assumed: none is
// written where the memory is full, which the admission sees to.
`default_nettype none
module harness(input wire clock, input wire reset, input wire written, input wire [`BITS-1:0] data,
    input wire result_ready, output wire cover_watched, output wire cover_full);
  localparam PLACE = $clog2(`PLACES);
  wire result_valid, batch_read, has_waiting, has_result;
  wire [PLACE-1:0] write_place, newest_place, read_place;
  wire [`BITS-1:0] word;
  wire [`BITS-1:0] result;
  wire [`BITS*`PLACES-1:0] results;
  dut dut(.clock(clock), .reset(reset), .result_valid_in(written), `DATA_IN .result_ready(result_ready),
    .result_valid(result_valid), `DATA_OUT .batch_read(batch_read), .write_place(write_place),
    .newest_place(newest_place), .read_place(read_place), .has_waiting(has_waiting),
    .has_result(has_result) `MEMORY);

  // Numbers have a bit more than places: as many words as there are places, and one on the pins, are told apart.
  reg [PLACE:0] write_number = 0, give_number = 0;
  reg [PLACE:0] watched;
  reg [`BITS-1:0] value = 0, before = 0;
  reg pending = 0, stalled = 0;
  wire given = result_valid & result_ready;
  wire [PLACE:0] inside = write_number - give_number;
  wire [PLACE:0] in_memory = inside - has_result;
  wire [PLACE:0] ahead = watched - give_number;
  always @(posedge clock) begin
    watched <= watched;
    stalled <= result_valid & ~result_ready & ~reset;
    before <= result;
    if (written) write_number <= write_number + 1'b1;
    if (given) give_number <= give_number + 1'b1;
    if (given & give_number == watched) pending <= 1'b0;
    if (written & write_number == watched) begin
      value <= data;
      pending <= 1'b1;
    end
    if (reset) begin
      write_number <= 0;
      give_number <= 0;
      pending <= 1'b0;
    end
  end
  wire [PLACE-1:0] watched_place = watched[PLACE-1:0];
  wire [PLACE:0] next_read = give_number + has_result;
  wire [PLACE:0] newest = write_number - 1'b1;
  always @(*) begin
    assume (!(written && in_memory == `PLACES));
    // What is given is what was written, under its number, and only where one was.
    assert (!given || inside != 0);
    assert (!given || give_number != watched || (pending && result == value));
    assert (!stalled || (result_valid && result == before));
    // What is known of the registers.
    assert (inside <= `PLACES + 1 && in_memory <= `PLACES);
    assert (write_place == write_number[PLACE-1:0] && read_place == next_read[PLACE-1:0]);
    assert (has_waiting == (in_memory != 0));
    assert (!has_waiting || newest_place == newest[PLACE-1:0]);
    assert (!has_result || inside != 0);
    assert (result_valid == has_result);
    assert (pending == (ahead < inside));
    assert (!pending || value == (has_result && ahead == 0 ? result : results[watched_place*`BITS+:`BITS]));
    // A batch has been read when the last of its results, one of each engine, leaves the memory.
    assert (batch_read == (has_waiting && (!has_result || result_ready) && next_read % `ENGINES == `ENGINES - 1));
  end
  assign cover_watched = given & give_number == watched & watched == 2;
  assign cover_full = in_memory == `PLACES & has_result;
endmodule
