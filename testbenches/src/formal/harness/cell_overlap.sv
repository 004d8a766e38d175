// The gate of the overlapped cell, its square's last stage and its sum, by the spec's op table; for all registers.
// A sum that no op writes stays.
`default_nettype none
module harness(input wire clock, input wire [`WORD-1:0] word, input wire write_query,
    input wire [`COORDINATE-1:0] query_in, input wire [`RADIUS_SQ-1:0] radius_sq_in,
    input wire [`COORDINATE-1:0] photon_in, input wire present_in, input wire [`POWER-1:0] power_in,
    input wire [`SUM-1:0] link_x, input wire [`SUM-1:0] link_y, input wire [`WORK-1:0] link_z,
    input wire [`WORK-1:0] link_w, input wire [`SUM:0] operand_bound, output wire cover_gate, output wire cover_sum);
  wire [`SUM-1:0] sum_out, sum_q, sum_d, operand_q, operand_d;
  wire [`WORK-1:0] z_out, w_out, work_q, distance_q;
  wire [`RADIUS_SQ-1:0] radius_sq_q;
  wire [`POWER-1:0] power_7_q;
  wire [2*`DIFFERENCE-1:0] square_q, square_d, digit_squares_q, addend_d;
  wire [5:0] low_product_q, high_product_q;
  wire present_7_q, in_range_q, in_range_d;
  dut dut(.clock(clock), .word(word), .write_query(write_query), .query_in(query_in),
    .radius_sq_in(radius_sq_in), .photon_in(photon_in), .present_in(present_in), .power_in(power_in),
    .link_x(link_x), .link_y(link_y), .link_z(link_z), .link_w(link_w), .sum_out(sum_out), .z_out(z_out),
    .w_out(w_out), .sum_q(sum_q), .sum_d(sum_d), .operand_q(operand_q), .operand_d(operand_d),
    .work_q(work_q), .distance_q(distance_q), .radius_sq_q(radius_sq_q), .power_7_q(power_7_q),
    .present_7_q(present_7_q), .in_range_q(in_range_q), .in_range_d(in_range_d), .square_q(square_q),
    .square_d(square_d), .digit_squares_q(digit_squares_q), .low_product_q(low_product_q),
    .high_product_q(high_product_q), .addend_d(addend_d));
  wire [3:0] axis = word[`axis+:4];
  wire gate = word[`gate];
  wire accumulates = word[`write_sum];
  reg [`SUM:0] bound = 0;
  wire [`SUM:0] next_bound = bound + operand_bound;
  wire [`SUM:0] exact = {1'b0, sum_q} + operand_q;
  always @(posedge clock) begin
    if (write_query) bound <= 0;
    else if (accumulates) bound <= next_bound;
  end
  always @(*) begin
    // As the control block's words are: one operand at most, and the adder's first operand of a sum is the sum.
    assume ((axis & (axis - 1'b1)) == 0 && !(gate && axis != 0));
    assume (accumulates == word[`add_sum]);
    // No more photons are given than are declared.
    assume (operand_q <= operand_bound && operand_bound <= `LARGEST);
    assume (!accumulates || next_bound <= `LARGEST);
    assert (sum_out == sum_q);
    assert (in_range_d == (distance_q <= radius_sq_q));
    assert (addend_d == square_q);
    if (word[`write_square]) assert (square_d - digit_squares_q == {low_product_q, 5'd0} + {high_product_q, 7'd0});
    else assert (square_d == square_q);
    if (gate) assert (operand_d == (in_range_q && present_7_q ? power_7_q : 0));
    else case (axis)
      1: assert (operand_d == link_x);
      2: assert (operand_d == link_y);
      4: assert (operand_d == link_z);
      8: assert (operand_d == link_w);
      default: assert (operand_d == 0);
    endcase
    if (write_query) assert (sum_d == 0);
    else if (accumulates) assert (sum_d == exact);
    else assert (sum_d == sum_q);
    assert (bound <= `LARGEST && sum_q <= bound);
  end
  assign cover_gate = gate & operand_d != 0;
  assign cover_sum = sum_q > 2 * link_x & link_x != 0;
endmodule
