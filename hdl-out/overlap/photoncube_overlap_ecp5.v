// SPDX-License-Identifier: MIT
// overlap: 1 modules of photoncube_overlap.v, made of an ECP5's own cells.
// Written by photoncube 0.2.0, `photoncube generate --machine overlap`; do not edit.
//
// Each replaces the module of that name in photoncube_overlap.v and is the same function, which
// scripts/yosys/ecp5.sh proves. With both files as they are a name is declared twice. Yosys:
// read_verilog photoncube_overlap.v; read_verilog -overwrite photoncube_overlap_ecp5.v. Elsewhere
// leave the modules below out of photoncube_overlap.v; the cells (CCU2C, LUT4, ...) are those of
// Lattice's library.
//
//   photoncube_overlap_chosen_sum

module photoncube_overlap_chosen_sum(sum, sum_low, addend, operand, add_sum, total);
    input wire [31:0] sum;
    input wire [17:0] sum_low;
    input wire [15:0] addend;
    input wire [31:0] operand;
    input wire add_sum;
    output wire [31:0] total;
    wire [31:0] chain;
    wire [16:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h656a), .INIT1(16'h656a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(operand[0]), .B0(sum_low[0]), .C0(add_sum), .D0(addend[0]),
        .A1(operand[1]), .B1(sum_low[1]), .C1(add_sum), .D1(addend[1]),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'h656a), .INIT1(16'h656a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(operand[2]), .B0(sum_low[2]), .C0(add_sum), .D0(addend[2]),
        .A1(operand[3]), .B1(sum_low[3]), .C1(add_sum), .D1(addend[3]),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h656a), .INIT1(16'h656a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(operand[4]), .B0(sum_low[4]), .C0(add_sum), .D0(addend[4]),
        .A1(operand[5]), .B1(sum_low[5]), .C1(add_sum), .D1(addend[5]),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h656a), .INIT1(16'h656a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(operand[6]), .B0(sum_low[6]), .C0(add_sum), .D0(addend[6]),
        .A1(operand[7]), .B1(sum_low[7]), .C1(add_sum), .D1(addend[7]),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'h656a), .INIT1(16'h656a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(operand[8]), .B0(sum_low[8]), .C0(add_sum), .D0(addend[8]),
        .A1(operand[9]), .B1(sum_low[9]), .C1(add_sum), .D1(addend[9]),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    CCU2C #(.INIT0(16'h656a), .INIT1(16'h656a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_5 (
        .CIN(carry[5]), .A0(operand[10]), .B0(sum_low[10]), .C0(add_sum), .D0(addend[10]),
        .A1(operand[11]), .B1(sum_low[11]), .C1(add_sum), .D1(addend[11]),
        .S0(chain[10]), .S1(chain[11]), .COUT(carry[6]));
    CCU2C #(.INIT0(16'h656a), .INIT1(16'h656a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_6 (
        .CIN(carry[6]), .A0(operand[12]), .B0(sum_low[12]), .C0(add_sum), .D0(addend[12]),
        .A1(operand[13]), .B1(sum_low[13]), .C1(add_sum), .D1(addend[13]),
        .S0(chain[12]), .S1(chain[13]), .COUT(carry[7]));
    CCU2C #(.INIT0(16'h656a), .INIT1(16'h656a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_7 (
        .CIN(carry[7]), .A0(operand[14]), .B0(sum_low[14]), .C0(add_sum), .D0(addend[14]),
        .A1(operand[15]), .B1(sum_low[15]), .C1(add_sum), .D1(addend[15]),
        .S0(chain[14]), .S1(chain[15]), .COUT(carry[8]));
    CCU2C #(.INIT0(16'h6a6a), .INIT1(16'h6a6a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_8 (
        .CIN(carry[8]), .A0(operand[16]), .B0(sum_low[16]), .C0(add_sum), .D0(1'b1),
        .A1(operand[17]), .B1(sum_low[17]), .C1(add_sum), .D1(1'b1),
        .S0(chain[16]), .S1(chain[17]), .COUT(carry[9]));
    CCU2C #(.INIT0(16'h666a), .INIT1(16'h666a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_9 (
        .CIN(carry[9]), .A0(operand[18]), .B0(sum[18]), .C0(1'b1), .D0(1'b1),
        .A1(operand[19]), .B1(sum[19]), .C1(1'b1), .D1(1'b1),
        .S0(chain[18]), .S1(chain[19]), .COUT(carry[10]));
    CCU2C #(.INIT0(16'h666a), .INIT1(16'h666a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_10 (
        .CIN(carry[10]), .A0(operand[20]), .B0(sum[20]), .C0(1'b1), .D0(1'b1),
        .A1(operand[21]), .B1(sum[21]), .C1(1'b1), .D1(1'b1),
        .S0(chain[20]), .S1(chain[21]), .COUT(carry[11]));
    CCU2C #(.INIT0(16'h666a), .INIT1(16'h666a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_11 (
        .CIN(carry[11]), .A0(operand[22]), .B0(sum[22]), .C0(1'b1), .D0(1'b1),
        .A1(operand[23]), .B1(sum[23]), .C1(1'b1), .D1(1'b1),
        .S0(chain[22]), .S1(chain[23]), .COUT(carry[12]));
    CCU2C #(.INIT0(16'h666a), .INIT1(16'h666a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_12 (
        .CIN(carry[12]), .A0(operand[24]), .B0(sum[24]), .C0(1'b1), .D0(1'b1),
        .A1(operand[25]), .B1(sum[25]), .C1(1'b1), .D1(1'b1),
        .S0(chain[24]), .S1(chain[25]), .COUT(carry[13]));
    CCU2C #(.INIT0(16'h666a), .INIT1(16'h666a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_13 (
        .CIN(carry[13]), .A0(operand[26]), .B0(sum[26]), .C0(1'b1), .D0(1'b1),
        .A1(operand[27]), .B1(sum[27]), .C1(1'b1), .D1(1'b1),
        .S0(chain[26]), .S1(chain[27]), .COUT(carry[14]));
    CCU2C #(.INIT0(16'h666a), .INIT1(16'h666a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_14 (
        .CIN(carry[14]), .A0(operand[28]), .B0(sum[28]), .C0(1'b1), .D0(1'b1),
        .A1(operand[29]), .B1(sum[29]), .C1(1'b1), .D1(1'b1),
        .S0(chain[28]), .S1(chain[29]), .COUT(carry[15]));
    CCU2C #(.INIT0(16'h666a), .INIT1(16'h666a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_15 (
        .CIN(carry[15]), .A0(operand[30]), .B0(sum[30]), .C0(1'b1), .D0(1'b1),
        .A1(operand[31]), .B1(sum[31]), .C1(1'b1), .D1(1'b1),
        .S0(chain[30]), .S1(chain[31]), .COUT(carry[16]));
    assign total = chain[31:0];
endmodule
