// The queue of pairs. A pair that was compared is queued if one of its groups is wanted, or if it ends its batch; else it is dropped.
// A group is wanted if it is there, its box is in range and its leaf is gathered. Of all pairs queued one is watched, by
// its number: it comes out under that number, as it was. The three memories are taken out: at the watched place they give what was
// written there last. Assumed: no pair is taken from an empty queue (leaves::player), none is queued in a full one (leaves::scan).
`default_nettype none
module harness(input wire clock, input wire reset, input wire valid, input wire [`K-1:0] pair, input wire bank,
    input wire ends, input wire releases, input wire [3:0] in_range, input wire [1:0] gathered, input wire [1:0] short,
    input wire takes_pair, input wire [`K-1:0] pair_read, input wire [3:0] mask_read, input wire [2:0] flags_read,
    output wire cover_watched, output wire cover_full);
  localparam P = $clog2(`QUEUE);
  localparam W = `K + 7;
  wire drops, has_pair;
  wire [`K-1:0] oldest_pair, pair_written;
  wire [3:0] oldest_mask, mask_written;
  wire [2:0] oldest_flags, flags_written;
  wire [1:0] wanted_leaves;
  wire [P-1:0] queue_write, queue_read, pair_place, mask_place, flag_place, pair_from, mask_from, flag_from;
  wire [P:0] queue_count;
  wire pair_write, mask_write, flag_write;
  dut dut(.clock(clock), .reset(reset), .valid(valid), .pair(pair), .bank(bank), .ends(ends), .releases(releases),
    .in_range_0(in_range[0]), .in_range_1(in_range[1]), .in_range_2(in_range[2]), .in_range_3(in_range[3]),
    .gathered_0(gathered[0]), .gathered_1(gathered[1]),
    .short_0(short[0]), .short_1(short[1]), .takes_pair(takes_pair), .drops(drops), .has_pair(has_pair),
    .oldest_pair(oldest_pair), .oldest_mask(oldest_mask), .oldest_flags(oldest_flags), .wanted(wanted_leaves),
    .queue_write_q(queue_write), .queue_read_q(queue_read), .queue_count_q(queue_count),
    .\pair_ram.clock (), .\pair_ram.write (pair_write), .\pair_ram.write_place (pair_place),
    .\pair_ram.write_word (pair_written), .\pair_ram.read_place (pair_from), .\pair_ram.read_word (pair_read),
    .\mask_ram.clock (), .\mask_ram.write (mask_write), .\mask_ram.write_place (mask_place),
    .\mask_ram.write_word (mask_written), .\mask_ram.read_place (mask_from), .\mask_ram.read_word (mask_read),
    .\flag_ram.clock (), .\flag_ram.write (flag_write), .\flag_ram.write_place (flag_place),
    .\flag_ram.write_word (flags_written), .\flag_ram.read_place (flag_from), .\flag_ram.read_word (flags_read));

  wire [3:0] groups = in_range & {{2{gathered[1]}}, {2{gathered[0]}}} & {~short[1], 1'b1, ~short[0], 1'b1};
  wire [1:0] wanted = {|groups[3:2], |groups[1:0]};
  wire queued = valid & (|wanted | ends);
  wire [W-1:0] word = {pair, groups, releases, ends, bank};
  // Numbers have a bit more than places: as many pairs as there are places are told apart.
  reg [P:0] write_number = 0, read_number = 0;
  reg [P:0] watched;
  reg [W-1:0] value = 0, stored = 0;
  reg pending = 0;
  wire [P:0] inside = write_number - read_number;
  wire [P:0] ahead = watched - read_number;
  wire is_watched = read_number == watched & pending;
  always @(posedge clock) begin
    watched <= watched;
    if (queued) write_number <= write_number + 1'b1;
    if (takes_pair) read_number <= read_number + 1'b1;
    if (takes_pair & read_number == watched) pending <= 1'b0;
    if (queued & write_number == watched) begin
      value <= word;
      pending <= 1'b1;
    end
    if (pair_write & pair_place == watched[P-1:0]) stored <= {pair_written, mask_written, flags_written};
    if (reset) begin
      write_number <= 0;
      read_number <= 0;
      pending <= 1'b0;
    end
  end
  always @(*) begin
    assume (!takes_pair || inside != 0);
    assume (!queued || inside < `QUEUE);
    assume (pair_from != watched[P-1:0] || {pair_read, mask_read, flags_read} == stored);
    assert (drops == (valid & ~queued));
    assert (wanted_leaves == (valid ? wanted[0] + wanted[1] : 0));
    assert (has_pair == (inside != 0));
    assert (!is_watched || {oldest_pair, oldest_mask, oldest_flags} == value);
    assert (pending == (ahead < inside));
    // What is known of the registers.
    assert (inside <= `QUEUE && queue_count == inside);
    assert (queue_write == write_number[P-1:0] && queue_read == read_number[P-1:0]);
    assert (pair_write == queued && mask_write == queued && flag_write == queued);
    assert (pair_place == queue_write && mask_place == queue_write && flag_place == queue_write);
    assert (pair_from == queue_read && mask_from == queue_read && flag_from == queue_read);
    assert (!pending || stored == value);
  end
  assign cover_watched = takes_pair & is_watched & watched == 2 & oldest_mask == 4'b1001;
  assign cover_full = inside == `QUEUE;
endmodule
