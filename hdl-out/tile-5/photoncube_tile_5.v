// SPDX-License-Identifier: MIT
// tile-5: 2 engines in a chain: every photon is read once for 2 queries.
// Written by photoncube 0.2.0, `photoncube generate --machine tile-5`; do not edit.
//
// cells          32
// numbers        photon format local7-rgb6d-n4096, 39 bits a stored photon
// power unit     the photon map's own: its largest power in any channel is the largest word
// frame          4 x 4 x 4 blocks; a block's edge is at least the search radius; a query has its
//                place in the inner 2 x 2 x 2 blocks, so that all photons in range are in the frame
// search radius  fixed, 126 of a block edge's 128 steps: in range where d^2 <= 15876
// most photons   4096 a query
// squarers       digits
// clocks         1 for a group of 4 photons; at least 3 a batch
// latency        14 clocks from a batch's last group to its first result, 2 more to each further
//                one
//
// Ports of photoncube_tile_5; bit 0 is the lowest:
//   input          clock                every register changes at its rising edge
//   input          reset                synchronous, active high; one clock is enough, and what is
//                                       taken in it is lost
//   input          query_valid          a query is on the query_ pins
//   input [8:0]    query_x              unsigned; cell i of 2^-7 block edge, in a frame of 4 block
//                                       edges; stands for the cell's middle
//   input [8:0]    query_y              unsigned; cell i of 2^-7 block edge, in a frame of 4 block
//                                       edges; stands for the cell's middle
//   input [8:0]    query_z              unsigned; cell i of 2^-7 block edge, in a frame of 4 block
//                                       edges; stands for the cell's middle
//   input          group_valid          a group is on the group_ and photon_ pins
//   input          group_last           this group is the last of its batch of queries
//   input          photon_present_0..3  the lane has a photon; where it is 0, the lane's other pins
//                                       are not looked at
//   input [8:0]    photon_x_0..3        unsigned; cell i of 2^-7 block edge, in a frame of 4 block
//                                       edges; stands for the cell's middle
//   input [8:0]    photon_y_0..3        unsigned; cell i of 2^-7 block edge, in a frame of 4 block
//                                       edges; stands for the cell's middle
//   input [8:0]    photon_z_0..3        unsigned; cell i of 2^-7 block edge, in a frame of 4 block
//                                       edges; stands for the cell's middle
//   input [5:0]    photon_red_0..3      unsigned; power units
//   input [5:0]    photon_green_0..3    unsigned; power units
//   input [5:0]    photon_blue_0..3     unsigned; power units
//   input          result_ready         the result is taken at this edge, if it is valid
//   output         query_ready          the query is taken at this edge, if it is valid
//   output         group_ready          the group is taken at this edge, if it is valid
//   output         result_valid         a result is on the result_ pins; it stays until it is taken
//   output [17:0]  result_red           sum of the powers in range, in power units
//   output [17:0]  result_green         sum of the powers in range, in power units
//   output [17:0]  result_blue          sum of the powers in range, in power units
//   output [12:0]  result_count         photons in range
//
// Protocol:
//   - A word is taken at a rising edge with valid and ready. A query may change until it is taken;
//     a group, once valid, must stay as it is until it is taken.
//   - A batch is 2 queries and then groups that all of them meet, of which the last has group_last.
//     It gives 2 results in the order of its queries. A batch of fewer queries waits for ever: fill
//     it with queries whose results are thrown away.
//   - Ready pins: group_ready depends on group_last, and query_ready on group_valid and group_last,
//     in the same clock (a path through the machine from pin to pin); where group_valid is 0,
//     group_ready means nothing.
//   - Reset needs one clock. No ready pin looks at it, so what is taken in that clock is lost; what
//     was under way is forgotten.
//   - No input is checked: with more than 4096 photons for a query, results are undefined.

module photoncube_tile_5(clock, reset, query_valid, query_ready, query_x, query_y,
    query_z, group_valid, group_ready, group_last, photon_present_0, photon_present_1,
    photon_present_2, photon_present_3, photon_x_0, photon_x_1, photon_x_2, photon_x_3,
    photon_y_0, photon_y_1, photon_y_2, photon_y_3, photon_z_0, photon_z_1, photon_z_2,
    photon_z_3, photon_red_0, photon_red_1, photon_red_2, photon_red_3, photon_green_0,
    photon_green_1, photon_green_2, photon_green_3, photon_blue_0, photon_blue_1, photon_blue_2,
    photon_blue_3, result_valid, result_ready, result_red, result_green, result_blue,
    result_count);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire query_valid;
    output reg query_ready;
    input wire [8:0] query_x;
    input wire [8:0] query_y;
    input wire [8:0] query_z;
    input wire group_valid;
    output reg group_ready;
    input wire group_last;
    input wire photon_present_0;
    input wire photon_present_1;
    input wire photon_present_2;
    input wire photon_present_3;
    input wire [8:0] photon_x_0;
    input wire [8:0] photon_x_1;
    input wire [8:0] photon_x_2;
    input wire [8:0] photon_x_3;
    input wire [8:0] photon_y_0;
    input wire [8:0] photon_y_1;
    input wire [8:0] photon_y_2;
    input wire [8:0] photon_y_3;
    input wire [8:0] photon_z_0;
    input wire [8:0] photon_z_1;
    input wire [8:0] photon_z_2;
    input wire [8:0] photon_z_3;
    input wire [5:0] photon_red_0;
    input wire [5:0] photon_red_1;
    input wire [5:0] photon_red_2;
    input wire [5:0] photon_red_3;
    input wire [5:0] photon_green_0;
    input wire [5:0] photon_green_1;
    input wire [5:0] photon_green_2;
    input wire [5:0] photon_green_3;
    input wire [5:0] photon_blue_0;
    input wire [5:0] photon_blue_1;
    input wire [5:0] photon_blue_2;
    input wire [5:0] photon_blue_3;
    output reg result_valid;
    input wire result_ready;
    output reg [17:0] result_red;
    output reg [17:0] result_green;
    output reg [17:0] result_blue;
    output reg [12:0] result_count;
    // Stub signals
    reg entry_token_valid_clock;
    reg entry_token_valid_clear;
    reg entry_token_valid_d;
    wire entry_token_valid_q;
    reg [8:0] entry_token_0_d;
    wire [8:0] entry_token_0_q;
    reg entry_token_0_clock;
    reg [8:0] entry_token_1_d;
    wire [8:0] entry_token_1_q;
    reg entry_token_1_clock;
    reg [8:0] entry_token_2_d;
    wire [8:0] entry_token_2_q;
    reg entry_token_2_clock;
    reg [8:0] entry_photon_0_d;
    wire [8:0] entry_photon_0_q;
    reg entry_photon_0_clock;
    reg [8:0] entry_photon_1_d;
    wire [8:0] entry_photon_1_q;
    reg entry_photon_1_clock;
    reg [8:0] entry_photon_2_d;
    wire [8:0] entry_photon_2_q;
    reg entry_photon_2_clock;
    reg [8:0] entry_photon_3_d;
    wire [8:0] entry_photon_3_q;
    reg entry_photon_3_clock;
    reg [8:0] entry_photon_4_d;
    wire [8:0] entry_photon_4_q;
    reg entry_photon_4_clock;
    reg [8:0] entry_photon_5_d;
    wire [8:0] entry_photon_5_q;
    reg entry_photon_5_clock;
    reg [8:0] entry_photon_6_d;
    wire [8:0] entry_photon_6_q;
    reg entry_photon_6_clock;
    reg [8:0] entry_photon_7_d;
    wire [8:0] entry_photon_7_q;
    reg entry_photon_7_clock;
    reg [8:0] entry_photon_8_d;
    wire [8:0] entry_photon_8_q;
    reg entry_photon_8_clock;
    reg [8:0] entry_photon_9_d;
    wire [8:0] entry_photon_9_q;
    reg entry_photon_9_clock;
    reg [8:0] entry_photon_10_d;
    wire [8:0] entry_photon_10_q;
    reg entry_photon_10_clock;
    reg [8:0] entry_photon_11_d;
    wire [8:0] entry_photon_11_q;
    reg entry_photon_11_clock;
    reg [5:0] entry_mantissa_0_d;
    wire [5:0] entry_mantissa_0_q;
    reg entry_mantissa_0_clock;
    reg [5:0] entry_mantissa_1_d;
    wire [5:0] entry_mantissa_1_q;
    reg entry_mantissa_1_clock;
    reg [5:0] entry_mantissa_2_d;
    wire [5:0] entry_mantissa_2_q;
    reg entry_mantissa_2_clock;
    reg [5:0] entry_mantissa_3_d;
    wire [5:0] entry_mantissa_3_q;
    reg entry_mantissa_3_clock;
    reg [5:0] entry_mantissa_4_d;
    wire [5:0] entry_mantissa_4_q;
    reg entry_mantissa_4_clock;
    reg [5:0] entry_mantissa_5_d;
    wire [5:0] entry_mantissa_5_q;
    reg entry_mantissa_5_clock;
    reg [5:0] entry_mantissa_6_d;
    wire [5:0] entry_mantissa_6_q;
    reg entry_mantissa_6_clock;
    reg [5:0] entry_mantissa_7_d;
    wire [5:0] entry_mantissa_7_q;
    reg entry_mantissa_7_clock;
    reg [5:0] entry_mantissa_8_d;
    wire [5:0] entry_mantissa_8_q;
    reg entry_mantissa_8_clock;
    reg [5:0] entry_mantissa_9_d;
    wire [5:0] entry_mantissa_9_q;
    reg entry_mantissa_9_clock;
    reg [5:0] entry_mantissa_10_d;
    wire [5:0] entry_mantissa_10_q;
    reg entry_mantissa_10_clock;
    reg [5:0] entry_mantissa_11_d;
    wire [5:0] entry_mantissa_11_q;
    reg entry_mantissa_11_clock;
    reg entry_present_0_d;
    wire entry_present_0_q;
    reg entry_present_0_clock;
    reg entry_present_1_d;
    wire entry_present_1_q;
    reg entry_present_1_clock;
    reg entry_present_2_d;
    wire entry_present_2_q;
    reg entry_present_2_clock;
    reg entry_present_3_d;
    wire entry_present_3_q;
    reg entry_present_3_clock;
    reg entry_taken_d;
    wire entry_taken_q;
    reg entry_taken_clock;
    reg entry_first_clock;
    reg entry_first_clear;
    reg entry_first_d;
    wire entry_first_q;
    reg entry_last_clock;
    reg entry_last_clear;
    reg entry_last_d;
    wire entry_last_q;
    reg head_clock;
    reg head_reset;
    reg head_query_valid;
    wire head_query_ready;
    reg head_group_valid;
    reg head_group_last;
    wire head_group_ready;
    wire head_taken;
    wire head_first_taken;
    wire head_last_taken;
    reg [5:0] head_red_0;
    reg [5:0] head_red_1;
    reg [5:0] head_red_2;
    reg [5:0] head_red_3;
    reg [5:0] head_green_0;
    reg [5:0] head_green_1;
    reg [5:0] head_green_2;
    reg [5:0] head_green_3;
    reg [5:0] head_blue_0;
    reg [5:0] head_blue_1;
    reg [5:0] head_blue_2;
    reg [5:0] head_blue_3;
    reg head_present_0;
    reg head_present_1;
    reg head_present_2;
    reg head_present_3;
    reg head_taken_in;
    reg head_first_in;
    reg head_last_in;
    wire head_result_valid;
    wire [17:0] head_result_red;
    wire [17:0] head_result_green;
    wire [17:0] head_result_blue;
    wire [12:0] head_result_count;
    reg head_result_ready;
    wire head_token_valid;
    wire head_is_full;
    wire head_has_room;
    wire [15:0] head_clocks_to_last;
    wire [5:0] head_power_0;
    wire [5:0] head_power_1;
    wire [5:0] head_power_2;
    wire [5:0] head_power_3;
    wire [5:0] head_power_4;
    wire [5:0] head_power_5;
    wire [5:0] head_power_6;
    wire [5:0] head_power_7;
    wire [5:0] head_power_8;
    wire [5:0] head_power_9;
    wire [5:0] head_power_10;
    wire [5:0] head_power_11;
    wire head_power_present_0;
    wire head_power_present_1;
    wire head_power_present_2;
    wire head_power_present_3;
    wire head_first;
    wire head_last;
    reg head_result_valid_in;
    reg [17:0] head_result_in_0;
    reg [17:0] head_result_in_1;
    reg [17:0] head_result_in_2;
    reg [12:0] head_result_count_in;
    reg engine_0_clock;
    reg engine_0_reset_in;
    reg engine_0_token_valid_in;
    reg [8:0] engine_0_token_in_0;
    reg [8:0] engine_0_token_in_1;
    reg [8:0] engine_0_token_in_2;
    reg engine_0_swap_in;
    reg [8:0] engine_0_photon_in_0;
    reg [8:0] engine_0_photon_in_1;
    reg [8:0] engine_0_photon_in_2;
    reg [8:0] engine_0_photon_in_3;
    reg [8:0] engine_0_photon_in_4;
    reg [8:0] engine_0_photon_in_5;
    reg [8:0] engine_0_photon_in_6;
    reg [8:0] engine_0_photon_in_7;
    reg [8:0] engine_0_photon_in_8;
    reg [8:0] engine_0_photon_in_9;
    reg [8:0] engine_0_photon_in_10;
    reg [8:0] engine_0_photon_in_11;
    reg [5:0] engine_0_power_in_0;
    reg [5:0] engine_0_power_in_1;
    reg [5:0] engine_0_power_in_2;
    reg [5:0] engine_0_power_in_3;
    reg [5:0] engine_0_power_in_4;
    reg [5:0] engine_0_power_in_5;
    reg [5:0] engine_0_power_in_6;
    reg [5:0] engine_0_power_in_7;
    reg [5:0] engine_0_power_in_8;
    reg [5:0] engine_0_power_in_9;
    reg [5:0] engine_0_power_in_10;
    reg [5:0] engine_0_power_in_11;
    reg engine_0_present_in_0;
    reg engine_0_present_in_1;
    reg engine_0_present_in_2;
    reg engine_0_present_in_3;
    reg engine_0_first_in;
    reg engine_0_last_in;
    reg engine_0_result_valid_in;
    reg [17:0] engine_0_result_in_0;
    reg [17:0] engine_0_result_in_1;
    reg [17:0] engine_0_result_in_2;
    reg [12:0] engine_0_result_count_in;
    wire engine_0_reset_out;
    wire engine_0_token_valid_out;
    wire [8:0] engine_0_token_out_0;
    wire [8:0] engine_0_token_out_1;
    wire [8:0] engine_0_token_out_2;
    wire engine_0_swap_out;
    wire [8:0] engine_0_photon_out_0;
    wire [8:0] engine_0_photon_out_1;
    wire [8:0] engine_0_photon_out_2;
    wire [8:0] engine_0_photon_out_3;
    wire [8:0] engine_0_photon_out_4;
    wire [8:0] engine_0_photon_out_5;
    wire [8:0] engine_0_photon_out_6;
    wire [8:0] engine_0_photon_out_7;
    wire [8:0] engine_0_photon_out_8;
    wire [8:0] engine_0_photon_out_9;
    wire [8:0] engine_0_photon_out_10;
    wire [8:0] engine_0_photon_out_11;
    wire [5:0] engine_0_power_out_0;
    wire [5:0] engine_0_power_out_1;
    wire [5:0] engine_0_power_out_2;
    wire [5:0] engine_0_power_out_3;
    wire [5:0] engine_0_power_out_4;
    wire [5:0] engine_0_power_out_5;
    wire [5:0] engine_0_power_out_6;
    wire [5:0] engine_0_power_out_7;
    wire [5:0] engine_0_power_out_8;
    wire [5:0] engine_0_power_out_9;
    wire [5:0] engine_0_power_out_10;
    wire [5:0] engine_0_power_out_11;
    wire engine_0_present_out_0;
    wire engine_0_present_out_1;
    wire engine_0_present_out_2;
    wire engine_0_present_out_3;
    wire engine_0_first_out;
    wire engine_0_last_out;
    wire engine_0_result_valid_out;
    wire [17:0] engine_0_result_out_0;
    wire [17:0] engine_0_result_out_1;
    wire [17:0] engine_0_result_out_2;
    wire [12:0] engine_0_result_count_out;
    reg engine_1_clock;
    reg engine_1_reset_in;
    reg engine_1_token_valid_in;
    reg [8:0] engine_1_token_in_0;
    reg [8:0] engine_1_token_in_1;
    reg [8:0] engine_1_token_in_2;
    reg engine_1_swap_in;
    reg [8:0] engine_1_photon_in_0;
    reg [8:0] engine_1_photon_in_1;
    reg [8:0] engine_1_photon_in_2;
    reg [8:0] engine_1_photon_in_3;
    reg [8:0] engine_1_photon_in_4;
    reg [8:0] engine_1_photon_in_5;
    reg [8:0] engine_1_photon_in_6;
    reg [8:0] engine_1_photon_in_7;
    reg [8:0] engine_1_photon_in_8;
    reg [8:0] engine_1_photon_in_9;
    reg [8:0] engine_1_photon_in_10;
    reg [8:0] engine_1_photon_in_11;
    reg [5:0] engine_1_power_in_0;
    reg [5:0] engine_1_power_in_1;
    reg [5:0] engine_1_power_in_2;
    reg [5:0] engine_1_power_in_3;
    reg [5:0] engine_1_power_in_4;
    reg [5:0] engine_1_power_in_5;
    reg [5:0] engine_1_power_in_6;
    reg [5:0] engine_1_power_in_7;
    reg [5:0] engine_1_power_in_8;
    reg [5:0] engine_1_power_in_9;
    reg [5:0] engine_1_power_in_10;
    reg [5:0] engine_1_power_in_11;
    reg engine_1_present_in_0;
    reg engine_1_present_in_1;
    reg engine_1_present_in_2;
    reg engine_1_present_in_3;
    reg engine_1_first_in;
    reg engine_1_last_in;
    reg engine_1_result_valid_in;
    reg [17:0] engine_1_result_in_0;
    reg [17:0] engine_1_result_in_1;
    reg [17:0] engine_1_result_in_2;
    reg [12:0] engine_1_result_count_in;
    wire engine_1_reset_out;
    wire engine_1_token_valid_out;
    wire [8:0] engine_1_token_out_0;
    wire [8:0] engine_1_token_out_1;
    wire [8:0] engine_1_token_out_2;
    wire engine_1_swap_out;
    wire [8:0] engine_1_photon_out_0;
    wire [8:0] engine_1_photon_out_1;
    wire [8:0] engine_1_photon_out_2;
    wire [8:0] engine_1_photon_out_3;
    wire [8:0] engine_1_photon_out_4;
    wire [8:0] engine_1_photon_out_5;
    wire [8:0] engine_1_photon_out_6;
    wire [8:0] engine_1_photon_out_7;
    wire [8:0] engine_1_photon_out_8;
    wire [8:0] engine_1_photon_out_9;
    wire [8:0] engine_1_photon_out_10;
    wire [8:0] engine_1_photon_out_11;
    wire [5:0] engine_1_power_out_0;
    wire [5:0] engine_1_power_out_1;
    wire [5:0] engine_1_power_out_2;
    wire [5:0] engine_1_power_out_3;
    wire [5:0] engine_1_power_out_4;
    wire [5:0] engine_1_power_out_5;
    wire [5:0] engine_1_power_out_6;
    wire [5:0] engine_1_power_out_7;
    wire [5:0] engine_1_power_out_8;
    wire [5:0] engine_1_power_out_9;
    wire [5:0] engine_1_power_out_10;
    wire [5:0] engine_1_power_out_11;
    wire engine_1_present_out_0;
    wire engine_1_present_out_1;
    wire engine_1_present_out_2;
    wire engine_1_present_out_3;
    wire engine_1_first_out;
    wire engine_1_last_out;
    wire engine_1_result_valid_out;
    wire [17:0] engine_1_result_out_0;
    wire [17:0] engine_1_result_out_1;
    wire [17:0] engine_1_result_out_2;
    wire [12:0] engine_1_result_count_out;
    // Sub module instances
    photoncube_tile_5_group_first entry_token_valid(
        .clock(entry_token_valid_clock),
        .clear(entry_token_valid_clear),
        .d(entry_token_valid_d),
        .q(entry_token_valid_q)
    );
    photoncube_tile_5_register_9 entry_token_0(
        .d(entry_token_0_d),
        .q(entry_token_0_q),
        .clock(entry_token_0_clock)
    );
    photoncube_tile_5_register_9 entry_token_1(
        .d(entry_token_1_d),
        .q(entry_token_1_q),
        .clock(entry_token_1_clock)
    );
    photoncube_tile_5_register_9 entry_token_2(
        .d(entry_token_2_d),
        .q(entry_token_2_q),
        .clock(entry_token_2_clock)
    );
    photoncube_tile_5_register_9 entry_photon_0(
        .d(entry_photon_0_d),
        .q(entry_photon_0_q),
        .clock(entry_photon_0_clock)
    );
    photoncube_tile_5_register_9 entry_photon_1(
        .d(entry_photon_1_d),
        .q(entry_photon_1_q),
        .clock(entry_photon_1_clock)
    );
    photoncube_tile_5_register_9 entry_photon_2(
        .d(entry_photon_2_d),
        .q(entry_photon_2_q),
        .clock(entry_photon_2_clock)
    );
    photoncube_tile_5_register_9 entry_photon_3(
        .d(entry_photon_3_d),
        .q(entry_photon_3_q),
        .clock(entry_photon_3_clock)
    );
    photoncube_tile_5_register_9 entry_photon_4(
        .d(entry_photon_4_d),
        .q(entry_photon_4_q),
        .clock(entry_photon_4_clock)
    );
    photoncube_tile_5_register_9 entry_photon_5(
        .d(entry_photon_5_d),
        .q(entry_photon_5_q),
        .clock(entry_photon_5_clock)
    );
    photoncube_tile_5_register_9 entry_photon_6(
        .d(entry_photon_6_d),
        .q(entry_photon_6_q),
        .clock(entry_photon_6_clock)
    );
    photoncube_tile_5_register_9 entry_photon_7(
        .d(entry_photon_7_d),
        .q(entry_photon_7_q),
        .clock(entry_photon_7_clock)
    );
    photoncube_tile_5_register_9 entry_photon_8(
        .d(entry_photon_8_d),
        .q(entry_photon_8_q),
        .clock(entry_photon_8_clock)
    );
    photoncube_tile_5_register_9 entry_photon_9(
        .d(entry_photon_9_d),
        .q(entry_photon_9_q),
        .clock(entry_photon_9_clock)
    );
    photoncube_tile_5_register_9 entry_photon_10(
        .d(entry_photon_10_d),
        .q(entry_photon_10_q),
        .clock(entry_photon_10_clock)
    );
    photoncube_tile_5_register_9 entry_photon_11(
        .d(entry_photon_11_d),
        .q(entry_photon_11_q),
        .clock(entry_photon_11_clock)
    );
    photoncube_tile_5_register_6 entry_mantissa_0(
        .d(entry_mantissa_0_d),
        .q(entry_mantissa_0_q),
        .clock(entry_mantissa_0_clock)
    );
    photoncube_tile_5_register_6 entry_mantissa_1(
        .d(entry_mantissa_1_d),
        .q(entry_mantissa_1_q),
        .clock(entry_mantissa_1_clock)
    );
    photoncube_tile_5_register_6 entry_mantissa_2(
        .d(entry_mantissa_2_d),
        .q(entry_mantissa_2_q),
        .clock(entry_mantissa_2_clock)
    );
    photoncube_tile_5_register_6 entry_mantissa_3(
        .d(entry_mantissa_3_d),
        .q(entry_mantissa_3_q),
        .clock(entry_mantissa_3_clock)
    );
    photoncube_tile_5_register_6 entry_mantissa_4(
        .d(entry_mantissa_4_d),
        .q(entry_mantissa_4_q),
        .clock(entry_mantissa_4_clock)
    );
    photoncube_tile_5_register_6 entry_mantissa_5(
        .d(entry_mantissa_5_d),
        .q(entry_mantissa_5_q),
        .clock(entry_mantissa_5_clock)
    );
    photoncube_tile_5_register_6 entry_mantissa_6(
        .d(entry_mantissa_6_d),
        .q(entry_mantissa_6_q),
        .clock(entry_mantissa_6_clock)
    );
    photoncube_tile_5_register_6 entry_mantissa_7(
        .d(entry_mantissa_7_d),
        .q(entry_mantissa_7_q),
        .clock(entry_mantissa_7_clock)
    );
    photoncube_tile_5_register_6 entry_mantissa_8(
        .d(entry_mantissa_8_d),
        .q(entry_mantissa_8_q),
        .clock(entry_mantissa_8_clock)
    );
    photoncube_tile_5_register_6 entry_mantissa_9(
        .d(entry_mantissa_9_d),
        .q(entry_mantissa_9_q),
        .clock(entry_mantissa_9_clock)
    );
    photoncube_tile_5_register_6 entry_mantissa_10(
        .d(entry_mantissa_10_d),
        .q(entry_mantissa_10_q),
        .clock(entry_mantissa_10_clock)
    );
    photoncube_tile_5_register_6 entry_mantissa_11(
        .d(entry_mantissa_11_d),
        .q(entry_mantissa_11_q),
        .clock(entry_mantissa_11_clock)
    );
    photoncube_tile_5_register_1 entry_present_0(
        .d(entry_present_0_d),
        .q(entry_present_0_q),
        .clock(entry_present_0_clock)
    );
    photoncube_tile_5_register_1 entry_present_1(
        .d(entry_present_1_d),
        .q(entry_present_1_q),
        .clock(entry_present_1_clock)
    );
    photoncube_tile_5_register_1 entry_present_2(
        .d(entry_present_2_d),
        .q(entry_present_2_q),
        .clock(entry_present_2_clock)
    );
    photoncube_tile_5_register_1 entry_present_3(
        .d(entry_present_3_d),
        .q(entry_present_3_q),
        .clock(entry_present_3_clock)
    );
    photoncube_tile_5_register_1 entry_taken(
        .d(entry_taken_d),
        .q(entry_taken_q),
        .clock(entry_taken_clock)
    );
    photoncube_tile_5_group_first entry_first(
        .clock(entry_first_clock),
        .clear(entry_first_clear),
        .d(entry_first_d),
        .q(entry_first_q)
    );
    photoncube_tile_5_group_first entry_last(
        .clock(entry_last_clock),
        .clear(entry_last_clear),
        .d(entry_last_d),
        .q(entry_last_q)
    );
    photoncube_tile_5_head head(
        .clock(head_clock),
        .reset(head_reset),
        .query_valid(head_query_valid),
        .query_ready(head_query_ready),
        .group_valid(head_group_valid),
        .group_last(head_group_last),
        .group_ready(head_group_ready),
        .taken(head_taken),
        .first_taken(head_first_taken),
        .last_taken(head_last_taken),
        .red_0(head_red_0),
        .red_1(head_red_1),
        .red_2(head_red_2),
        .red_3(head_red_3),
        .green_0(head_green_0),
        .green_1(head_green_1),
        .green_2(head_green_2),
        .green_3(head_green_3),
        .blue_0(head_blue_0),
        .blue_1(head_blue_1),
        .blue_2(head_blue_2),
        .blue_3(head_blue_3),
        .present_0(head_present_0),
        .present_1(head_present_1),
        .present_2(head_present_2),
        .present_3(head_present_3),
        .taken_in(head_taken_in),
        .first_in(head_first_in),
        .last_in(head_last_in),
        .result_valid(head_result_valid),
        .result_red(head_result_red),
        .result_green(head_result_green),
        .result_blue(head_result_blue),
        .result_count(head_result_count),
        .result_ready(head_result_ready),
        .token_valid(head_token_valid),
        .is_full(head_is_full),
        .has_room(head_has_room),
        .clocks_to_last(head_clocks_to_last),
        .power_0(head_power_0),
        .power_1(head_power_1),
        .power_2(head_power_2),
        .power_3(head_power_3),
        .power_4(head_power_4),
        .power_5(head_power_5),
        .power_6(head_power_6),
        .power_7(head_power_7),
        .power_8(head_power_8),
        .power_9(head_power_9),
        .power_10(head_power_10),
        .power_11(head_power_11),
        .power_present_0(head_power_present_0),
        .power_present_1(head_power_present_1),
        .power_present_2(head_power_present_2),
        .power_present_3(head_power_present_3),
        .first(head_first),
        .last(head_last),
        .result_valid_in(head_result_valid_in),
        .result_in_0(head_result_in_0),
        .result_in_1(head_result_in_1),
        .result_in_2(head_result_in_2),
        .result_count_in(head_result_count_in)
    );
    photoncube_tile_5_engine engine_0(
        .clock(engine_0_clock),
        .reset_in(engine_0_reset_in),
        .token_valid_in(engine_0_token_valid_in),
        .token_in_0(engine_0_token_in_0),
        .token_in_1(engine_0_token_in_1),
        .token_in_2(engine_0_token_in_2),
        .swap_in(engine_0_swap_in),
        .photon_in_0(engine_0_photon_in_0),
        .photon_in_1(engine_0_photon_in_1),
        .photon_in_2(engine_0_photon_in_2),
        .photon_in_3(engine_0_photon_in_3),
        .photon_in_4(engine_0_photon_in_4),
        .photon_in_5(engine_0_photon_in_5),
        .photon_in_6(engine_0_photon_in_6),
        .photon_in_7(engine_0_photon_in_7),
        .photon_in_8(engine_0_photon_in_8),
        .photon_in_9(engine_0_photon_in_9),
        .photon_in_10(engine_0_photon_in_10),
        .photon_in_11(engine_0_photon_in_11),
        .power_in_0(engine_0_power_in_0),
        .power_in_1(engine_0_power_in_1),
        .power_in_2(engine_0_power_in_2),
        .power_in_3(engine_0_power_in_3),
        .power_in_4(engine_0_power_in_4),
        .power_in_5(engine_0_power_in_5),
        .power_in_6(engine_0_power_in_6),
        .power_in_7(engine_0_power_in_7),
        .power_in_8(engine_0_power_in_8),
        .power_in_9(engine_0_power_in_9),
        .power_in_10(engine_0_power_in_10),
        .power_in_11(engine_0_power_in_11),
        .present_in_0(engine_0_present_in_0),
        .present_in_1(engine_0_present_in_1),
        .present_in_2(engine_0_present_in_2),
        .present_in_3(engine_0_present_in_3),
        .first_in(engine_0_first_in),
        .last_in(engine_0_last_in),
        .result_valid_in(engine_0_result_valid_in),
        .result_in_0(engine_0_result_in_0),
        .result_in_1(engine_0_result_in_1),
        .result_in_2(engine_0_result_in_2),
        .result_count_in(engine_0_result_count_in),
        .reset_out(engine_0_reset_out),
        .token_valid_out(engine_0_token_valid_out),
        .token_out_0(engine_0_token_out_0),
        .token_out_1(engine_0_token_out_1),
        .token_out_2(engine_0_token_out_2),
        .swap_out(engine_0_swap_out),
        .photon_out_0(engine_0_photon_out_0),
        .photon_out_1(engine_0_photon_out_1),
        .photon_out_2(engine_0_photon_out_2),
        .photon_out_3(engine_0_photon_out_3),
        .photon_out_4(engine_0_photon_out_4),
        .photon_out_5(engine_0_photon_out_5),
        .photon_out_6(engine_0_photon_out_6),
        .photon_out_7(engine_0_photon_out_7),
        .photon_out_8(engine_0_photon_out_8),
        .photon_out_9(engine_0_photon_out_9),
        .photon_out_10(engine_0_photon_out_10),
        .photon_out_11(engine_0_photon_out_11),
        .power_out_0(engine_0_power_out_0),
        .power_out_1(engine_0_power_out_1),
        .power_out_2(engine_0_power_out_2),
        .power_out_3(engine_0_power_out_3),
        .power_out_4(engine_0_power_out_4),
        .power_out_5(engine_0_power_out_5),
        .power_out_6(engine_0_power_out_6),
        .power_out_7(engine_0_power_out_7),
        .power_out_8(engine_0_power_out_8),
        .power_out_9(engine_0_power_out_9),
        .power_out_10(engine_0_power_out_10),
        .power_out_11(engine_0_power_out_11),
        .present_out_0(engine_0_present_out_0),
        .present_out_1(engine_0_present_out_1),
        .present_out_2(engine_0_present_out_2),
        .present_out_3(engine_0_present_out_3),
        .first_out(engine_0_first_out),
        .last_out(engine_0_last_out),
        .result_valid_out(engine_0_result_valid_out),
        .result_out_0(engine_0_result_out_0),
        .result_out_1(engine_0_result_out_1),
        .result_out_2(engine_0_result_out_2),
        .result_count_out(engine_0_result_count_out)
    );
    photoncube_tile_5_engine engine_1(
        .clock(engine_1_clock),
        .reset_in(engine_1_reset_in),
        .token_valid_in(engine_1_token_valid_in),
        .token_in_0(engine_1_token_in_0),
        .token_in_1(engine_1_token_in_1),
        .token_in_2(engine_1_token_in_2),
        .swap_in(engine_1_swap_in),
        .photon_in_0(engine_1_photon_in_0),
        .photon_in_1(engine_1_photon_in_1),
        .photon_in_2(engine_1_photon_in_2),
        .photon_in_3(engine_1_photon_in_3),
        .photon_in_4(engine_1_photon_in_4),
        .photon_in_5(engine_1_photon_in_5),
        .photon_in_6(engine_1_photon_in_6),
        .photon_in_7(engine_1_photon_in_7),
        .photon_in_8(engine_1_photon_in_8),
        .photon_in_9(engine_1_photon_in_9),
        .photon_in_10(engine_1_photon_in_10),
        .photon_in_11(engine_1_photon_in_11),
        .power_in_0(engine_1_power_in_0),
        .power_in_1(engine_1_power_in_1),
        .power_in_2(engine_1_power_in_2),
        .power_in_3(engine_1_power_in_3),
        .power_in_4(engine_1_power_in_4),
        .power_in_5(engine_1_power_in_5),
        .power_in_6(engine_1_power_in_6),
        .power_in_7(engine_1_power_in_7),
        .power_in_8(engine_1_power_in_8),
        .power_in_9(engine_1_power_in_9),
        .power_in_10(engine_1_power_in_10),
        .power_in_11(engine_1_power_in_11),
        .present_in_0(engine_1_present_in_0),
        .present_in_1(engine_1_present_in_1),
        .present_in_2(engine_1_present_in_2),
        .present_in_3(engine_1_present_in_3),
        .first_in(engine_1_first_in),
        .last_in(engine_1_last_in),
        .result_valid_in(engine_1_result_valid_in),
        .result_in_0(engine_1_result_in_0),
        .result_in_1(engine_1_result_in_1),
        .result_in_2(engine_1_result_in_2),
        .result_count_in(engine_1_result_count_in),
        .reset_out(engine_1_reset_out),
        .token_valid_out(engine_1_token_valid_out),
        .token_out_0(engine_1_token_out_0),
        .token_out_1(engine_1_token_out_1),
        .token_out_2(engine_1_token_out_2),
        .swap_out(engine_1_swap_out),
        .photon_out_0(engine_1_photon_out_0),
        .photon_out_1(engine_1_photon_out_1),
        .photon_out_2(engine_1_photon_out_2),
        .photon_out_3(engine_1_photon_out_3),
        .photon_out_4(engine_1_photon_out_4),
        .photon_out_5(engine_1_photon_out_5),
        .photon_out_6(engine_1_photon_out_6),
        .photon_out_7(engine_1_photon_out_7),
        .photon_out_8(engine_1_photon_out_8),
        .photon_out_9(engine_1_photon_out_9),
        .photon_out_10(engine_1_photon_out_10),
        .photon_out_11(engine_1_photon_out_11),
        .power_out_0(engine_1_power_out_0),
        .power_out_1(engine_1_power_out_1),
        .power_out_2(engine_1_power_out_2),
        .power_out_3(engine_1_power_out_3),
        .power_out_4(engine_1_power_out_4),
        .power_out_5(engine_1_power_out_5),
        .power_out_6(engine_1_power_out_6),
        .power_out_7(engine_1_power_out_7),
        .power_out_8(engine_1_power_out_8),
        .power_out_9(engine_1_power_out_9),
        .power_out_10(engine_1_power_out_10),
        .power_out_11(engine_1_power_out_11),
        .present_out_0(engine_1_present_out_0),
        .present_out_1(engine_1_present_out_1),
        .present_out_2(engine_1_present_out_2),
        .present_out_3(engine_1_present_out_3),
        .first_out(engine_1_first_out),
        .last_out(engine_1_last_out),
        .result_valid_out(engine_1_result_valid_out),
        .result_out_0(engine_1_result_out_0),
        .result_out_1(engine_1_result_out_1),
        .result_out_2(engine_1_result_out_2),
        .result_count_out(engine_1_result_count_out)
    );
    // Update code
    always @(*) begin
        head_clock = clock;
        head_reset = reset;
        head_query_valid = query_valid;
        query_ready = head_query_ready;
        head_result_ready = result_ready;
        result_valid = head_result_valid;
        result_count = head_result_count;
        head_result_valid_in = engine_0_result_valid_out;
        head_result_count_in = engine_0_result_count_out;
        head_result_in_0 = engine_0_result_out_0;
        result_red = head_result_red;
        head_result_in_1 = engine_0_result_out_1;
        result_green = head_result_green;
        head_result_in_2 = engine_0_result_out_2;
        result_blue = head_result_blue;
        head_group_valid = group_valid;
        head_group_last = group_last;
        group_ready = head_group_ready;
        entry_present_0_d = photon_present_0;
        entry_photon_0_d = photon_x_0;
        entry_photon_1_d = photon_y_0;
        entry_photon_2_d = photon_z_0;
        entry_present_1_d = photon_present_1;
        entry_photon_3_d = photon_x_1;
        entry_photon_4_d = photon_y_1;
        entry_photon_5_d = photon_z_1;
        entry_present_2_d = photon_present_2;
        entry_photon_6_d = photon_x_2;
        entry_photon_7_d = photon_y_2;
        entry_photon_8_d = photon_z_2;
        entry_present_3_d = photon_present_3;
        entry_photon_9_d = photon_x_3;
        entry_photon_10_d = photon_y_3;
        entry_photon_11_d = photon_z_3;
        entry_mantissa_0_d = photon_red_0;
        entry_mantissa_1_d = photon_red_1;
        entry_mantissa_2_d = photon_red_2;
        entry_mantissa_3_d = photon_red_3;
        entry_mantissa_4_d = photon_green_0;
        entry_mantissa_5_d = photon_green_1;
        entry_mantissa_6_d = photon_green_2;
        entry_mantissa_7_d = photon_green_3;
        entry_mantissa_8_d = photon_blue_0;
        entry_mantissa_9_d = photon_blue_1;
        entry_mantissa_10_d = photon_blue_2;
        entry_mantissa_11_d = photon_blue_3;
        entry_token_valid_clock = clock;
        entry_token_valid_clear = reset;
        entry_token_valid_d = head_token_valid;
        entry_token_0_d = query_x;
        entry_token_1_d = query_y;
        entry_token_2_d = query_z;
        entry_first_clock = clock;
        entry_first_clear = reset;
        entry_first_d = head_first_taken;
        entry_last_clock = clock;
        entry_last_clear = reset;
        entry_last_d = head_last_taken;
        entry_taken_clock = clock;
        entry_taken_d = head_taken;
        head_taken_in = entry_taken_q;
        head_first_in = entry_first_q;
        head_last_in = entry_last_q;
        entry_token_0_clock = clock;
        entry_token_1_clock = clock;
        entry_token_2_clock = clock;
        entry_photon_0_clock = clock;
        entry_photon_1_clock = clock;
        entry_photon_2_clock = clock;
        entry_photon_3_clock = clock;
        entry_photon_4_clock = clock;
        entry_photon_5_clock = clock;
        entry_photon_6_clock = clock;
        entry_photon_7_clock = clock;
        entry_photon_8_clock = clock;
        entry_photon_9_clock = clock;
        entry_photon_10_clock = clock;
        entry_photon_11_clock = clock;
        entry_mantissa_0_clock = clock;
        head_red_0 = entry_mantissa_0_q;
        entry_mantissa_1_clock = clock;
        head_red_1 = entry_mantissa_1_q;
        entry_mantissa_2_clock = clock;
        head_red_2 = entry_mantissa_2_q;
        entry_mantissa_3_clock = clock;
        head_red_3 = entry_mantissa_3_q;
        entry_mantissa_4_clock = clock;
        head_green_0 = entry_mantissa_4_q;
        entry_mantissa_5_clock = clock;
        head_green_1 = entry_mantissa_5_q;
        entry_mantissa_6_clock = clock;
        head_green_2 = entry_mantissa_6_q;
        entry_mantissa_7_clock = clock;
        head_green_3 = entry_mantissa_7_q;
        entry_mantissa_8_clock = clock;
        head_blue_0 = entry_mantissa_8_q;
        entry_mantissa_9_clock = clock;
        head_blue_1 = entry_mantissa_9_q;
        entry_mantissa_10_clock = clock;
        head_blue_2 = entry_mantissa_10_q;
        entry_mantissa_11_clock = clock;
        head_blue_3 = entry_mantissa_11_q;
        entry_present_0_clock = clock;
        head_present_0 = entry_present_0_q;
        entry_present_1_clock = clock;
        head_present_1 = entry_present_1_q;
        entry_present_2_clock = clock;
        head_present_2 = entry_present_2_q;
        entry_present_3_clock = clock;
        head_present_3 = entry_present_3_q;
        engine_0_clock = clock;
        engine_0_reset_in = reset;
        engine_0_token_valid_in = entry_token_valid_q;
        engine_0_swap_in = entry_first_q;
        engine_0_first_in = head_first;
        engine_0_last_in = head_last;
        engine_0_token_in_0 = entry_token_0_q;
        engine_0_token_in_1 = entry_token_1_q;
        engine_0_token_in_2 = entry_token_2_q;
        engine_0_photon_in_0 = entry_photon_0_q;
        engine_0_photon_in_1 = entry_photon_1_q;
        engine_0_photon_in_2 = entry_photon_2_q;
        engine_0_photon_in_3 = entry_photon_3_q;
        engine_0_photon_in_4 = entry_photon_4_q;
        engine_0_photon_in_5 = entry_photon_5_q;
        engine_0_photon_in_6 = entry_photon_6_q;
        engine_0_photon_in_7 = entry_photon_7_q;
        engine_0_photon_in_8 = entry_photon_8_q;
        engine_0_photon_in_9 = entry_photon_9_q;
        engine_0_photon_in_10 = entry_photon_10_q;
        engine_0_photon_in_11 = entry_photon_11_q;
        engine_0_present_in_0 = head_power_present_0;
        engine_0_present_in_1 = head_power_present_1;
        engine_0_present_in_2 = head_power_present_2;
        engine_0_present_in_3 = head_power_present_3;
        engine_0_power_in_0 = head_power_0;
        engine_0_power_in_1 = head_power_1;
        engine_0_power_in_2 = head_power_2;
        engine_0_power_in_3 = head_power_3;
        engine_0_power_in_4 = head_power_4;
        engine_0_power_in_5 = head_power_5;
        engine_0_power_in_6 = head_power_6;
        engine_0_power_in_7 = head_power_7;
        engine_0_power_in_8 = head_power_8;
        engine_0_power_in_9 = head_power_9;
        engine_0_power_in_10 = head_power_10;
        engine_0_power_in_11 = head_power_11;
        engine_1_clock = clock;
        engine_1_reset_in = engine_0_reset_out;
        engine_1_token_valid_in = engine_0_token_valid_out;
        engine_1_swap_in = engine_0_swap_out;
        engine_1_first_in = engine_0_first_out;
        engine_1_last_in = engine_0_last_out;
        engine_0_result_valid_in = engine_1_result_valid_out;
        engine_0_result_count_in = engine_1_result_count_out;
        engine_1_token_in_0 = engine_0_token_out_0;
        engine_1_token_in_1 = engine_0_token_out_1;
        engine_1_token_in_2 = engine_0_token_out_2;
        engine_1_photon_in_0 = engine_0_photon_out_0;
        engine_1_photon_in_1 = engine_0_photon_out_1;
        engine_1_photon_in_2 = engine_0_photon_out_2;
        engine_1_photon_in_3 = engine_0_photon_out_3;
        engine_1_photon_in_4 = engine_0_photon_out_4;
        engine_1_photon_in_5 = engine_0_photon_out_5;
        engine_1_photon_in_6 = engine_0_photon_out_6;
        engine_1_photon_in_7 = engine_0_photon_out_7;
        engine_1_photon_in_8 = engine_0_photon_out_8;
        engine_1_photon_in_9 = engine_0_photon_out_9;
        engine_1_photon_in_10 = engine_0_photon_out_10;
        engine_1_photon_in_11 = engine_0_photon_out_11;
        engine_1_power_in_0 = engine_0_power_out_0;
        engine_1_power_in_1 = engine_0_power_out_1;
        engine_1_power_in_2 = engine_0_power_out_2;
        engine_1_power_in_3 = engine_0_power_out_3;
        engine_1_power_in_4 = engine_0_power_out_4;
        engine_1_power_in_5 = engine_0_power_out_5;
        engine_1_power_in_6 = engine_0_power_out_6;
        engine_1_power_in_7 = engine_0_power_out_7;
        engine_1_power_in_8 = engine_0_power_out_8;
        engine_1_power_in_9 = engine_0_power_out_9;
        engine_1_power_in_10 = engine_0_power_out_10;
        engine_1_power_in_11 = engine_0_power_out_11;
        engine_1_present_in_0 = engine_0_present_out_0;
        engine_1_present_in_1 = engine_0_present_out_1;
        engine_1_present_in_2 = engine_0_present_out_2;
        engine_1_present_in_3 = engine_0_present_out_3;
        engine_0_result_in_0 = engine_1_result_out_0;
        engine_0_result_in_1 = engine_1_result_out_1;
        engine_0_result_in_2 = engine_1_result_out_2;
        engine_1_result_valid_in = 1'b0;
        engine_1_result_count_in = 13'b0;
        engine_1_result_in_0 = 18'b0;
        engine_1_result_in_1 = 18'b0;
        engine_1_result_in_2 = 18'b0;
    end
endmodule

module photoncube_tile_5_head(clock, reset, query_valid, query_ready, group_valid,
    group_last, group_ready, taken, first_taken, last_taken, red_0, red_1, red_2, red_3, green_0,
    green_1, green_2, green_3, blue_0, blue_1, blue_2, blue_3, present_0, present_1, present_2,
    present_3, taken_in, first_in, last_in, result_valid, result_red, result_green, result_blue,
    result_count, result_ready, token_valid, is_full, has_room, clocks_to_last, power_0, power_1,
    power_2, power_3, power_4, power_5, power_6, power_7, power_8, power_9, power_10, power_11,
    power_present_0, power_present_1, power_present_2, power_present_3, first, last,
    result_valid_in, result_in_0, result_in_1, result_in_2, result_count_in);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire query_valid;
    output reg query_ready;
    input wire group_valid;
    input wire group_last;
    output reg group_ready;
    output reg taken;
    output reg first_taken;
    output reg last_taken;
    input wire [5:0] red_0;
    input wire [5:0] red_1;
    input wire [5:0] red_2;
    input wire [5:0] red_3;
    input wire [5:0] green_0;
    input wire [5:0] green_1;
    input wire [5:0] green_2;
    input wire [5:0] green_3;
    input wire [5:0] blue_0;
    input wire [5:0] blue_1;
    input wire [5:0] blue_2;
    input wire [5:0] blue_3;
    input wire present_0;
    input wire present_1;
    input wire present_2;
    input wire present_3;
    input wire taken_in;
    input wire first_in;
    input wire last_in;
    output reg result_valid;
    output reg [17:0] result_red;
    output reg [17:0] result_green;
    output reg [17:0] result_blue;
    output reg [12:0] result_count;
    input wire result_ready;
    output reg token_valid;
    output reg is_full;
    output reg has_room;
    output reg [15:0] clocks_to_last;
    output reg [5:0] power_0;
    output reg [5:0] power_1;
    output reg [5:0] power_2;
    output reg [5:0] power_3;
    output reg [5:0] power_4;
    output reg [5:0] power_5;
    output reg [5:0] power_6;
    output reg [5:0] power_7;
    output reg [5:0] power_8;
    output reg [5:0] power_9;
    output reg [5:0] power_10;
    output reg [5:0] power_11;
    output reg power_present_0;
    output reg power_present_1;
    output reg power_present_2;
    output reg power_present_3;
    output reg first;
    output reg last;
    input wire result_valid_in;
    input wire [17:0] result_in_0;
    input wire [17:0] result_in_1;
    input wire [17:0] result_in_2;
    input wire [12:0] result_count_in;
    // Stub signals
    reg admission_clock;
    reg admission_reset;
    reg admission_query_valid;
    reg admission_group_valid;
    reg admission_group_last;
    reg admission_batch_read;
    wire admission_query_ready;
    wire admission_group_ready;
    wire admission_taken;
    wire admission_first_taken;
    wire admission_last_taken;
    wire admission_token_valid;
    wire admission_is_full;
    wire admission_has_room;
    wire [15:0] admission_clocks_to_last;
    reg [5:0] power_decoder_0_mantissa;
    wire [5:0] power_decoder_0_power;
    reg [5:0] power_decoder_1_mantissa;
    wire [5:0] power_decoder_1_power;
    reg [5:0] power_decoder_2_mantissa;
    wire [5:0] power_decoder_2_power;
    reg [5:0] power_decoder_3_mantissa;
    wire [5:0] power_decoder_3_power;
    reg [5:0] power_decoder_4_mantissa;
    wire [5:0] power_decoder_4_power;
    reg [5:0] power_decoder_5_mantissa;
    wire [5:0] power_decoder_5_power;
    reg [5:0] power_decoder_6_mantissa;
    wire [5:0] power_decoder_6_power;
    reg [5:0] power_decoder_7_mantissa;
    wire [5:0] power_decoder_7_power;
    reg [5:0] power_decoder_8_mantissa;
    wire [5:0] power_decoder_8_power;
    reg [5:0] power_decoder_9_mantissa;
    wire [5:0] power_decoder_9_power;
    reg [5:0] power_decoder_10_mantissa;
    wire [5:0] power_decoder_10_power;
    reg [5:0] power_decoder_11_mantissa;
    wire [5:0] power_decoder_11_power;
    reg [5:0] decoded_0_d;
    wire [5:0] decoded_0_q;
    reg decoded_0_clock;
    reg [5:0] decoded_1_d;
    wire [5:0] decoded_1_q;
    reg decoded_1_clock;
    reg [5:0] decoded_2_d;
    wire [5:0] decoded_2_q;
    reg decoded_2_clock;
    reg [5:0] decoded_3_d;
    wire [5:0] decoded_3_q;
    reg decoded_3_clock;
    reg [5:0] decoded_4_d;
    wire [5:0] decoded_4_q;
    reg decoded_4_clock;
    reg [5:0] decoded_5_d;
    wire [5:0] decoded_5_q;
    reg decoded_5_clock;
    reg [5:0] decoded_6_d;
    wire [5:0] decoded_6_q;
    reg decoded_6_clock;
    reg [5:0] decoded_7_d;
    wire [5:0] decoded_7_q;
    reg decoded_7_clock;
    reg [5:0] decoded_8_d;
    wire [5:0] decoded_8_q;
    reg decoded_8_clock;
    reg [5:0] decoded_9_d;
    wire [5:0] decoded_9_q;
    reg decoded_9_clock;
    reg [5:0] decoded_10_d;
    wire [5:0] decoded_10_q;
    reg decoded_10_clock;
    reg [5:0] decoded_11_d;
    wire [5:0] decoded_11_q;
    reg decoded_11_clock;
    reg presence_0_clock;
    reg presence_0_taken;
    reg presence_0_photon_present;
    wire presence_0_present;
    wire presence_0_absent;
    reg presence_1_clock;
    reg presence_1_taken;
    reg presence_1_photon_present;
    wire presence_1_present;
    wire presence_1_absent;
    reg presence_2_clock;
    reg presence_2_taken;
    reg presence_2_photon_present;
    wire presence_2_present;
    wire presence_2_absent;
    reg presence_3_clock;
    reg presence_3_taken;
    reg presence_3_photon_present;
    wire presence_3_present;
    wire presence_3_absent;
    reg power_of_present_0_absent;
    reg [5:0] power_of_present_0_word;
    wire [5:0] power_of_present_0_power;
    reg power_of_present_1_absent;
    reg [5:0] power_of_present_1_word;
    wire [5:0] power_of_present_1_power;
    reg power_of_present_2_absent;
    reg [5:0] power_of_present_2_word;
    wire [5:0] power_of_present_2_power;
    reg power_of_present_3_absent;
    reg [5:0] power_of_present_3_word;
    wire [5:0] power_of_present_3_power;
    reg power_of_present_4_absent;
    reg [5:0] power_of_present_4_word;
    wire [5:0] power_of_present_4_power;
    reg power_of_present_5_absent;
    reg [5:0] power_of_present_5_word;
    wire [5:0] power_of_present_5_power;
    reg power_of_present_6_absent;
    reg [5:0] power_of_present_6_word;
    wire [5:0] power_of_present_6_power;
    reg power_of_present_7_absent;
    reg [5:0] power_of_present_7_word;
    wire [5:0] power_of_present_7_power;
    reg power_of_present_8_absent;
    reg [5:0] power_of_present_8_word;
    wire [5:0] power_of_present_8_power;
    reg power_of_present_9_absent;
    reg [5:0] power_of_present_9_word;
    wire [5:0] power_of_present_9_power;
    reg power_of_present_10_absent;
    reg [5:0] power_of_present_10_word;
    wire [5:0] power_of_present_10_power;
    reg power_of_present_11_absent;
    reg [5:0] power_of_present_11_word;
    wire [5:0] power_of_present_11_power;
    reg power_delay_0_clock;
    reg [5:0] power_delay_0_word;
    wire [5:0] power_delay_0_delayed;
    reg power_delay_1_clock;
    reg [5:0] power_delay_1_word;
    wire [5:0] power_delay_1_delayed;
    reg power_delay_2_clock;
    reg [5:0] power_delay_2_word;
    wire [5:0] power_delay_2_delayed;
    reg power_delay_3_clock;
    reg [5:0] power_delay_3_word;
    wire [5:0] power_delay_3_delayed;
    reg power_delay_4_clock;
    reg [5:0] power_delay_4_word;
    wire [5:0] power_delay_4_delayed;
    reg power_delay_5_clock;
    reg [5:0] power_delay_5_word;
    wire [5:0] power_delay_5_delayed;
    reg power_delay_6_clock;
    reg [5:0] power_delay_6_word;
    wire [5:0] power_delay_6_delayed;
    reg power_delay_7_clock;
    reg [5:0] power_delay_7_word;
    wire [5:0] power_delay_7_delayed;
    reg power_delay_8_clock;
    reg [5:0] power_delay_8_word;
    wire [5:0] power_delay_8_delayed;
    reg power_delay_9_clock;
    reg [5:0] power_delay_9_word;
    wire [5:0] power_delay_9_delayed;
    reg power_delay_10_clock;
    reg [5:0] power_delay_10_word;
    wire [5:0] power_delay_10_delayed;
    reg power_delay_11_clock;
    reg [5:0] power_delay_11_word;
    wire [5:0] power_delay_11_delayed;
    reg present_delay_0_clock;
    reg present_delay_0_word;
    wire present_delay_0_delayed;
    reg present_delay_1_clock;
    reg present_delay_1_word;
    wire present_delay_1_delayed;
    reg present_delay_2_clock;
    reg present_delay_2_word;
    wire present_delay_2_delayed;
    reg present_delay_3_clock;
    reg present_delay_3_word;
    wire present_delay_3_delayed;
    reg first_delay_clock;
    reg first_delay_clear;
    reg first_delay_flag;
    wire first_delay_delayed;
    reg last_delay_clock;
    reg last_delay_clear;
    reg last_delay_flag;
    wire last_delay_delayed;
    reg queue_clock;
    reg queue_reset;
    reg queue_result_valid_in;
    reg [17:0] queue_result_in_0;
    reg [17:0] queue_result_in_1;
    reg [17:0] queue_result_in_2;
    reg [12:0] queue_result_count_in;
    reg queue_result_ready;
    wire queue_result_valid;
    wire [17:0] queue_result_red;
    wire [17:0] queue_result_green;
    wire [17:0] queue_result_blue;
    wire [12:0] queue_result_count;
    wire queue_batch_read;
    // Sub module instances
    photoncube_tile_5_admission admission(
        .clock(admission_clock),
        .reset(admission_reset),
        .query_valid(admission_query_valid),
        .group_valid(admission_group_valid),
        .group_last(admission_group_last),
        .batch_read(admission_batch_read),
        .query_ready(admission_query_ready),
        .group_ready(admission_group_ready),
        .taken(admission_taken),
        .first_taken(admission_first_taken),
        .last_taken(admission_last_taken),
        .token_valid(admission_token_valid),
        .is_full(admission_is_full),
        .has_room(admission_has_room),
        .clocks_to_last(admission_clocks_to_last)
    );
    photoncube_tile_5_power_decoder power_decoder_0(
        .mantissa(power_decoder_0_mantissa),
        .power(power_decoder_0_power)
    );
    photoncube_tile_5_power_decoder power_decoder_1(
        .mantissa(power_decoder_1_mantissa),
        .power(power_decoder_1_power)
    );
    photoncube_tile_5_power_decoder power_decoder_2(
        .mantissa(power_decoder_2_mantissa),
        .power(power_decoder_2_power)
    );
    photoncube_tile_5_power_decoder power_decoder_3(
        .mantissa(power_decoder_3_mantissa),
        .power(power_decoder_3_power)
    );
    photoncube_tile_5_power_decoder power_decoder_4(
        .mantissa(power_decoder_4_mantissa),
        .power(power_decoder_4_power)
    );
    photoncube_tile_5_power_decoder power_decoder_5(
        .mantissa(power_decoder_5_mantissa),
        .power(power_decoder_5_power)
    );
    photoncube_tile_5_power_decoder power_decoder_6(
        .mantissa(power_decoder_6_mantissa),
        .power(power_decoder_6_power)
    );
    photoncube_tile_5_power_decoder power_decoder_7(
        .mantissa(power_decoder_7_mantissa),
        .power(power_decoder_7_power)
    );
    photoncube_tile_5_power_decoder power_decoder_8(
        .mantissa(power_decoder_8_mantissa),
        .power(power_decoder_8_power)
    );
    photoncube_tile_5_power_decoder power_decoder_9(
        .mantissa(power_decoder_9_mantissa),
        .power(power_decoder_9_power)
    );
    photoncube_tile_5_power_decoder power_decoder_10(
        .mantissa(power_decoder_10_mantissa),
        .power(power_decoder_10_power)
    );
    photoncube_tile_5_power_decoder power_decoder_11(
        .mantissa(power_decoder_11_mantissa),
        .power(power_decoder_11_power)
    );
    photoncube_tile_5_register_6 decoded_0(
        .d(decoded_0_d),
        .q(decoded_0_q),
        .clock(decoded_0_clock)
    );
    photoncube_tile_5_register_6 decoded_1(
        .d(decoded_1_d),
        .q(decoded_1_q),
        .clock(decoded_1_clock)
    );
    photoncube_tile_5_register_6 decoded_2(
        .d(decoded_2_d),
        .q(decoded_2_q),
        .clock(decoded_2_clock)
    );
    photoncube_tile_5_register_6 decoded_3(
        .d(decoded_3_d),
        .q(decoded_3_q),
        .clock(decoded_3_clock)
    );
    photoncube_tile_5_register_6 decoded_4(
        .d(decoded_4_d),
        .q(decoded_4_q),
        .clock(decoded_4_clock)
    );
    photoncube_tile_5_register_6 decoded_5(
        .d(decoded_5_d),
        .q(decoded_5_q),
        .clock(decoded_5_clock)
    );
    photoncube_tile_5_register_6 decoded_6(
        .d(decoded_6_d),
        .q(decoded_6_q),
        .clock(decoded_6_clock)
    );
    photoncube_tile_5_register_6 decoded_7(
        .d(decoded_7_d),
        .q(decoded_7_q),
        .clock(decoded_7_clock)
    );
    photoncube_tile_5_register_6 decoded_8(
        .d(decoded_8_d),
        .q(decoded_8_q),
        .clock(decoded_8_clock)
    );
    photoncube_tile_5_register_6 decoded_9(
        .d(decoded_9_d),
        .q(decoded_9_q),
        .clock(decoded_9_clock)
    );
    photoncube_tile_5_register_6 decoded_10(
        .d(decoded_10_d),
        .q(decoded_10_q),
        .clock(decoded_10_clock)
    );
    photoncube_tile_5_register_6 decoded_11(
        .d(decoded_11_d),
        .q(decoded_11_q),
        .clock(decoded_11_clock)
    );
    photoncube_tile_5_presence presence_0(
        .clock(presence_0_clock),
        .taken(presence_0_taken),
        .photon_present(presence_0_photon_present),
        .present(presence_0_present),
        .absent(presence_0_absent)
    );
    photoncube_tile_5_presence presence_1(
        .clock(presence_1_clock),
        .taken(presence_1_taken),
        .photon_present(presence_1_photon_present),
        .present(presence_1_present),
        .absent(presence_1_absent)
    );
    photoncube_tile_5_presence presence_2(
        .clock(presence_2_clock),
        .taken(presence_2_taken),
        .photon_present(presence_2_photon_present),
        .present(presence_2_present),
        .absent(presence_2_absent)
    );
    photoncube_tile_5_presence presence_3(
        .clock(presence_3_clock),
        .taken(presence_3_taken),
        .photon_present(presence_3_photon_present),
        .present(presence_3_present),
        .absent(presence_3_absent)
    );
    photoncube_tile_5_power_of_present power_of_present_0(
        .absent(power_of_present_0_absent),
        .word(power_of_present_0_word),
        .power(power_of_present_0_power)
    );
    photoncube_tile_5_power_of_present power_of_present_1(
        .absent(power_of_present_1_absent),
        .word(power_of_present_1_word),
        .power(power_of_present_1_power)
    );
    photoncube_tile_5_power_of_present power_of_present_2(
        .absent(power_of_present_2_absent),
        .word(power_of_present_2_word),
        .power(power_of_present_2_power)
    );
    photoncube_tile_5_power_of_present power_of_present_3(
        .absent(power_of_present_3_absent),
        .word(power_of_present_3_word),
        .power(power_of_present_3_power)
    );
    photoncube_tile_5_power_of_present power_of_present_4(
        .absent(power_of_present_4_absent),
        .word(power_of_present_4_word),
        .power(power_of_present_4_power)
    );
    photoncube_tile_5_power_of_present power_of_present_5(
        .absent(power_of_present_5_absent),
        .word(power_of_present_5_word),
        .power(power_of_present_5_power)
    );
    photoncube_tile_5_power_of_present power_of_present_6(
        .absent(power_of_present_6_absent),
        .word(power_of_present_6_word),
        .power(power_of_present_6_power)
    );
    photoncube_tile_5_power_of_present power_of_present_7(
        .absent(power_of_present_7_absent),
        .word(power_of_present_7_word),
        .power(power_of_present_7_power)
    );
    photoncube_tile_5_power_of_present power_of_present_8(
        .absent(power_of_present_8_absent),
        .word(power_of_present_8_word),
        .power(power_of_present_8_power)
    );
    photoncube_tile_5_power_of_present power_of_present_9(
        .absent(power_of_present_9_absent),
        .word(power_of_present_9_word),
        .power(power_of_present_9_power)
    );
    photoncube_tile_5_power_of_present power_of_present_10(
        .absent(power_of_present_10_absent),
        .word(power_of_present_10_word),
        .power(power_of_present_10_power)
    );
    photoncube_tile_5_power_of_present power_of_present_11(
        .absent(power_of_present_11_absent),
        .word(power_of_present_11_word),
        .power(power_of_present_11_power)
    );
    photoncube_tile_5_power_delay power_delay_0(
        .clock(power_delay_0_clock),
        .word(power_delay_0_word),
        .delayed(power_delay_0_delayed)
    );
    photoncube_tile_5_power_delay power_delay_1(
        .clock(power_delay_1_clock),
        .word(power_delay_1_word),
        .delayed(power_delay_1_delayed)
    );
    photoncube_tile_5_power_delay power_delay_2(
        .clock(power_delay_2_clock),
        .word(power_delay_2_word),
        .delayed(power_delay_2_delayed)
    );
    photoncube_tile_5_power_delay power_delay_3(
        .clock(power_delay_3_clock),
        .word(power_delay_3_word),
        .delayed(power_delay_3_delayed)
    );
    photoncube_tile_5_power_delay power_delay_4(
        .clock(power_delay_4_clock),
        .word(power_delay_4_word),
        .delayed(power_delay_4_delayed)
    );
    photoncube_tile_5_power_delay power_delay_5(
        .clock(power_delay_5_clock),
        .word(power_delay_5_word),
        .delayed(power_delay_5_delayed)
    );
    photoncube_tile_5_power_delay power_delay_6(
        .clock(power_delay_6_clock),
        .word(power_delay_6_word),
        .delayed(power_delay_6_delayed)
    );
    photoncube_tile_5_power_delay power_delay_7(
        .clock(power_delay_7_clock),
        .word(power_delay_7_word),
        .delayed(power_delay_7_delayed)
    );
    photoncube_tile_5_power_delay power_delay_8(
        .clock(power_delay_8_clock),
        .word(power_delay_8_word),
        .delayed(power_delay_8_delayed)
    );
    photoncube_tile_5_power_delay power_delay_9(
        .clock(power_delay_9_clock),
        .word(power_delay_9_word),
        .delayed(power_delay_9_delayed)
    );
    photoncube_tile_5_power_delay power_delay_10(
        .clock(power_delay_10_clock),
        .word(power_delay_10_word),
        .delayed(power_delay_10_delayed)
    );
    photoncube_tile_5_power_delay power_delay_11(
        .clock(power_delay_11_clock),
        .word(power_delay_11_word),
        .delayed(power_delay_11_delayed)
    );
    photoncube_tile_5_present_delay present_delay_0(
        .clock(present_delay_0_clock),
        .word(present_delay_0_word),
        .delayed(present_delay_0_delayed)
    );
    photoncube_tile_5_present_delay present_delay_1(
        .clock(present_delay_1_clock),
        .word(present_delay_1_word),
        .delayed(present_delay_1_delayed)
    );
    photoncube_tile_5_present_delay present_delay_2(
        .clock(present_delay_2_clock),
        .word(present_delay_2_word),
        .delayed(present_delay_2_delayed)
    );
    photoncube_tile_5_present_delay present_delay_3(
        .clock(present_delay_3_clock),
        .word(present_delay_3_word),
        .delayed(present_delay_3_delayed)
    );
    photoncube_tile_5_first_delay first_delay(
        .clock(first_delay_clock),
        .clear(first_delay_clear),
        .flag(first_delay_flag),
        .delayed(first_delay_delayed)
    );
    photoncube_tile_5_first_delay last_delay(
        .clock(last_delay_clock),
        .clear(last_delay_clear),
        .flag(last_delay_flag),
        .delayed(last_delay_delayed)
    );
    photoncube_tile_5_queue queue(
        .clock(queue_clock),
        .reset(queue_reset),
        .result_valid_in(queue_result_valid_in),
        .result_in_0(queue_result_in_0),
        .result_in_1(queue_result_in_1),
        .result_in_2(queue_result_in_2),
        .result_count_in(queue_result_count_in),
        .result_ready(queue_result_ready),
        .result_valid(queue_result_valid),
        .result_red(queue_result_red),
        .result_green(queue_result_green),
        .result_blue(queue_result_blue),
        .result_count(queue_result_count),
        .batch_read(queue_batch_read)
    );
    // Update code
    always @(*) begin
        admission_clock = clock;
        admission_reset = reset;
        admission_query_valid = query_valid;
        admission_group_valid = group_valid;
        admission_group_last = group_last;
        admission_batch_read = queue_batch_read;
        query_ready = admission_query_ready;
        group_ready = admission_group_ready;
        token_valid = admission_token_valid;
        taken = admission_taken;
        first_taken = admission_first_taken;
        last_taken = admission_last_taken;
        is_full = admission_is_full;
        has_room = admission_has_room;
        clocks_to_last = admission_clocks_to_last;
        queue_clock = clock;
        queue_reset = reset;
        queue_result_ready = result_ready;
        queue_result_valid_in = result_valid_in;
        queue_result_count_in = result_count_in;
        result_valid = queue_result_valid;
        result_count = queue_result_count;
        queue_result_in_0 = result_in_0;
        result_red = queue_result_red;
        queue_result_in_1 = result_in_1;
        result_green = queue_result_green;
        queue_result_in_2 = result_in_2;
        result_blue = queue_result_blue;
        presence_0_clock = clock;
        presence_0_photon_present = present_0;
        presence_0_taken = taken_in;
        present_delay_0_clock = clock;
        present_delay_0_word = presence_0_present;
        power_present_0 = present_delay_0_delayed;
        power_decoder_0_mantissa = red_0;
        decoded_0_clock = clock;
        decoded_0_d = power_decoder_0_power;
        power_of_present_0_absent = presence_0_absent;
        power_of_present_0_word = decoded_0_q;
        power_delay_0_clock = clock;
        power_delay_0_word = power_of_present_0_power;
        power_0 = power_delay_0_delayed;
        power_decoder_1_mantissa = green_0;
        decoded_1_clock = clock;
        decoded_1_d = power_decoder_1_power;
        power_of_present_1_absent = presence_0_absent;
        power_of_present_1_word = decoded_1_q;
        power_delay_1_clock = clock;
        power_delay_1_word = power_of_present_1_power;
        power_1 = power_delay_1_delayed;
        power_decoder_2_mantissa = blue_0;
        decoded_2_clock = clock;
        decoded_2_d = power_decoder_2_power;
        power_of_present_2_absent = presence_0_absent;
        power_of_present_2_word = decoded_2_q;
        power_delay_2_clock = clock;
        power_delay_2_word = power_of_present_2_power;
        power_2 = power_delay_2_delayed;
        presence_1_clock = clock;
        presence_1_photon_present = present_1;
        presence_1_taken = taken_in;
        present_delay_1_clock = clock;
        present_delay_1_word = presence_1_present;
        power_present_1 = present_delay_1_delayed;
        power_decoder_3_mantissa = red_1;
        decoded_3_clock = clock;
        decoded_3_d = power_decoder_3_power;
        power_of_present_3_absent = presence_1_absent;
        power_of_present_3_word = decoded_3_q;
        power_delay_3_clock = clock;
        power_delay_3_word = power_of_present_3_power;
        power_3 = power_delay_3_delayed;
        power_decoder_4_mantissa = green_1;
        decoded_4_clock = clock;
        decoded_4_d = power_decoder_4_power;
        power_of_present_4_absent = presence_1_absent;
        power_of_present_4_word = decoded_4_q;
        power_delay_4_clock = clock;
        power_delay_4_word = power_of_present_4_power;
        power_4 = power_delay_4_delayed;
        power_decoder_5_mantissa = blue_1;
        decoded_5_clock = clock;
        decoded_5_d = power_decoder_5_power;
        power_of_present_5_absent = presence_1_absent;
        power_of_present_5_word = decoded_5_q;
        power_delay_5_clock = clock;
        power_delay_5_word = power_of_present_5_power;
        power_5 = power_delay_5_delayed;
        presence_2_clock = clock;
        presence_2_photon_present = present_2;
        presence_2_taken = taken_in;
        present_delay_2_clock = clock;
        present_delay_2_word = presence_2_present;
        power_present_2 = present_delay_2_delayed;
        power_decoder_6_mantissa = red_2;
        decoded_6_clock = clock;
        decoded_6_d = power_decoder_6_power;
        power_of_present_6_absent = presence_2_absent;
        power_of_present_6_word = decoded_6_q;
        power_delay_6_clock = clock;
        power_delay_6_word = power_of_present_6_power;
        power_6 = power_delay_6_delayed;
        power_decoder_7_mantissa = green_2;
        decoded_7_clock = clock;
        decoded_7_d = power_decoder_7_power;
        power_of_present_7_absent = presence_2_absent;
        power_of_present_7_word = decoded_7_q;
        power_delay_7_clock = clock;
        power_delay_7_word = power_of_present_7_power;
        power_7 = power_delay_7_delayed;
        power_decoder_8_mantissa = blue_2;
        decoded_8_clock = clock;
        decoded_8_d = power_decoder_8_power;
        power_of_present_8_absent = presence_2_absent;
        power_of_present_8_word = decoded_8_q;
        power_delay_8_clock = clock;
        power_delay_8_word = power_of_present_8_power;
        power_8 = power_delay_8_delayed;
        presence_3_clock = clock;
        presence_3_photon_present = present_3;
        presence_3_taken = taken_in;
        present_delay_3_clock = clock;
        present_delay_3_word = presence_3_present;
        power_present_3 = present_delay_3_delayed;
        power_decoder_9_mantissa = red_3;
        decoded_9_clock = clock;
        decoded_9_d = power_decoder_9_power;
        power_of_present_9_absent = presence_3_absent;
        power_of_present_9_word = decoded_9_q;
        power_delay_9_clock = clock;
        power_delay_9_word = power_of_present_9_power;
        power_9 = power_delay_9_delayed;
        power_decoder_10_mantissa = green_3;
        decoded_10_clock = clock;
        decoded_10_d = power_decoder_10_power;
        power_of_present_10_absent = presence_3_absent;
        power_of_present_10_word = decoded_10_q;
        power_delay_10_clock = clock;
        power_delay_10_word = power_of_present_10_power;
        power_10 = power_delay_10_delayed;
        power_decoder_11_mantissa = blue_3;
        decoded_11_clock = clock;
        decoded_11_d = power_decoder_11_power;
        power_of_present_11_absent = presence_3_absent;
        power_of_present_11_word = decoded_11_q;
        power_delay_11_clock = clock;
        power_delay_11_word = power_of_present_11_power;
        power_11 = power_delay_11_delayed;
        first_delay_clock = clock;
        first_delay_clear = reset;
        first_delay_flag = first_in;
        first = first_delay_delayed;
        last_delay_clock = clock;
        last_delay_clear = reset;
        last_delay_flag = last_in;
        last = last_delay_delayed;
    end
endmodule

module photoncube_tile_5_engine(clock, reset_in, token_valid_in, token_in_0, token_in_1,
    token_in_2, swap_in, photon_in_0, photon_in_1, photon_in_2, photon_in_3, photon_in_4,
    photon_in_5, photon_in_6, photon_in_7, photon_in_8, photon_in_9, photon_in_10, photon_in_11,
    power_in_0, power_in_1, power_in_2, power_in_3, power_in_4, power_in_5, power_in_6,
    power_in_7, power_in_8, power_in_9, power_in_10, power_in_11, present_in_0, present_in_1,
    present_in_2, present_in_3, first_in, last_in, result_valid_in, result_in_0, result_in_1,
    result_in_2, result_count_in, reset_out, token_valid_out, token_out_0, token_out_1,
    token_out_2, swap_out, photon_out_0, photon_out_1, photon_out_2, photon_out_3, photon_out_4,
    photon_out_5, photon_out_6, photon_out_7, photon_out_8, photon_out_9, photon_out_10,
    photon_out_11, power_out_0, power_out_1, power_out_2, power_out_3, power_out_4, power_out_5,
    power_out_6, power_out_7, power_out_8, power_out_9, power_out_10, power_out_11,
    present_out_0, present_out_1, present_out_2, present_out_3, first_out, last_out,
    result_valid_out, result_out_0, result_out_1, result_out_2, result_count_out);
    // Module arguments
    input wire clock;
    input wire reset_in;
    input wire token_valid_in;
    input wire [8:0] token_in_0;
    input wire [8:0] token_in_1;
    input wire [8:0] token_in_2;
    input wire swap_in;
    input wire [8:0] photon_in_0;
    input wire [8:0] photon_in_1;
    input wire [8:0] photon_in_2;
    input wire [8:0] photon_in_3;
    input wire [8:0] photon_in_4;
    input wire [8:0] photon_in_5;
    input wire [8:0] photon_in_6;
    input wire [8:0] photon_in_7;
    input wire [8:0] photon_in_8;
    input wire [8:0] photon_in_9;
    input wire [8:0] photon_in_10;
    input wire [8:0] photon_in_11;
    input wire [5:0] power_in_0;
    input wire [5:0] power_in_1;
    input wire [5:0] power_in_2;
    input wire [5:0] power_in_3;
    input wire [5:0] power_in_4;
    input wire [5:0] power_in_5;
    input wire [5:0] power_in_6;
    input wire [5:0] power_in_7;
    input wire [5:0] power_in_8;
    input wire [5:0] power_in_9;
    input wire [5:0] power_in_10;
    input wire [5:0] power_in_11;
    input wire present_in_0;
    input wire present_in_1;
    input wire present_in_2;
    input wire present_in_3;
    input wire first_in;
    input wire last_in;
    input wire result_valid_in;
    input wire [17:0] result_in_0;
    input wire [17:0] result_in_1;
    input wire [17:0] result_in_2;
    input wire [12:0] result_count_in;
    output reg reset_out;
    output reg token_valid_out;
    output reg [8:0] token_out_0;
    output reg [8:0] token_out_1;
    output reg [8:0] token_out_2;
    output reg swap_out;
    output reg [8:0] photon_out_0;
    output reg [8:0] photon_out_1;
    output reg [8:0] photon_out_2;
    output reg [8:0] photon_out_3;
    output reg [8:0] photon_out_4;
    output reg [8:0] photon_out_5;
    output reg [8:0] photon_out_6;
    output reg [8:0] photon_out_7;
    output reg [8:0] photon_out_8;
    output reg [8:0] photon_out_9;
    output reg [8:0] photon_out_10;
    output reg [8:0] photon_out_11;
    output reg [5:0] power_out_0;
    output reg [5:0] power_out_1;
    output reg [5:0] power_out_2;
    output reg [5:0] power_out_3;
    output reg [5:0] power_out_4;
    output reg [5:0] power_out_5;
    output reg [5:0] power_out_6;
    output reg [5:0] power_out_7;
    output reg [5:0] power_out_8;
    output reg [5:0] power_out_9;
    output reg [5:0] power_out_10;
    output reg [5:0] power_out_11;
    output reg present_out_0;
    output reg present_out_1;
    output reg present_out_2;
    output reg present_out_3;
    output reg first_out;
    output reg last_out;
    output reg result_valid_out;
    output reg [17:0] result_out_0;
    output reg [17:0] result_out_1;
    output reg [17:0] result_out_2;
    output reg [12:0] result_count_out;
    // Stub signals
    reg query_flags_clock;
    reg query_flags_reset_in;
    reg query_flags_token_valid_in;
    reg query_flags_swap_in;
    wire query_flags_keeps;
    wire query_flags_reset_out;
    wire query_flags_token_valid_out;
    wire query_flags_swap_out;
    reg query_0_clock;
    reg [8:0] query_0_token_in;
    reg query_0_keeps;
    reg query_0_swap_in;
    wire [8:0] query_0_token_out;
    wire [8:0] query_0_query_out;
    reg query_1_clock;
    reg [8:0] query_1_token_in;
    reg query_1_keeps;
    reg query_1_swap_in;
    wire [8:0] query_1_token_out;
    wire [8:0] query_1_query_out;
    reg query_2_clock;
    reg [8:0] query_2_token_in;
    reg query_2_keeps;
    reg query_2_swap_in;
    wire [8:0] query_2_token_out;
    wire [8:0] query_2_query_out;
    reg [8:0] photon_0_d;
    wire [8:0] photon_0_q;
    reg photon_0_clock;
    reg [8:0] photon_1_d;
    wire [8:0] photon_1_q;
    reg photon_1_clock;
    reg [8:0] photon_2_d;
    wire [8:0] photon_2_q;
    reg photon_2_clock;
    reg [8:0] photon_3_d;
    wire [8:0] photon_3_q;
    reg photon_3_clock;
    reg [8:0] photon_4_d;
    wire [8:0] photon_4_q;
    reg photon_4_clock;
    reg [8:0] photon_5_d;
    wire [8:0] photon_5_q;
    reg photon_5_clock;
    reg [8:0] photon_6_d;
    wire [8:0] photon_6_q;
    reg photon_6_clock;
    reg [8:0] photon_7_d;
    wire [8:0] photon_7_q;
    reg photon_7_clock;
    reg [8:0] photon_8_d;
    wire [8:0] photon_8_q;
    reg photon_8_clock;
    reg [8:0] photon_9_d;
    wire [8:0] photon_9_q;
    reg photon_9_clock;
    reg [8:0] photon_10_d;
    wire [8:0] photon_10_q;
    reg photon_10_clock;
    reg [8:0] photon_11_d;
    wire [8:0] photon_11_q;
    reg photon_11_clock;
    reg square_pair_0_clock;
    reg [8:0] square_pair_0_query;
    reg [8:0] square_pair_0_photon_a;
    reg [8:0] square_pair_0_photon_b;
    wire [13:0] square_pair_0_square_a;
    wire [13:0] square_pair_0_square_b;
    wire square_pair_0_far_a;
    wire square_pair_0_far_b;
    reg square_pair_1_clock;
    reg [8:0] square_pair_1_query;
    reg [8:0] square_pair_1_photon_a;
    reg [8:0] square_pair_1_photon_b;
    wire [13:0] square_pair_1_square_a;
    wire [13:0] square_pair_1_square_b;
    wire square_pair_1_far_a;
    wire square_pair_1_far_b;
    reg square_pair_2_clock;
    reg [8:0] square_pair_2_query;
    reg [8:0] square_pair_2_photon_a;
    reg [8:0] square_pair_2_photon_b;
    wire [13:0] square_pair_2_square_a;
    wire [13:0] square_pair_2_square_b;
    wire square_pair_2_far_a;
    wire square_pair_2_far_b;
    reg square_pair_3_clock;
    reg [8:0] square_pair_3_query;
    reg [8:0] square_pair_3_photon_a;
    reg [8:0] square_pair_3_photon_b;
    wire [13:0] square_pair_3_square_a;
    wire [13:0] square_pair_3_square_b;
    wire square_pair_3_far_a;
    wire square_pair_3_far_b;
    reg square_pair_4_clock;
    reg [8:0] square_pair_4_query;
    reg [8:0] square_pair_4_photon_a;
    reg [8:0] square_pair_4_photon_b;
    wire [13:0] square_pair_4_square_a;
    wire [13:0] square_pair_4_square_b;
    wire square_pair_4_far_a;
    wire square_pair_4_far_b;
    reg square_pair_5_clock;
    reg [8:0] square_pair_5_query;
    reg [8:0] square_pair_5_photon_a;
    reg [8:0] square_pair_5_photon_b;
    wire [13:0] square_pair_5_square_a;
    wire [13:0] square_pair_5_square_b;
    wire square_pair_5_far_a;
    wire square_pair_5_far_b;
    reg lane_0_clock;
    reg [13:0] lane_0_axis_square_0;
    reg [13:0] lane_0_axis_square_1;
    reg [13:0] lane_0_axis_square_2;
    reg lane_0_axis_far_0;
    reg lane_0_axis_far_1;
    reg lane_0_axis_far_2;
    wire lane_0_photon_in_range;
    reg lane_1_clock;
    reg [13:0] lane_1_axis_square_0;
    reg [13:0] lane_1_axis_square_1;
    reg [13:0] lane_1_axis_square_2;
    reg lane_1_axis_far_0;
    reg lane_1_axis_far_1;
    reg lane_1_axis_far_2;
    wire lane_1_photon_in_range;
    reg lane_2_clock;
    reg [13:0] lane_2_axis_square_0;
    reg [13:0] lane_2_axis_square_1;
    reg [13:0] lane_2_axis_square_2;
    reg lane_2_axis_far_0;
    reg lane_2_axis_far_1;
    reg lane_2_axis_far_2;
    wire lane_2_photon_in_range;
    reg lane_3_clock;
    reg [13:0] lane_3_axis_square_0;
    reg [13:0] lane_3_axis_square_1;
    reg [13:0] lane_3_axis_square_2;
    reg lane_3_axis_far_0;
    reg lane_3_axis_far_1;
    reg lane_3_axis_far_2;
    wire lane_3_photon_in_range;
    reg group_flags_clock;
    reg group_flags_reset_in;
    reg group_flags_reset;
    reg group_flags_first_in;
    reg group_flags_last_in;
    reg group_flags_result_valid_in;
    wire group_flags_first_out;
    wire group_flags_last_out;
    wire group_flags_replace;
    wire group_flags_sums_done;
    wire group_flags_result_valid_out;
    reg channel_sum_0_clock;
    reg [5:0] channel_sum_0_power_in_0;
    reg [5:0] channel_sum_0_power_in_1;
    reg [5:0] channel_sum_0_power_in_2;
    reg [5:0] channel_sum_0_power_in_3;
    wire [5:0] channel_sum_0_power_0;
    wire [5:0] channel_sum_0_power_1;
    wire [5:0] channel_sum_0_power_2;
    wire [5:0] channel_sum_0_power_3;
    reg channel_sum_0_in_range_0;
    reg channel_sum_0_in_range_1;
    reg channel_sum_0_in_range_2;
    reg channel_sum_0_in_range_3;
    reg channel_sum_0_first;
    reg channel_sum_0_done;
    reg [17:0] channel_sum_0_result_in;
    wire [17:0] channel_sum_0_result_out;
    reg channel_sum_1_clock;
    reg [5:0] channel_sum_1_power_in_0;
    reg [5:0] channel_sum_1_power_in_1;
    reg [5:0] channel_sum_1_power_in_2;
    reg [5:0] channel_sum_1_power_in_3;
    wire [5:0] channel_sum_1_power_0;
    wire [5:0] channel_sum_1_power_1;
    wire [5:0] channel_sum_1_power_2;
    wire [5:0] channel_sum_1_power_3;
    reg channel_sum_1_in_range_0;
    reg channel_sum_1_in_range_1;
    reg channel_sum_1_in_range_2;
    reg channel_sum_1_in_range_3;
    reg channel_sum_1_first;
    reg channel_sum_1_done;
    reg [17:0] channel_sum_1_result_in;
    wire [17:0] channel_sum_1_result_out;
    reg channel_sum_2_clock;
    reg [5:0] channel_sum_2_power_in_0;
    reg [5:0] channel_sum_2_power_in_1;
    reg [5:0] channel_sum_2_power_in_2;
    reg [5:0] channel_sum_2_power_in_3;
    wire [5:0] channel_sum_2_power_0;
    wire [5:0] channel_sum_2_power_1;
    wire [5:0] channel_sum_2_power_2;
    wire [5:0] channel_sum_2_power_3;
    reg channel_sum_2_in_range_0;
    reg channel_sum_2_in_range_1;
    reg channel_sum_2_in_range_2;
    reg channel_sum_2_in_range_3;
    reg channel_sum_2_first;
    reg channel_sum_2_done;
    reg [17:0] channel_sum_2_result_in;
    wire [17:0] channel_sum_2_result_out;
    reg count_sum_clock;
    reg count_sum_power_in_0;
    reg count_sum_power_in_1;
    reg count_sum_power_in_2;
    reg count_sum_power_in_3;
    wire count_sum_power_0;
    wire count_sum_power_1;
    wire count_sum_power_2;
    wire count_sum_power_3;
    reg count_sum_in_range_0;
    reg count_sum_in_range_1;
    reg count_sum_in_range_2;
    reg count_sum_in_range_3;
    reg count_sum_first;
    reg count_sum_done;
    reg [12:0] count_sum_result_in;
    wire [12:0] count_sum_result_out;
    // Sub module instances
    photoncube_tile_5_query_flags query_flags(
        .clock(query_flags_clock),
        .reset_in(query_flags_reset_in),
        .token_valid_in(query_flags_token_valid_in),
        .swap_in(query_flags_swap_in),
        .keeps(query_flags_keeps),
        .reset_out(query_flags_reset_out),
        .token_valid_out(query_flags_token_valid_out),
        .swap_out(query_flags_swap_out)
    );
    photoncube_tile_5_query query_0(
        .clock(query_0_clock),
        .token_in(query_0_token_in),
        .keeps(query_0_keeps),
        .swap_in(query_0_swap_in),
        .token_out(query_0_token_out),
        .query_out(query_0_query_out)
    );
    photoncube_tile_5_query query_1(
        .clock(query_1_clock),
        .token_in(query_1_token_in),
        .keeps(query_1_keeps),
        .swap_in(query_1_swap_in),
        .token_out(query_1_token_out),
        .query_out(query_1_query_out)
    );
    photoncube_tile_5_query query_2(
        .clock(query_2_clock),
        .token_in(query_2_token_in),
        .keeps(query_2_keeps),
        .swap_in(query_2_swap_in),
        .token_out(query_2_token_out),
        .query_out(query_2_query_out)
    );
    photoncube_tile_5_register_9 photon_0(
        .d(photon_0_d),
        .q(photon_0_q),
        .clock(photon_0_clock)
    );
    photoncube_tile_5_register_9 photon_1(
        .d(photon_1_d),
        .q(photon_1_q),
        .clock(photon_1_clock)
    );
    photoncube_tile_5_register_9 photon_2(
        .d(photon_2_d),
        .q(photon_2_q),
        .clock(photon_2_clock)
    );
    photoncube_tile_5_register_9 photon_3(
        .d(photon_3_d),
        .q(photon_3_q),
        .clock(photon_3_clock)
    );
    photoncube_tile_5_register_9 photon_4(
        .d(photon_4_d),
        .q(photon_4_q),
        .clock(photon_4_clock)
    );
    photoncube_tile_5_register_9 photon_5(
        .d(photon_5_d),
        .q(photon_5_q),
        .clock(photon_5_clock)
    );
    photoncube_tile_5_register_9 photon_6(
        .d(photon_6_d),
        .q(photon_6_q),
        .clock(photon_6_clock)
    );
    photoncube_tile_5_register_9 photon_7(
        .d(photon_7_d),
        .q(photon_7_q),
        .clock(photon_7_clock)
    );
    photoncube_tile_5_register_9 photon_8(
        .d(photon_8_d),
        .q(photon_8_q),
        .clock(photon_8_clock)
    );
    photoncube_tile_5_register_9 photon_9(
        .d(photon_9_d),
        .q(photon_9_q),
        .clock(photon_9_clock)
    );
    photoncube_tile_5_register_9 photon_10(
        .d(photon_10_d),
        .q(photon_10_q),
        .clock(photon_10_clock)
    );
    photoncube_tile_5_register_9 photon_11(
        .d(photon_11_d),
        .q(photon_11_q),
        .clock(photon_11_clock)
    );
    photoncube_tile_5_square_pair square_pair_0(
        .clock(square_pair_0_clock),
        .query(square_pair_0_query),
        .photon_a(square_pair_0_photon_a),
        .photon_b(square_pair_0_photon_b),
        .square_a(square_pair_0_square_a),
        .square_b(square_pair_0_square_b),
        .far_a(square_pair_0_far_a),
        .far_b(square_pair_0_far_b)
    );
    photoncube_tile_5_square_pair square_pair_1(
        .clock(square_pair_1_clock),
        .query(square_pair_1_query),
        .photon_a(square_pair_1_photon_a),
        .photon_b(square_pair_1_photon_b),
        .square_a(square_pair_1_square_a),
        .square_b(square_pair_1_square_b),
        .far_a(square_pair_1_far_a),
        .far_b(square_pair_1_far_b)
    );
    photoncube_tile_5_square_pair square_pair_2(
        .clock(square_pair_2_clock),
        .query(square_pair_2_query),
        .photon_a(square_pair_2_photon_a),
        .photon_b(square_pair_2_photon_b),
        .square_a(square_pair_2_square_a),
        .square_b(square_pair_2_square_b),
        .far_a(square_pair_2_far_a),
        .far_b(square_pair_2_far_b)
    );
    photoncube_tile_5_square_pair square_pair_3(
        .clock(square_pair_3_clock),
        .query(square_pair_3_query),
        .photon_a(square_pair_3_photon_a),
        .photon_b(square_pair_3_photon_b),
        .square_a(square_pair_3_square_a),
        .square_b(square_pair_3_square_b),
        .far_a(square_pair_3_far_a),
        .far_b(square_pair_3_far_b)
    );
    photoncube_tile_5_square_pair square_pair_4(
        .clock(square_pair_4_clock),
        .query(square_pair_4_query),
        .photon_a(square_pair_4_photon_a),
        .photon_b(square_pair_4_photon_b),
        .square_a(square_pair_4_square_a),
        .square_b(square_pair_4_square_b),
        .far_a(square_pair_4_far_a),
        .far_b(square_pair_4_far_b)
    );
    photoncube_tile_5_square_pair square_pair_5(
        .clock(square_pair_5_clock),
        .query(square_pair_5_query),
        .photon_a(square_pair_5_photon_a),
        .photon_b(square_pair_5_photon_b),
        .square_a(square_pair_5_square_a),
        .square_b(square_pair_5_square_b),
        .far_a(square_pair_5_far_a),
        .far_b(square_pair_5_far_b)
    );
    photoncube_tile_5_lane lane_0(
        .clock(lane_0_clock),
        .axis_square_0(lane_0_axis_square_0),
        .axis_square_1(lane_0_axis_square_1),
        .axis_square_2(lane_0_axis_square_2),
        .axis_far_0(lane_0_axis_far_0),
        .axis_far_1(lane_0_axis_far_1),
        .axis_far_2(lane_0_axis_far_2),
        .photon_in_range(lane_0_photon_in_range)
    );
    photoncube_tile_5_lane lane_1(
        .clock(lane_1_clock),
        .axis_square_0(lane_1_axis_square_0),
        .axis_square_1(lane_1_axis_square_1),
        .axis_square_2(lane_1_axis_square_2),
        .axis_far_0(lane_1_axis_far_0),
        .axis_far_1(lane_1_axis_far_1),
        .axis_far_2(lane_1_axis_far_2),
        .photon_in_range(lane_1_photon_in_range)
    );
    photoncube_tile_5_lane lane_2(
        .clock(lane_2_clock),
        .axis_square_0(lane_2_axis_square_0),
        .axis_square_1(lane_2_axis_square_1),
        .axis_square_2(lane_2_axis_square_2),
        .axis_far_0(lane_2_axis_far_0),
        .axis_far_1(lane_2_axis_far_1),
        .axis_far_2(lane_2_axis_far_2),
        .photon_in_range(lane_2_photon_in_range)
    );
    photoncube_tile_5_lane lane_3(
        .clock(lane_3_clock),
        .axis_square_0(lane_3_axis_square_0),
        .axis_square_1(lane_3_axis_square_1),
        .axis_square_2(lane_3_axis_square_2),
        .axis_far_0(lane_3_axis_far_0),
        .axis_far_1(lane_3_axis_far_1),
        .axis_far_2(lane_3_axis_far_2),
        .photon_in_range(lane_3_photon_in_range)
    );
    photoncube_tile_5_group_flags group_flags(
        .clock(group_flags_clock),
        .reset_in(group_flags_reset_in),
        .reset(group_flags_reset),
        .first_in(group_flags_first_in),
        .last_in(group_flags_last_in),
        .result_valid_in(group_flags_result_valid_in),
        .first_out(group_flags_first_out),
        .last_out(group_flags_last_out),
        .replace(group_flags_replace),
        .sums_done(group_flags_sums_done),
        .result_valid_out(group_flags_result_valid_out)
    );
    photoncube_tile_5_channel_sum channel_sum_0(
        .clock(channel_sum_0_clock),
        .power_in_0(channel_sum_0_power_in_0),
        .power_in_1(channel_sum_0_power_in_1),
        .power_in_2(channel_sum_0_power_in_2),
        .power_in_3(channel_sum_0_power_in_3),
        .power_0(channel_sum_0_power_0),
        .power_1(channel_sum_0_power_1),
        .power_2(channel_sum_0_power_2),
        .power_3(channel_sum_0_power_3),
        .in_range_0(channel_sum_0_in_range_0),
        .in_range_1(channel_sum_0_in_range_1),
        .in_range_2(channel_sum_0_in_range_2),
        .in_range_3(channel_sum_0_in_range_3),
        .first(channel_sum_0_first),
        .done(channel_sum_0_done),
        .result_in(channel_sum_0_result_in),
        .result_out(channel_sum_0_result_out)
    );
    photoncube_tile_5_channel_sum channel_sum_1(
        .clock(channel_sum_1_clock),
        .power_in_0(channel_sum_1_power_in_0),
        .power_in_1(channel_sum_1_power_in_1),
        .power_in_2(channel_sum_1_power_in_2),
        .power_in_3(channel_sum_1_power_in_3),
        .power_0(channel_sum_1_power_0),
        .power_1(channel_sum_1_power_1),
        .power_2(channel_sum_1_power_2),
        .power_3(channel_sum_1_power_3),
        .in_range_0(channel_sum_1_in_range_0),
        .in_range_1(channel_sum_1_in_range_1),
        .in_range_2(channel_sum_1_in_range_2),
        .in_range_3(channel_sum_1_in_range_3),
        .first(channel_sum_1_first),
        .done(channel_sum_1_done),
        .result_in(channel_sum_1_result_in),
        .result_out(channel_sum_1_result_out)
    );
    photoncube_tile_5_channel_sum channel_sum_2(
        .clock(channel_sum_2_clock),
        .power_in_0(channel_sum_2_power_in_0),
        .power_in_1(channel_sum_2_power_in_1),
        .power_in_2(channel_sum_2_power_in_2),
        .power_in_3(channel_sum_2_power_in_3),
        .power_0(channel_sum_2_power_0),
        .power_1(channel_sum_2_power_1),
        .power_2(channel_sum_2_power_2),
        .power_3(channel_sum_2_power_3),
        .in_range_0(channel_sum_2_in_range_0),
        .in_range_1(channel_sum_2_in_range_1),
        .in_range_2(channel_sum_2_in_range_2),
        .in_range_3(channel_sum_2_in_range_3),
        .first(channel_sum_2_first),
        .done(channel_sum_2_done),
        .result_in(channel_sum_2_result_in),
        .result_out(channel_sum_2_result_out)
    );
    photoncube_tile_5_count_sum count_sum(
        .clock(count_sum_clock),
        .power_in_0(count_sum_power_in_0),
        .power_in_1(count_sum_power_in_1),
        .power_in_2(count_sum_power_in_2),
        .power_in_3(count_sum_power_in_3),
        .power_0(count_sum_power_0),
        .power_1(count_sum_power_1),
        .power_2(count_sum_power_2),
        .power_3(count_sum_power_3),
        .in_range_0(count_sum_in_range_0),
        .in_range_1(count_sum_in_range_1),
        .in_range_2(count_sum_in_range_2),
        .in_range_3(count_sum_in_range_3),
        .first(count_sum_first),
        .done(count_sum_done),
        .result_in(count_sum_result_in),
        .result_out(count_sum_result_out)
    );
    // Update code
    always @(*) begin
        query_flags_clock = clock;
        query_flags_reset_in = reset_in;
        query_flags_token_valid_in = token_valid_in;
        query_flags_swap_in = swap_in;
        reset_out = query_flags_reset_out;
        token_valid_out = query_flags_token_valid_out;
        swap_out = query_flags_swap_out;
        query_0_clock = clock;
        query_0_keeps = query_flags_keeps;
        query_0_swap_in = swap_in;
        query_0_token_in = token_in_0;
        token_out_0 = query_0_token_out;
        query_1_clock = clock;
        query_1_keeps = query_flags_keeps;
        query_1_swap_in = swap_in;
        query_1_token_in = token_in_1;
        token_out_1 = query_1_token_out;
        query_2_clock = clock;
        query_2_keeps = query_flags_keeps;
        query_2_swap_in = swap_in;
        query_2_token_in = token_in_2;
        token_out_2 = query_2_token_out;
        photon_0_clock = clock;
        photon_0_d = photon_in_0;
        photon_out_0 = photon_0_q;
        photon_1_clock = clock;
        photon_1_d = photon_in_1;
        photon_out_1 = photon_1_q;
        photon_2_clock = clock;
        photon_2_d = photon_in_2;
        photon_out_2 = photon_2_q;
        photon_3_clock = clock;
        photon_3_d = photon_in_3;
        photon_out_3 = photon_3_q;
        photon_4_clock = clock;
        photon_4_d = photon_in_4;
        photon_out_4 = photon_4_q;
        photon_5_clock = clock;
        photon_5_d = photon_in_5;
        photon_out_5 = photon_5_q;
        photon_6_clock = clock;
        photon_6_d = photon_in_6;
        photon_out_6 = photon_6_q;
        photon_7_clock = clock;
        photon_7_d = photon_in_7;
        photon_out_7 = photon_7_q;
        photon_8_clock = clock;
        photon_8_d = photon_in_8;
        photon_out_8 = photon_8_q;
        photon_9_clock = clock;
        photon_9_d = photon_in_9;
        photon_out_9 = photon_9_q;
        photon_10_clock = clock;
        photon_10_d = photon_in_10;
        photon_out_10 = photon_10_q;
        photon_11_clock = clock;
        photon_11_d = photon_in_11;
        photon_out_11 = photon_11_q;
        square_pair_0_clock = clock;
        square_pair_0_query = query_0_query_out;
        square_pair_0_photon_a = photon_0_q;
        square_pair_0_photon_b = photon_3_q;
        lane_0_axis_square_0 = square_pair_0_square_a;
        lane_1_axis_square_0 = square_pair_0_square_b;
        lane_0_axis_far_0 = square_pair_0_far_a;
        lane_1_axis_far_0 = square_pair_0_far_b;
        square_pair_1_clock = clock;
        square_pair_1_query = query_1_query_out;
        square_pair_1_photon_a = photon_1_q;
        square_pair_1_photon_b = photon_4_q;
        lane_0_axis_square_1 = square_pair_1_square_a;
        lane_1_axis_square_1 = square_pair_1_square_b;
        lane_0_axis_far_1 = square_pair_1_far_a;
        lane_1_axis_far_1 = square_pair_1_far_b;
        square_pair_2_clock = clock;
        square_pair_2_query = query_2_query_out;
        square_pair_2_photon_a = photon_2_q;
        square_pair_2_photon_b = photon_5_q;
        lane_0_axis_square_2 = square_pair_2_square_a;
        lane_1_axis_square_2 = square_pair_2_square_b;
        lane_0_axis_far_2 = square_pair_2_far_a;
        lane_1_axis_far_2 = square_pair_2_far_b;
        square_pair_3_clock = clock;
        square_pair_3_query = query_0_query_out;
        square_pair_3_photon_a = photon_6_q;
        square_pair_3_photon_b = photon_9_q;
        lane_2_axis_square_0 = square_pair_3_square_a;
        lane_3_axis_square_0 = square_pair_3_square_b;
        lane_2_axis_far_0 = square_pair_3_far_a;
        lane_3_axis_far_0 = square_pair_3_far_b;
        square_pair_4_clock = clock;
        square_pair_4_query = query_1_query_out;
        square_pair_4_photon_a = photon_7_q;
        square_pair_4_photon_b = photon_10_q;
        lane_2_axis_square_1 = square_pair_4_square_a;
        lane_3_axis_square_1 = square_pair_4_square_b;
        lane_2_axis_far_1 = square_pair_4_far_a;
        lane_3_axis_far_1 = square_pair_4_far_b;
        square_pair_5_clock = clock;
        square_pair_5_query = query_2_query_out;
        square_pair_5_photon_a = photon_8_q;
        square_pair_5_photon_b = photon_11_q;
        lane_2_axis_square_2 = square_pair_5_square_a;
        lane_3_axis_square_2 = square_pair_5_square_b;
        lane_2_axis_far_2 = square_pair_5_far_a;
        lane_3_axis_far_2 = square_pair_5_far_b;
        lane_0_clock = clock;
        lane_1_clock = clock;
        lane_2_clock = clock;
        lane_3_clock = clock;
        group_flags_clock = clock;
        group_flags_reset_in = reset_in;
        group_flags_reset = query_flags_reset_out;
        group_flags_first_in = first_in;
        group_flags_last_in = last_in;
        group_flags_result_valid_in = result_valid_in;
        first_out = group_flags_first_out;
        last_out = group_flags_last_out;
        result_valid_out = group_flags_result_valid_out;
        count_sum_clock = clock;
        count_sum_first = group_flags_replace;
        count_sum_done = group_flags_sums_done;
        count_sum_result_in = result_count_in;
        result_count_out = count_sum_result_out;
        count_sum_power_in_0 = present_in_0;
        count_sum_in_range_0 = lane_0_photon_in_range;
        present_out_0 = count_sum_power_0;
        count_sum_power_in_1 = present_in_1;
        count_sum_in_range_1 = lane_1_photon_in_range;
        present_out_1 = count_sum_power_1;
        count_sum_power_in_2 = present_in_2;
        count_sum_in_range_2 = lane_2_photon_in_range;
        present_out_2 = count_sum_power_2;
        count_sum_power_in_3 = present_in_3;
        count_sum_in_range_3 = lane_3_photon_in_range;
        present_out_3 = count_sum_power_3;
        channel_sum_0_clock = clock;
        channel_sum_0_first = group_flags_replace;
        channel_sum_0_done = group_flags_sums_done;
        channel_sum_0_result_in = result_in_0;
        result_out_0 = channel_sum_0_result_out;
        channel_sum_0_power_in_0 = power_in_0;
        channel_sum_0_in_range_0 = lane_0_photon_in_range;
        power_out_0 = channel_sum_0_power_0;
        channel_sum_0_power_in_1 = power_in_3;
        channel_sum_0_in_range_1 = lane_1_photon_in_range;
        power_out_3 = channel_sum_0_power_1;
        channel_sum_0_power_in_2 = power_in_6;
        channel_sum_0_in_range_2 = lane_2_photon_in_range;
        power_out_6 = channel_sum_0_power_2;
        channel_sum_0_power_in_3 = power_in_9;
        channel_sum_0_in_range_3 = lane_3_photon_in_range;
        power_out_9 = channel_sum_0_power_3;
        channel_sum_1_clock = clock;
        channel_sum_1_first = group_flags_replace;
        channel_sum_1_done = group_flags_sums_done;
        channel_sum_1_result_in = result_in_1;
        result_out_1 = channel_sum_1_result_out;
        channel_sum_1_power_in_0 = power_in_1;
        channel_sum_1_in_range_0 = lane_0_photon_in_range;
        power_out_1 = channel_sum_1_power_0;
        channel_sum_1_power_in_1 = power_in_4;
        channel_sum_1_in_range_1 = lane_1_photon_in_range;
        power_out_4 = channel_sum_1_power_1;
        channel_sum_1_power_in_2 = power_in_7;
        channel_sum_1_in_range_2 = lane_2_photon_in_range;
        power_out_7 = channel_sum_1_power_2;
        channel_sum_1_power_in_3 = power_in_10;
        channel_sum_1_in_range_3 = lane_3_photon_in_range;
        power_out_10 = channel_sum_1_power_3;
        channel_sum_2_clock = clock;
        channel_sum_2_first = group_flags_replace;
        channel_sum_2_done = group_flags_sums_done;
        channel_sum_2_result_in = result_in_2;
        result_out_2 = channel_sum_2_result_out;
        channel_sum_2_power_in_0 = power_in_2;
        channel_sum_2_in_range_0 = lane_0_photon_in_range;
        power_out_2 = channel_sum_2_power_0;
        channel_sum_2_power_in_1 = power_in_5;
        channel_sum_2_in_range_1 = lane_1_photon_in_range;
        power_out_5 = channel_sum_2_power_1;
        channel_sum_2_power_in_2 = power_in_8;
        channel_sum_2_in_range_2 = lane_2_photon_in_range;
        power_out_8 = channel_sum_2_power_2;
        channel_sum_2_power_in_3 = power_in_11;
        channel_sum_2_in_range_3 = lane_3_photon_in_range;
        power_out_11 = channel_sum_2_power_3;
    end
endmodule

module photoncube_tile_5_queue(clock, reset, result_valid_in, result_in_0, result_in_1,
    result_in_2, result_count_in, result_ready, result_valid, result_red, result_green,
    result_blue, result_count, batch_read);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire result_valid_in;
    input wire [17:0] result_in_0;
    input wire [17:0] result_in_1;
    input wire [17:0] result_in_2;
    input wire [12:0] result_count_in;
    input wire result_ready;
    output reg result_valid;
    output reg [17:0] result_red;
    output reg [17:0] result_green;
    output reg [17:0] result_blue;
    output reg [12:0] result_count;
    output reg batch_read;
    // Update code (custom)
    (* no_rw_check *) reg [66:0] results [0:15];
    reg [66:0] word = 67'd0;
    reg [3:0] write_place = 4'd0;
    reg [3:0] newest_place = 4'd0;
    reg [3:0] read_place = 4'd0;
    reg has_waiting = 1'd0;
    reg has_result = 1'd0;
    integer place;
    initial for (place = 0; place <= 15; place = place + 1) results[place] = 67'd0;
    wire reads = has_waiting & (~has_result | result_ready);
    (* keep *) wire is_newest;
    assign is_newest = read_place == newest_place;
    wire reads_newest = reads & is_newest;
    always @(*) result_valid = has_result;
    always @(*) batch_read = reads & (&read_place[0:0]);
    always @(*) result_red = word[17:0];
    always @(*) result_green = word[35:18];
    always @(*) result_blue = word[53:36];
    always @(*) result_count = word[66:54];
    always @(posedge clock) begin
      if (result_valid_in) begin
        results[write_place] <= {result_count_in, result_in_2, result_in_1, result_in_0};
        newest_place <= write_place;
        write_place <= write_place + 4'd1;
      end
      if (reads) begin
        word <= results[read_place];
        read_place <= read_place + 4'd1;
      end
      has_waiting <= result_valid_in | (has_waiting & ~reads_newest);
      has_result <= reads | (has_result & ~result_ready);
      if (reset) begin
        write_place <= 4'd0;
        newest_place <= 4'd0;
        read_place <= 4'd0;
        has_waiting <= 1'd0;
        has_result <= 1'd0;
      end
    end
endmodule

module photoncube_tile_5_admission(clock, reset, query_valid, group_valid, group_last,
    batch_read, query_ready, group_ready, taken, first_taken, last_taken, token_valid, is_full,
    has_room, clocks_to_last);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire query_valid;
    input wire group_valid;
    input wire group_last;
    input wire batch_read;
    output reg query_ready;
    output reg group_ready;
    output reg taken;
    output reg first_taken;
    output reg last_taken;
    output reg token_valid;
    output reg is_full;
    output reg has_room;
    output reg [15:0] clocks_to_last;
    // Update code (custom)
    reg [1:0] loaded = 2'd0;
    reg open = 1'd0;
    reg has_batch = 1'd0;
    reg [1:0] spacing = 2'd0;
    reg waits = 1'd0;
    reg gives_back = 1'd0;
    reg [7:0] promised = 8'd0;
    wire full = loaded[1];
    wire fills = query_valid & (&loaded[0:0]);
    wire room = ~promised[7];
    wire fits = ~waits & room;
    wire admits_group = has_batch & (~group_last | fits);
    wire takes_group = group_valid & admits_group;
    wire takes_first = group_valid & full & ~open & (~group_last | fits);
    wire takes_last = group_valid & has_batch & group_last & fits;
    wire admits_query = ~full | takes_first;
    wire takes_query = query_valid & admits_query;
    always @(*) query_ready = admits_query;
    always @(*) group_ready = admits_group;
    always @(*) taken = takes_group;
    always @(*) first_taken = takes_first;
    always @(*) last_taken = takes_last;
    always @(*) token_valid = takes_query & ~reset;
    always @(*) is_full = full;
    always @(*) has_room = room;
    always @(*) clocks_to_last = {14'd0, spacing};
    always @(posedge clock) begin
      loaded <= takes_first ? {1'd0, query_valid} : loaded + {1'd0, query_valid & ~full};
      open <= (takes_group & ~group_last) | (open & ~takes_last);
      has_batch <= (open & full) | (has_batch & ~takes_last) | fills;
      if (takes_last) spacing <= 2'd2;
      else if (waits) spacing <= spacing - 2'd1;
      waits <= takes_last | (|spacing[1:1]);
      gives_back <= batch_read;
      if (takes_last != gives_back)
        promised <= takes_last ? {promised[6:0], 1'd1} : {1'd0, promised[7:1]};
      if (reset) begin
        loaded <= 2'd0;
        open <= 1'd0;
        has_batch <= 1'd0;
        spacing <= 2'd0;
        waits <= 1'd0;
        gives_back <= 1'd0;
        promised <= 8'd0;
      end
    end
endmodule

module photoncube_tile_5_presence(clock, taken, photon_present, present, absent);
    // Module arguments
    input wire clock;
    input wire taken;
    input wire photon_present;
    output reg present;
    output reg absent;
    // Stub signals
    reg is_present_d;
    wire is_present_q;
    reg is_present_clock;
    reg is_absent_d;
    wire is_absent_q;
    reg is_absent_clock;
    // Local signals
    reg is_photon;
    // Sub module instances
    photoncube_tile_5_register_1 is_present(
        .d(is_present_d),
        .q(is_present_q),
        .clock(is_present_clock)
    );
    photoncube_tile_5_register_1 is_absent(
        .d(is_absent_d),
        .q(is_absent_q),
        .clock(is_absent_clock)
    );
    // Update code
    always @(*) begin
        is_present_clock = clock;
        is_absent_clock = clock;
        is_present_d = is_present_q;
        is_absent_d = is_absent_q;
        is_photon = taken & |photon_present;
        is_absent_d = ~is_photon;
        is_present_d = 32'h0;
        if (is_photon) begin
            is_present_d = 32'h1;
        end
        present = is_present_q;
        absent = is_absent_q;
    end
endmodule

module photoncube_tile_5_lane(clock, axis_square_0, axis_square_1, axis_square_2,
    axis_far_0, axis_far_1, axis_far_2, photon_in_range);
    // Module arguments
    input wire clock;
    input wire [13:0] axis_square_0;
    input wire [13:0] axis_square_1;
    input wire [13:0] axis_square_2;
    input wire axis_far_0;
    input wire axis_far_1;
    input wire axis_far_2;
    output reg photon_in_range;
    // Stub signals
    reg any_far_x;
    reg any_far_y;
    reg any_far_z;
    wire any_far_any;
    reg [13:0] pair_sum_a;
    reg [13:0] pair_sum_b;
    wire [14:0] pair_sum_sum;
    reg [14:0] pair_square_d;
    wire [14:0] pair_square_q;
    reg pair_square_clock;
    reg [13:0] pair_z_d;
    wire [13:0] pair_z_q;
    reg pair_z_clock;
    reg pair_far_d;
    wire pair_far_q;
    reg pair_far_clock;
    reg [14:0] distance_sum_a;
    reg [13:0] distance_sum_b;
    wire [15:0] distance_sum_sum;
    reg [15:0] distance_d;
    wire [15:0] distance_q;
    reg distance_clock;
    reg distance_far_d;
    wire distance_far_q;
    reg distance_far_clock;
    reg [15:0] range_of_format_0_distance;
    reg range_of_format_0_far;
    wire range_of_format_0_in_range;
    reg in_range_d;
    wire in_range_q;
    reg in_range_clock;
    // Sub module instances
    photoncube_tile_5_any_far any_far(
        .x(any_far_x),
        .y(any_far_y),
        .z(any_far_z),
        .any(any_far_any)
    );
    photoncube_tile_5_pair_sum pair_sum(
        .a(pair_sum_a),
        .b(pair_sum_b),
        .sum(pair_sum_sum)
    );
    photoncube_tile_5_register_15 pair_square(
        .d(pair_square_d),
        .q(pair_square_q),
        .clock(pair_square_clock)
    );
    photoncube_tile_5_register_14 pair_z(
        .d(pair_z_d),
        .q(pair_z_q),
        .clock(pair_z_clock)
    );
    photoncube_tile_5_register_1 pair_far(
        .d(pair_far_d),
        .q(pair_far_q),
        .clock(pair_far_clock)
    );
    photoncube_tile_5_distance_sum distance_sum(
        .a(distance_sum_a),
        .b(distance_sum_b),
        .sum(distance_sum_sum)
    );
    photoncube_tile_5_register_16 distance(
        .d(distance_d),
        .q(distance_q),
        .clock(distance_clock)
    );
    photoncube_tile_5_register_1 distance_far(
        .d(distance_far_d),
        .q(distance_far_q),
        .clock(distance_far_clock)
    );
    photoncube_tile_5_range_of_format range_of_format_0(
        .distance(range_of_format_0_distance),
        .far(range_of_format_0_far),
        .in_range(range_of_format_0_in_range)
    );
    photoncube_tile_5_register_1 in_range(
        .d(in_range_d),
        .q(in_range_q),
        .clock(in_range_clock)
    );
    // Update code
    always @(*) begin
        pair_square_clock = clock;
        pair_z_clock = clock;
        pair_far_clock = clock;
        distance_clock = clock;
        distance_far_clock = clock;
        in_range_clock = clock;
        any_far_x = axis_far_0;
        any_far_y = axis_far_1;
        any_far_z = axis_far_2;
        pair_sum_a = axis_square_0;
        pair_sum_b = axis_square_1;
        pair_square_d = pair_sum_sum;
        pair_z_d = axis_square_2;
        pair_far_d = any_far_any;
        distance_sum_a = pair_square_q;
        distance_sum_b = pair_z_q;
        distance_d = distance_sum_sum;
        distance_far_d = pair_far_q;
        range_of_format_0_distance = distance_q;
        range_of_format_0_far = distance_far_q;
        in_range_d = range_of_format_0_in_range;
        photon_in_range = in_range_q;
    end
endmodule

module photoncube_tile_5_first_delay(clock, clear, flag, delayed);
    // Module arguments
    input wire clock;
    input wire clear;
    input wire flag;
    output reg delayed;
    // Stub signals
    reg stage_0_clock;
    reg stage_0_clear;
    reg stage_0_d;
    wire stage_0_q;
    reg stage_1_clock;
    reg stage_1_clear;
    reg stage_1_d;
    wire stage_1_q;
    reg stage_2_clock;
    reg stage_2_clear;
    reg stage_2_d;
    wire stage_2_q;
    reg stage_3_clock;
    reg stage_3_clear;
    reg stage_3_d;
    wire stage_3_q;
    reg stage_4_clock;
    reg stage_4_clear;
    reg stage_4_d;
    wire stage_4_q;
    reg stage_5_clock;
    reg stage_5_clear;
    reg stage_5_d;
    wire stage_5_q;
    // Sub module instances
    photoncube_tile_5_group_first stage_0(
        .clock(stage_0_clock),
        .clear(stage_0_clear),
        .d(stage_0_d),
        .q(stage_0_q)
    );
    photoncube_tile_5_group_first stage_1(
        .clock(stage_1_clock),
        .clear(stage_1_clear),
        .d(stage_1_d),
        .q(stage_1_q)
    );
    photoncube_tile_5_group_first stage_2(
        .clock(stage_2_clock),
        .clear(stage_2_clear),
        .d(stage_2_d),
        .q(stage_2_q)
    );
    photoncube_tile_5_group_first stage_3(
        .clock(stage_3_clock),
        .clear(stage_3_clear),
        .d(stage_3_d),
        .q(stage_3_q)
    );
    photoncube_tile_5_group_first stage_4(
        .clock(stage_4_clock),
        .clear(stage_4_clear),
        .d(stage_4_d),
        .q(stage_4_q)
    );
    photoncube_tile_5_group_first stage_5(
        .clock(stage_5_clock),
        .clear(stage_5_clear),
        .d(stage_5_d),
        .q(stage_5_q)
    );
    // Update code
    always @(*) begin
        stage_0_d = flag;
        stage_1_d = stage_0_q;
        stage_2_d = stage_1_q;
        stage_3_d = stage_2_q;
        stage_4_d = stage_3_q;
        stage_5_d = stage_4_q;
        stage_0_clock = clock;
        stage_0_clear = clear;
        stage_1_clock = clock;
        stage_1_clear = clear;
        stage_2_clock = clock;
        stage_2_clear = clear;
        stage_3_clock = clock;
        stage_3_clear = clear;
        stage_4_clock = clock;
        stage_4_clear = clear;
        stage_5_clock = clock;
        stage_5_clear = clear;
        delayed = stage_5_q;
    end
endmodule

module photoncube_tile_5_query(clock, token_in, keeps, swap_in, token_out, query_out);
    // Module arguments
    input wire clock;
    input wire [8:0] token_in;
    input wire keeps;
    input wire swap_in;
    output reg [8:0] token_out;
    output reg [8:0] query_out;
    // Stub signals
    reg [8:0] token_d;
    wire [8:0] token_q;
    reg token_clock;
    reg [8:0] waiting_d;
    wire [8:0] waiting_q;
    reg waiting_clock;
    reg [8:0] query_d;
    wire [8:0] query_q;
    reg query_clock;
    // Local signals
    reg [8:0] newest;
    // Sub module instances
    photoncube_tile_5_register_9 token(
        .d(token_d),
        .q(token_q),
        .clock(token_clock)
    );
    photoncube_tile_5_register_9 waiting(
        .d(waiting_d),
        .q(waiting_q),
        .clock(waiting_clock)
    );
    photoncube_tile_5_register_9 query(
        .d(query_d),
        .q(query_q),
        .clock(query_clock)
    );
    // Update code
    always @(*) begin
        token_clock = clock;
        waiting_clock = clock;
        query_clock = clock;
        token_d = token_q;
        waiting_d = waiting_q;
        query_d = query_q;
        token_d = token_in;
        newest = waiting_q;
        if (keeps) begin
            newest = token_q;
            waiting_d = token_q;
        end
        if (swap_in) begin
            query_d = newest;
        end
        token_out = token_q;
        query_out = query_q;
    end
endmodule

module photoncube_tile_5_count_sum(clock, power_in_0, power_in_1, power_in_2, power_in_3,
    power_0, power_1, power_2, power_3, in_range_0, in_range_1, in_range_2, in_range_3, first,
    done, result_in, result_out);
    // Module arguments
    input wire clock;
    input wire power_in_0;
    input wire power_in_1;
    input wire power_in_2;
    input wire power_in_3;
    output reg power_0;
    output reg power_1;
    output reg power_2;
    output reg power_3;
    input wire in_range_0;
    input wire in_range_1;
    input wire in_range_2;
    input wire in_range_3;
    input wire first;
    input wire done;
    input wire [12:0] result_in;
    output reg [12:0] result_out;
    // Stub signals
    reg hop_0_d;
    wire hop_0_q;
    reg hop_0_clock;
    reg hop_1_d;
    wire hop_1_q;
    reg hop_1_clock;
    reg hop_2_d;
    wire hop_2_q;
    reg hop_2_clock;
    reg hop_3_d;
    wire hop_3_q;
    reg hop_3_clock;
    reg gated_sum_0_a;
    reg gated_sum_0_b;
    reg gated_sum_0_a_in_range;
    reg gated_sum_0_b_in_range;
    wire [1:0] gated_sum_0_sum;
    reg gated_sum_1_a;
    reg gated_sum_1_b;
    reg gated_sum_1_a_in_range;
    reg gated_sum_1_b_in_range;
    wire [1:0] gated_sum_1_sum;
    reg [1:0] pair_0_d;
    wire [1:0] pair_0_q;
    reg pair_0_clock;
    reg [1:0] pair_1_d;
    wire [1:0] pair_1_q;
    reg pair_1_clock;
    reg [1:0] group_sum_a;
    reg [1:0] group_sum_b;
    wire [2:0] group_sum_sum;
    reg [2:0] group_d;
    wire [2:0] group_q;
    reg group_clock;
    reg [2:0] accumulate_group;
    reg [12:0] accumulate_sum;
    reg accumulate_first;
    wire [12:0] accumulate_next_sum;
    reg [12:0] sum_d;
    wire [12:0] sum_q;
    reg sum_clock;
    reg result_link_done;
    reg [12:0] result_link_own;
    reg [12:0] result_link_further;
    wire [12:0] result_link_result;
    reg [12:0] result_d;
    wire [12:0] result_q;
    reg result_clock;
    // Sub module instances
    photoncube_tile_5_register_1 hop_0(
        .d(hop_0_d),
        .q(hop_0_q),
        .clock(hop_0_clock)
    );
    photoncube_tile_5_register_1 hop_1(
        .d(hop_1_d),
        .q(hop_1_q),
        .clock(hop_1_clock)
    );
    photoncube_tile_5_register_1 hop_2(
        .d(hop_2_d),
        .q(hop_2_q),
        .clock(hop_2_clock)
    );
    photoncube_tile_5_register_1 hop_3(
        .d(hop_3_d),
        .q(hop_3_q),
        .clock(hop_3_clock)
    );
    photoncube_tile_5_gated_sum_2 gated_sum_0(
        .a(gated_sum_0_a),
        .b(gated_sum_0_b),
        .a_in_range(gated_sum_0_a_in_range),
        .b_in_range(gated_sum_0_b_in_range),
        .sum(gated_sum_0_sum)
    );
    photoncube_tile_5_gated_sum_2 gated_sum_1(
        .a(gated_sum_1_a),
        .b(gated_sum_1_b),
        .a_in_range(gated_sum_1_a_in_range),
        .b_in_range(gated_sum_1_b_in_range),
        .sum(gated_sum_1_sum)
    );
    photoncube_tile_5_register_2 pair_0(
        .d(pair_0_d),
        .q(pair_0_q),
        .clock(pair_0_clock)
    );
    photoncube_tile_5_register_2 pair_1(
        .d(pair_1_d),
        .q(pair_1_q),
        .clock(pair_1_clock)
    );
    photoncube_tile_5_group_sum_2 group_sum(
        .a(group_sum_a),
        .b(group_sum_b),
        .sum(group_sum_sum)
    );
    photoncube_tile_5_register_3 group(
        .d(group_d),
        .q(group_q),
        .clock(group_clock)
    );
    photoncube_tile_5_accumulate_2 accumulate(
        .group(accumulate_group),
        .sum(accumulate_sum),
        .first(accumulate_first),
        .next_sum(accumulate_next_sum)
    );
    photoncube_tile_5_register_13 sum(
        .d(sum_d),
        .q(sum_q),
        .clock(sum_clock)
    );
    photoncube_tile_5_result_link_2 result_link(
        .done(result_link_done),
        .own(result_link_own),
        .further(result_link_further),
        .result(result_link_result)
    );
    photoncube_tile_5_register_13 result(
        .d(result_d),
        .q(result_q),
        .clock(result_clock)
    );
    // Update code
    always @(*) begin
        hop_0_clock = clock;
        hop_0_d = power_in_0;
        power_0 = hop_0_q;
        hop_1_clock = clock;
        hop_1_d = power_in_1;
        power_1 = hop_1_q;
        hop_2_clock = clock;
        hop_2_d = power_in_2;
        power_2 = hop_2_q;
        hop_3_clock = clock;
        hop_3_d = power_in_3;
        power_3 = hop_3_q;
        gated_sum_0_a = hop_0_q;
        gated_sum_0_b = hop_1_q;
        gated_sum_0_a_in_range = in_range_0;
        gated_sum_0_b_in_range = in_range_1;
        pair_0_d = gated_sum_0_sum;
        gated_sum_1_a = hop_2_q;
        gated_sum_1_b = hop_3_q;
        gated_sum_1_a_in_range = in_range_2;
        gated_sum_1_b_in_range = in_range_3;
        pair_1_d = gated_sum_1_sum;
        pair_0_clock = clock;
        pair_1_clock = clock;
        group_sum_a = pair_0_q;
        group_sum_b = pair_1_q;
        group_clock = clock;
        group_d = group_sum_sum;
        accumulate_group = group_q;
        accumulate_sum = sum_q;
        accumulate_first = first;
        sum_clock = clock;
        sum_d = accumulate_next_sum;
        result_link_done = done;
        result_link_own = sum_q;
        result_link_further = result_in;
        result_clock = clock;
        result_d = result_link_result;
        result_out = result_q;
    end
endmodule

module photoncube_tile_5_power_delay(clock, word, delayed);
    // Module arguments
    input wire clock;
    input wire [5:0] word;
    output reg [5:0] delayed;
    // Stub signals
    reg [5:0] stage_0_d;
    wire [5:0] stage_0_q;
    reg stage_0_clock;
    reg [5:0] stage_1_d;
    wire [5:0] stage_1_q;
    reg stage_1_clock;
    reg [5:0] stage_2_d;
    wire [5:0] stage_2_q;
    reg stage_2_clock;
    reg [5:0] stage_3_d;
    wire [5:0] stage_3_q;
    reg stage_3_clock;
    reg [5:0] stage_4_d;
    wire [5:0] stage_4_q;
    reg stage_4_clock;
    // Sub module instances
    photoncube_tile_5_register_6 stage_0(
        .d(stage_0_d),
        .q(stage_0_q),
        .clock(stage_0_clock)
    );
    photoncube_tile_5_register_6 stage_1(
        .d(stage_1_d),
        .q(stage_1_q),
        .clock(stage_1_clock)
    );
    photoncube_tile_5_register_6 stage_2(
        .d(stage_2_d),
        .q(stage_2_q),
        .clock(stage_2_clock)
    );
    photoncube_tile_5_register_6 stage_3(
        .d(stage_3_d),
        .q(stage_3_q),
        .clock(stage_3_clock)
    );
    photoncube_tile_5_register_6 stage_4(
        .d(stage_4_d),
        .q(stage_4_q),
        .clock(stage_4_clock)
    );
    // Update code
    always @(*) begin
        stage_0_clock = clock;
        stage_0_d = word;
        stage_1_clock = clock;
        stage_1_d = stage_0_q;
        stage_2_clock = clock;
        stage_2_d = stage_1_q;
        stage_3_clock = clock;
        stage_3_d = stage_2_q;
        stage_4_clock = clock;
        stage_4_d = stage_3_q;
        delayed = stage_4_q;
    end
endmodule

module photoncube_tile_5_present_delay(clock, word, delayed);
    // Module arguments
    input wire clock;
    input wire word;
    output reg delayed;
    // Stub signals
    reg stage_0_d;
    wire stage_0_q;
    reg stage_0_clock;
    reg stage_1_d;
    wire stage_1_q;
    reg stage_1_clock;
    reg stage_2_d;
    wire stage_2_q;
    reg stage_2_clock;
    reg stage_3_d;
    wire stage_3_q;
    reg stage_3_clock;
    reg stage_4_d;
    wire stage_4_q;
    reg stage_4_clock;
    // Sub module instances
    photoncube_tile_5_register_1 stage_0(
        .d(stage_0_d),
        .q(stage_0_q),
        .clock(stage_0_clock)
    );
    photoncube_tile_5_register_1 stage_1(
        .d(stage_1_d),
        .q(stage_1_q),
        .clock(stage_1_clock)
    );
    photoncube_tile_5_register_1 stage_2(
        .d(stage_2_d),
        .q(stage_2_q),
        .clock(stage_2_clock)
    );
    photoncube_tile_5_register_1 stage_3(
        .d(stage_3_d),
        .q(stage_3_q),
        .clock(stage_3_clock)
    );
    photoncube_tile_5_register_1 stage_4(
        .d(stage_4_d),
        .q(stage_4_q),
        .clock(stage_4_clock)
    );
    // Update code
    always @(*) begin
        stage_0_clock = clock;
        stage_0_d = word;
        stage_1_clock = clock;
        stage_1_d = stage_0_q;
        stage_2_clock = clock;
        stage_2_d = stage_1_q;
        stage_3_clock = clock;
        stage_3_d = stage_2_q;
        stage_4_clock = clock;
        stage_4_d = stage_3_q;
        delayed = stage_4_q;
    end
endmodule

module photoncube_tile_5_query_flags(clock, reset_in, token_valid_in, swap_in, keeps, reset_out,
    token_valid_out, swap_out);
    // Module arguments
    input wire clock;
    input wire reset_in;
    input wire token_valid_in;
    input wire swap_in;
    output reg keeps;
    output reg reset_out;
    output reg token_valid_out;
    output reg swap_out;
    // Stub signals
    reg reset_d;
    wire reset_q;
    reg reset_clock;
    reg token_valid_d;
    wire token_valid_q;
    reg token_valid_clock;
    reg next_valid_d;
    wire next_valid_q;
    reg next_valid_clock;
    reg keep_d;
    wire keep_q;
    reg keep_clock;
    reg swap_d;
    wire swap_q;
    reg swap_clock;
    // Local signals
    reg is_free;
    // Sub module instances
    photoncube_tile_5_register_1 reset(
        .d(reset_d),
        .q(reset_q),
        .clock(reset_clock)
    );
    photoncube_tile_5_register_1 token_valid(
        .d(token_valid_d),
        .q(token_valid_q),
        .clock(token_valid_clock)
    );
    photoncube_tile_5_register_1 next_valid(
        .d(next_valid_d),
        .q(next_valid_q),
        .clock(next_valid_clock)
    );
    photoncube_tile_5_register_1 keep(
        .d(keep_d),
        .q(keep_q),
        .clock(keep_clock)
    );
    photoncube_tile_5_register_1 swap(
        .d(swap_d),
        .q(swap_q),
        .clock(swap_clock)
    );
    // Update code
    always @(*) begin
        reset_clock = clock;
        token_valid_clock = clock;
        next_valid_clock = clock;
        keep_clock = clock;
        swap_clock = clock;
        reset_d = reset_q;
        token_valid_d = token_valid_q;
        next_valid_d = next_valid_q;
        keep_d = keep_q;
        swap_d = swap_q;
        is_free = ~next_valid_q | swap_in;
        keep_d = token_valid_in & is_free;
        keeps = keep_q;
        reset_d = reset_in;
        token_valid_d = token_valid_in & ~is_free;
        next_valid_d = ~is_free | token_valid_in;
        swap_d = swap_in;
        if (reset_in) begin
            token_valid_d = 1'b0;
            next_valid_d = 1'b0;
            swap_d = 1'b0;
        end
        reset_out = reset_q;
        token_valid_out = token_valid_q;
        swap_out = swap_q;
    end
endmodule

module photoncube_tile_5_group_flags(clock, reset_in, reset, first_in, last_in, result_valid_in,
    first_out, last_out, replace, sums_done, result_valid_out);
    // Module arguments
    input wire clock;
    input wire reset_in;
    input wire reset;
    input wire first_in;
    input wire last_in;
    input wire result_valid_in;
    output reg first_out;
    output reg last_out;
    output reg replace;
    output reg sums_done;
    output reg result_valid_out;
    // Stub signals
    reg first_clock;
    reg first_clear;
    reg first_d;
    wire first_q;
    reg last_clock;
    reg last_clear;
    reg last_d;
    wire last_q;
    reg gate_first_clock;
    reg gate_first_clear;
    reg gate_first_d;
    wire gate_first_q;
    reg gate_last_clock;
    reg gate_last_clear;
    reg gate_last_d;
    wire gate_last_q;
    reg pair_first_clock;
    reg pair_first_clear;
    reg pair_first_d;
    wire pair_first_q;
    reg pair_last_clock;
    reg pair_last_clear;
    reg pair_last_d;
    wire pair_last_q;
    reg group_first_clock;
    reg group_first_clear;
    reg group_first_d;
    wire group_first_q;
    reg group_last_clock;
    reg group_last_clear;
    reg group_last_d;
    wire group_last_q;
    reg done_d;
    wire done_q;
    reg done_clock;
    reg result_valid_d;
    wire result_valid_q;
    reg result_valid_clock;
    // Sub module instances
    photoncube_tile_5_group_first first(
        .clock(first_clock),
        .clear(first_clear),
        .d(first_d),
        .q(first_q)
    );
    photoncube_tile_5_group_first last(
        .clock(last_clock),
        .clear(last_clear),
        .d(last_d),
        .q(last_q)
    );
    photoncube_tile_5_gate_first gate_first(
        .clock(gate_first_clock),
        .clear(gate_first_clear),
        .d(gate_first_d),
        .q(gate_first_q)
    );
    photoncube_tile_5_gate_first gate_last(
        .clock(gate_last_clock),
        .clear(gate_last_clear),
        .d(gate_last_d),
        .q(gate_last_q)
    );
    photoncube_tile_5_group_first pair_first(
        .clock(pair_first_clock),
        .clear(pair_first_clear),
        .d(pair_first_d),
        .q(pair_first_q)
    );
    photoncube_tile_5_group_first pair_last(
        .clock(pair_last_clock),
        .clear(pair_last_clear),
        .d(pair_last_d),
        .q(pair_last_q)
    );
    photoncube_tile_5_group_first group_first(
        .clock(group_first_clock),
        .clear(group_first_clear),
        .d(group_first_d),
        .q(group_first_q)
    );
    photoncube_tile_5_group_first group_last(
        .clock(group_last_clock),
        .clear(group_last_clear),
        .d(group_last_d),
        .q(group_last_q)
    );
    photoncube_tile_5_register_1 done(
        .d(done_d),
        .q(done_q),
        .clock(done_clock)
    );
    photoncube_tile_5_register_1 result_valid(
        .d(result_valid_d),
        .q(result_valid_q),
        .clock(result_valid_clock)
    );
    // Update code
    always @(*) begin
        done_clock = clock;
        result_valid_clock = clock;
        done_d = done_q;
        result_valid_d = result_valid_q;
        first_clock = clock;
        last_clock = clock;
        gate_first_clock = clock;
        gate_last_clock = clock;
        pair_first_clock = clock;
        pair_last_clock = clock;
        group_first_clock = clock;
        group_last_clock = clock;
        first_clear = reset_in;
        last_clear = reset_in;
        gate_first_clear = reset_in;
        gate_last_clear = reset_in;
        pair_first_clear = reset_in;
        pair_last_clear = reset_in;
        group_first_clear = reset_in;
        group_last_clear = reset_in;
        first_d = first_in;
        last_d = last_in;
        first_out = first_q;
        last_out = last_q;
        gate_first_d = first_q;
        gate_last_d = last_q;
        pair_first_d = gate_first_q;
        pair_last_d = gate_last_q;
        group_first_d = pair_first_q;
        group_last_d = pair_last_q;
        replace = group_first_q;
        done_d = group_last_q & ~reset_in;
        sums_done = done_q;
        result_valid_d = done_q | result_valid_in;
        if (reset_in | reset) begin
            result_valid_d = 1'b0;
        end
        result_valid_out = result_valid_q;
    end
endmodule

module photoncube_tile_5_power_decoder(mantissa, power);
    // Module arguments
    input wire [5:0] mantissa;
    output reg [5:0] power;
    // Local signals
    reg [5:0] decoded;
    // Update code
    always @(*) begin
        decoded = ((mantissa) & 6'h3f);
        power = decoded;
    end
endmodule

module photoncube_tile_5_square_pair(clock, query, photon_a, photon_b, square_a, square_b, far_a,
    far_b);
    // Module arguments
    input wire clock;
    input wire [8:0] query;
    input wire [8:0] photon_a;
    input wire [8:0] photon_b;
    output reg [13:0] square_a;
    output reg [13:0] square_b;
    output reg far_a;
    output reg far_b;
    // Stub signals
    reg [8:0] subtract_0_a;
    reg [8:0] subtract_0_b;
    wire [9:0] subtract_0_difference;
    reg [8:0] subtract_1_a;
    reg [8:0] subtract_1_b;
    wire [9:0] subtract_1_difference;
    reg [9:0] difference_0_d;
    wire [9:0] difference_0_q;
    reg difference_0_clock;
    reg [9:0] difference_1_d;
    wire [9:0] difference_1_q;
    reg difference_1_clock;
    reg digits_0_clock;
    reg [9:0] digits_0_difference;
    wire [13:0] digits_0_square;
    wire digits_0_far;
    reg digits_1_clock;
    reg [9:0] digits_1_difference;
    wire [13:0] digits_1_square;
    wire digits_1_far;
    reg [13:0] square_stage_0_d;
    wire [13:0] square_stage_0_q;
    reg square_stage_0_clock;
    reg [13:0] square_stage_1_d;
    wire [13:0] square_stage_1_q;
    reg square_stage_1_clock;
    reg far_stage_0_d;
    wire far_stage_0_q;
    reg far_stage_0_clock;
    reg far_stage_1_d;
    wire far_stage_1_q;
    reg far_stage_1_clock;
    // Sub module instances
    photoncube_tile_5_subtract subtract_0(
        .a(subtract_0_a),
        .b(subtract_0_b),
        .difference(subtract_0_difference)
    );
    photoncube_tile_5_subtract subtract_1(
        .a(subtract_1_a),
        .b(subtract_1_b),
        .difference(subtract_1_difference)
    );
    photoncube_tile_5_register_10 difference_0(
        .d(difference_0_d),
        .q(difference_0_q),
        .clock(difference_0_clock)
    );
    photoncube_tile_5_register_10 difference_1(
        .d(difference_1_d),
        .q(difference_1_q),
        .clock(difference_1_clock)
    );
    photoncube_tile_5_digits digits_0(
        .clock(digits_0_clock),
        .difference(digits_0_difference),
        .square(digits_0_square),
        .far(digits_0_far)
    );
    photoncube_tile_5_digits digits_1(
        .clock(digits_1_clock),
        .difference(digits_1_difference),
        .square(digits_1_square),
        .far(digits_1_far)
    );
    photoncube_tile_5_square_stage square_stage_0(
        .d(square_stage_0_d),
        .q(square_stage_0_q),
        .clock(square_stage_0_clock)
    );
    photoncube_tile_5_square_stage square_stage_1(
        .d(square_stage_1_d),
        .q(square_stage_1_q),
        .clock(square_stage_1_clock)
    );
    photoncube_tile_5_products_far far_stage_0(
        .d(far_stage_0_d),
        .q(far_stage_0_q),
        .clock(far_stage_0_clock)
    );
    photoncube_tile_5_products_far far_stage_1(
        .d(far_stage_1_d),
        .q(far_stage_1_q),
        .clock(far_stage_1_clock)
    );
    // Update code
    always @(*) begin
        subtract_0_b = photon_a;
        subtract_1_b = photon_b;
        subtract_0_a = query;
        difference_0_clock = clock;
        difference_0_d = subtract_0_difference;
        square_stage_0_clock = clock;
        far_stage_0_clock = clock;
        subtract_1_a = query;
        difference_1_clock = clock;
        difference_1_d = subtract_1_difference;
        square_stage_1_clock = clock;
        far_stage_1_clock = clock;
        digits_0_clock = clock;
        digits_0_difference = difference_0_q;
        square_stage_0_d = digits_0_square;
        far_stage_0_d = digits_0_far;
        digits_1_clock = clock;
        digits_1_difference = difference_1_q;
        square_stage_1_d = digits_1_square;
        far_stage_1_d = digits_1_far;
        square_a = square_stage_0_q;
        square_b = square_stage_1_q;
        far_a = far_stage_0_q;
        far_b = far_stage_1_q;
    end
endmodule

module photoncube_tile_5_register_14(d, q, clock);
    // Module arguments
    input wire [13:0] d;
    output reg [13:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 14'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_channel_sum(clock, power_in_0, power_in_1, power_in_2, power_in_3,
    power_0, power_1, power_2, power_3, in_range_0, in_range_1, in_range_2, in_range_3, first,
    done, result_in, result_out);
    // Module arguments
    input wire clock;
    input wire [5:0] power_in_0;
    input wire [5:0] power_in_1;
    input wire [5:0] power_in_2;
    input wire [5:0] power_in_3;
    output reg [5:0] power_0;
    output reg [5:0] power_1;
    output reg [5:0] power_2;
    output reg [5:0] power_3;
    input wire in_range_0;
    input wire in_range_1;
    input wire in_range_2;
    input wire in_range_3;
    input wire first;
    input wire done;
    input wire [17:0] result_in;
    output reg [17:0] result_out;
    // Stub signals
    reg [5:0] hop_0_d;
    wire [5:0] hop_0_q;
    reg hop_0_clock;
    reg [5:0] hop_1_d;
    wire [5:0] hop_1_q;
    reg hop_1_clock;
    reg [5:0] hop_2_d;
    wire [5:0] hop_2_q;
    reg hop_2_clock;
    reg [5:0] hop_3_d;
    wire [5:0] hop_3_q;
    reg hop_3_clock;
    reg [5:0] gated_sum_0_a;
    reg [5:0] gated_sum_0_b;
    reg gated_sum_0_a_in_range;
    reg gated_sum_0_b_in_range;
    wire [6:0] gated_sum_0_sum;
    reg [5:0] gated_sum_1_a;
    reg [5:0] gated_sum_1_b;
    reg gated_sum_1_a_in_range;
    reg gated_sum_1_b_in_range;
    wire [6:0] gated_sum_1_sum;
    reg [6:0] pair_0_d;
    wire [6:0] pair_0_q;
    reg pair_0_clock;
    reg [6:0] pair_1_d;
    wire [6:0] pair_1_q;
    reg pair_1_clock;
    reg [6:0] group_sum_a;
    reg [6:0] group_sum_b;
    wire [7:0] group_sum_sum;
    reg [7:0] group_d;
    wire [7:0] group_q;
    reg group_clock;
    reg [7:0] accumulate_group;
    reg [17:0] accumulate_sum;
    reg accumulate_first;
    wire [17:0] accumulate_next_sum;
    reg [17:0] sum_d;
    wire [17:0] sum_q;
    reg sum_clock;
    reg result_link_done;
    reg [17:0] result_link_own;
    reg [17:0] result_link_further;
    wire [17:0] result_link_result;
    reg [17:0] result_d;
    wire [17:0] result_q;
    reg result_clock;
    // Sub module instances
    photoncube_tile_5_register_6 hop_0(
        .d(hop_0_d),
        .q(hop_0_q),
        .clock(hop_0_clock)
    );
    photoncube_tile_5_register_6 hop_1(
        .d(hop_1_d),
        .q(hop_1_q),
        .clock(hop_1_clock)
    );
    photoncube_tile_5_register_6 hop_2(
        .d(hop_2_d),
        .q(hop_2_q),
        .clock(hop_2_clock)
    );
    photoncube_tile_5_register_6 hop_3(
        .d(hop_3_d),
        .q(hop_3_q),
        .clock(hop_3_clock)
    );
    photoncube_tile_5_gated_sum gated_sum_0(
        .a(gated_sum_0_a),
        .b(gated_sum_0_b),
        .a_in_range(gated_sum_0_a_in_range),
        .b_in_range(gated_sum_0_b_in_range),
        .sum(gated_sum_0_sum)
    );
    photoncube_tile_5_gated_sum gated_sum_1(
        .a(gated_sum_1_a),
        .b(gated_sum_1_b),
        .a_in_range(gated_sum_1_a_in_range),
        .b_in_range(gated_sum_1_b_in_range),
        .sum(gated_sum_1_sum)
    );
    photoncube_tile_5_register_7 pair_0(
        .d(pair_0_d),
        .q(pair_0_q),
        .clock(pair_0_clock)
    );
    photoncube_tile_5_register_7 pair_1(
        .d(pair_1_d),
        .q(pair_1_q),
        .clock(pair_1_clock)
    );
    photoncube_tile_5_group_sum group_sum(
        .a(group_sum_a),
        .b(group_sum_b),
        .sum(group_sum_sum)
    );
    photoncube_tile_5_register_8 group(
        .d(group_d),
        .q(group_q),
        .clock(group_clock)
    );
    photoncube_tile_5_accumulate accumulate(
        .group(accumulate_group),
        .sum(accumulate_sum),
        .first(accumulate_first),
        .next_sum(accumulate_next_sum)
    );
    photoncube_tile_5_register_18 sum(
        .d(sum_d),
        .q(sum_q),
        .clock(sum_clock)
    );
    photoncube_tile_5_result_link result_link(
        .done(result_link_done),
        .own(result_link_own),
        .further(result_link_further),
        .result(result_link_result)
    );
    photoncube_tile_5_register_18 result(
        .d(result_d),
        .q(result_q),
        .clock(result_clock)
    );
    // Update code
    always @(*) begin
        hop_0_clock = clock;
        hop_0_d = power_in_0;
        power_0 = hop_0_q;
        hop_1_clock = clock;
        hop_1_d = power_in_1;
        power_1 = hop_1_q;
        hop_2_clock = clock;
        hop_2_d = power_in_2;
        power_2 = hop_2_q;
        hop_3_clock = clock;
        hop_3_d = power_in_3;
        power_3 = hop_3_q;
        gated_sum_0_a = hop_0_q;
        gated_sum_0_b = hop_1_q;
        gated_sum_0_a_in_range = in_range_0;
        gated_sum_0_b_in_range = in_range_1;
        pair_0_d = gated_sum_0_sum;
        gated_sum_1_a = hop_2_q;
        gated_sum_1_b = hop_3_q;
        gated_sum_1_a_in_range = in_range_2;
        gated_sum_1_b_in_range = in_range_3;
        pair_1_d = gated_sum_1_sum;
        pair_0_clock = clock;
        pair_1_clock = clock;
        group_sum_a = pair_0_q;
        group_sum_b = pair_1_q;
        group_clock = clock;
        group_d = group_sum_sum;
        accumulate_group = group_q;
        accumulate_sum = sum_q;
        accumulate_first = first;
        sum_clock = clock;
        sum_d = accumulate_next_sum;
        result_link_done = done;
        result_link_own = sum_q;
        result_link_further = result_in;
        result_clock = clock;
        result_d = result_link_result;
        result_out = result_q;
    end
endmodule

module photoncube_tile_5_any_far(x, y, z, any);
    // Module arguments
    input wire x;
    input wire y;
    input wire z;
    output reg any;
    // Update code
    always @(*) begin
        any = x | y | z;
    end
endmodule

module photoncube_tile_5_power_of_present(absent, word, power);
    // Module arguments
    input wire absent;
    input wire [5:0] word;
    output reg [5:0] power;
    // Update code
    always @(*) begin
        power = word;
        if (absent) begin
            power = 32'h0;
        end
    end
endmodule

module photoncube_tile_5_pair_sum(a, b, sum);
    // Module arguments
    input wire [13:0] a;
    input wire [13:0] b;
    output reg [14:0] sum;
    // Local signals
    reg [14:0] wide_a;
    reg [14:0] wide_b;
    // Update code
    always @(*) begin
        wide_a = ((a) & 15'h7fff);
        wide_b = ((b) & 15'h7fff);
        sum = wide_a + wide_b;
    end
endmodule

module photoncube_tile_5_register_16(d, q, clock);
    // Module arguments
    input wire [15:0] d;
    output reg [15:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 16'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_register_3(d, q, clock);
    // Module arguments
    input wire [2:0] d;
    output reg [2:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 3'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_register_13(d, q, clock);
    // Module arguments
    input wire [12:0] d;
    output reg [12:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 13'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_register_2(d, q, clock);
    // Module arguments
    input wire [1:0] d;
    output reg [1:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 2'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_register_15(d, q, clock);
    // Module arguments
    input wire [14:0] d;
    output reg [14:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 15'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_distance_sum(a, b, sum);
    // Module arguments
    input wire [14:0] a;
    input wire [13:0] b;
    output reg [15:0] sum;
    // Local signals
    reg [15:0] wide_a;
    reg [15:0] wide_b;
    // Update code
    always @(*) begin
        wide_a = ((a) & 16'hffff);
        wide_b = ((b) & 16'hffff);
        sum = wide_a + wide_b;
    end
endmodule

module photoncube_tile_5_group_sum_2(a, b, sum);
    // Module arguments
    input wire [1:0] a;
    input wire [1:0] b;
    output reg [2:0] sum;
    // Local signals
    reg [2:0] wide_a;
    reg [2:0] wide_b;
    // Update code
    always @(*) begin
        wide_a = ((a) & 3'h7);
        wide_b = ((b) & 3'h7);
        sum = wide_a + wide_b;
    end
endmodule

module photoncube_tile_5_register_6(d, q, clock);
    // Module arguments
    input wire [5:0] d;
    output reg [5:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 6'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_register_8(d, q, clock);
    // Module arguments
    input wire [7:0] d;
    output reg [7:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 8'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_accumulate_2(group, sum, first, next_sum);
    // Module arguments
    input wire [2:0] group;
    input wire [12:0] sum;
    input wire first;
    output reg [12:0] next_sum;
    // Local signals
    reg [12:0] wide_group;
    reg [12:0] kept;
    // Update code
    always @(*) begin
        wide_group = ((group) & 13'h1fff);
        kept = sum;
        if (first) begin
            kept = 32'h0;
        end
        next_sum = kept + wide_group;
    end
endmodule

module photoncube_tile_5_register_18(d, q, clock);
    // Module arguments
    input wire [17:0] d;
    output reg [17:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 18'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_result_link_2(done, own, further, result);
    // Module arguments
    input wire done;
    input wire [12:0] own;
    input wire [12:0] further;
    output reg [12:0] result;
    // Update code
    always @(*) begin
        result = further;
        if (done) begin
            result = own;
        end
    end
endmodule

module photoncube_tile_5_gated_sum_2(a, b, a_in_range, b_in_range, sum);
    // Module arguments
    input wire a;
    input wire b;
    input wire a_in_range;
    input wire b_in_range;
    output reg [1:0] sum;
    // Local signals
    reg [1:0] gated_a;
    reg [1:0] gated_b;
    // Update code
    always @(*) begin
        gated_a = 32'h0;
        gated_b = 32'h0;
        if (a_in_range) begin
            gated_a = ((a) & 2'h3);
        end
        if (b_in_range) begin
            gated_b = ((b) & 2'h3);
        end
        sum = gated_a + gated_b;
    end
endmodule

module photoncube_tile_5_digits(clock, difference, square, far);
    // Module arguments
    input wire clock;
    input wire [9:0] difference;
    output reg [13:0] square;
    output reg far;
    // Stub signals
    reg [9:0] magnitude_of_difference;
    wire [8:0] magnitude_of_magnitude;
    reg [8:0] magnitude_d;
    wire [8:0] magnitude_q;
    reg magnitude_clock;
    reg [8:0] split_magnitude_magnitude;
    wire [6:0] split_magnitude_counted;
    wire split_magnitude_far;
    reg [6:0] digit_products_magnitude;
    wire [5:0] digit_products_low_product;
    wire [3:0] digit_products_high_product;
    reg [6:0] products_magnitude_d;
    wire [6:0] products_magnitude_q;
    reg products_magnitude_clock;
    reg [5:0] low_product_d;
    wire [5:0] low_product_q;
    reg low_product_clock;
    reg [3:0] high_product_d;
    wire [3:0] high_product_q;
    reg high_product_clock;
    reg products_far_d;
    wire products_far_q;
    reg products_far_clock;
    reg [5:0] cross_sum_low_product;
    reg [3:0] cross_sum_high_product;
    wire [6:0] cross_sum_cross_product;
    reg [6:0] cross_magnitude_d;
    wire [6:0] cross_magnitude_q;
    reg cross_magnitude_clock;
    reg [6:0] cross_product_d;
    wire [6:0] cross_product_q;
    reg cross_product_clock;
    reg cross_far_d;
    wire cross_far_q;
    reg cross_far_clock;
    reg [6:0] square_sum_magnitude;
    reg [6:0] square_sum_cross_product;
    wire [13:0] square_sum_square;
    // Sub module instances
    photoncube_tile_5_magnitude_of magnitude_of(
        .difference(magnitude_of_difference),
        .magnitude(magnitude_of_magnitude)
    );
    photoncube_tile_5_register_9 magnitude(
        .d(magnitude_d),
        .q(magnitude_q),
        .clock(magnitude_clock)
    );
    photoncube_tile_5_split_magnitude split_magnitude(
        .magnitude(split_magnitude_magnitude),
        .counted(split_magnitude_counted),
        .far(split_magnitude_far)
    );
    photoncube_tile_5_digit_products digit_products(
        .magnitude(digit_products_magnitude),
        .low_product(digit_products_low_product),
        .high_product(digit_products_high_product)
    );
    photoncube_tile_5_products_magnitude products_magnitude(
        .d(products_magnitude_d),
        .q(products_magnitude_q),
        .clock(products_magnitude_clock)
    );
    photoncube_tile_5_low_product low_product(
        .d(low_product_d),
        .q(low_product_q),
        .clock(low_product_clock)
    );
    photoncube_tile_5_high_product high_product(
        .d(high_product_d),
        .q(high_product_q),
        .clock(high_product_clock)
    );
    photoncube_tile_5_products_far products_far(
        .d(products_far_d),
        .q(products_far_q),
        .clock(products_far_clock)
    );
    photoncube_tile_5_cross_sum cross_sum(
        .low_product(cross_sum_low_product),
        .high_product(cross_sum_high_product),
        .cross_product(cross_sum_cross_product)
    );
    photoncube_tile_5_register_7 cross_magnitude(
        .d(cross_magnitude_d),
        .q(cross_magnitude_q),
        .clock(cross_magnitude_clock)
    );
    photoncube_tile_5_register_7 cross_product(
        .d(cross_product_d),
        .q(cross_product_q),
        .clock(cross_product_clock)
    );
    photoncube_tile_5_register_1 cross_far(
        .d(cross_far_d),
        .q(cross_far_q),
        .clock(cross_far_clock)
    );
    photoncube_tile_5_square_sum square_sum(
        .magnitude(square_sum_magnitude),
        .cross_product(square_sum_cross_product),
        .square(square_sum_square)
    );
    // Update code
    always @(*) begin
        magnitude_clock = clock;
        products_magnitude_clock = clock;
        low_product_clock = clock;
        high_product_clock = clock;
        products_far_clock = clock;
        cross_magnitude_clock = clock;
        cross_product_clock = clock;
        cross_far_clock = clock;
        magnitude_of_difference = difference;
        magnitude_d = magnitude_of_magnitude;
        split_magnitude_magnitude = magnitude_q;
        digit_products_magnitude = split_magnitude_counted;
        products_magnitude_d = split_magnitude_counted;
        low_product_d = digit_products_low_product;
        high_product_d = digit_products_high_product;
        products_far_d = split_magnitude_far;
        cross_sum_low_product = low_product_q;
        cross_sum_high_product = high_product_q;
        cross_magnitude_d = products_magnitude_q;
        cross_product_d = cross_sum_cross_product;
        cross_far_d = products_far_q;
        square_sum_magnitude = cross_magnitude_q;
        square_sum_cross_product = cross_product_q;
        square = square_sum_square;
        far = cross_far_q;
    end
endmodule

module photoncube_tile_5_gate_first(clock, clear, d, q);
    // Module arguments
    input wire clock;
    input wire clear;
    input wire d;
    output reg q;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_tile_5_group_first(clock, clear, d, q);
    // Module arguments
    input wire clock;
    input wire clear;
    input wire d;
    output reg q;
    // Stub signals
    reg flag_0_d;
    wire flag_0_q;
    reg flag_0_clock;
    // Sub module instances
    photoncube_tile_5_register_1 flag_0(
        .d(flag_0_d),
        .q(flag_0_q),
        .clock(flag_0_clock)
    );
    // Update code
    always @(*) begin
        q = d;
        flag_0_clock = clock;
        flag_0_d = d & ~clear;
        q = flag_0_q;
    end
endmodule

module photoncube_tile_5_group_sum(a, b, sum);
    // Module arguments
    input wire [6:0] a;
    input wire [6:0] b;
    output reg [7:0] sum;
    // Local signals
    reg [7:0] wide_a;
    reg [7:0] wide_b;
    // Update code
    always @(*) begin
        wide_a = ((a) & 8'hff);
        wide_b = ((b) & 8'hff);
        sum = wide_a + wide_b;
    end
endmodule

module photoncube_tile_5_subtract(a, b, difference);
    // Module arguments
    input wire [8:0] a;
    input wire [8:0] b;
    output reg [9:0] difference;
    // Local signals
    reg [9:0] wide_a;
    reg [9:0] wide_b;
    // Update code
    always @(*) begin
        wide_a = ((a) & 10'h3ff);
        wide_b = ((b) & 10'h3ff);
        difference = wide_a - wide_b;
    end
endmodule

module photoncube_tile_5_range_of_format(distance, far, in_range);
    // Module arguments
    input wire [15:0] distance;
    input wire far;
    output reg in_range;
    // Constant declarations
    localparam limit = 16'h3e04;
    // Local signals
    reg near;
    // Update code
    always @(*) begin
        near = distance <= limit;
        in_range = near & ~far;
    end
endmodule

module photoncube_tile_5_accumulate(group, sum, first, next_sum);
    // Module arguments
    input wire [7:0] group;
    input wire [17:0] sum;
    input wire first;
    output reg [17:0] next_sum;
    // Local signals
    reg [17:0] wide_group;
    reg [17:0] kept;
    // Update code
    always @(*) begin
        wide_group = ((group) & 18'h3ffff);
        kept = sum;
        if (first) begin
            kept = 32'h0;
        end
        next_sum = kept + wide_group;
    end
endmodule

module photoncube_tile_5_result_link(done, own, further, result);
    // Module arguments
    input wire done;
    input wire [17:0] own;
    input wire [17:0] further;
    output reg [17:0] result;
    // Update code
    always @(*) begin
        result = further;
        if (done) begin
            result = own;
        end
    end
endmodule

module photoncube_tile_5_gated_sum(a, b, a_in_range, b_in_range, sum);
    // Module arguments
    input wire [5:0] a;
    input wire [5:0] b;
    input wire a_in_range;
    input wire b_in_range;
    output reg [6:0] sum;
    // Local signals
    reg [6:0] gated_a;
    reg [6:0] gated_b;
    // Update code
    always @(*) begin
        gated_a = 32'h0;
        gated_b = 32'h0;
        if (a_in_range) begin
            gated_a = ((a) & 7'h7f);
        end
        if (b_in_range) begin
            gated_b = ((b) & 7'h7f);
        end
        sum = gated_a + gated_b;
    end
endmodule

module photoncube_tile_5_register_10(d, q, clock);
    // Module arguments
    input wire [9:0] d;
    output reg [9:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 10'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_square_stage(d, q, clock);
    // Module arguments
    input wire [13:0] d;
    output reg [13:0] q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_tile_5_register_9(d, q, clock);
    // Module arguments
    input wire [8:0] d;
    output reg [8:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 9'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_cross_sum(low_product, high_product, cross_product);
    // Module arguments
    input wire [5:0] low_product;
    input wire [3:0] high_product;
    output reg [6:0] cross_product;
    // Update code (custom)
    wire [4:0] upper = low_product[5:2] + high_product;
    always @(*) cross_product = {upper, low_product[1:0]};
endmodule

module photoncube_tile_5_register_1(d, q, clock);
    // Module arguments
    input wire d;
    output reg q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 1'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_square_sum(magnitude, cross_product, square);
    // Module arguments
    input wire [6:0] magnitude;
    input wire [6:0] cross_product;
    output reg [13:0] square;
    // Update code (custom)
    function [7:0] high_square;
      input [3:0] digit;
      case (digit)
        4'd0: high_square = 8'd0;
        4'd1: high_square = 8'd1;
        4'd2: high_square = 8'd4;
        4'd3: high_square = 8'd9;
        4'd4: high_square = 8'd16;
        4'd5: high_square = 8'd25;
        4'd6: high_square = 8'd36;
        4'd7: high_square = 8'd49;
        4'd8: high_square = 8'd64;
        4'd9: high_square = 8'd81;
        4'd10: high_square = 8'd100;
        4'd11: high_square = 8'd121;
        4'd12: high_square = 8'd144;
        4'd13: high_square = 8'd169;
        4'd14: high_square = 8'd196;
        default: high_square = 8'd225;
      endcase
    endfunction
    function [5:0] low_square;
      input [2:0] digit;
      case (digit)
        3'd0: low_square = 6'd0;
        3'd1: low_square = 6'd1;
        3'd2: low_square = 6'd4;
        3'd3: low_square = 6'd9;
        3'd4: low_square = 6'd16;
        3'd5: low_square = 6'd25;
        3'd6: low_square = 6'd36;
        default: low_square = 6'd49;
      endcase
    endfunction
    wire [13:0] squares = {high_square(magnitude[6:3]), low_square(magnitude[2:0])};
    wire [9:0] upper = squares[13:4] + {3'd0, cross_product};
    always @(*) square = {upper, squares[3:0]};
endmodule

module photoncube_tile_5_low_product(d, q, clock);
    // Module arguments
    input wire [5:0] d;
    output reg [5:0] q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_tile_5_products_far(d, q, clock);
    // Module arguments
    input wire d;
    output reg q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_tile_5_magnitude_of(difference, magnitude);
    // Module arguments
    input wire [9:0] difference;
    output reg [8:0] magnitude;
    // Update code (custom)
    wire negative = difference[9];
    wire [8:0] inverted = difference[8:0] ^ {9{negative}};
    always @(*) magnitude = inverted + {8'd0, negative};
endmodule

module photoncube_tile_5_high_product(d, q, clock);
    // Module arguments
    input wire [3:0] d;
    output reg [3:0] q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule

module photoncube_tile_5_digit_products(magnitude, low_product, high_product);
    // Module arguments
    input wire [6:0] magnitude;
    output reg [5:0] low_product;
    output reg [3:0] high_product;
    // Update code (custom)
    wire [3:0] high = magnitude[6:3];
    always @(*) low_product = {2'd0, high & {4{magnitude[0]}}} + {1'd0, high & {4{magnitude[1]}}, 1'd0};
    always @(*) high_product = {high & {4{magnitude[2]}}};
endmodule

module photoncube_tile_5_split_magnitude(magnitude, counted, far);
    // Module arguments
    input wire [8:0] magnitude;
    output reg [6:0] counted;
    output reg far;
    // Update code (custom)
    always @(*) counted = magnitude[6:0];
    always @(*) far = |magnitude[8:7];
endmodule

module photoncube_tile_5_register_7(d, q, clock);
    // Module arguments
    input wire [6:0] d;
    output reg [6:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 7'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_tile_5_products_magnitude(d, q, clock);
    // Module arguments
    input wire [6:0] d;
    output reg [6:0] q;
    input wire clock;
    // Update code
    always @(*) begin
        q = d;
    end
endmodule
