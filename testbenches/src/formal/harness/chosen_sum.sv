// The adder with its choice of operands: the sum and the operand, modulo the sum's width, or the addend and the
// operand, modulo the work register's. Assumed is how the cell gives it the sum's low bits.
`default_nettype none
module harness(input wire [`SUM-1:0] sum, input wire [`SQUARE-1:0] addend, input wire [`SUM-1:0] operand,
    input wire add_sum, output wire cover_sum, output wire cover_work);
  wire [`SUM-1:0] total;
  wire [`WORK-1:0] work = total[`WORK-1:0];
  wire [`WORK-1:0] addend_wide = addend;
  dut dut(.sum(sum), .sum_low(sum[`WORK-1:0]), .addend(addend), .operand(operand), .add_sum(add_sum), .total(total));
  always @(*) begin
    if (add_sum) assert (total - operand == sum);
    else assert (work - operand[`WORK-1:0] == addend_wide);
  end
  assign cover_sum = add_sum & total < sum;
  assign cover_work = ~add_sum & total != operand;
endmodule
