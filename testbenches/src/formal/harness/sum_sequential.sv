// The sum of a cell cannot overflow for the declared number of photons. `bound` grows by the full scale for each
// photon of an iteration; the work register, which is added, holds no more than these photons' full scale (a gated
// power is no more than the full scale, and an exchange-add at most doubles it, which `cell::ops` shows).
// That the bound stays within the declared photons' full scale is that no more are given.
`default_nettype none
module harness(input wire clock, input wire write_query, input wire write_photon, input wire write_power,
    input wire write_work, input wire write_sum, input wire [1:0] work_source,
    input wire [`COORDINATE-1:0] query_in, input wire [`RADIUS_SQ-1:0] radius_sq_in,
    input wire [`PHOTON-1:0] photon_in, input wire present_in, input wire [`POWER-1:0] power_in,
    input wire [`WORK-1:0] link_in, input wire [`SUM-1:0] photons_full_scale, output wire cover_full);
  wire [`WORK-1:0] work_out, work_q;
  wire [`SUM-1:0] sum_out, sum_q, sum_d;
  dut dut(.clock(clock), .write_query(write_query), .write_photon(write_photon), .write_power(write_power),
    .write_work(write_work), .write_sum(write_sum), .work_source(work_source), .add_sum(write_sum),
    .query_in(query_in), .radius_sq_in(radius_sq_in), .photon_in(photon_in), .present_in(present_in),
    .power_in(power_in), .link_in(link_in), .work_out(work_out), .sum_out(sum_out),
    .work_q(work_q), .sum_q(sum_q), .sum_d(sum_d));
  // One bit more than a sum: it does not wrap itself.
  reg [`SUM:0] bound = 0;
  wire [`SUM:0] next_bound = bound + photons_full_scale;
  wire [`SUM:0] exact = {1'b0, sum_q} + work_q;
  always @(posedge clock) begin
    if (write_query) bound <= 0;
    else if (write_sum) bound <= next_bound;
  end
  always @(*) begin
    assume (!(write_query && write_sum));
    assume (`ONE_OF_THE_COUNTS);
    if (write_sum) begin
      assume (link_in == 0);
      assume (work_q <= photons_full_scale);
      assume (next_bound <= `LARGEST);
    end
    assert (bound <= `LARGEST && sum_q <= bound);
    if (write_sum && !write_query) assert (sum_d == exact);
  end
  assign cover_full = sum_q == `COVERED;
endmodule
