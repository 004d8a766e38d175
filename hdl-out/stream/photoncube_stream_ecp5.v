// SPDX-License-Identifier: MIT
// stream: 9 modules of photoncube_stream.v, made of an ECP5's own cells.
// Written by photoncube 0.2.0, `photoncube generate --machine stream`; do not edit.
//
// Each replaces the module of that name in photoncube_stream.v and is the same function, which
// scripts/yosys/ecp5.sh proves. With both files as they are a name is declared twice. Yosys:
// read_verilog photoncube_stream.v; read_verilog -overwrite photoncube_stream_ecp5.v. Elsewhere
// leave the modules below out of photoncube_stream.v; the cells (CCU2C, LUT4, ...) are those of
// Lattice's library.
//
//   photoncube_stream_accumulate_2
//   photoncube_stream_gated_sum_2
//   photoncube_stream_range_of_query
//   photoncube_stream_subtract
//   photoncube_stream_accumulate
//   photoncube_stream_gated_sum
//   photoncube_stream_square_sum
//   photoncube_stream_magnitude_of
//   photoncube_stream_digit_products

module photoncube_stream_accumulate_2(group, sum, first, next_sum);
    input wire [2:0] group;
    input wire [14:0] sum;
    input wire first;
    output wire [14:0] next_sum;
    wire [15:0] chain;
    wire [8:0] carry;
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
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(sum[6]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[7]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(sum[8]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[9]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_5 (
        .CIN(carry[5]), .A0(sum[10]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[11]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[10]), .S1(chain[11]), .COUT(carry[6]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_6 (
        .CIN(carry[6]), .A0(sum[12]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[13]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[12]), .S1(chain[13]), .COUT(carry[7]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_7 (
        .CIN(carry[7]), .A0(sum[14]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[14]), .S1(chain[15]), .COUT(carry[8]));
    assign next_sum = chain[14:0];
endmodule

module photoncube_stream_gated_sum_2(a, b, a_in_range, b_in_range, sum);
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

module photoncube_stream_range_of_query(distance, far, largest, in_range);
    input wire [17:0] distance;
    input wire far;
    input wire [15:0] largest;
    output wire in_range;
    wire [17:0] chain;
    wire [9:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h000b), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(largest[0]), .B0(distance[0]), .C0(1'b1), .D0(1'b1),
        .A1(largest[1]), .B1(distance[1]), .C1(1'b1), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(largest[2]), .B0(distance[2]), .C0(1'b1), .D0(1'b1),
        .A1(largest[3]), .B1(distance[3]), .C1(1'b1), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(largest[4]), .B0(distance[4]), .C0(1'b1), .D0(1'b1),
        .A1(largest[5]), .B1(distance[5]), .C1(1'b1), .D1(1'b1),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(largest[6]), .B0(distance[6]), .C0(1'b1), .D0(1'b1),
        .A1(largest[7]), .B1(distance[7]), .C1(1'b1), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(largest[8]), .B0(distance[8]), .C0(1'b1), .D0(1'b1),
        .A1(largest[9]), .B1(distance[9]), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_5 (
        .CIN(carry[5]), .A0(largest[10]), .B0(distance[10]), .C0(1'b1), .D0(1'b1),
        .A1(largest[11]), .B1(distance[11]), .C1(1'b1), .D1(1'b1),
        .S0(chain[10]), .S1(chain[11]), .COUT(carry[6]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_6 (
        .CIN(carry[6]), .A0(largest[12]), .B0(distance[12]), .C0(1'b1), .D0(1'b1),
        .A1(largest[13]), .B1(distance[13]), .C1(1'b1), .D1(1'b1),
        .S0(chain[12]), .S1(chain[13]), .COUT(carry[7]));
    CCU2C #(.INIT0(16'h9992), .INIT1(16'h9992), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_7 (
        .CIN(carry[7]), .A0(largest[14]), .B0(distance[14]), .C0(1'b1), .D0(1'b1),
        .A1(largest[15]), .B1(distance[15]), .C1(1'b1), .D1(1'b1),
        .S0(chain[14]), .S1(chain[15]), .COUT(carry[8]));
    CCU2C #(.INIT0(16'h0100), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_8 (
        .CIN(carry[8]), .A0(distance[16]), .B0(distance[17]), .C0(far), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[16]), .S1(chain[17]), .COUT(carry[9]));
    assign in_range = chain[17];
endmodule

module photoncube_stream_subtract(a, b, difference);
    input wire [9:0] a;
    input wire [9:0] b;
    output wire [10:0] difference;
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
    CCU2C #(.INIT0(16'h9992), .INIT1(16'hfff0), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_5 (
        .CIN(carry[5]), .A0(a[9]), .B0(b[9]), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[10]), .S1(chain[11]), .COUT(carry[6]));
    assign difference = chain[11:1];
endmodule

module photoncube_stream_accumulate(group, sum, first, next_sum);
    input wire [9:0] group;
    input wire [21:0] sum;
    input wire first;
    output wire [21:0] next_sum;
    wire [21:0] chain;
    wire [11:0] carry;
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
    CCU2C #(.INIT0(16'hd2d2), .INIT1(16'hd2d2), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(sum[8]), .B0(first), .C0(group[8]), .D0(1'b1),
        .A1(sum[9]), .B1(first), .C1(group[9]), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_5 (
        .CIN(carry[5]), .A0(sum[10]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[11]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[10]), .S1(chain[11]), .COUT(carry[6]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_6 (
        .CIN(carry[6]), .A0(sum[12]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[13]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[12]), .S1(chain[13]), .COUT(carry[7]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_7 (
        .CIN(carry[7]), .A0(sum[14]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[15]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[14]), .S1(chain[15]), .COUT(carry[8]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_8 (
        .CIN(carry[8]), .A0(sum[16]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[17]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[16]), .S1(chain[17]), .COUT(carry[9]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_9 (
        .CIN(carry[9]), .A0(sum[18]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[19]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[18]), .S1(chain[19]), .COUT(carry[10]));
    CCU2C #(.INIT0(16'h2220), .INIT1(16'h2220), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_10 (
        .CIN(carry[10]), .A0(sum[20]), .B0(first), .C0(1'b1), .D0(1'b1),
        .A1(sum[21]), .B1(first), .C1(1'b1), .D1(1'b1),
        .S0(chain[20]), .S1(chain[21]), .COUT(carry[11]));
    assign next_sum = chain[21:0];
endmodule

module photoncube_stream_gated_sum(a, b, a_in_range, b_in_range, sum);
    input wire [7:0] a;
    input wire [7:0] b;
    input wire a_in_range;
    input wire b_in_range;
    output wire [8:0] sum;
    wire [9:0] chain;
    wire [5:0] carry;
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
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(a[6]), .B0(a_in_range), .C0(b[6]), .D0(b_in_range),
        .A1(a[7]), .B1(a_in_range), .C1(b[7]), .D1(b_in_range),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'h0000), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(1'b1), .B0(1'b1), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    assign sum = chain[8:0];
endmodule

module photoncube_stream_square_sum(magnitude, cross_product, square);
    input wire [7:0] magnitude;
    input wire [7:0] cross_product;
    output wire [15:0] square;
    wire table_0 = (magnitude[0]);
    wire table_1 = 1'b0;
    wire table_2 = (~magnitude[0] & magnitude[1]);
    wire table_3 = (magnitude[0] & magnitude[1] & ~magnitude[2]) | (magnitude[0] & ~magnitude[1] & magnitude[2]);
    wire table_4 = (~magnitude[0] & ~magnitude[1] & magnitude[2] & ~magnitude[3]) | (magnitude[0] & ~magnitude[1] & magnitude[2] & ~magnitude[3]) | (magnitude[0] & magnitude[1] & magnitude[2] & ~magnitude[3]) | (magnitude[0] & ~magnitude[1] & ~magnitude[2] & magnitude[3]) | (magnitude[0] & magnitude[1] & ~magnitude[2] & magnitude[3]) | (~magnitude[0] & ~magnitude[1] & magnitude[2] & magnitude[3]);
    wire table_5 = (~magnitude[0] & magnitude[1] & magnitude[2] & ~magnitude[3]) | (magnitude[0] & magnitude[1] & magnitude[2] & ~magnitude[3]) | (~magnitude[0] & magnitude[1] & ~magnitude[2] & magnitude[3]) | (magnitude[0] & magnitude[1] & ~magnitude[2] & magnitude[3]) | (magnitude[0] & ~magnitude[1] & magnitude[2] & magnitude[3]) | (magnitude[0] & magnitude[1] & magnitude[2] & magnitude[3]);
    wire table_6 = (~magnitude[1] & ~magnitude[2] & magnitude[3]) | (magnitude[1] & ~magnitude[2] & magnitude[3]) | (magnitude[1] & magnitude[2] & magnitude[3]);
    wire table_7 = (magnitude[2] & magnitude[3]);
    wire table_8 = (magnitude[4]);
    wire table_9 = 1'b0;
    wire table_10 = (~magnitude[4] & magnitude[5]);
    wire table_11 = (magnitude[4] & magnitude[5] & ~magnitude[6]) | (magnitude[4] & ~magnitude[5] & magnitude[6]);
    wire table_12 = (~magnitude[4] & ~magnitude[5] & magnitude[6] & ~magnitude[7]) | (magnitude[4] & ~magnitude[5] & magnitude[6] & ~magnitude[7]) | (magnitude[4] & magnitude[5] & magnitude[6] & ~magnitude[7]) | (magnitude[4] & ~magnitude[5] & ~magnitude[6] & magnitude[7]) | (magnitude[4] & magnitude[5] & ~magnitude[6] & magnitude[7]) | (~magnitude[4] & ~magnitude[5] & magnitude[6] & magnitude[7]);
    wire table_13 = (~magnitude[4] & magnitude[5] & magnitude[6] & ~magnitude[7]) | (magnitude[4] & magnitude[5] & magnitude[6] & ~magnitude[7]) | (~magnitude[4] & magnitude[5] & ~magnitude[6] & magnitude[7]) | (magnitude[4] & magnitude[5] & ~magnitude[6] & magnitude[7]) | (magnitude[4] & ~magnitude[5] & magnitude[6] & magnitude[7]) | (magnitude[4] & magnitude[5] & magnitude[6] & magnitude[7]);
    wire table_14 = (~magnitude[5] & ~magnitude[6] & magnitude[7]) | (magnitude[5] & ~magnitude[6] & magnitude[7]) | (magnitude[5] & magnitude[6] & magnitude[7]);
    wire table_15 = (magnitude[6] & magnitude[7]);
    wire [11:0] chain;
    wire [6:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h666a), .INIT1(16'h5a9a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(cross_product[0]), .B0(table_5), .C0(1'b1), .D0(1'b1),
        .A1(cross_product[1]), .B1(magnitude[2]), .C1(magnitude[3]), .D1(magnitude[1]),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'h6a6a), .INIT1(16'h666a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(cross_product[2]), .B0(magnitude[2]), .C0(magnitude[3]), .D0(1'b1),
        .A1(cross_product[3]), .B1(magnitude[4]), .C1(1'b1), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'haaaa), .INIT1(16'h9a9a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(cross_product[4]), .B0(1'b1), .C0(1'b1), .D0(1'b1),
        .A1(cross_product[5]), .B1(magnitude[4]), .C1(magnitude[5]), .D1(1'b1),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h96aa), .INIT1(16'h666a), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(cross_product[6]), .B0(magnitude[6]), .C0(magnitude[5]), .D0(magnitude[4]),
        .A1(cross_product[7]), .B1(table_12), .C1(1'b1), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'he860), .INIT1(16'hc4c0), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(magnitude[6]), .B0(magnitude[7]), .C0(magnitude[5]), .D0(magnitude[4]),
        .A1(magnitude[6]), .B1(magnitude[7]), .C1(magnitude[5]), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    CCU2C #(.INIT0(16'h8880), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_5 (
        .CIN(carry[5]), .A0(magnitude[6]), .B0(magnitude[7]), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(chain[10]), .S1(chain[11]), .COUT(carry[6]));
    assign square = {chain[10:0], table_4, table_3, table_2, table_1, table_0};
endmodule

module photoncube_stream_magnitude_of(difference, magnitude);
    input wire [10:0] difference;
    output wire [9:0] magnitude;
    wire [9:0] chain;
    wire [5:0] carry;
    assign carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h0002), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_0 (
        .CIN(carry[0]), .A0(difference[10]), .B0(difference[0]), .C0(1'b1), .D0(1'b1),
        .A1(difference[1]), .B1(difference[10]), .C1(1'b1), .D1(1'b1),
        .S0(chain[0]), .S1(chain[1]), .COUT(carry[1]));
    CCU2C #(.INIT0(16'h6660), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_1 (
        .CIN(carry[1]), .A0(difference[2]), .B0(difference[10]), .C0(1'b1), .D0(1'b1),
        .A1(difference[3]), .B1(difference[10]), .C1(1'b1), .D1(1'b1),
        .S0(chain[2]), .S1(chain[3]), .COUT(carry[2]));
    CCU2C #(.INIT0(16'h6660), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_2 (
        .CIN(carry[2]), .A0(difference[4]), .B0(difference[10]), .C0(1'b1), .D0(1'b1),
        .A1(difference[5]), .B1(difference[10]), .C1(1'b1), .D1(1'b1),
        .S0(chain[4]), .S1(chain[5]), .COUT(carry[3]));
    CCU2C #(.INIT0(16'h6660), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_3 (
        .CIN(carry[3]), .A0(difference[6]), .B0(difference[10]), .C0(1'b1), .D0(1'b1),
        .A1(difference[7]), .B1(difference[10]), .C1(1'b1), .D1(1'b1),
        .S0(chain[6]), .S1(chain[7]), .COUT(carry[4]));
    CCU2C #(.INIT0(16'h6660), .INIT1(16'h6660), .INJECT1_0("NO"), .INJECT1_1("NO")) pair_4 (
        .CIN(carry[4]), .A0(difference[8]), .B0(difference[10]), .C0(1'b1), .D0(1'b1),
        .A1(difference[9]), .B1(difference[10]), .C1(1'b1), .D1(1'b1),
        .S0(chain[8]), .S1(chain[9]), .COUT(carry[5]));
    assign magnitude = {chain[9:1], difference[0]};
endmodule

module photoncube_stream_digit_products(magnitude, low_product, high_product);
    input wire [7:0] magnitude;
    output wire [5:0] low_product;
    output wire [5:0] high_product;
    wire [5:0] low_product_chain;
    wire [3:0] low_product_carry;
    assign low_product_carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h8880), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) low_product_pair_0 (
        .CIN(low_product_carry[0]), .A0(magnitude[4]), .B0(magnitude[0]), .C0(1'b1), .D0(1'b1),
        .A1(magnitude[5]), .B1(magnitude[0]), .C1(magnitude[4]), .D1(magnitude[1]),
        .S0(low_product_chain[0]), .S1(low_product_chain[1]), .COUT(low_product_carry[1]));
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) low_product_pair_1 (
        .CIN(low_product_carry[1]), .A0(magnitude[6]), .B0(magnitude[0]), .C0(magnitude[5]), .D0(magnitude[1]),
        .A1(magnitude[7]), .B1(magnitude[0]), .C1(magnitude[6]), .D1(magnitude[1]),
        .S0(low_product_chain[2]), .S1(low_product_chain[3]), .COUT(low_product_carry[2]));
    CCU2C #(.INIT0(16'h8880), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) low_product_pair_2 (
        .CIN(low_product_carry[2]), .A0(magnitude[7]), .B0(magnitude[1]), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(low_product_chain[4]), .S1(low_product_chain[5]), .COUT(low_product_carry[3]));
    assign low_product = low_product_chain[5:0];
    wire [5:0] high_product_chain;
    wire [3:0] high_product_carry;
    assign high_product_carry[0] = 1'b0;
    CCU2C #(.INIT0(16'h8880), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) high_product_pair_0 (
        .CIN(high_product_carry[0]), .A0(magnitude[4]), .B0(magnitude[2]), .C0(1'b1), .D0(1'b1),
        .A1(magnitude[5]), .B1(magnitude[2]), .C1(magnitude[4]), .D1(magnitude[3]),
        .S0(high_product_chain[0]), .S1(high_product_chain[1]), .COUT(high_product_carry[1]));
    CCU2C #(.INIT0(16'h7888), .INIT1(16'h7888), .INJECT1_0("NO"), .INJECT1_1("NO")) high_product_pair_1 (
        .CIN(high_product_carry[1]), .A0(magnitude[6]), .B0(magnitude[2]), .C0(magnitude[5]), .D0(magnitude[3]),
        .A1(magnitude[7]), .B1(magnitude[2]), .C1(magnitude[6]), .D1(magnitude[3]),
        .S0(high_product_chain[2]), .S1(high_product_chain[3]), .COUT(high_product_carry[2]));
    CCU2C #(.INIT0(16'h8880), .INIT1(16'h0000), .INJECT1_0("NO"), .INJECT1_1("NO")) high_product_pair_2 (
        .CIN(high_product_carry[2]), .A0(magnitude[7]), .B0(magnitude[3]), .C0(1'b1), .D0(1'b1),
        .A1(1'b1), .B1(1'b1), .C1(1'b1), .D1(1'b1),
        .S0(high_product_chain[4]), .S1(high_product_chain[5]), .COUT(high_product_carry[3]));
    assign high_product = high_product_chain[5:0];
endmodule
