// SPDX-License-Identifier: MIT
// leaf-5-local7-rgb6d-n64: 10 modules of photoncube_leaf_5_local7_rgb6d_n64.v, made of an ECP5's
// own cells.
// Written by photoncube 0.2.0, `photoncube generate --machine leaf-5-local7-rgb6d-n64`; do not edit.
//
// Each replaces the module of that name in photoncube_leaf_5_local7_rgb6d_n64.v and is the same
// function, which scripts/yosys/ecp5.sh proves. With both files as they are a name is declared
// twice. Yosys: read_verilog photoncube_leaf_5_local7_rgb6d_n64.v; read_verilog -overwrite
// photoncube_leaf_5_local7_rgb6d_n64_ecp5.v. Elsewhere leave the modules below out of
// photoncube_leaf_5_local7_rgb6d_n64.v; the cells (CCU2C, LUT4, ...) are those of Lattice's
// library.
//
//   photoncube_leaf_5_local7_rgb6d_n64_accumulate_2
//   photoncube_leaf_5_local7_rgb6d_n64_gated_sum_2
//   photoncube_leaf_5_local7_rgb6d_n64_product
//   photoncube_leaf_5_local7_rgb6d_n64_subtract
//   photoncube_leaf_5_local7_rgb6d_n64_range_of_format
//   photoncube_leaf_5_local7_rgb6d_n64_accumulate
//   photoncube_leaf_5_local7_rgb6d_n64_gated_sum
//   photoncube_leaf_5_local7_rgb6d_n64_square_sum
//   photoncube_leaf_5_local7_rgb6d_n64_magnitude_of
//   photoncube_leaf_5_local7_rgb6d_n64_digit_products

module photoncube_leaf_5_local7_rgb6d_n64_accumulate_2(group, sum, first, next_sum);
    input wire [2:0] group;
    input wire [6:0] sum;
    input wire first;
    output wire [6:0] next_sum;
    wire [7:0] chain;
    wire [4:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'hd2d2), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(sum[0]), .B0(first), .C0(group[0]), .D0(1'b1),
        .A1(sum[1]), .B1(first), .C1(group[1]), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(sum[2]), .B0(first), .C0(group[2]), .D0(1'b1),
        .A1(sum[3]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(sum[4]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[5]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(sum[6]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    assign next_sum = chain[6:0];
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_gated_sum_2(a, b, a_in_range, b_in_range, sum);
    input wire a;
    input wire b;
    input wire a_in_range;
    input wire b_in_range;
    output wire [1:0] sum;
    wire [1:0] chain;
    wire [1:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(a), .B0(a_in_range), .C0(b), .D0(b_in_range),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    assign sum = chain[1:0];
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_product(clock, difference, square, far);
    input wire clock;
    input wire [9:0] difference;
    output wire [13:0] square;
    output wire far;
    wire [9:0] operand = difference;
    wire [35:0] product;
    MULT18X18D #(.REG_INPUTA_CLK("CLK0"), .REG_INPUTB_CLK("CLK0"), .REG_OUTPUT_CLK("CLK0"), .GSR("DISABLED")) block (
        .CLK0(clock), .CE0(1'b1), .RST0(1'b0),
        .SIGNEDA(1'b1), .SIGNEDB(1'b1), .SOURCEA(1'b0), .SOURCEB(1'b0),
        .A0(1'b0), .A1(1'b0), .A2(1'b0), .A3(1'b0), .A4(1'b0), .A5(1'b0), .A6(1'b0), .A7(1'b0), .A8(operand[0]), .A9(operand[1]), .A10(operand[2]), .A11(operand[3]), .A12(operand[4]), .A13(operand[5]), .A14(operand[6]), .A15(operand[7]), .A16(operand[8]), .A17(operand[9]),
        .B0(1'b0), .B1(1'b0), .B2(1'b0), .B3(1'b0), .B4(1'b0), .B5(1'b0), .B6(1'b0), .B7(1'b0), .B8(operand[0]), .B9(operand[1]), .B10(operand[2]), .B11(operand[3]), .B12(operand[4]), .B13(operand[5]), .B14(operand[6]), .B15(operand[7]), .B16(operand[8]), .B17(operand[9]),
        .P0(product[0]), .P1(product[1]), .P2(product[2]), .P3(product[3]), .P4(product[4]), .P5(product[5]), .P6(product[6]), .P7(product[7]), .P8(product[8]), .P9(product[9]), .P10(product[10]), .P11(product[11]), .P12(product[12]), .P13(product[13]), .P14(product[14]), .P15(product[15]), .P16(product[16]), .P17(product[17]), .P18(product[18]), .P19(product[19]), .P20(product[20]), .P21(product[21]), .P22(product[22]), .P23(product[23]), .P24(product[24]), .P25(product[25]), .P26(product[26]), .P27(product[27]), .P28(product[28]), .P29(product[29]), .P30(product[30]), .P31(product[31]), .P32(product[32]), .P33(product[33]), .P34(product[34]), .P35(product[35]));
    assign square = product[29:16];
    assign far = |product[33:30];
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_subtract(a, b, difference);
    input wire [8:0] a;
    input wire [8:0] b;
    output wire [9:0] difference;
    wire [11:0] chain;
    wire [6:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h0008), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(1'b1), .B0(1'b1), .C0(1'b1), .D0(1'b1),
        .A1(a[0]), .B1(b[0]), .C1(1'b1), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(a[1]), .B0(b[1]), .C0(1'b1), .D0(1'b1),
        .A1(a[2]), .B1(b[2]), .C1(1'b1), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(a[3]), .B0(b[3]), .C0(1'b1), .D0(1'b1),
        .A1(a[4]), .B1(b[4]), .C1(1'b1), .D1(1'b1),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(a[5]), .B0(b[5]), .C0(1'b1), .D0(1'b1),
        .A1(a[6]), .B1(b[6]), .C1(1'b1), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(a[7]), .B0(b[7]), .C0(1'b1), .D0(1'b1),
        .A1(a[8]), .B1(b[8]), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    CCU2C #(.INIT0(16'hfff0), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_5 (
        .CIN(carry[5]), .A0(1'b1), .B0(1'b1), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[10]), .S1(chain[11]), .COUT(carry[6]));
    assign difference = chain[10:1];
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_range_of_format(distance, far, in_range);
    input wire [15:0] distance;
    input wire far;
    output wire in_range;
    wire above;
    LUT4 #(.INIT(16'hfefe)) lut_above (.A(far), .B(distance[14]), .C(distance[15]), .D(1'b0), .Z(above));
    wire all_without;
    LUT4 #(.INIT(16'h0000)) lut_all_without (.A(distance[9]), .B(distance[10]), .C(distance[11]), .D(distance[12]), .Z(all_without));
    wire all_with;
    LUT4 #(.INIT(16'h8000)) lut_all_with (.A(distance[9]), .B(distance[10]), .C(distance[11]), .D(distance[12]), .Z(all_with));
    wire all;
    PFUMX mux_all (.ALUT(all_with), .BLUT(all_without), .C0(distance[13]), .Z(all));
    wire middle;
    LUT4 #(.INIT(16'hfffe)) lut_middle (.A(distance[5]), .B(distance[6]), .C(distance[7]), .D(distance[8]), .Z(middle));
    wire low_without;
    LUT4 #(.INIT(16'hffe0)) lut_low_without (.A(distance[0]), .B(distance[1]), .C(distance[2]), .D(distance[3]), .Z(low_without));
    wire low_with;
    LUT4 #(.INIT(16'hffff)) lut_low_with (.A(distance[0]), .B(distance[1]), .C(distance[2]), .D(distance[3]), .Z(low_with));
    wire low;
    PFUMX mux_low (.ALUT(low_with), .BLUT(low_without), .C0(distance[4]), .Z(low));
    wire near;
    LUT4 #(.INIT(16'h1115)) lut_near (.A(above), .B(all), .C(middle), .D(low), .Z(near));
    assign in_range = near;
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_accumulate(group, sum, first, next_sum);
    input wire [7:0] group;
    input wire [11:0] sum;
    input wire first;
    output wire [11:0] next_sum;
    wire [11:0] chain;
    wire [6:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'hd2d2), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(sum[0]), .B0(first), .C0(group[0]), .D0(1'b1),
        .A1(sum[1]), .B1(first), .C1(group[1]), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'hd2d2), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(sum[2]), .B0(first), .C0(group[2]), .D0(1'b1),
        .A1(sum[3]), .B1(first), .C1(group[3]), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'hd2d2), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(sum[4]), .B0(first), .C0(group[4]), .D0(1'b1),
        .A1(sum[5]), .B1(first), .C1(group[5]), .D1(1'b1),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'hd2d2), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(sum[6]), .B0(first), .C0(group[6]), .D0(1'b1),
        .A1(sum[7]), .B1(first), .C1(group[7]), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(sum[8]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[9]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_5 (
        .CIN(carry[5]), .A0(sum[10]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[11]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[10]), .S1(chain[11]), .COUT(carry[6]));
    assign next_sum = chain[11:0];
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_gated_sum(a, b, a_in_range, b_in_range, sum);
    input wire [5:0] a;
    input wire [5:0] b;
    input wire a_in_range;
    input wire b_in_range;
    output wire [6:0] sum;
    wire [7:0] chain;
    wire [4:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(a[0]), .B0(a_in_range), .C0(b[0]), .D0(b_in_range),
        .A1(a[1]), .B1(a_in_range), .C1(b[1]), .D1(b_in_range),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(a[2]), .B0(a_in_range), .C0(b[2]), .D0(b_in_range),
        .A1(a[3]), .B1(a_in_range), .C1(b[3]), .D1(b_in_range),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(a[4]), .B0(a_in_range), .C0(b[4]), .D0(b_in_range),
        .A1(a[5]), .B1(a_in_range), .C1(b[5]), .D1(b_in_range),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h0000), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(1'b1), .B0(1'b1), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    assign sum = chain[6:0];
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_square_sum(magnitude, cross_product, square);
    input wire [6:0] magnitude;
    input wire [6:0] cross_product;
    output wire [13:0] square;
    wire table_0 = (magnitude[0]);
    wire table_1 = 1'b0;
    wire table_2 = (~magnitude[0] & magnitude[1]);
    wire table_3 = (magnitude[0] & magnitude[1] & ~magnitude[2]) | (magnitude[0] & ~magnitude[1] & magnitude[2]);
    wire table_4 = (~magnitude[0] & ~magnitude[1] & magnitude[2]) | (magnitude[0] & ~magnitude[1] & magnitude[2]) | (magnitude[0] & magnitude[1] & magnitude[2]);
    wire table_5 = (magnitude[1] & magnitude[2]);
    wire table_6 = (magnitude[3]);
    wire table_7 = 1'b0;
    wire table_8 = (~magnitude[3] & magnitude[4]);
    wire table_9 = (magnitude[3] & magnitude[4] & ~magnitude[5]) | (magnitude[3] & ~magnitude[4] & magnitude[5]);
    wire table_10 = (~magnitude[3] & ~magnitude[4] & magnitude[5] & ~magnitude[6]) | (magnitude[3] & ~magnitude[4] & magnitude[5] & ~magnitude[6]) | (magnitude[3] & magnitude[4] & magnitude[5] & ~magnitude[6]) | (magnitude[3] & ~magnitude[4] & ~magnitude[5] & magnitude[6]) | (magnitude[3] & magnitude[4] & ~magnitude[5] & magnitude[6]) | (~magnitude[3] & ~magnitude[4] & magnitude[5] & magnitude[6]);
    wire table_11 = (~magnitude[3] & magnitude[4] & magnitude[5] & ~magnitude[6]) | (magnitude[3] & magnitude[4] & magnitude[5] & ~magnitude[6]) | (~magnitude[3] & magnitude[4] & ~magnitude[5] & magnitude[6]) | (magnitude[3] & magnitude[4] & ~magnitude[5] & magnitude[6]) | (magnitude[3] & ~magnitude[4] & magnitude[5] & magnitude[6]) | (magnitude[3] & magnitude[4] & magnitude[5] & magnitude[6]);
    wire table_12 = (~magnitude[4] & ~magnitude[5] & magnitude[6]) | (magnitude[4] & ~magnitude[5] & magnitude[6]) | (magnitude[4] & magnitude[5] & magnitude[6]);
    wire table_13 = (magnitude[5] & magnitude[6]);
    wire [9:0] chain;
    wire [5:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h5a9a), .INIT1(16'h6a6a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(cross_product[0]), .B0(magnitude[1]), .C0(magnitude[2]), .D0(magnitude[0]),
        .A1(cross_product[1]), .B1(magnitude[1]), .C1(magnitude[2]), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'h666a), .INIT1(16'haaaa), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(cross_product[2]), .B0(magnitude[3]), .C0(1'b1), .D0(1'b1),
        .A1(cross_product[3]), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h9a9a), .INIT1(16'h96aa), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(cross_product[4]), .B0(magnitude[3]), .C0(magnitude[4]), .D0(1'b1),
        .A1(cross_product[5]), .B1(magnitude[5]), .C1(magnitude[4]), .D1(magnitude[3]),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h666a), .INIT1(16'he860), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(cross_product[6]), .B0(table_10), .C0(1'b1), .D0(1'b1),
        .A1(magnitude[5]), .B1(magnitude[6]), .C1(magnitude[4]), .D1(magnitude[3]),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'hc4c0), .INIT1(16'h8880), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(magnitude[5]), .B0(magnitude[6]), .C0(magnitude[4]), .D0(1'b1),
        .A1(magnitude[5]), .B1(magnitude[6]), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    assign square = {chain[9:0], table_3, table_2, table_1, table_0};
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_magnitude_of(difference, magnitude);
    input wire [9:0] difference;
    output wire [8:0] magnitude;
    wire [9:0] chain;
    wire [5:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h0002), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(difference[9]), .B0(difference[0]), .C0(1'b1), .D0(1'b1),
        .A1(difference[1]), .B1(difference[9]), .C1(1'b1), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'h6660), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(difference[2]), .B0(difference[9]), .C0(1'b1), .D0(1'b1),
        .A1(difference[3]), .B1(difference[9]), .C1(1'b1), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h6660), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(difference[4]), .B0(difference[9]), .C0(1'b1), .D0(1'b1),
        .A1(difference[5]), .B1(difference[9]), .C1(1'b1), .D1(1'b1),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h6660), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(difference[6]), .B0(difference[9]), .C0(1'b1), .D0(1'b1),
        .A1(difference[7]), .B1(difference[9]), .C1(1'b1), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'h6660), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(difference[8]), .B0(difference[9]), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    assign magnitude = {chain[8:1], difference[0]};
endmodule

module photoncube_leaf_5_local7_rgb6d_n64_digit_products(magnitude, low_product, high_product);
    input wire [6:0] magnitude;
    output wire [5:0] low_product;
    output wire [3:0] high_product;
    wire [5:0] low_product_chain;
    wire [3:0] low_product_carry;
    assign low_product_carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h8880), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) low_product_pair_0 (
        .CIN(low_product_carry[0]), .A0(magnitude[3]), .B0(magnitude[0]), .C0(1'b1), .D0(1'b1),
        .A1(magnitude[4]), .B1(magnitude[0]), .C1(magnitude[3]), .D1(magnitude[1]),
        .S0(low_product_chain[0]), .S1(low_product_chain[1]), .COUT(low_product_carry[1]));
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) low_product_pair_1 (
        .CIN(low_product_carry[1]), .A0(magnitude[5]), .B0(magnitude[0]), .C0(magnitude[4]), .D0(magnitude[1]),
        .A1(magnitude[6]), .B1(magnitude[0]), .C1(magnitude[5]), .D1(magnitude[1]),
        .S0(low_product_chain[2]), .S1(low_product_chain[3]), .COUT(low_product_carry[2]));
    CCU2C #(.INIT0(16'h8880), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) low_product_pair_2 (
        .CIN(low_product_carry[2]), .A0(magnitude[6]), .B0(magnitude[1]), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(low_product_chain[4]), .S1(low_product_chain[5]), .COUT(low_product_carry[3]));
    assign low_product = low_product_chain[5:0];
    assign high_product = magnitude[6:3] & {4{magnitude[2]}};
endmodule
