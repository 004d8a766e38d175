// Each op of the cell is its formula in the spec's op table, for all registers; a register that an op does not write
// stays. The square is that of the square unit, which has properties of its own.
`default_nettype none
module harness(input wire clock, input wire write_query, input wire write_photon, input wire write_power,
    input wire write_work, input wire write_sum, input wire [1:0] work_source, input wire add_sum,
    input wire [`COORDINATE-1:0] query_in, input wire [`RADIUS_SQ-1:0] radius_sq_in,
    input wire [`PHOTON-1:0] photon_in, input wire present_in, input wire [`POWER-1:0] power_in,
    input wire [`WORK-1:0] link_in, output wire cover_gate, output wire cover_sum);
  wire [`WORK-1:0] work_out, work_q, work_d;
  wire [`SUM-1:0] sum_out, sum_q, sum_d;
  wire [`COORDINATE-1:0] query_q, query_d;
  wire [`PHOTON-1:0] photon_q, photon_d;
  wire [`RADIUS_SQ-1:0] radius_sq_q, radius_sq_d;
  wire [`POWER-1:0] power_q, power_d;
  wire [`COORDINATE-1:0] square_unit_a;
  wire [`PHOTON-1:0] square_unit_b;
  wire [2*`DIFFERENCE-1:0] square_unit_square;
  dut dut(.clock(clock), .write_query(write_query), .write_photon(write_photon), .write_power(write_power),
    .write_work(write_work), .write_sum(write_sum), .work_source(work_source), .add_sum(add_sum),
    .query_in(query_in), .radius_sq_in(radius_sq_in), .photon_in(photon_in), .present_in(present_in),
    .power_in(power_in), .link_in(link_in), .work_out(work_out), .sum_out(sum_out),
    .work_q(work_q), .work_d(work_d), .sum_q(sum_q), .sum_d(sum_d), .query_q(query_q), .query_d(query_d),
    .photon_q(photon_q), .photon_d(photon_d), .radius_sq_q(radius_sq_q), .radius_sq_d(radius_sq_d),
    .power_q(power_q), .power_d(power_d), .square_unit_a(square_unit_a), .square_unit_b(square_unit_b),
    .square_unit_square(square_unit_square));
  // An op writes by one of these fields, as the words of the program do.
  wire [4:0] writes = {write_query, write_photon, write_power, write_work, write_sum};
  always @(*) begin
    assume ((writes & (writes - 1'b1)) == 0);
    assume (!(write_work && work_source == 1) || !add_sum);
    assume (!write_sum || (add_sum && link_in == 0));
    assert (work_out == work_q && sum_out == sum_q);
    assert (square_unit_a == query_q && square_unit_b == photon_q);
    assert (query_d == (write_query ? query_in : query_q));
    assert (radius_sq_d == (write_query ? radius_sq_in : radius_sq_q));
    assert (photon_d == (write_photon ? photon_in : photon_q));
    assert (power_d == (write_power ? (present_in ? power_in : {`POWER{1'b0}}) : power_q));
    if (!write_work) assert (work_d == work_q);
    `OPS
    // Where two words are each no more than the full scale of so many photons, their sum is no more than twice that.
    if (write_work && work_source == 1) begin `EXCHANGES end
    if (write_query) assert (sum_d == 0);
    else if (!write_sum) assert (sum_d == sum_q);
  end
  assign cover_gate = write_work & work_source == 2 & work_q == radius_sq_q & work_d != 0 & sum_q != 0;
  assign cover_sum = write_sum & sum_q != 0 & work_q != 0;
endmodule
