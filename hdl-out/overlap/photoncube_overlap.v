// SPDX-License-Identifier: MIT
// overlap: the paper's 16 cells with all units at work: a modulo-scheduled kernel.
// Written by photoncube 0.2.0, `photoncube generate --machine overlap`; do not edit.
//
// cells         16
// numbers       plain: 8-bit coordinates, 16-bit powers
// power unit    the photon map's own: its largest power in any channel is the largest word
// frame         4 x 4 x 4 blocks; a block's edge is at least the search radius; a query has its
//               place in the inner 2 x 2 x 2 blocks, so that all photons in range are in the frame
// most photons  65537 a query
// squarers      digits
// clocks        3 for 2 groups of 4 photons; 20 for a query of 1 group, 168 for one of 100
//
// Ports of photoncube_overlap; bit 0 is the lowest:
//   input          clock                every register changes at its rising edge
//   input          reset                synchronous, active high; one clock is enough, and what is
//                                       taken in it is lost
//   input          query_valid          a query is on the query_ pins
//   input [7:0]    query_x              unsigned; steps of 2^-6 block edge, in a frame of 4 block
//                                       edges
//   input [7:0]    query_y              unsigned; steps of 2^-6 block edge, in a frame of 4 block
//                                       edges
//   input [7:0]    query_z              unsigned; steps of 2^-6 block edge, in a frame of 4 block
//                                       edges
//   input [17:0]   query_radius_sq      squared search radius in square steps; in range where d^2
//                                       <= query_radius_sq
//   input          group_valid          a group is on the group_ and photon_ pins
//   input          group_last           this group is the last of its query
//   input          photon_present_0..3  the lane has a photon; where it is 0, the lane's other pins
//                                       are not looked at
//   input [7:0]    photon_x_0..3        unsigned; steps of 2^-6 block edge, in a frame of 4 block
//                                       edges
//   input [7:0]    photon_y_0..3        unsigned; steps of 2^-6 block edge, in a frame of 4 block
//                                       edges
//   input [7:0]    photon_z_0..3        unsigned; steps of 2^-6 block edge, in a frame of 4 block
//                                       edges
//   input [15:0]   photon_red_0..3      unsigned; power units
//   input [15:0]   photon_green_0..3    unsigned; power units
//   input [15:0]   photon_blue_0..3     unsigned; power units
//   input          result_ready         the result is taken at this edge, if it is valid
//   output         query_ready          the query is taken at this edge, if it is valid
//   output         group_ready          the group is taken at this edge, if it is valid
//   output         result_valid         a result is on the result_ pins; it stays until it is taken
//   output [31:0]  result_red           sum of the powers in range, in power units
//   output [31:0]  result_green         sum of the powers in range, in power units
//   output [31:0]  result_blue          sum of the powers in range, in power units
//   output [31:0]  result_count         photons in range
//
// Protocol:
//   - A word is taken at a rising edge with valid and ready. A query may change until it is taken;
//     a group, once valid, must stay as it is until it is taken.
//   - A query, then its groups, of which the last has group_last, give one result; results come in
//     the order of the queries. A query has at least one group, which may be empty of photons.
//   - Ready pins depend on registers alone. A group is taken a clock after the machine began to
//     read it, so group_ready may rise only after group_valid.
//   - Reset needs one clock. No ready pin looks at it, so what is taken in that clock is lost; what
//     was under way is forgotten.
//   - No input is checked: with more than 65537 photons for a query, results are undefined.

module photoncube_overlap(clock, reset, query_valid, query_x, query_y, query_z,
    query_radius_sq, group_valid, group_last, photon_present_0, photon_present_1,
    photon_present_2, photon_present_3, photon_x_0, photon_x_1, photon_x_2, photon_x_3,
    photon_y_0, photon_y_1, photon_y_2, photon_y_3, photon_z_0, photon_z_1, photon_z_2,
    photon_z_3, photon_red_0, photon_red_1, photon_red_2, photon_red_3, photon_green_0,
    photon_green_1, photon_green_2, photon_green_3, photon_blue_0, photon_blue_1, photon_blue_2,
    photon_blue_3, result_ready, query_ready, group_ready, result_valid, result_red,
    result_green, result_blue, result_count);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire query_valid;
    input wire [7:0] query_x;
    input wire [7:0] query_y;
    input wire [7:0] query_z;
    input wire [17:0] query_radius_sq;
    input wire group_valid;
    input wire group_last;
    input wire photon_present_0;
    input wire photon_present_1;
    input wire photon_present_2;
    input wire photon_present_3;
    input wire [7:0] photon_x_0;
    input wire [7:0] photon_x_1;
    input wire [7:0] photon_x_2;
    input wire [7:0] photon_x_3;
    input wire [7:0] photon_y_0;
    input wire [7:0] photon_y_1;
    input wire [7:0] photon_y_2;
    input wire [7:0] photon_y_3;
    input wire [7:0] photon_z_0;
    input wire [7:0] photon_z_1;
    input wire [7:0] photon_z_2;
    input wire [7:0] photon_z_3;
    input wire [15:0] photon_red_0;
    input wire [15:0] photon_red_1;
    input wire [15:0] photon_red_2;
    input wire [15:0] photon_red_3;
    input wire [15:0] photon_green_0;
    input wire [15:0] photon_green_1;
    input wire [15:0] photon_green_2;
    input wire [15:0] photon_green_3;
    input wire [15:0] photon_blue_0;
    input wire [15:0] photon_blue_1;
    input wire [15:0] photon_blue_2;
    input wire [15:0] photon_blue_3;
    input wire result_ready;
    output reg query_ready;
    output reg group_ready;
    output reg result_valid;
    output reg [31:0] result_red;
    output reg [31:0] result_green;
    output reg [31:0] result_blue;
    output reg [31:0] result_count;
    // Constant declarations
    localparam one = 16'h1;
    // Stub signals
    reg control_clock;
    reg control_reset;
    reg control_query_valid;
    wire control_query_ready;
    reg control_group_valid;
    reg control_group_last;
    wire control_group_ready;
    wire control_result_valid;
    reg control_result_ready;
    wire control_write_query;
    wire control_group_taken;
    wire [22:0] control_to_x;
    wire [22:0] control_to_y;
    wire [22:0] control_to_z;
    wire [22:0] control_to_d;
    reg cell_0_clock;
    reg [22:0] cell_0_word;
    reg cell_0_write_query;
    reg [7:0] cell_0_query_in;
    reg [17:0] cell_0_radius_sq_in;
    reg [7:0] cell_0_photon_in;
    reg cell_0_present_in;
    reg [15:0] cell_0_power_in;
    reg [31:0] cell_0_link_x;
    reg [31:0] cell_0_link_y;
    reg [17:0] cell_0_link_z;
    reg [17:0] cell_0_link_w;
    wire [31:0] cell_0_sum_out;
    wire [17:0] cell_0_z_out;
    wire [17:0] cell_0_w_out;
    reg cell_1_clock;
    reg [22:0] cell_1_word;
    reg cell_1_write_query;
    reg [7:0] cell_1_query_in;
    reg [17:0] cell_1_radius_sq_in;
    reg [7:0] cell_1_photon_in;
    reg cell_1_present_in;
    reg [15:0] cell_1_power_in;
    reg [31:0] cell_1_link_x;
    reg [31:0] cell_1_link_y;
    reg [17:0] cell_1_link_z;
    reg [17:0] cell_1_link_w;
    wire [31:0] cell_1_sum_out;
    wire [17:0] cell_1_z_out;
    wire [17:0] cell_1_w_out;
    reg cell_2_clock;
    reg [22:0] cell_2_word;
    reg cell_2_write_query;
    reg [7:0] cell_2_query_in;
    reg [17:0] cell_2_radius_sq_in;
    reg [7:0] cell_2_photon_in;
    reg cell_2_present_in;
    reg [15:0] cell_2_power_in;
    reg [31:0] cell_2_link_x;
    reg [31:0] cell_2_link_y;
    reg [17:0] cell_2_link_z;
    reg [17:0] cell_2_link_w;
    wire [31:0] cell_2_sum_out;
    wire [17:0] cell_2_z_out;
    wire [17:0] cell_2_w_out;
    reg cell_3_clock;
    reg [22:0] cell_3_word;
    reg cell_3_write_query;
    reg [7:0] cell_3_query_in;
    reg [17:0] cell_3_radius_sq_in;
    reg [7:0] cell_3_photon_in;
    reg cell_3_present_in;
    reg [15:0] cell_3_power_in;
    reg [31:0] cell_3_link_x;
    reg [31:0] cell_3_link_y;
    reg [17:0] cell_3_link_z;
    reg [17:0] cell_3_link_w;
    wire [31:0] cell_3_sum_out;
    wire [17:0] cell_3_z_out;
    wire [17:0] cell_3_w_out;
    reg cell_4_clock;
    reg [22:0] cell_4_word;
    reg cell_4_write_query;
    reg [7:0] cell_4_query_in;
    reg [17:0] cell_4_radius_sq_in;
    reg [7:0] cell_4_photon_in;
    reg cell_4_present_in;
    reg [15:0] cell_4_power_in;
    reg [31:0] cell_4_link_x;
    reg [31:0] cell_4_link_y;
    reg [17:0] cell_4_link_z;
    reg [17:0] cell_4_link_w;
    wire [31:0] cell_4_sum_out;
    wire [17:0] cell_4_z_out;
    wire [17:0] cell_4_w_out;
    reg cell_5_clock;
    reg [22:0] cell_5_word;
    reg cell_5_write_query;
    reg [7:0] cell_5_query_in;
    reg [17:0] cell_5_radius_sq_in;
    reg [7:0] cell_5_photon_in;
    reg cell_5_present_in;
    reg [15:0] cell_5_power_in;
    reg [31:0] cell_5_link_x;
    reg [31:0] cell_5_link_y;
    reg [17:0] cell_5_link_z;
    reg [17:0] cell_5_link_w;
    wire [31:0] cell_5_sum_out;
    wire [17:0] cell_5_z_out;
    wire [17:0] cell_5_w_out;
    reg cell_6_clock;
    reg [22:0] cell_6_word;
    reg cell_6_write_query;
    reg [7:0] cell_6_query_in;
    reg [17:0] cell_6_radius_sq_in;
    reg [7:0] cell_6_photon_in;
    reg cell_6_present_in;
    reg [15:0] cell_6_power_in;
    reg [31:0] cell_6_link_x;
    reg [31:0] cell_6_link_y;
    reg [17:0] cell_6_link_z;
    reg [17:0] cell_6_link_w;
    wire [31:0] cell_6_sum_out;
    wire [17:0] cell_6_z_out;
    wire [17:0] cell_6_w_out;
    reg cell_7_clock;
    reg [22:0] cell_7_word;
    reg cell_7_write_query;
    reg [7:0] cell_7_query_in;
    reg [17:0] cell_7_radius_sq_in;
    reg [7:0] cell_7_photon_in;
    reg cell_7_present_in;
    reg [15:0] cell_7_power_in;
    reg [31:0] cell_7_link_x;
    reg [31:0] cell_7_link_y;
    reg [17:0] cell_7_link_z;
    reg [17:0] cell_7_link_w;
    wire [31:0] cell_7_sum_out;
    wire [17:0] cell_7_z_out;
    wire [17:0] cell_7_w_out;
    reg cell_8_clock;
    reg [22:0] cell_8_word;
    reg cell_8_write_query;
    reg [7:0] cell_8_query_in;
    reg [17:0] cell_8_radius_sq_in;
    reg [7:0] cell_8_photon_in;
    reg cell_8_present_in;
    reg [15:0] cell_8_power_in;
    reg [31:0] cell_8_link_x;
    reg [31:0] cell_8_link_y;
    reg [17:0] cell_8_link_z;
    reg [17:0] cell_8_link_w;
    wire [31:0] cell_8_sum_out;
    wire [17:0] cell_8_z_out;
    wire [17:0] cell_8_w_out;
    reg cell_9_clock;
    reg [22:0] cell_9_word;
    reg cell_9_write_query;
    reg [7:0] cell_9_query_in;
    reg [17:0] cell_9_radius_sq_in;
    reg [7:0] cell_9_photon_in;
    reg cell_9_present_in;
    reg [15:0] cell_9_power_in;
    reg [31:0] cell_9_link_x;
    reg [31:0] cell_9_link_y;
    reg [17:0] cell_9_link_z;
    reg [17:0] cell_9_link_w;
    wire [31:0] cell_9_sum_out;
    wire [17:0] cell_9_z_out;
    wire [17:0] cell_9_w_out;
    reg cell_10_clock;
    reg [22:0] cell_10_word;
    reg cell_10_write_query;
    reg [7:0] cell_10_query_in;
    reg [17:0] cell_10_radius_sq_in;
    reg [7:0] cell_10_photon_in;
    reg cell_10_present_in;
    reg [15:0] cell_10_power_in;
    reg [31:0] cell_10_link_x;
    reg [31:0] cell_10_link_y;
    reg [17:0] cell_10_link_z;
    reg [17:0] cell_10_link_w;
    wire [31:0] cell_10_sum_out;
    wire [17:0] cell_10_z_out;
    wire [17:0] cell_10_w_out;
    reg cell_11_clock;
    reg [22:0] cell_11_word;
    reg cell_11_write_query;
    reg [7:0] cell_11_query_in;
    reg [17:0] cell_11_radius_sq_in;
    reg [7:0] cell_11_photon_in;
    reg cell_11_present_in;
    reg [15:0] cell_11_power_in;
    reg [31:0] cell_11_link_x;
    reg [31:0] cell_11_link_y;
    reg [17:0] cell_11_link_z;
    reg [17:0] cell_11_link_w;
    wire [31:0] cell_11_sum_out;
    wire [17:0] cell_11_z_out;
    wire [17:0] cell_11_w_out;
    reg cell_12_clock;
    reg [22:0] cell_12_word;
    reg cell_12_write_query;
    reg [7:0] cell_12_query_in;
    reg [17:0] cell_12_radius_sq_in;
    reg [7:0] cell_12_photon_in;
    reg cell_12_present_in;
    reg [15:0] cell_12_power_in;
    reg [31:0] cell_12_link_x;
    reg [31:0] cell_12_link_y;
    reg [17:0] cell_12_link_z;
    reg [17:0] cell_12_link_w;
    wire [31:0] cell_12_sum_out;
    wire [17:0] cell_12_z_out;
    wire [17:0] cell_12_w_out;
    reg cell_13_clock;
    reg [22:0] cell_13_word;
    reg cell_13_write_query;
    reg [7:0] cell_13_query_in;
    reg [17:0] cell_13_radius_sq_in;
    reg [7:0] cell_13_photon_in;
    reg cell_13_present_in;
    reg [15:0] cell_13_power_in;
    reg [31:0] cell_13_link_x;
    reg [31:0] cell_13_link_y;
    reg [17:0] cell_13_link_z;
    reg [17:0] cell_13_link_w;
    wire [31:0] cell_13_sum_out;
    wire [17:0] cell_13_z_out;
    wire [17:0] cell_13_w_out;
    reg cell_14_clock;
    reg [22:0] cell_14_word;
    reg cell_14_write_query;
    reg [7:0] cell_14_query_in;
    reg [17:0] cell_14_radius_sq_in;
    reg [7:0] cell_14_photon_in;
    reg cell_14_present_in;
    reg [15:0] cell_14_power_in;
    reg [31:0] cell_14_link_x;
    reg [31:0] cell_14_link_y;
    reg [17:0] cell_14_link_z;
    reg [17:0] cell_14_link_w;
    wire [31:0] cell_14_sum_out;
    wire [17:0] cell_14_z_out;
    wire [17:0] cell_14_w_out;
    reg cell_15_clock;
    reg [22:0] cell_15_word;
    reg cell_15_write_query;
    reg [7:0] cell_15_query_in;
    reg [17:0] cell_15_radius_sq_in;
    reg [7:0] cell_15_photon_in;
    reg cell_15_present_in;
    reg [15:0] cell_15_power_in;
    reg [31:0] cell_15_link_x;
    reg [31:0] cell_15_link_y;
    reg [17:0] cell_15_link_z;
    reg [17:0] cell_15_link_w;
    wire [31:0] cell_15_sum_out;
    wire [17:0] cell_15_z_out;
    wire [17:0] cell_15_w_out;
    // Local signals
    reg present_0;
    reg present_1;
    reg present_2;
    reg present_3;
    // Sub module instances
    photoncube_overlap_control control(
        .clock(control_clock),
        .reset(control_reset),
        .query_valid(control_query_valid),
        .query_ready(control_query_ready),
        .group_valid(control_group_valid),
        .group_last(control_group_last),
        .group_ready(control_group_ready),
        .result_valid(control_result_valid),
        .result_ready(control_result_ready),
        .write_query(control_write_query),
        .group_taken(control_group_taken),
        .to_x(control_to_x),
        .to_y(control_to_y),
        .to_z(control_to_z),
        .to_d(control_to_d)
    );
    photoncube_overlap_cell cell_0(
        .clock(cell_0_clock),
        .word(cell_0_word),
        .write_query(cell_0_write_query),
        .query_in(cell_0_query_in),
        .radius_sq_in(cell_0_radius_sq_in),
        .photon_in(cell_0_photon_in),
        .present_in(cell_0_present_in),
        .power_in(cell_0_power_in),
        .link_x(cell_0_link_x),
        .link_y(cell_0_link_y),
        .link_z(cell_0_link_z),
        .link_w(cell_0_link_w),
        .sum_out(cell_0_sum_out),
        .z_out(cell_0_z_out),
        .w_out(cell_0_w_out)
    );
    photoncube_overlap_cell cell_1(
        .clock(cell_1_clock),
        .word(cell_1_word),
        .write_query(cell_1_write_query),
        .query_in(cell_1_query_in),
        .radius_sq_in(cell_1_radius_sq_in),
        .photon_in(cell_1_photon_in),
        .present_in(cell_1_present_in),
        .power_in(cell_1_power_in),
        .link_x(cell_1_link_x),
        .link_y(cell_1_link_y),
        .link_z(cell_1_link_z),
        .link_w(cell_1_link_w),
        .sum_out(cell_1_sum_out),
        .z_out(cell_1_z_out),
        .w_out(cell_1_w_out)
    );
    photoncube_overlap_cell cell_2(
        .clock(cell_2_clock),
        .word(cell_2_word),
        .write_query(cell_2_write_query),
        .query_in(cell_2_query_in),
        .radius_sq_in(cell_2_radius_sq_in),
        .photon_in(cell_2_photon_in),
        .present_in(cell_2_present_in),
        .power_in(cell_2_power_in),
        .link_x(cell_2_link_x),
        .link_y(cell_2_link_y),
        .link_z(cell_2_link_z),
        .link_w(cell_2_link_w),
        .sum_out(cell_2_sum_out),
        .z_out(cell_2_z_out),
        .w_out(cell_2_w_out)
    );
    photoncube_overlap_cell cell_3(
        .clock(cell_3_clock),
        .word(cell_3_word),
        .write_query(cell_3_write_query),
        .query_in(cell_3_query_in),
        .radius_sq_in(cell_3_radius_sq_in),
        .photon_in(cell_3_photon_in),
        .present_in(cell_3_present_in),
        .power_in(cell_3_power_in),
        .link_x(cell_3_link_x),
        .link_y(cell_3_link_y),
        .link_z(cell_3_link_z),
        .link_w(cell_3_link_w),
        .sum_out(cell_3_sum_out),
        .z_out(cell_3_z_out),
        .w_out(cell_3_w_out)
    );
    photoncube_overlap_cell cell_4(
        .clock(cell_4_clock),
        .word(cell_4_word),
        .write_query(cell_4_write_query),
        .query_in(cell_4_query_in),
        .radius_sq_in(cell_4_radius_sq_in),
        .photon_in(cell_4_photon_in),
        .present_in(cell_4_present_in),
        .power_in(cell_4_power_in),
        .link_x(cell_4_link_x),
        .link_y(cell_4_link_y),
        .link_z(cell_4_link_z),
        .link_w(cell_4_link_w),
        .sum_out(cell_4_sum_out),
        .z_out(cell_4_z_out),
        .w_out(cell_4_w_out)
    );
    photoncube_overlap_cell cell_5(
        .clock(cell_5_clock),
        .word(cell_5_word),
        .write_query(cell_5_write_query),
        .query_in(cell_5_query_in),
        .radius_sq_in(cell_5_radius_sq_in),
        .photon_in(cell_5_photon_in),
        .present_in(cell_5_present_in),
        .power_in(cell_5_power_in),
        .link_x(cell_5_link_x),
        .link_y(cell_5_link_y),
        .link_z(cell_5_link_z),
        .link_w(cell_5_link_w),
        .sum_out(cell_5_sum_out),
        .z_out(cell_5_z_out),
        .w_out(cell_5_w_out)
    );
    photoncube_overlap_cell cell_6(
        .clock(cell_6_clock),
        .word(cell_6_word),
        .write_query(cell_6_write_query),
        .query_in(cell_6_query_in),
        .radius_sq_in(cell_6_radius_sq_in),
        .photon_in(cell_6_photon_in),
        .present_in(cell_6_present_in),
        .power_in(cell_6_power_in),
        .link_x(cell_6_link_x),
        .link_y(cell_6_link_y),
        .link_z(cell_6_link_z),
        .link_w(cell_6_link_w),
        .sum_out(cell_6_sum_out),
        .z_out(cell_6_z_out),
        .w_out(cell_6_w_out)
    );
    photoncube_overlap_cell cell_7(
        .clock(cell_7_clock),
        .word(cell_7_word),
        .write_query(cell_7_write_query),
        .query_in(cell_7_query_in),
        .radius_sq_in(cell_7_radius_sq_in),
        .photon_in(cell_7_photon_in),
        .present_in(cell_7_present_in),
        .power_in(cell_7_power_in),
        .link_x(cell_7_link_x),
        .link_y(cell_7_link_y),
        .link_z(cell_7_link_z),
        .link_w(cell_7_link_w),
        .sum_out(cell_7_sum_out),
        .z_out(cell_7_z_out),
        .w_out(cell_7_w_out)
    );
    photoncube_overlap_cell cell_8(
        .clock(cell_8_clock),
        .word(cell_8_word),
        .write_query(cell_8_write_query),
        .query_in(cell_8_query_in),
        .radius_sq_in(cell_8_radius_sq_in),
        .photon_in(cell_8_photon_in),
        .present_in(cell_8_present_in),
        .power_in(cell_8_power_in),
        .link_x(cell_8_link_x),
        .link_y(cell_8_link_y),
        .link_z(cell_8_link_z),
        .link_w(cell_8_link_w),
        .sum_out(cell_8_sum_out),
        .z_out(cell_8_z_out),
        .w_out(cell_8_w_out)
    );
    photoncube_overlap_cell cell_9(
        .clock(cell_9_clock),
        .word(cell_9_word),
        .write_query(cell_9_write_query),
        .query_in(cell_9_query_in),
        .radius_sq_in(cell_9_radius_sq_in),
        .photon_in(cell_9_photon_in),
        .present_in(cell_9_present_in),
        .power_in(cell_9_power_in),
        .link_x(cell_9_link_x),
        .link_y(cell_9_link_y),
        .link_z(cell_9_link_z),
        .link_w(cell_9_link_w),
        .sum_out(cell_9_sum_out),
        .z_out(cell_9_z_out),
        .w_out(cell_9_w_out)
    );
    photoncube_overlap_cell cell_10(
        .clock(cell_10_clock),
        .word(cell_10_word),
        .write_query(cell_10_write_query),
        .query_in(cell_10_query_in),
        .radius_sq_in(cell_10_radius_sq_in),
        .photon_in(cell_10_photon_in),
        .present_in(cell_10_present_in),
        .power_in(cell_10_power_in),
        .link_x(cell_10_link_x),
        .link_y(cell_10_link_y),
        .link_z(cell_10_link_z),
        .link_w(cell_10_link_w),
        .sum_out(cell_10_sum_out),
        .z_out(cell_10_z_out),
        .w_out(cell_10_w_out)
    );
    photoncube_overlap_cell cell_11(
        .clock(cell_11_clock),
        .word(cell_11_word),
        .write_query(cell_11_write_query),
        .query_in(cell_11_query_in),
        .radius_sq_in(cell_11_radius_sq_in),
        .photon_in(cell_11_photon_in),
        .present_in(cell_11_present_in),
        .power_in(cell_11_power_in),
        .link_x(cell_11_link_x),
        .link_y(cell_11_link_y),
        .link_z(cell_11_link_z),
        .link_w(cell_11_link_w),
        .sum_out(cell_11_sum_out),
        .z_out(cell_11_z_out),
        .w_out(cell_11_w_out)
    );
    photoncube_overlap_cell cell_12(
        .clock(cell_12_clock),
        .word(cell_12_word),
        .write_query(cell_12_write_query),
        .query_in(cell_12_query_in),
        .radius_sq_in(cell_12_radius_sq_in),
        .photon_in(cell_12_photon_in),
        .present_in(cell_12_present_in),
        .power_in(cell_12_power_in),
        .link_x(cell_12_link_x),
        .link_y(cell_12_link_y),
        .link_z(cell_12_link_z),
        .link_w(cell_12_link_w),
        .sum_out(cell_12_sum_out),
        .z_out(cell_12_z_out),
        .w_out(cell_12_w_out)
    );
    photoncube_overlap_cell cell_13(
        .clock(cell_13_clock),
        .word(cell_13_word),
        .write_query(cell_13_write_query),
        .query_in(cell_13_query_in),
        .radius_sq_in(cell_13_radius_sq_in),
        .photon_in(cell_13_photon_in),
        .present_in(cell_13_present_in),
        .power_in(cell_13_power_in),
        .link_x(cell_13_link_x),
        .link_y(cell_13_link_y),
        .link_z(cell_13_link_z),
        .link_w(cell_13_link_w),
        .sum_out(cell_13_sum_out),
        .z_out(cell_13_z_out),
        .w_out(cell_13_w_out)
    );
    photoncube_overlap_cell cell_14(
        .clock(cell_14_clock),
        .word(cell_14_word),
        .write_query(cell_14_write_query),
        .query_in(cell_14_query_in),
        .radius_sq_in(cell_14_radius_sq_in),
        .photon_in(cell_14_photon_in),
        .present_in(cell_14_present_in),
        .power_in(cell_14_power_in),
        .link_x(cell_14_link_x),
        .link_y(cell_14_link_y),
        .link_z(cell_14_link_z),
        .link_w(cell_14_link_w),
        .sum_out(cell_14_sum_out),
        .z_out(cell_14_z_out),
        .w_out(cell_14_w_out)
    );
    photoncube_overlap_cell cell_15(
        .clock(cell_15_clock),
        .word(cell_15_word),
        .write_query(cell_15_write_query),
        .query_in(cell_15_query_in),
        .radius_sq_in(cell_15_radius_sq_in),
        .photon_in(cell_15_photon_in),
        .present_in(cell_15_present_in),
        .power_in(cell_15_power_in),
        .link_x(cell_15_link_x),
        .link_y(cell_15_link_y),
        .link_z(cell_15_link_z),
        .link_w(cell_15_link_w),
        .sum_out(cell_15_sum_out),
        .z_out(cell_15_z_out),
        .w_out(cell_15_w_out)
    );
    // Update code
    always @(*) begin
        control_clock = clock;
        control_reset = reset;
        control_query_valid = query_valid;
        control_group_valid = group_valid;
        control_group_last = group_last;
        control_result_ready = result_ready;
        query_ready = control_query_ready;
        group_ready = control_group_ready;
        result_valid = control_result_valid;
        cell_0_clock = clock;
        cell_0_write_query = control_write_query;
        cell_0_radius_sq_in = query_radius_sq;
        cell_0_link_x = cell_1_sum_out;
        cell_0_link_y = cell_2_sum_out;
        cell_0_link_z = cell_4_z_out;
        cell_0_link_w = cell_8_w_out;
        cell_1_clock = clock;
        cell_1_write_query = control_write_query;
        cell_1_radius_sq_in = query_radius_sq;
        cell_1_link_x = cell_0_sum_out;
        cell_1_link_y = cell_3_sum_out;
        cell_1_link_z = cell_5_z_out;
        cell_1_link_w = cell_9_w_out;
        cell_2_clock = clock;
        cell_2_write_query = control_write_query;
        cell_2_radius_sq_in = query_radius_sq;
        cell_2_link_x = cell_3_sum_out;
        cell_2_link_y = cell_0_sum_out;
        cell_2_link_z = cell_6_z_out;
        cell_2_link_w = cell_10_w_out;
        cell_3_clock = clock;
        cell_3_write_query = control_write_query;
        cell_3_radius_sq_in = query_radius_sq;
        cell_3_link_x = cell_2_sum_out;
        cell_3_link_y = cell_1_sum_out;
        cell_3_link_z = cell_7_z_out;
        cell_3_link_w = cell_11_w_out;
        cell_4_clock = clock;
        cell_4_write_query = control_write_query;
        cell_4_radius_sq_in = query_radius_sq;
        cell_4_link_x = cell_5_sum_out;
        cell_4_link_y = cell_6_sum_out;
        cell_4_link_z = cell_0_z_out;
        cell_4_link_w = cell_12_w_out;
        cell_5_clock = clock;
        cell_5_write_query = control_write_query;
        cell_5_radius_sq_in = query_radius_sq;
        cell_5_link_x = cell_4_sum_out;
        cell_5_link_y = cell_7_sum_out;
        cell_5_link_z = cell_1_z_out;
        cell_5_link_w = cell_13_w_out;
        cell_6_clock = clock;
        cell_6_write_query = control_write_query;
        cell_6_radius_sq_in = query_radius_sq;
        cell_6_link_x = cell_7_sum_out;
        cell_6_link_y = cell_4_sum_out;
        cell_6_link_z = cell_2_z_out;
        cell_6_link_w = cell_14_w_out;
        cell_7_clock = clock;
        cell_7_write_query = control_write_query;
        cell_7_radius_sq_in = query_radius_sq;
        cell_7_link_x = cell_6_sum_out;
        cell_7_link_y = cell_5_sum_out;
        cell_7_link_z = cell_3_z_out;
        cell_7_link_w = cell_15_w_out;
        cell_8_clock = clock;
        cell_8_write_query = control_write_query;
        cell_8_radius_sq_in = query_radius_sq;
        cell_8_link_x = cell_9_sum_out;
        cell_8_link_y = cell_10_sum_out;
        cell_8_link_z = cell_12_z_out;
        cell_8_link_w = cell_0_w_out;
        cell_9_clock = clock;
        cell_9_write_query = control_write_query;
        cell_9_radius_sq_in = query_radius_sq;
        cell_9_link_x = cell_8_sum_out;
        cell_9_link_y = cell_11_sum_out;
        cell_9_link_z = cell_13_z_out;
        cell_9_link_w = cell_1_w_out;
        cell_10_clock = clock;
        cell_10_write_query = control_write_query;
        cell_10_radius_sq_in = query_radius_sq;
        cell_10_link_x = cell_11_sum_out;
        cell_10_link_y = cell_8_sum_out;
        cell_10_link_z = cell_14_z_out;
        cell_10_link_w = cell_2_w_out;
        cell_11_clock = clock;
        cell_11_write_query = control_write_query;
        cell_11_radius_sq_in = query_radius_sq;
        cell_11_link_x = cell_10_sum_out;
        cell_11_link_y = cell_9_sum_out;
        cell_11_link_z = cell_15_z_out;
        cell_11_link_w = cell_3_w_out;
        cell_12_clock = clock;
        cell_12_write_query = control_write_query;
        cell_12_radius_sq_in = query_radius_sq;
        cell_12_link_x = cell_13_sum_out;
        cell_12_link_y = cell_14_sum_out;
        cell_12_link_z = cell_8_z_out;
        cell_12_link_w = cell_4_w_out;
        cell_13_clock = clock;
        cell_13_write_query = control_write_query;
        cell_13_radius_sq_in = query_radius_sq;
        cell_13_link_x = cell_12_sum_out;
        cell_13_link_y = cell_15_sum_out;
        cell_13_link_z = cell_9_z_out;
        cell_13_link_w = cell_5_w_out;
        cell_14_clock = clock;
        cell_14_write_query = control_write_query;
        cell_14_radius_sq_in = query_radius_sq;
        cell_14_link_x = cell_15_sum_out;
        cell_14_link_y = cell_12_sum_out;
        cell_14_link_z = cell_10_z_out;
        cell_14_link_w = cell_6_w_out;
        cell_15_clock = clock;
        cell_15_write_query = control_write_query;
        cell_15_radius_sq_in = query_radius_sq;
        cell_15_link_x = cell_14_sum_out;
        cell_15_link_y = cell_13_sum_out;
        cell_15_link_z = cell_11_z_out;
        cell_15_link_w = cell_7_w_out;
        present_0 = control_group_taken & photon_present_0;
        cell_0_word = control_to_x;
        cell_0_query_in = query_x;
        cell_0_photon_in = photon_x_0;
        cell_0_power_in = photon_red_0;
        cell_0_present_in = present_0;
        cell_4_word = control_to_y;
        cell_4_query_in = query_y;
        cell_4_photon_in = photon_y_0;
        cell_4_power_in = photon_green_0;
        cell_4_present_in = present_0;
        cell_8_word = control_to_z;
        cell_8_query_in = query_z;
        cell_8_photon_in = photon_z_0;
        cell_8_power_in = photon_blue_0;
        cell_8_present_in = present_0;
        cell_12_word = control_to_d;
        cell_12_query_in = query_z;
        cell_12_photon_in = photon_z_0;
        cell_12_power_in = one;
        cell_12_present_in = present_0;
        present_1 = control_group_taken & photon_present_1;
        cell_1_word = control_to_x;
        cell_1_query_in = query_x;
        cell_1_photon_in = photon_x_1;
        cell_1_power_in = photon_red_1;
        cell_1_present_in = present_1;
        cell_5_word = control_to_y;
        cell_5_query_in = query_y;
        cell_5_photon_in = photon_y_1;
        cell_5_power_in = photon_green_1;
        cell_5_present_in = present_1;
        cell_9_word = control_to_z;
        cell_9_query_in = query_z;
        cell_9_photon_in = photon_z_1;
        cell_9_power_in = photon_blue_1;
        cell_9_present_in = present_1;
        cell_13_word = control_to_d;
        cell_13_query_in = query_z;
        cell_13_photon_in = photon_z_1;
        cell_13_power_in = one;
        cell_13_present_in = present_1;
        present_2 = control_group_taken & photon_present_2;
        cell_2_word = control_to_x;
        cell_2_query_in = query_x;
        cell_2_photon_in = photon_x_2;
        cell_2_power_in = photon_red_2;
        cell_2_present_in = present_2;
        cell_6_word = control_to_y;
        cell_6_query_in = query_y;
        cell_6_photon_in = photon_y_2;
        cell_6_power_in = photon_green_2;
        cell_6_present_in = present_2;
        cell_10_word = control_to_z;
        cell_10_query_in = query_z;
        cell_10_photon_in = photon_z_2;
        cell_10_power_in = photon_blue_2;
        cell_10_present_in = present_2;
        cell_14_word = control_to_d;
        cell_14_query_in = query_z;
        cell_14_photon_in = photon_z_2;
        cell_14_power_in = one;
        cell_14_present_in = present_2;
        present_3 = control_group_taken & photon_present_3;
        cell_3_word = control_to_x;
        cell_3_query_in = query_x;
        cell_3_photon_in = photon_x_3;
        cell_3_power_in = photon_red_3;
        cell_3_present_in = present_3;
        cell_7_word = control_to_y;
        cell_7_query_in = query_y;
        cell_7_photon_in = photon_y_3;
        cell_7_power_in = photon_green_3;
        cell_7_present_in = present_3;
        cell_11_word = control_to_z;
        cell_11_query_in = query_z;
        cell_11_photon_in = photon_z_3;
        cell_11_power_in = photon_blue_3;
        cell_11_present_in = present_3;
        cell_15_word = control_to_d;
        cell_15_query_in = query_z;
        cell_15_photon_in = photon_z_3;
        cell_15_power_in = one;
        cell_15_present_in = present_3;
        result_red = cell_0_sum_out;
        result_green = cell_4_sum_out;
        result_blue = cell_8_sum_out;
        result_count = cell_12_sum_out;
    end
endmodule

module photoncube_overlap_control(clock, reset, query_valid, query_ready, group_valid,
    group_last, group_ready, result_valid, result_ready, write_query, group_taken, to_x, to_y,
    to_z, to_d);
    // Module arguments
    input wire clock;
    input wire reset;
    input wire query_valid;
    output reg query_ready;
    input wire group_valid;
    input wire group_last;
    output reg group_ready;
    output reg result_valid;
    input wire result_ready;
    output reg write_query;
    output reg group_taken;
    output reg [22:0] to_x;
    output reg [22:0] to_y;
    output reg [22:0] to_z;
    output reg [22:0] to_d;
    // Constant declarations
    localparam kernel_end = 3'b10;
    localparam epilogue_address = 3'b11;
    localparam end_address = 3'b111;
    localparam drain_end = 4'hb;
    // Stub signals
    reg [2:0] address_d;
    wire [2:0] address_q;
    reg address_clock;
    reg occupied_d;
    wire occupied_q;
    reg occupied_clock;
    reg last_d;
    wire last_q;
    reg last_clock;
    reg [3:0] drain_d;
    wire [3:0] drain_q;
    reg drain_clock;
    reg done_d;
    wire done_q;
    reg done_clock;
    reg [22:0] word_x_d;
    wire [22:0] word_x_q;
    reg word_x_clock;
    reg [22:0] word_y_d;
    wire [22:0] word_y_q;
    reg word_y_clock;
    reg [22:0] word_z_d;
    wire [22:0] word_z_q;
    reg word_z_clock;
    reg [22:0] word_d_d;
    wire [22:0] word_d_q;
    reg word_d_clock;
    reg [2:0] store_x_address;
    wire [22:0] store_x_word;
    reg [2:0] store_y_address;
    wire [22:0] store_y_word;
    reg [2:0] store_z_address;
    wire [22:0] store_z_word;
    reg [2:0] store_d_address;
    wire [22:0] store_d_word;
    reg [22:0] decoder_word;
    wire decoder_write_photon;
    wire decoder_write_power;
    wire [6:0] decoder_move_power;
    wire decoder_write_square;
    wire decoder_write_work;
    wire decoder_write_sum;
    wire decoder_write_distance;
    wire [1:0] decoder_distance_source;
    wire [3:0] decoder_axis;
    wire decoder_gate;
    wire decoder_add_sum;
    wire decoder_send_work;
    wire decoder_send_distance;
    // Local signals
    reg accepts;
    reg takes_query;
    reg accepts_group;
    reg takes_group;
    reg takes_last;
    reg drain_ends;
    reg drained;
    reg kernel_ends;
    reg is_at_end;
    reg is_at_work;
    reg works;
    reg fetches;
    reg taken;
    // Sub module instances
    photoncube_overlap_register_3 address(
        .d(address_d),
        .q(address_q),
        .clock(address_clock)
    );
    photoncube_overlap_register_1 occupied(
        .d(occupied_d),
        .q(occupied_q),
        .clock(occupied_clock)
    );
    photoncube_overlap_register_1 last(
        .d(last_d),
        .q(last_q),
        .clock(last_clock)
    );
    photoncube_overlap_register_4 drain(
        .d(drain_d),
        .q(drain_q),
        .clock(drain_clock)
    );
    photoncube_overlap_register_1 done(
        .d(done_d),
        .q(done_q),
        .clock(done_clock)
    );
    photoncube_overlap_register_23 word_x(
        .d(word_x_d),
        .q(word_x_q),
        .clock(word_x_clock)
    );
    photoncube_overlap_register_23 word_y(
        .d(word_y_d),
        .q(word_y_q),
        .clock(word_y_clock)
    );
    photoncube_overlap_register_23 word_z(
        .d(word_z_d),
        .q(word_z_q),
        .clock(word_z_clock)
    );
    photoncube_overlap_register_23 word_d(
        .d(word_d_d),
        .q(word_d_q),
        .clock(word_d_clock)
    );
    photoncube_overlap_store_x store_x(
        .address(store_x_address),
        .word(store_x_word)
    );
    photoncube_overlap_store_y store_y(
        .address(store_y_address),
        .word(store_y_word)
    );
    photoncube_overlap_store_z store_z(
        .address(store_z_address),
        .word(store_z_word)
    );
    photoncube_overlap_store_d store_d(
        .address(store_d_address),
        .word(store_d_word)
    );
    photoncube_overlap_decoder decoder(
        .word(decoder_word),
        .write_photon(decoder_write_photon),
        .write_power(decoder_write_power),
        .move_power(decoder_move_power),
        .write_square(decoder_write_square),
        .write_work(decoder_write_work),
        .write_sum(decoder_write_sum),
        .write_distance(decoder_write_distance),
        .distance_source(decoder_distance_source),
        .axis(decoder_axis),
        .gate(decoder_gate),
        .add_sum(decoder_add_sum),
        .send_work(decoder_send_work),
        .send_distance(decoder_send_distance)
    );
    // Update code
    always @(*) begin
        address_clock = clock;
        occupied_clock = clock;
        last_clock = clock;
        drain_clock = clock;
        done_clock = clock;
        word_x_clock = clock;
        word_y_clock = clock;
        word_z_clock = clock;
        word_d_clock = clock;
        address_d = address_q;
        occupied_d = occupied_q;
        last_d = last_q;
        drain_d = drain_q;
        done_d = done_q;
        word_x_d = word_x_q;
        word_y_d = word_y_q;
        word_z_d = word_z_q;
        word_d_d = word_d_q;
        decoder_word = word_x_q;
        to_x = word_x_q;
        to_y = word_y_q;
        to_z = word_z_q;
        to_d = word_d_q;
        accepts = ~occupied_q;
        takes_query = accepts & query_valid;
        query_ready = accepts;
        write_query = accepts;
        accepts_group = decoder_write_power & ~last_q;
        takes_group = accepts_group & group_valid;
        takes_last = takes_group & group_last;
        group_ready = accepts_group;
        group_taken = takes_group;
        result_valid = done_q;
        if (last_q) begin
            drain_d = drain_q + 32'h1;
        end
        if (takes_last) begin
            last_d = 1'b1;
            drain_d = 32'h0;
        end
        drain_ends = drain_q == drain_end;
        drained = drain_ends & last_q;
        kernel_ends = address_q == kernel_end;
        is_at_end = address_q == end_address;
        taken = done_q & result_ready;
        if (taken) begin
            done_d = 1'b0;
            occupied_d = 1'b0;
        end
        is_at_work = occupied_q & ~done_q;
        works = is_at_work | takes_query;
        if (works) begin
            occupied_d = 1'b1;
            address_d = address_q + 32'h1;
            if (kernel_ends) begin
                address_d = 32'h0;
            end
            if (drained) begin
                address_d = epilogue_address;
            end
            if (is_at_end) begin
                address_d = 32'h0;
                last_d = 1'b0;
                done_d = 1'b1;
            end
        end
        store_x_address = address_q;
        store_y_address = address_q;
        store_z_address = address_q;
        store_d_address = address_q;
        fetches = works & ~reset;
        word_x_d = 32'h0;
        word_y_d = 32'h0;
        word_z_d = 32'h0;
        word_d_d = 32'h0;
        if (fetches) begin
            word_x_d = store_x_word;
            word_y_d = store_y_word;
            word_z_d = store_z_word;
            word_d_d = store_d_word;
        end
        if (reset) begin
            address_d = 32'h0;
            occupied_d = 1'b0;
            last_d = 1'b0;
            drain_d = 32'h0;
            done_d = 1'b0;
        end
    end
endmodule

module photoncube_overlap_cell(clock, word, write_query, query_in, radius_sq_in, photon_in,
    present_in, power_in, link_x, link_y, link_z, link_w, sum_out, z_out, w_out);
    // Module arguments
    input wire clock;
    input wire [22:0] word;
    input wire write_query;
    input wire [7:0] query_in;
    input wire [17:0] radius_sq_in;
    input wire [7:0] photon_in;
    input wire present_in;
    input wire [15:0] power_in;
    input wire [31:0] link_x;
    input wire [31:0] link_y;
    input wire [17:0] link_z;
    input wire [17:0] link_w;
    output reg [31:0] sum_out;
    output reg [17:0] z_out;
    output reg [17:0] w_out;
    // Stub signals
    reg [7:0] query_d;
    wire [7:0] query_q;
    reg query_clock;
    reg [17:0] radius_sq_d;
    wire [17:0] radius_sq_q;
    reg radius_sq_clock;
    reg [7:0] photon_d;
    wire [7:0] photon_q;
    reg photon_clock;
    reg [7:0] magnitude_d;
    wire [7:0] magnitude_q;
    reg magnitude_clock;
    reg [15:0] digit_squares_d;
    wire [15:0] digit_squares_q;
    reg digit_squares_clock;
    reg [5:0] low_product_d;
    wire [5:0] low_product_q;
    reg low_product_clock;
    reg [5:0] high_product_d;
    wire [5:0] high_product_q;
    reg high_product_clock;
    reg [15:0] square_d;
    wire [15:0] square_q;
    reg square_clock;
    reg [15:0] addend_d;
    wire [15:0] addend_q;
    reg addend_clock;
    reg [31:0] operand_d;
    wire [31:0] operand_q;
    reg operand_clock;
    reg [17:0] work_d;
    wire [17:0] work_q;
    reg work_clock;
    reg [17:0] distance_d;
    wire [17:0] distance_q;
    reg distance_clock;
    reg in_range_d;
    wire in_range_q;
    reg in_range_clock;
    reg [31:0] sum_d;
    wire [31:0] sum_q;
    reg sum_clock;
    reg [15:0] power_0_d;
    wire [15:0] power_0_q;
    reg power_0_clock;
    reg [15:0] power_1_d;
    wire [15:0] power_1_q;
    reg power_1_clock;
    reg [15:0] power_2_d;
    wire [15:0] power_2_q;
    reg power_2_clock;
    reg [15:0] power_3_d;
    wire [15:0] power_3_q;
    reg power_3_clock;
    reg [15:0] power_4_d;
    wire [15:0] power_4_q;
    reg power_4_clock;
    reg [15:0] power_5_d;
    wire [15:0] power_5_q;
    reg power_5_clock;
    reg [15:0] power_6_d;
    wire [15:0] power_6_q;
    reg power_6_clock;
    reg [15:0] power_7_d;
    wire [15:0] power_7_q;
    reg power_7_clock;
    reg present_0_d;
    wire present_0_q;
    reg present_0_clock;
    reg present_1_d;
    wire present_1_q;
    reg present_1_clock;
    reg present_2_d;
    wire present_2_q;
    reg present_2_clock;
    reg present_3_d;
    wire present_3_q;
    reg present_3_clock;
    reg present_4_d;
    wire present_4_q;
    reg present_4_clock;
    reg present_5_d;
    wire present_5_q;
    reg present_5_clock;
    reg present_6_d;
    wire present_6_q;
    reg present_6_clock;
    reg present_7_d;
    wire present_7_q;
    reg present_7_clock;
    reg [22:0] decoder_word;
    wire decoder_write_photon;
    wire decoder_write_power;
    wire [6:0] decoder_move_power;
    wire decoder_write_square;
    wire decoder_write_work;
    wire decoder_write_sum;
    wire decoder_write_distance;
    wire [1:0] decoder_distance_source;
    wire [3:0] decoder_axis;
    wire decoder_gate;
    wire decoder_add_sum;
    wire decoder_send_work;
    wire decoder_send_distance;
    reg [7:0] difference_a;
    reg [7:0] difference_b;
    wire [7:0] difference_magnitude;
    reg [7:0] digits_root;
    wire [15:0] digits_squares;
    wire [5:0] digits_low_product;
    wire [5:0] digits_high_product;
    reg [31:0] chosen_sum_sum;
    reg [17:0] chosen_sum_sum_low;
    reg [15:0] chosen_sum_addend;
    reg [31:0] chosen_sum_operand;
    reg chosen_sum_add_sum;
    wire [31:0] chosen_sum_total;
    // Local signals
    reg [15:0] wide_low;
    reg [15:0] wide_high;
    reg [15:0] shifted_low;
    reg [15:0] shifted_high;
    reg [15:0] products;
    reg [15:0] new_square;
    reg [17:0] wide_square;
    reg [31:0] from_x;
    reg [31:0] from_y;
    reg [17:0] from_z;
    reg [17:0] from_w;
    reg [17:0] wide_radius_sq;
    reg in_range_now;
    reg is_there;
    reg opens;
    reg [17:0] wide_power;
    reg [17:0] from_gate;
    reg [17:0] from_role_axes;
    reg [31:0] from_photon_axes;
    reg [17:0] from_quad;
    reg [31:0] wide_from_quad;
    // Sub module instances
    photoncube_overlap_register_8 query(
        .d(query_d),
        .q(query_q),
        .clock(query_clock)
    );
    photoncube_overlap_register_18 radius_sq(
        .d(radius_sq_d),
        .q(radius_sq_q),
        .clock(radius_sq_clock)
    );
    photoncube_overlap_register_8 photon(
        .d(photon_d),
        .q(photon_q),
        .clock(photon_clock)
    );
    photoncube_overlap_register_8 magnitude(
        .d(magnitude_d),
        .q(magnitude_q),
        .clock(magnitude_clock)
    );
    photoncube_overlap_register_16 digit_squares(
        .d(digit_squares_d),
        .q(digit_squares_q),
        .clock(digit_squares_clock)
    );
    photoncube_overlap_register_6 low_product(
        .d(low_product_d),
        .q(low_product_q),
        .clock(low_product_clock)
    );
    photoncube_overlap_register_6 high_product(
        .d(high_product_d),
        .q(high_product_q),
        .clock(high_product_clock)
    );
    photoncube_overlap_register_16 square(
        .d(square_d),
        .q(square_q),
        .clock(square_clock)
    );
    photoncube_overlap_register_16 addend(
        .d(addend_d),
        .q(addend_q),
        .clock(addend_clock)
    );
    photoncube_overlap_register_32 operand(
        .d(operand_d),
        .q(operand_q),
        .clock(operand_clock)
    );
    photoncube_overlap_register_18 work(
        .d(work_d),
        .q(work_q),
        .clock(work_clock)
    );
    photoncube_overlap_register_18 distance(
        .d(distance_d),
        .q(distance_q),
        .clock(distance_clock)
    );
    photoncube_overlap_register_1 in_range(
        .d(in_range_d),
        .q(in_range_q),
        .clock(in_range_clock)
    );
    photoncube_overlap_register_32 sum(
        .d(sum_d),
        .q(sum_q),
        .clock(sum_clock)
    );
    photoncube_overlap_register_16 power_0(
        .d(power_0_d),
        .q(power_0_q),
        .clock(power_0_clock)
    );
    photoncube_overlap_register_16 power_1(
        .d(power_1_d),
        .q(power_1_q),
        .clock(power_1_clock)
    );
    photoncube_overlap_register_16 power_2(
        .d(power_2_d),
        .q(power_2_q),
        .clock(power_2_clock)
    );
    photoncube_overlap_register_16 power_3(
        .d(power_3_d),
        .q(power_3_q),
        .clock(power_3_clock)
    );
    photoncube_overlap_register_16 power_4(
        .d(power_4_d),
        .q(power_4_q),
        .clock(power_4_clock)
    );
    photoncube_overlap_register_16 power_5(
        .d(power_5_d),
        .q(power_5_q),
        .clock(power_5_clock)
    );
    photoncube_overlap_register_16 power_6(
        .d(power_6_d),
        .q(power_6_q),
        .clock(power_6_clock)
    );
    photoncube_overlap_register_16 power_7(
        .d(power_7_d),
        .q(power_7_q),
        .clock(power_7_clock)
    );
    photoncube_overlap_register_1 present_0(
        .d(present_0_d),
        .q(present_0_q),
        .clock(present_0_clock)
    );
    photoncube_overlap_register_1 present_1(
        .d(present_1_d),
        .q(present_1_q),
        .clock(present_1_clock)
    );
    photoncube_overlap_register_1 present_2(
        .d(present_2_d),
        .q(present_2_q),
        .clock(present_2_clock)
    );
    photoncube_overlap_register_1 present_3(
        .d(present_3_d),
        .q(present_3_q),
        .clock(present_3_clock)
    );
    photoncube_overlap_register_1 present_4(
        .d(present_4_d),
        .q(present_4_q),
        .clock(present_4_clock)
    );
    photoncube_overlap_register_1 present_5(
        .d(present_5_d),
        .q(present_5_q),
        .clock(present_5_clock)
    );
    photoncube_overlap_register_1 present_6(
        .d(present_6_d),
        .q(present_6_q),
        .clock(present_6_clock)
    );
    photoncube_overlap_register_1 present_7(
        .d(present_7_d),
        .q(present_7_q),
        .clock(present_7_clock)
    );
    photoncube_overlap_decoder decoder(
        .word(decoder_word),
        .write_photon(decoder_write_photon),
        .write_power(decoder_write_power),
        .move_power(decoder_move_power),
        .write_square(decoder_write_square),
        .write_work(decoder_write_work),
        .write_sum(decoder_write_sum),
        .write_distance(decoder_write_distance),
        .distance_source(decoder_distance_source),
        .axis(decoder_axis),
        .gate(decoder_gate),
        .add_sum(decoder_add_sum),
        .send_work(decoder_send_work),
        .send_distance(decoder_send_distance)
    );
    photoncube_overlap_difference difference(
        .a(difference_a),
        .b(difference_b),
        .magnitude(difference_magnitude)
    );
    photoncube_overlap_digits digits(
        .root(digits_root),
        .squares(digits_squares),
        .low_product(digits_low_product),
        .high_product(digits_high_product)
    );
    photoncube_overlap_chosen_sum chosen_sum(
        .sum(chosen_sum_sum),
        .sum_low(chosen_sum_sum_low),
        .addend(chosen_sum_addend),
        .operand(chosen_sum_operand),
        .add_sum(chosen_sum_add_sum),
        .total(chosen_sum_total)
    );
    // Update code
    always @(*) begin
        query_clock = clock;
        radius_sq_clock = clock;
        photon_clock = clock;
        magnitude_clock = clock;
        digit_squares_clock = clock;
        low_product_clock = clock;
        high_product_clock = clock;
        square_clock = clock;
        addend_clock = clock;
        operand_clock = clock;
        work_clock = clock;
        distance_clock = clock;
        in_range_clock = clock;
        sum_clock = clock;
        query_d = query_q;
        radius_sq_d = radius_sq_q;
        photon_d = photon_q;
        magnitude_d = magnitude_q;
        digit_squares_d = digit_squares_q;
        low_product_d = low_product_q;
        high_product_d = high_product_q;
        square_d = square_q;
        addend_d = addend_q;
        operand_d = operand_q;
        work_d = work_q;
        distance_d = distance_q;
        in_range_d = in_range_q;
        sum_d = sum_q;
        power_0_clock = clock;
        power_0_d = power_0_q;
        present_0_clock = clock;
        present_0_d = present_0_q;
        power_1_clock = clock;
        power_1_d = power_1_q;
        present_1_clock = clock;
        present_1_d = present_1_q;
        power_2_clock = clock;
        power_2_d = power_2_q;
        present_2_clock = clock;
        present_2_d = present_2_q;
        power_3_clock = clock;
        power_3_d = power_3_q;
        present_3_clock = clock;
        present_3_d = present_3_q;
        power_4_clock = clock;
        power_4_d = power_4_q;
        present_4_clock = clock;
        present_4_d = present_4_q;
        power_5_clock = clock;
        power_5_d = power_5_q;
        present_5_clock = clock;
        present_5_d = present_5_q;
        power_6_clock = clock;
        power_6_d = power_6_q;
        present_6_clock = clock;
        present_6_d = present_6_q;
        power_7_clock = clock;
        power_7_d = power_7_q;
        present_7_clock = clock;
        present_7_d = present_7_q;
        decoder_word = word;
        difference_a = query_q;
        difference_b = photon_q;
        magnitude_d = difference_magnitude;
        digits_root = magnitude_q;
        digit_squares_d = digits_squares;
        low_product_d = digits_low_product;
        high_product_d = digits_high_product;
        wide_low = ((low_product_q) & 16'hffff);
        wide_high = ((high_product_q) & 16'hffff);
        shifted_low = wide_low << 32'h5;
        shifted_high = wide_high << 32'h7;
        products = shifted_low + shifted_high;
        new_square = digit_squares_q + products;
        if (decoder_write_square) begin
            square_d = new_square;
        end
        addend_d = square_q;
        wide_square = ((square_q) & 18'h3ffff);
        wide_radius_sq = ((radius_sq_q) & 18'h3ffff);
        in_range_now = wide_radius_sq >= distance_q;
        in_range_d = in_range_now;
        is_there = in_range_q & present_7_q;
        opens = is_there & decoder_gate;
        wide_power = ((power_7_q) & 18'h3ffff);
        from_gate = 32'h0;
        if (opens) begin
            from_gate = wide_power;
        end
        from_x = 32'h0;
        if (decoder_axis[32'h0]) begin
            from_x = link_x;
        end
        from_y = 32'h0;
        if (decoder_axis[32'h1]) begin
            from_y = link_y;
        end
        from_z = 32'h0;
        if (decoder_axis[32'h2]) begin
            from_z = link_z;
        end
        from_w = 32'h0;
        if (decoder_axis[32'h3]) begin
            from_w = link_w;
        end
        from_role_axes = from_z | from_w;
        from_photon_axes = from_x | from_y;
        from_quad = from_role_axes | from_gate;
        wide_from_quad = ((from_quad) & 32'hffffffff);
        operand_d = from_photon_axes | wide_from_quad;
        chosen_sum_sum = sum_q;
        chosen_sum_sum_low = ((sum_q) & 18'h3ffff);
        chosen_sum_addend = addend_q;
        chosen_sum_operand = operand_q;
        chosen_sum_add_sum = decoder_add_sum;
        if (decoder_write_work) begin
            work_d = ((chosen_sum_total) & 18'h3ffff);
        end
        if (decoder_write_sum) begin
            sum_d = chosen_sum_total;
        end
        if (decoder_write_distance) begin
            case (decoder_distance_source)
                0:
                    begin
                        distance_d = work_q;
                    end
                1:
                    begin
                        distance_d = link_z;
                    end
                default:
                    begin
                        distance_d = link_w;
                    end
            endcase
        end
        if (decoder_write_photon) begin
            photon_d = photon_in;
        end
        if (decoder_write_power) begin
            power_0_d = power_in;
            present_0_d = present_in;
        end
        if (decoder_move_power[0]) begin
            power_1_d = power_0_q;
            present_1_d = present_0_q;
        end
        if (decoder_move_power[1]) begin
            power_2_d = power_1_q;
            present_2_d = present_1_q;
        end
        if (decoder_move_power[2]) begin
            power_3_d = power_2_q;
            present_3_d = present_2_q;
        end
        if (decoder_move_power[3]) begin
            power_4_d = power_3_q;
            present_4_d = present_3_q;
        end
        if (decoder_move_power[4]) begin
            power_5_d = power_4_q;
            present_5_d = present_4_q;
        end
        if (decoder_move_power[5]) begin
            power_6_d = power_5_q;
            present_6_d = present_5_q;
        end
        if (decoder_move_power[6]) begin
            power_7_d = power_6_q;
            present_7_d = present_6_q;
        end
        if (write_query) begin
            query_d = query_in;
            radius_sq_d = radius_sq_in;
            sum_d = 32'h0;
            present_0_d = 1'b0;
            present_1_d = 1'b0;
            present_2_d = 1'b0;
            present_3_d = 1'b0;
            present_4_d = 1'b0;
            present_5_d = 1'b0;
            present_6_d = 1'b0;
            present_7_d = 1'b0;
        end
        sum_out = sum_q;
        z_out = wide_square;
        if (decoder_send_work) begin
            z_out = work_q;
        end
        w_out = work_q;
        if (decoder_send_distance) begin
            w_out = distance_q;
        end
    end
endmodule

module photoncube_overlap_register_4(d, q, clock);
    // Module arguments
    input wire [3:0] d;
    output reg [3:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 4'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_overlap_register_23(d, q, clock);
    // Module arguments
    input wire [22:0] d;
    output reg [22:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 23'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_overlap_digits(root, squares, low_product, high_product);
    // Module arguments
    input wire [7:0] root;
    output reg [15:0] squares;
    output reg [5:0] low_product;
    output reg [5:0] high_product;
    // Stub signals
    reg [3:0] high_square_digit;
    wire [7:0] high_square_square;
    reg [3:0] low_square_digit;
    wire [7:0] low_square_square;
    // Local signals
    reg [3:0] high;
    reg [3:0] low;
    reg [15:0] wide_high;
    reg [15:0] shifted_high;
    reg [15:0] wide_low;
    reg [5:0] once;
    reg [5:0] twice;
    reg [5:0] rows_0;
    reg [5:0] rows_1;
    reg [5:0] rows_2;
    reg [5:0] rows_3;
    // Sub module instances
    photoncube_overlap_high_square high_square(
        .digit(high_square_digit),
        .square(high_square_square)
    );
    photoncube_overlap_high_square low_square(
        .digit(low_square_digit),
        .square(low_square_square)
    );
    // Update code
    always @(*) begin
        high = root[(32'h4)+:(4)];
        low = root[(32'h0)+:(4)];
        high_square_digit = high;
        low_square_digit = low;
        wide_high = ((high_square_square) & 16'hffff);
        shifted_high = wide_high << 32'h8;
        wide_low = ((low_square_square) & 16'hffff);
        squares = shifted_high | wide_low;
        once = ((low) & 6'h3f);
        twice = once << 32'h1;
        rows_0 = 32'h0;
        rows_1 = 32'h0;
        rows_2 = 32'h0;
        rows_3 = 32'h0;
        if (high[32'h0]) begin
            rows_0 = once;
        end
        if (high[32'h1]) begin
            rows_1 = twice;
        end
        if (high[32'h2]) begin
            rows_2 = once;
        end
        if (high[32'h3]) begin
            rows_3 = twice;
        end
        low_product = rows_0 + rows_1;
        high_product = rows_2 + rows_3;
    end
endmodule

module photoncube_overlap_store_z(address, word);
    // Module arguments
    input wire [2:0] address;
    output reg [22:0] word;
    // Update code
    always @(*) begin
        case (address)
            3'd0:
                begin
                    word = 23'h7809fa;
                end
            3'd1:
                begin
                    word = 23'h141a07;
                end
            3'd2:
                begin
                    word = 23'h835fc;
                end
            3'd3:
                begin
                    word = 23'h8000;
                end
            3'd4:
                begin
                    word = 23'h100800;
                end
            3'd5:
                begin
                    word = 23'h10000;
                end
            3'd6:
                begin
                    word = 23'h100800;
                end
            default:
                begin
                    word = 23'h0;
                end
        endcase
    end
endmodule

module photoncube_overlap_store_y(address, word);
    // Module arguments
    input wire [2:0] address;
    output reg [22:0] word;
    // Update code
    always @(*) begin
        case (address)
            3'd0:
                begin
                    word = 23'h180bfb;
                end
            3'd1:
                begin
                    word = 23'h125a07;
                end
            3'd2:
                begin
                    word = 23'h855fc;
                end
            3'd3:
                begin
                    word = 23'h8000;
                end
            3'd4:
                begin
                    word = 23'h100800;
                end
            3'd5:
                begin
                    word = 23'h10000;
                end
            3'd6:
                begin
                    word = 23'h100800;
                end
            default:
                begin
                    word = 23'h0;
                end
        endcase
    end
endmodule

module photoncube_overlap_store_x(address, word);
    // Module arguments
    input wire [2:0] address;
    output reg [22:0] word;
    // Update code
    always @(*) begin
        case (address)
            3'd0:
                begin
                    word = 23'h857ff;
                end
            3'd1:
                begin
                    word = 23'h180bff;
                end
            3'd2:
                begin
                    word = 23'h125800;
                end
            3'd3:
                begin
                    word = 23'h8000;
                end
            3'd4:
                begin
                    word = 23'h100800;
                end
            3'd5:
                begin
                    word = 23'h10000;
                end
            3'd6:
                begin
                    word = 23'h100800;
                end
            default:
                begin
                    word = 23'h0;
                end
        endcase
    end
endmodule

module photoncube_overlap_store_d(address, word);
    // Module arguments
    input wire [2:0] address;
    output reg [22:0] word;
    // Update code
    always @(*) begin
        case (address)
            3'd0:
                begin
                    word = 23'h143a1b;
                end
            3'd1:
                begin
                    word = 23'h4805f6;
                end
            3'd2:
                begin
                    word = 23'h3819ec;
                end
            3'd3:
                begin
                    word = 23'h8000;
                end
            3'd4:
                begin
                    word = 23'h100800;
                end
            3'd5:
                begin
                    word = 23'h10000;
                end
            3'd6:
                begin
                    word = 23'h100800;
                end
            default:
                begin
                    word = 23'h0;
                end
        endcase
    end
endmodule

module photoncube_overlap_register_3(d, q, clock);
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

module photoncube_overlap_register_32(d, q, clock);
    // Module arguments
    input wire [31:0] d;
    output reg [31:0] q;
    input wire clock;
    // Update code (custom)
    initial begin
       q = 32'h0;
    end
    always @(posedge clock) begin
       q <= d;
    end
endmodule

module photoncube_overlap_decoder(word, write_photon, write_power, move_power, write_square,
    write_work, write_sum, write_distance, distance_source, axis, gate, add_sum, send_work,
    send_distance);
    // Module arguments
    input wire [22:0] word;
    output reg write_photon;
    output reg write_power;
    output reg [6:0] move_power;
    output reg write_square;
    output reg write_work;
    output reg write_sum;
    output reg write_distance;
    output reg [1:0] distance_source;
    output reg [3:0] axis;
    output reg gate;
    output reg add_sum;
    output reg send_work;
    output reg send_distance;
    // Update code
    always @(*) begin
        write_photon = word[32'h0];
        write_power = word[32'h1];
        move_power = word[(32'h2)+:(7)];
        write_square = word[32'h9];
        write_work = word[32'ha];
        write_sum = word[32'hb];
        write_distance = word[32'hc];
        distance_source = word[(32'hd)+:(2)];
        axis = word[(32'hf)+:(4)];
        gate = word[32'h13];
        add_sum = word[32'h14];
        send_work = word[32'h15];
        send_distance = word[32'h16];
    end
endmodule

module photoncube_overlap_register_18(d, q, clock);
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

module photoncube_overlap_register_1(d, q, clock);
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

module photoncube_overlap_register_8(d, q, clock);
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

module photoncube_overlap_difference(a, b, magnitude);
    // Module arguments
    input wire [7:0] a;
    input wire [7:0] b;
    output reg [7:0] magnitude;
    // Update code (custom)
    wire [7:0] a_minus_b = a - b;
    wire [7:0] b_minus_a = b - a;
    wire below = a < b;
    wire [7:0] distance = below ? b_minus_a : a_minus_b;
    always @(*) magnitude = distance;
endmodule

module photoncube_overlap_chosen_sum(sum, sum_low, addend, operand, add_sum, total);
    // Module arguments
    input wire [31:0] sum;
    input wire [17:0] sum_low;
    input wire [15:0] addend;
    input wire [31:0] operand;
    input wire add_sum;
    output reg [31:0] total;
    // Constant declarations
    localparam high_bits = 32'hfffc0000;
    // Local signals
    reg [17:0] low;
    reg [31:0] wide_low;
    reg [31:0] high;
    reg [31:0] first;
    // Update code
    always @(*) begin
        low = ((addend) & 18'h3ffff);
        if (add_sum) begin
            low = sum_low;
        end
        wide_low = ((low) & 32'hffffffff);
        high = sum & high_bits;
        first = high | wide_low;
        total = first + operand;
    end
endmodule

module photoncube_overlap_register_6(d, q, clock);
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

module photoncube_overlap_register_16(d, q, clock);
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

module photoncube_overlap_high_square(digit, square);
    // Module arguments
    input wire [3:0] digit;
    output reg [7:0] square;
    // Update code
    always @(*) begin
        case (digit)
            0:
                begin
                    square = 32'h0;
                end
            1:
                begin
                    square = 32'h1;
                end
            2:
                begin
                    square = 32'h4;
                end
            3:
                begin
                    square = 32'h9;
                end
            4:
                begin
                    square = 32'h10;
                end
            5:
                begin
                    square = 32'h19;
                end
            6:
                begin
                    square = 32'h24;
                end
            7:
                begin
                    square = 32'h31;
                end
            8:
                begin
                    square = 32'h40;
                end
            9:
                begin
                    square = 32'h51;
                end
            10:
                begin
                    square = 32'h64;
                end
            11:
                begin
                    square = 32'h79;
                end
            12:
                begin
                    square = 32'h90;
                end
            13:
                begin
                    square = 32'ha9;
                end
            14:
                begin
                    square = 32'hc4;
                end
            default:
                begin
                    square = 32'he1;
                end
        endcase
    end
endmodule
