// SPDX-License-Identifier: MIT
// paper: Ryu, Kim, Lee: 16 cells on a 4-D hypercube, squarers for LUTs.
// Written by photoncube 0.2.0, `photoncube generate --machine paper`; do not edit.
//
// cells         16
// numbers       plain: 8-bit coordinates, 16-bit powers
// power unit    the photon map's own: its largest power in any channel is the largest word
// frame         4 x 4 x 4 blocks; a block's edge is at least the search radius; a query has its
//               place in the inner 2 x 2 x 2 blocks, so that all photons in range are in the frame
// most photons  65537 a query
// squarers      digits
// clocks        9 for a group of 4 photons, and 2 more a query
//
// Ports of photoncube_paper; bit 0 is the lowest:
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

module photoncube_paper(clock, reset, query_valid, query_x, query_y, query_z,
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
    wire control_write_photon;
    wire control_write_power;
    wire control_write_work;
    wire control_write_sum;
    wire [1:0] control_work_source;
    wire control_add_sum;
    wire [3:0] control_axis;
    reg [7:0] ports_query_x;
    reg [7:0] ports_query_y;
    reg [7:0] ports_query_z;
    reg ports_present_0;
    reg ports_present_1;
    reg ports_present_2;
    reg ports_present_3;
    reg [7:0] ports_x_0;
    reg [7:0] ports_x_1;
    reg [7:0] ports_x_2;
    reg [7:0] ports_x_3;
    reg [7:0] ports_y_0;
    reg [7:0] ports_y_1;
    reg [7:0] ports_y_2;
    reg [7:0] ports_y_3;
    reg [7:0] ports_z_0;
    reg [7:0] ports_z_1;
    reg [7:0] ports_z_2;
    reg [7:0] ports_z_3;
    reg [15:0] ports_red_0;
    reg [15:0] ports_red_1;
    reg [15:0] ports_red_2;
    reg [15:0] ports_red_3;
    reg [15:0] ports_green_0;
    reg [15:0] ports_green_1;
    reg [15:0] ports_green_2;
    reg [15:0] ports_green_3;
    reg [15:0] ports_blue_0;
    reg [15:0] ports_blue_1;
    reg [15:0] ports_blue_2;
    reg [15:0] ports_blue_3;
    reg [31:0] ports_sum_0;
    reg [31:0] ports_sum_1;
    reg [31:0] ports_sum_2;
    reg [31:0] ports_sum_3;
    reg [31:0] ports_sum_4;
    reg [31:0] ports_sum_5;
    reg [31:0] ports_sum_6;
    reg [31:0] ports_sum_7;
    reg [31:0] ports_sum_8;
    reg [31:0] ports_sum_9;
    reg [31:0] ports_sum_10;
    reg [31:0] ports_sum_11;
    reg [31:0] ports_sum_12;
    reg [31:0] ports_sum_13;
    reg [31:0] ports_sum_14;
    reg [31:0] ports_sum_15;
    wire [7:0] ports_cell_query_0;
    wire [7:0] ports_cell_query_1;
    wire [7:0] ports_cell_query_2;
    wire [7:0] ports_cell_query_3;
    wire [7:0] ports_cell_query_4;
    wire [7:0] ports_cell_query_5;
    wire [7:0] ports_cell_query_6;
    wire [7:0] ports_cell_query_7;
    wire [7:0] ports_cell_query_8;
    wire [7:0] ports_cell_query_9;
    wire [7:0] ports_cell_query_10;
    wire [7:0] ports_cell_query_11;
    wire [7:0] ports_cell_query_12;
    wire [7:0] ports_cell_query_13;
    wire [7:0] ports_cell_query_14;
    wire [7:0] ports_cell_query_15;
    wire [7:0] ports_cell_photon_0;
    wire [7:0] ports_cell_photon_1;
    wire [7:0] ports_cell_photon_2;
    wire [7:0] ports_cell_photon_3;
    wire [7:0] ports_cell_photon_4;
    wire [7:0] ports_cell_photon_5;
    wire [7:0] ports_cell_photon_6;
    wire [7:0] ports_cell_photon_7;
    wire [7:0] ports_cell_photon_8;
    wire [7:0] ports_cell_photon_9;
    wire [7:0] ports_cell_photon_10;
    wire [7:0] ports_cell_photon_11;
    wire [7:0] ports_cell_photon_12;
    wire [7:0] ports_cell_photon_13;
    wire [7:0] ports_cell_photon_14;
    wire [7:0] ports_cell_photon_15;
    wire ports_cell_present_0;
    wire ports_cell_present_1;
    wire ports_cell_present_2;
    wire ports_cell_present_3;
    wire ports_cell_present_4;
    wire ports_cell_present_5;
    wire ports_cell_present_6;
    wire ports_cell_present_7;
    wire ports_cell_present_8;
    wire ports_cell_present_9;
    wire ports_cell_present_10;
    wire ports_cell_present_11;
    wire ports_cell_present_12;
    wire ports_cell_present_13;
    wire ports_cell_present_14;
    wire ports_cell_present_15;
    wire [15:0] ports_cell_power_0;
    wire [15:0] ports_cell_power_1;
    wire [15:0] ports_cell_power_2;
    wire [15:0] ports_cell_power_3;
    wire [15:0] ports_cell_power_4;
    wire [15:0] ports_cell_power_5;
    wire [15:0] ports_cell_power_6;
    wire [15:0] ports_cell_power_7;
    wire [15:0] ports_cell_power_8;
    wire [15:0] ports_cell_power_9;
    wire [15:0] ports_cell_power_10;
    wire [15:0] ports_cell_power_11;
    wire [15:0] ports_cell_power_12;
    wire [15:0] ports_cell_power_13;
    wire [15:0] ports_cell_power_14;
    wire [15:0] ports_cell_power_15;
    wire [31:0] ports_result_red;
    wire [31:0] ports_result_green;
    wire [31:0] ports_result_blue;
    wire [31:0] ports_result_count;
    reg [3:0] network_axis;
    reg [17:0] network_work_0;
    reg [17:0] network_work_1;
    reg [17:0] network_work_2;
    reg [17:0] network_work_3;
    reg [17:0] network_work_4;
    reg [17:0] network_work_5;
    reg [17:0] network_work_6;
    reg [17:0] network_work_7;
    reg [17:0] network_work_8;
    reg [17:0] network_work_9;
    reg [17:0] network_work_10;
    reg [17:0] network_work_11;
    reg [17:0] network_work_12;
    reg [17:0] network_work_13;
    reg [17:0] network_work_14;
    reg [17:0] network_work_15;
    wire [17:0] network_link_0;
    wire [17:0] network_link_1;
    wire [17:0] network_link_2;
    wire [17:0] network_link_3;
    wire [17:0] network_link_4;
    wire [17:0] network_link_5;
    wire [17:0] network_link_6;
    wire [17:0] network_link_7;
    wire [17:0] network_link_8;
    wire [17:0] network_link_9;
    wire [17:0] network_link_10;
    wire [17:0] network_link_11;
    wire [17:0] network_link_12;
    wire [17:0] network_link_13;
    wire [17:0] network_link_14;
    wire [17:0] network_link_15;
    reg cell_0_clock;
    reg cell_0_write_query;
    reg cell_0_write_photon;
    reg cell_0_write_power;
    reg cell_0_write_work;
    reg cell_0_write_sum;
    reg [1:0] cell_0_work_source;
    reg cell_0_add_sum;
    reg [7:0] cell_0_query_in;
    reg [17:0] cell_0_radius_sq_in;
    reg [7:0] cell_0_photon_in;
    reg cell_0_present_in;
    reg [15:0] cell_0_power_in;
    reg [17:0] cell_0_link_in;
    wire [17:0] cell_0_work_out;
    wire [31:0] cell_0_sum_out;
    reg cell_1_clock;
    reg cell_1_write_query;
    reg cell_1_write_photon;
    reg cell_1_write_power;
    reg cell_1_write_work;
    reg cell_1_write_sum;
    reg [1:0] cell_1_work_source;
    reg cell_1_add_sum;
    reg [7:0] cell_1_query_in;
    reg [17:0] cell_1_radius_sq_in;
    reg [7:0] cell_1_photon_in;
    reg cell_1_present_in;
    reg [15:0] cell_1_power_in;
    reg [17:0] cell_1_link_in;
    wire [17:0] cell_1_work_out;
    wire [31:0] cell_1_sum_out;
    reg cell_2_clock;
    reg cell_2_write_query;
    reg cell_2_write_photon;
    reg cell_2_write_power;
    reg cell_2_write_work;
    reg cell_2_write_sum;
    reg [1:0] cell_2_work_source;
    reg cell_2_add_sum;
    reg [7:0] cell_2_query_in;
    reg [17:0] cell_2_radius_sq_in;
    reg [7:0] cell_2_photon_in;
    reg cell_2_present_in;
    reg [15:0] cell_2_power_in;
    reg [17:0] cell_2_link_in;
    wire [17:0] cell_2_work_out;
    wire [31:0] cell_2_sum_out;
    reg cell_3_clock;
    reg cell_3_write_query;
    reg cell_3_write_photon;
    reg cell_3_write_power;
    reg cell_3_write_work;
    reg cell_3_write_sum;
    reg [1:0] cell_3_work_source;
    reg cell_3_add_sum;
    reg [7:0] cell_3_query_in;
    reg [17:0] cell_3_radius_sq_in;
    reg [7:0] cell_3_photon_in;
    reg cell_3_present_in;
    reg [15:0] cell_3_power_in;
    reg [17:0] cell_3_link_in;
    wire [17:0] cell_3_work_out;
    wire [31:0] cell_3_sum_out;
    reg cell_4_clock;
    reg cell_4_write_query;
    reg cell_4_write_photon;
    reg cell_4_write_power;
    reg cell_4_write_work;
    reg cell_4_write_sum;
    reg [1:0] cell_4_work_source;
    reg cell_4_add_sum;
    reg [7:0] cell_4_query_in;
    reg [17:0] cell_4_radius_sq_in;
    reg [7:0] cell_4_photon_in;
    reg cell_4_present_in;
    reg [15:0] cell_4_power_in;
    reg [17:0] cell_4_link_in;
    wire [17:0] cell_4_work_out;
    wire [31:0] cell_4_sum_out;
    reg cell_5_clock;
    reg cell_5_write_query;
    reg cell_5_write_photon;
    reg cell_5_write_power;
    reg cell_5_write_work;
    reg cell_5_write_sum;
    reg [1:0] cell_5_work_source;
    reg cell_5_add_sum;
    reg [7:0] cell_5_query_in;
    reg [17:0] cell_5_radius_sq_in;
    reg [7:0] cell_5_photon_in;
    reg cell_5_present_in;
    reg [15:0] cell_5_power_in;
    reg [17:0] cell_5_link_in;
    wire [17:0] cell_5_work_out;
    wire [31:0] cell_5_sum_out;
    reg cell_6_clock;
    reg cell_6_write_query;
    reg cell_6_write_photon;
    reg cell_6_write_power;
    reg cell_6_write_work;
    reg cell_6_write_sum;
    reg [1:0] cell_6_work_source;
    reg cell_6_add_sum;
    reg [7:0] cell_6_query_in;
    reg [17:0] cell_6_radius_sq_in;
    reg [7:0] cell_6_photon_in;
    reg cell_6_present_in;
    reg [15:0] cell_6_power_in;
    reg [17:0] cell_6_link_in;
    wire [17:0] cell_6_work_out;
    wire [31:0] cell_6_sum_out;
    reg cell_7_clock;
    reg cell_7_write_query;
    reg cell_7_write_photon;
    reg cell_7_write_power;
    reg cell_7_write_work;
    reg cell_7_write_sum;
    reg [1:0] cell_7_work_source;
    reg cell_7_add_sum;
    reg [7:0] cell_7_query_in;
    reg [17:0] cell_7_radius_sq_in;
    reg [7:0] cell_7_photon_in;
    reg cell_7_present_in;
    reg [15:0] cell_7_power_in;
    reg [17:0] cell_7_link_in;
    wire [17:0] cell_7_work_out;
    wire [31:0] cell_7_sum_out;
    reg cell_8_clock;
    reg cell_8_write_query;
    reg cell_8_write_photon;
    reg cell_8_write_power;
    reg cell_8_write_work;
    reg cell_8_write_sum;
    reg [1:0] cell_8_work_source;
    reg cell_8_add_sum;
    reg [7:0] cell_8_query_in;
    reg [17:0] cell_8_radius_sq_in;
    reg [7:0] cell_8_photon_in;
    reg cell_8_present_in;
    reg [15:0] cell_8_power_in;
    reg [17:0] cell_8_link_in;
    wire [17:0] cell_8_work_out;
    wire [31:0] cell_8_sum_out;
    reg cell_9_clock;
    reg cell_9_write_query;
    reg cell_9_write_photon;
    reg cell_9_write_power;
    reg cell_9_write_work;
    reg cell_9_write_sum;
    reg [1:0] cell_9_work_source;
    reg cell_9_add_sum;
    reg [7:0] cell_9_query_in;
    reg [17:0] cell_9_radius_sq_in;
    reg [7:0] cell_9_photon_in;
    reg cell_9_present_in;
    reg [15:0] cell_9_power_in;
    reg [17:0] cell_9_link_in;
    wire [17:0] cell_9_work_out;
    wire [31:0] cell_9_sum_out;
    reg cell_10_clock;
    reg cell_10_write_query;
    reg cell_10_write_photon;
    reg cell_10_write_power;
    reg cell_10_write_work;
    reg cell_10_write_sum;
    reg [1:0] cell_10_work_source;
    reg cell_10_add_sum;
    reg [7:0] cell_10_query_in;
    reg [17:0] cell_10_radius_sq_in;
    reg [7:0] cell_10_photon_in;
    reg cell_10_present_in;
    reg [15:0] cell_10_power_in;
    reg [17:0] cell_10_link_in;
    wire [17:0] cell_10_work_out;
    wire [31:0] cell_10_sum_out;
    reg cell_11_clock;
    reg cell_11_write_query;
    reg cell_11_write_photon;
    reg cell_11_write_power;
    reg cell_11_write_work;
    reg cell_11_write_sum;
    reg [1:0] cell_11_work_source;
    reg cell_11_add_sum;
    reg [7:0] cell_11_query_in;
    reg [17:0] cell_11_radius_sq_in;
    reg [7:0] cell_11_photon_in;
    reg cell_11_present_in;
    reg [15:0] cell_11_power_in;
    reg [17:0] cell_11_link_in;
    wire [17:0] cell_11_work_out;
    wire [31:0] cell_11_sum_out;
    reg cell_12_clock;
    reg cell_12_write_query;
    reg cell_12_write_photon;
    reg cell_12_write_power;
    reg cell_12_write_work;
    reg cell_12_write_sum;
    reg [1:0] cell_12_work_source;
    reg cell_12_add_sum;
    reg [7:0] cell_12_query_in;
    reg [17:0] cell_12_radius_sq_in;
    reg [7:0] cell_12_photon_in;
    reg cell_12_present_in;
    reg [15:0] cell_12_power_in;
    reg [17:0] cell_12_link_in;
    wire [17:0] cell_12_work_out;
    wire [31:0] cell_12_sum_out;
    reg cell_13_clock;
    reg cell_13_write_query;
    reg cell_13_write_photon;
    reg cell_13_write_power;
    reg cell_13_write_work;
    reg cell_13_write_sum;
    reg [1:0] cell_13_work_source;
    reg cell_13_add_sum;
    reg [7:0] cell_13_query_in;
    reg [17:0] cell_13_radius_sq_in;
    reg [7:0] cell_13_photon_in;
    reg cell_13_present_in;
    reg [15:0] cell_13_power_in;
    reg [17:0] cell_13_link_in;
    wire [17:0] cell_13_work_out;
    wire [31:0] cell_13_sum_out;
    reg cell_14_clock;
    reg cell_14_write_query;
    reg cell_14_write_photon;
    reg cell_14_write_power;
    reg cell_14_write_work;
    reg cell_14_write_sum;
    reg [1:0] cell_14_work_source;
    reg cell_14_add_sum;
    reg [7:0] cell_14_query_in;
    reg [17:0] cell_14_radius_sq_in;
    reg [7:0] cell_14_photon_in;
    reg cell_14_present_in;
    reg [15:0] cell_14_power_in;
    reg [17:0] cell_14_link_in;
    wire [17:0] cell_14_work_out;
    wire [31:0] cell_14_sum_out;
    reg cell_15_clock;
    reg cell_15_write_query;
    reg cell_15_write_photon;
    reg cell_15_write_power;
    reg cell_15_write_work;
    reg cell_15_write_sum;
    reg [1:0] cell_15_work_source;
    reg cell_15_add_sum;
    reg [7:0] cell_15_query_in;
    reg [17:0] cell_15_radius_sq_in;
    reg [7:0] cell_15_photon_in;
    reg cell_15_present_in;
    reg [15:0] cell_15_power_in;
    reg [17:0] cell_15_link_in;
    wire [17:0] cell_15_work_out;
    wire [31:0] cell_15_sum_out;
    // Sub module instances
    photoncube_paper_control control(
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
        .write_photon(control_write_photon),
        .write_power(control_write_power),
        .write_work(control_write_work),
        .write_sum(control_write_sum),
        .work_source(control_work_source),
        .add_sum(control_add_sum),
        .axis(control_axis)
    );
    photoncube_paper_ports ports(
        .query_x(ports_query_x),
        .query_y(ports_query_y),
        .query_z(ports_query_z),
        .present_0(ports_present_0),
        .present_1(ports_present_1),
        .present_2(ports_present_2),
        .present_3(ports_present_3),
        .x_0(ports_x_0),
        .x_1(ports_x_1),
        .x_2(ports_x_2),
        .x_3(ports_x_3),
        .y_0(ports_y_0),
        .y_1(ports_y_1),
        .y_2(ports_y_2),
        .y_3(ports_y_3),
        .z_0(ports_z_0),
        .z_1(ports_z_1),
        .z_2(ports_z_2),
        .z_3(ports_z_3),
        .red_0(ports_red_0),
        .red_1(ports_red_1),
        .red_2(ports_red_2),
        .red_3(ports_red_3),
        .green_0(ports_green_0),
        .green_1(ports_green_1),
        .green_2(ports_green_2),
        .green_3(ports_green_3),
        .blue_0(ports_blue_0),
        .blue_1(ports_blue_1),
        .blue_2(ports_blue_2),
        .blue_3(ports_blue_3),
        .sum_0(ports_sum_0),
        .sum_1(ports_sum_1),
        .sum_2(ports_sum_2),
        .sum_3(ports_sum_3),
        .sum_4(ports_sum_4),
        .sum_5(ports_sum_5),
        .sum_6(ports_sum_6),
        .sum_7(ports_sum_7),
        .sum_8(ports_sum_8),
        .sum_9(ports_sum_9),
        .sum_10(ports_sum_10),
        .sum_11(ports_sum_11),
        .sum_12(ports_sum_12),
        .sum_13(ports_sum_13),
        .sum_14(ports_sum_14),
        .sum_15(ports_sum_15),
        .cell_query_0(ports_cell_query_0),
        .cell_query_1(ports_cell_query_1),
        .cell_query_2(ports_cell_query_2),
        .cell_query_3(ports_cell_query_3),
        .cell_query_4(ports_cell_query_4),
        .cell_query_5(ports_cell_query_5),
        .cell_query_6(ports_cell_query_6),
        .cell_query_7(ports_cell_query_7),
        .cell_query_8(ports_cell_query_8),
        .cell_query_9(ports_cell_query_9),
        .cell_query_10(ports_cell_query_10),
        .cell_query_11(ports_cell_query_11),
        .cell_query_12(ports_cell_query_12),
        .cell_query_13(ports_cell_query_13),
        .cell_query_14(ports_cell_query_14),
        .cell_query_15(ports_cell_query_15),
        .cell_photon_0(ports_cell_photon_0),
        .cell_photon_1(ports_cell_photon_1),
        .cell_photon_2(ports_cell_photon_2),
        .cell_photon_3(ports_cell_photon_3),
        .cell_photon_4(ports_cell_photon_4),
        .cell_photon_5(ports_cell_photon_5),
        .cell_photon_6(ports_cell_photon_6),
        .cell_photon_7(ports_cell_photon_7),
        .cell_photon_8(ports_cell_photon_8),
        .cell_photon_9(ports_cell_photon_9),
        .cell_photon_10(ports_cell_photon_10),
        .cell_photon_11(ports_cell_photon_11),
        .cell_photon_12(ports_cell_photon_12),
        .cell_photon_13(ports_cell_photon_13),
        .cell_photon_14(ports_cell_photon_14),
        .cell_photon_15(ports_cell_photon_15),
        .cell_present_0(ports_cell_present_0),
        .cell_present_1(ports_cell_present_1),
        .cell_present_2(ports_cell_present_2),
        .cell_present_3(ports_cell_present_3),
        .cell_present_4(ports_cell_present_4),
        .cell_present_5(ports_cell_present_5),
        .cell_present_6(ports_cell_present_6),
        .cell_present_7(ports_cell_present_7),
        .cell_present_8(ports_cell_present_8),
        .cell_present_9(ports_cell_present_9),
        .cell_present_10(ports_cell_present_10),
        .cell_present_11(ports_cell_present_11),
        .cell_present_12(ports_cell_present_12),
        .cell_present_13(ports_cell_present_13),
        .cell_present_14(ports_cell_present_14),
        .cell_present_15(ports_cell_present_15),
        .cell_power_0(ports_cell_power_0),
        .cell_power_1(ports_cell_power_1),
        .cell_power_2(ports_cell_power_2),
        .cell_power_3(ports_cell_power_3),
        .cell_power_4(ports_cell_power_4),
        .cell_power_5(ports_cell_power_5),
        .cell_power_6(ports_cell_power_6),
        .cell_power_7(ports_cell_power_7),
        .cell_power_8(ports_cell_power_8),
        .cell_power_9(ports_cell_power_9),
        .cell_power_10(ports_cell_power_10),
        .cell_power_11(ports_cell_power_11),
        .cell_power_12(ports_cell_power_12),
        .cell_power_13(ports_cell_power_13),
        .cell_power_14(ports_cell_power_14),
        .cell_power_15(ports_cell_power_15),
        .result_red(ports_result_red),
        .result_green(ports_result_green),
        .result_blue(ports_result_blue),
        .result_count(ports_result_count)
    );
    photoncube_paper_network network(
        .axis(network_axis),
        .work_0(network_work_0),
        .work_1(network_work_1),
        .work_2(network_work_2),
        .work_3(network_work_3),
        .work_4(network_work_4),
        .work_5(network_work_5),
        .work_6(network_work_6),
        .work_7(network_work_7),
        .work_8(network_work_8),
        .work_9(network_work_9),
        .work_10(network_work_10),
        .work_11(network_work_11),
        .work_12(network_work_12),
        .work_13(network_work_13),
        .work_14(network_work_14),
        .work_15(network_work_15),
        .link_0(network_link_0),
        .link_1(network_link_1),
        .link_2(network_link_2),
        .link_3(network_link_3),
        .link_4(network_link_4),
        .link_5(network_link_5),
        .link_6(network_link_6),
        .link_7(network_link_7),
        .link_8(network_link_8),
        .link_9(network_link_9),
        .link_10(network_link_10),
        .link_11(network_link_11),
        .link_12(network_link_12),
        .link_13(network_link_13),
        .link_14(network_link_14),
        .link_15(network_link_15)
    );
    photoncube_paper_cell cell_0(
        .clock(cell_0_clock),
        .write_query(cell_0_write_query),
        .write_photon(cell_0_write_photon),
        .write_power(cell_0_write_power),
        .write_work(cell_0_write_work),
        .write_sum(cell_0_write_sum),
        .work_source(cell_0_work_source),
        .add_sum(cell_0_add_sum),
        .query_in(cell_0_query_in),
        .radius_sq_in(cell_0_radius_sq_in),
        .photon_in(cell_0_photon_in),
        .present_in(cell_0_present_in),
        .power_in(cell_0_power_in),
        .link_in(cell_0_link_in),
        .work_out(cell_0_work_out),
        .sum_out(cell_0_sum_out)
    );
    photoncube_paper_cell cell_1(
        .clock(cell_1_clock),
        .write_query(cell_1_write_query),
        .write_photon(cell_1_write_photon),
        .write_power(cell_1_write_power),
        .write_work(cell_1_write_work),
        .write_sum(cell_1_write_sum),
        .work_source(cell_1_work_source),
        .add_sum(cell_1_add_sum),
        .query_in(cell_1_query_in),
        .radius_sq_in(cell_1_radius_sq_in),
        .photon_in(cell_1_photon_in),
        .present_in(cell_1_present_in),
        .power_in(cell_1_power_in),
        .link_in(cell_1_link_in),
        .work_out(cell_1_work_out),
        .sum_out(cell_1_sum_out)
    );
    photoncube_paper_cell cell_2(
        .clock(cell_2_clock),
        .write_query(cell_2_write_query),
        .write_photon(cell_2_write_photon),
        .write_power(cell_2_write_power),
        .write_work(cell_2_write_work),
        .write_sum(cell_2_write_sum),
        .work_source(cell_2_work_source),
        .add_sum(cell_2_add_sum),
        .query_in(cell_2_query_in),
        .radius_sq_in(cell_2_radius_sq_in),
        .photon_in(cell_2_photon_in),
        .present_in(cell_2_present_in),
        .power_in(cell_2_power_in),
        .link_in(cell_2_link_in),
        .work_out(cell_2_work_out),
        .sum_out(cell_2_sum_out)
    );
    photoncube_paper_cell cell_3(
        .clock(cell_3_clock),
        .write_query(cell_3_write_query),
        .write_photon(cell_3_write_photon),
        .write_power(cell_3_write_power),
        .write_work(cell_3_write_work),
        .write_sum(cell_3_write_sum),
        .work_source(cell_3_work_source),
        .add_sum(cell_3_add_sum),
        .query_in(cell_3_query_in),
        .radius_sq_in(cell_3_radius_sq_in),
        .photon_in(cell_3_photon_in),
        .present_in(cell_3_present_in),
        .power_in(cell_3_power_in),
        .link_in(cell_3_link_in),
        .work_out(cell_3_work_out),
        .sum_out(cell_3_sum_out)
    );
    photoncube_paper_cell cell_4(
        .clock(cell_4_clock),
        .write_query(cell_4_write_query),
        .write_photon(cell_4_write_photon),
        .write_power(cell_4_write_power),
        .write_work(cell_4_write_work),
        .write_sum(cell_4_write_sum),
        .work_source(cell_4_work_source),
        .add_sum(cell_4_add_sum),
        .query_in(cell_4_query_in),
        .radius_sq_in(cell_4_radius_sq_in),
        .photon_in(cell_4_photon_in),
        .present_in(cell_4_present_in),
        .power_in(cell_4_power_in),
        .link_in(cell_4_link_in),
        .work_out(cell_4_work_out),
        .sum_out(cell_4_sum_out)
    );
    photoncube_paper_cell cell_5(
        .clock(cell_5_clock),
        .write_query(cell_5_write_query),
        .write_photon(cell_5_write_photon),
        .write_power(cell_5_write_power),
        .write_work(cell_5_write_work),
        .write_sum(cell_5_write_sum),
        .work_source(cell_5_work_source),
        .add_sum(cell_5_add_sum),
        .query_in(cell_5_query_in),
        .radius_sq_in(cell_5_radius_sq_in),
        .photon_in(cell_5_photon_in),
        .present_in(cell_5_present_in),
        .power_in(cell_5_power_in),
        .link_in(cell_5_link_in),
        .work_out(cell_5_work_out),
        .sum_out(cell_5_sum_out)
    );
    photoncube_paper_cell cell_6(
        .clock(cell_6_clock),
        .write_query(cell_6_write_query),
        .write_photon(cell_6_write_photon),
        .write_power(cell_6_write_power),
        .write_work(cell_6_write_work),
        .write_sum(cell_6_write_sum),
        .work_source(cell_6_work_source),
        .add_sum(cell_6_add_sum),
        .query_in(cell_6_query_in),
        .radius_sq_in(cell_6_radius_sq_in),
        .photon_in(cell_6_photon_in),
        .present_in(cell_6_present_in),
        .power_in(cell_6_power_in),
        .link_in(cell_6_link_in),
        .work_out(cell_6_work_out),
        .sum_out(cell_6_sum_out)
    );
    photoncube_paper_cell cell_7(
        .clock(cell_7_clock),
        .write_query(cell_7_write_query),
        .write_photon(cell_7_write_photon),
        .write_power(cell_7_write_power),
        .write_work(cell_7_write_work),
        .write_sum(cell_7_write_sum),
        .work_source(cell_7_work_source),
        .add_sum(cell_7_add_sum),
        .query_in(cell_7_query_in),
        .radius_sq_in(cell_7_radius_sq_in),
        .photon_in(cell_7_photon_in),
        .present_in(cell_7_present_in),
        .power_in(cell_7_power_in),
        .link_in(cell_7_link_in),
        .work_out(cell_7_work_out),
        .sum_out(cell_7_sum_out)
    );
    photoncube_paper_cell cell_8(
        .clock(cell_8_clock),
        .write_query(cell_8_write_query),
        .write_photon(cell_8_write_photon),
        .write_power(cell_8_write_power),
        .write_work(cell_8_write_work),
        .write_sum(cell_8_write_sum),
        .work_source(cell_8_work_source),
        .add_sum(cell_8_add_sum),
        .query_in(cell_8_query_in),
        .radius_sq_in(cell_8_radius_sq_in),
        .photon_in(cell_8_photon_in),
        .present_in(cell_8_present_in),
        .power_in(cell_8_power_in),
        .link_in(cell_8_link_in),
        .work_out(cell_8_work_out),
        .sum_out(cell_8_sum_out)
    );
    photoncube_paper_cell cell_9(
        .clock(cell_9_clock),
        .write_query(cell_9_write_query),
        .write_photon(cell_9_write_photon),
        .write_power(cell_9_write_power),
        .write_work(cell_9_write_work),
        .write_sum(cell_9_write_sum),
        .work_source(cell_9_work_source),
        .add_sum(cell_9_add_sum),
        .query_in(cell_9_query_in),
        .radius_sq_in(cell_9_radius_sq_in),
        .photon_in(cell_9_photon_in),
        .present_in(cell_9_present_in),
        .power_in(cell_9_power_in),
        .link_in(cell_9_link_in),
        .work_out(cell_9_work_out),
        .sum_out(cell_9_sum_out)
    );
    photoncube_paper_cell cell_10(
        .clock(cell_10_clock),
        .write_query(cell_10_write_query),
        .write_photon(cell_10_write_photon),
        .write_power(cell_10_write_power),
        .write_work(cell_10_write_work),
        .write_sum(cell_10_write_sum),
        .work_source(cell_10_work_source),
        .add_sum(cell_10_add_sum),
        .query_in(cell_10_query_in),
        .radius_sq_in(cell_10_radius_sq_in),
        .photon_in(cell_10_photon_in),
        .present_in(cell_10_present_in),
        .power_in(cell_10_power_in),
        .link_in(cell_10_link_in),
        .work_out(cell_10_work_out),
        .sum_out(cell_10_sum_out)
    );
    photoncube_paper_cell cell_11(
        .clock(cell_11_clock),
        .write_query(cell_11_write_query),
        .write_photon(cell_11_write_photon),
        .write_power(cell_11_write_power),
        .write_work(cell_11_write_work),
        .write_sum(cell_11_write_sum),
        .work_source(cell_11_work_source),
        .add_sum(cell_11_add_sum),
        .query_in(cell_11_query_in),
        .radius_sq_in(cell_11_radius_sq_in),
        .photon_in(cell_11_photon_in),
        .present_in(cell_11_present_in),
        .power_in(cell_11_power_in),
        .link_in(cell_11_link_in),
        .work_out(cell_11_work_out),
        .sum_out(cell_11_sum_out)
    );
    photoncube_paper_cell cell_12(
        .clock(cell_12_clock),
        .write_query(cell_12_write_query),
        .write_photon(cell_12_write_photon),
        .write_power(cell_12_write_power),
        .write_work(cell_12_write_work),
        .write_sum(cell_12_write_sum),
        .work_source(cell_12_work_source),
        .add_sum(cell_12_add_sum),
        .query_in(cell_12_query_in),
        .radius_sq_in(cell_12_radius_sq_in),
        .photon_in(cell_12_photon_in),
        .present_in(cell_12_present_in),
        .power_in(cell_12_power_in),
        .link_in(cell_12_link_in),
        .work_out(cell_12_work_out),
        .sum_out(cell_12_sum_out)
    );
    photoncube_paper_cell cell_13(
        .clock(cell_13_clock),
        .write_query(cell_13_write_query),
        .write_photon(cell_13_write_photon),
        .write_power(cell_13_write_power),
        .write_work(cell_13_write_work),
        .write_sum(cell_13_write_sum),
        .work_source(cell_13_work_source),
        .add_sum(cell_13_add_sum),
        .query_in(cell_13_query_in),
        .radius_sq_in(cell_13_radius_sq_in),
        .photon_in(cell_13_photon_in),
        .present_in(cell_13_present_in),
        .power_in(cell_13_power_in),
        .link_in(cell_13_link_in),
        .work_out(cell_13_work_out),
        .sum_out(cell_13_sum_out)
    );
    photoncube_paper_cell cell_14(
        .clock(cell_14_clock),
        .write_query(cell_14_write_query),
        .write_photon(cell_14_write_photon),
        .write_power(cell_14_write_power),
        .write_work(cell_14_write_work),
        .write_sum(cell_14_write_sum),
        .work_source(cell_14_work_source),
        .add_sum(cell_14_add_sum),
        .query_in(cell_14_query_in),
        .radius_sq_in(cell_14_radius_sq_in),
        .photon_in(cell_14_photon_in),
        .present_in(cell_14_present_in),
        .power_in(cell_14_power_in),
        .link_in(cell_14_link_in),
        .work_out(cell_14_work_out),
        .sum_out(cell_14_sum_out)
    );
    photoncube_paper_cell cell_15(
        .clock(cell_15_clock),
        .write_query(cell_15_write_query),
        .write_photon(cell_15_write_photon),
        .write_power(cell_15_write_power),
        .write_work(cell_15_write_work),
        .write_sum(cell_15_write_sum),
        .work_source(cell_15_work_source),
        .add_sum(cell_15_add_sum),
        .query_in(cell_15_query_in),
        .radius_sq_in(cell_15_radius_sq_in),
        .photon_in(cell_15_photon_in),
        .present_in(cell_15_present_in),
        .power_in(cell_15_power_in),
        .link_in(cell_15_link_in),
        .work_out(cell_15_work_out),
        .sum_out(cell_15_sum_out)
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
        ports_query_x = query_x;
        ports_query_y = query_y;
        ports_query_z = query_z;
        ports_present_0 = photon_present_0;
        ports_x_0 = photon_x_0;
        ports_y_0 = photon_y_0;
        ports_z_0 = photon_z_0;
        ports_present_1 = photon_present_1;
        ports_x_1 = photon_x_1;
        ports_y_1 = photon_y_1;
        ports_z_1 = photon_z_1;
        ports_present_2 = photon_present_2;
        ports_x_2 = photon_x_2;
        ports_y_2 = photon_y_2;
        ports_z_2 = photon_z_2;
        ports_present_3 = photon_present_3;
        ports_x_3 = photon_x_3;
        ports_y_3 = photon_y_3;
        ports_z_3 = photon_z_3;
        ports_red_0 = photon_red_0;
        ports_red_1 = photon_red_1;
        ports_red_2 = photon_red_2;
        ports_red_3 = photon_red_3;
        ports_green_0 = photon_green_0;
        ports_green_1 = photon_green_1;
        ports_green_2 = photon_green_2;
        ports_green_3 = photon_green_3;
        ports_blue_0 = photon_blue_0;
        ports_blue_1 = photon_blue_1;
        ports_blue_2 = photon_blue_2;
        ports_blue_3 = photon_blue_3;
        network_axis = control_axis;
        cell_0_clock = clock;
        cell_0_write_query = control_write_query;
        cell_0_write_photon = control_write_photon;
        cell_0_write_power = control_write_power;
        cell_0_write_work = control_write_work;
        cell_0_write_sum = control_write_sum;
        cell_0_work_source = control_work_source;
        cell_0_add_sum = control_add_sum;
        cell_0_query_in = ports_cell_query_0;
        cell_0_radius_sq_in = query_radius_sq;
        cell_0_photon_in = ports_cell_photon_0;
        cell_0_present_in = ports_cell_present_0;
        cell_0_power_in = ports_cell_power_0;
        network_work_0 = cell_0_work_out;
        cell_0_link_in = network_link_0;
        ports_sum_0 = cell_0_sum_out;
        cell_1_clock = clock;
        cell_1_write_query = control_write_query;
        cell_1_write_photon = control_write_photon;
        cell_1_write_power = control_write_power;
        cell_1_write_work = control_write_work;
        cell_1_write_sum = control_write_sum;
        cell_1_work_source = control_work_source;
        cell_1_add_sum = control_add_sum;
        cell_1_query_in = ports_cell_query_1;
        cell_1_radius_sq_in = query_radius_sq;
        cell_1_photon_in = ports_cell_photon_1;
        cell_1_present_in = ports_cell_present_1;
        cell_1_power_in = ports_cell_power_1;
        network_work_1 = cell_1_work_out;
        cell_1_link_in = network_link_1;
        ports_sum_1 = cell_1_sum_out;
        cell_2_clock = clock;
        cell_2_write_query = control_write_query;
        cell_2_write_photon = control_write_photon;
        cell_2_write_power = control_write_power;
        cell_2_write_work = control_write_work;
        cell_2_write_sum = control_write_sum;
        cell_2_work_source = control_work_source;
        cell_2_add_sum = control_add_sum;
        cell_2_query_in = ports_cell_query_2;
        cell_2_radius_sq_in = query_radius_sq;
        cell_2_photon_in = ports_cell_photon_2;
        cell_2_present_in = ports_cell_present_2;
        cell_2_power_in = ports_cell_power_2;
        network_work_2 = cell_2_work_out;
        cell_2_link_in = network_link_2;
        ports_sum_2 = cell_2_sum_out;
        cell_3_clock = clock;
        cell_3_write_query = control_write_query;
        cell_3_write_photon = control_write_photon;
        cell_3_write_power = control_write_power;
        cell_3_write_work = control_write_work;
        cell_3_write_sum = control_write_sum;
        cell_3_work_source = control_work_source;
        cell_3_add_sum = control_add_sum;
        cell_3_query_in = ports_cell_query_3;
        cell_3_radius_sq_in = query_radius_sq;
        cell_3_photon_in = ports_cell_photon_3;
        cell_3_present_in = ports_cell_present_3;
        cell_3_power_in = ports_cell_power_3;
        network_work_3 = cell_3_work_out;
        cell_3_link_in = network_link_3;
        ports_sum_3 = cell_3_sum_out;
        cell_4_clock = clock;
        cell_4_write_query = control_write_query;
        cell_4_write_photon = control_write_photon;
        cell_4_write_power = control_write_power;
        cell_4_write_work = control_write_work;
        cell_4_write_sum = control_write_sum;
        cell_4_work_source = control_work_source;
        cell_4_add_sum = control_add_sum;
        cell_4_query_in = ports_cell_query_4;
        cell_4_radius_sq_in = query_radius_sq;
        cell_4_photon_in = ports_cell_photon_4;
        cell_4_present_in = ports_cell_present_4;
        cell_4_power_in = ports_cell_power_4;
        network_work_4 = cell_4_work_out;
        cell_4_link_in = network_link_4;
        ports_sum_4 = cell_4_sum_out;
        cell_5_clock = clock;
        cell_5_write_query = control_write_query;
        cell_5_write_photon = control_write_photon;
        cell_5_write_power = control_write_power;
        cell_5_write_work = control_write_work;
        cell_5_write_sum = control_write_sum;
        cell_5_work_source = control_work_source;
        cell_5_add_sum = control_add_sum;
        cell_5_query_in = ports_cell_query_5;
        cell_5_radius_sq_in = query_radius_sq;
        cell_5_photon_in = ports_cell_photon_5;
        cell_5_present_in = ports_cell_present_5;
        cell_5_power_in = ports_cell_power_5;
        network_work_5 = cell_5_work_out;
        cell_5_link_in = network_link_5;
        ports_sum_5 = cell_5_sum_out;
        cell_6_clock = clock;
        cell_6_write_query = control_write_query;
        cell_6_write_photon = control_write_photon;
        cell_6_write_power = control_write_power;
        cell_6_write_work = control_write_work;
        cell_6_write_sum = control_write_sum;
        cell_6_work_source = control_work_source;
        cell_6_add_sum = control_add_sum;
        cell_6_query_in = ports_cell_query_6;
        cell_6_radius_sq_in = query_radius_sq;
        cell_6_photon_in = ports_cell_photon_6;
        cell_6_present_in = ports_cell_present_6;
        cell_6_power_in = ports_cell_power_6;
        network_work_6 = cell_6_work_out;
        cell_6_link_in = network_link_6;
        ports_sum_6 = cell_6_sum_out;
        cell_7_clock = clock;
        cell_7_write_query = control_write_query;
        cell_7_write_photon = control_write_photon;
        cell_7_write_power = control_write_power;
        cell_7_write_work = control_write_work;
        cell_7_write_sum = control_write_sum;
        cell_7_work_source = control_work_source;
        cell_7_add_sum = control_add_sum;
        cell_7_query_in = ports_cell_query_7;
        cell_7_radius_sq_in = query_radius_sq;
        cell_7_photon_in = ports_cell_photon_7;
        cell_7_present_in = ports_cell_present_7;
        cell_7_power_in = ports_cell_power_7;
        network_work_7 = cell_7_work_out;
        cell_7_link_in = network_link_7;
        ports_sum_7 = cell_7_sum_out;
        cell_8_clock = clock;
        cell_8_write_query = control_write_query;
        cell_8_write_photon = control_write_photon;
        cell_8_write_power = control_write_power;
        cell_8_write_work = control_write_work;
        cell_8_write_sum = control_write_sum;
        cell_8_work_source = control_work_source;
        cell_8_add_sum = control_add_sum;
        cell_8_query_in = ports_cell_query_8;
        cell_8_radius_sq_in = query_radius_sq;
        cell_8_photon_in = ports_cell_photon_8;
        cell_8_present_in = ports_cell_present_8;
        cell_8_power_in = ports_cell_power_8;
        network_work_8 = cell_8_work_out;
        cell_8_link_in = network_link_8;
        ports_sum_8 = cell_8_sum_out;
        cell_9_clock = clock;
        cell_9_write_query = control_write_query;
        cell_9_write_photon = control_write_photon;
        cell_9_write_power = control_write_power;
        cell_9_write_work = control_write_work;
        cell_9_write_sum = control_write_sum;
        cell_9_work_source = control_work_source;
        cell_9_add_sum = control_add_sum;
        cell_9_query_in = ports_cell_query_9;
        cell_9_radius_sq_in = query_radius_sq;
        cell_9_photon_in = ports_cell_photon_9;
        cell_9_present_in = ports_cell_present_9;
        cell_9_power_in = ports_cell_power_9;
        network_work_9 = cell_9_work_out;
        cell_9_link_in = network_link_9;
        ports_sum_9 = cell_9_sum_out;
        cell_10_clock = clock;
        cell_10_write_query = control_write_query;
        cell_10_write_photon = control_write_photon;
        cell_10_write_power = control_write_power;
        cell_10_write_work = control_write_work;
        cell_10_write_sum = control_write_sum;
        cell_10_work_source = control_work_source;
        cell_10_add_sum = control_add_sum;
        cell_10_query_in = ports_cell_query_10;
        cell_10_radius_sq_in = query_radius_sq;
        cell_10_photon_in = ports_cell_photon_10;
        cell_10_present_in = ports_cell_present_10;
        cell_10_power_in = ports_cell_power_10;
        network_work_10 = cell_10_work_out;
        cell_10_link_in = network_link_10;
        ports_sum_10 = cell_10_sum_out;
        cell_11_clock = clock;
        cell_11_write_query = control_write_query;
        cell_11_write_photon = control_write_photon;
        cell_11_write_power = control_write_power;
        cell_11_write_work = control_write_work;
        cell_11_write_sum = control_write_sum;
        cell_11_work_source = control_work_source;
        cell_11_add_sum = control_add_sum;
        cell_11_query_in = ports_cell_query_11;
        cell_11_radius_sq_in = query_radius_sq;
        cell_11_photon_in = ports_cell_photon_11;
        cell_11_present_in = ports_cell_present_11;
        cell_11_power_in = ports_cell_power_11;
        network_work_11 = cell_11_work_out;
        cell_11_link_in = network_link_11;
        ports_sum_11 = cell_11_sum_out;
        cell_12_clock = clock;
        cell_12_write_query = control_write_query;
        cell_12_write_photon = control_write_photon;
        cell_12_write_power = control_write_power;
        cell_12_write_work = control_write_work;
        cell_12_write_sum = control_write_sum;
        cell_12_work_source = control_work_source;
        cell_12_add_sum = control_add_sum;
        cell_12_query_in = ports_cell_query_12;
        cell_12_radius_sq_in = query_radius_sq;
        cell_12_photon_in = ports_cell_photon_12;
        cell_12_present_in = ports_cell_present_12;
        cell_12_power_in = ports_cell_power_12;
        network_work_12 = cell_12_work_out;
        cell_12_link_in = network_link_12;
        ports_sum_12 = cell_12_sum_out;
        cell_13_clock = clock;
        cell_13_write_query = control_write_query;
        cell_13_write_photon = control_write_photon;
        cell_13_write_power = control_write_power;
        cell_13_write_work = control_write_work;
        cell_13_write_sum = control_write_sum;
        cell_13_work_source = control_work_source;
        cell_13_add_sum = control_add_sum;
        cell_13_query_in = ports_cell_query_13;
        cell_13_radius_sq_in = query_radius_sq;
        cell_13_photon_in = ports_cell_photon_13;
        cell_13_present_in = ports_cell_present_13;
        cell_13_power_in = ports_cell_power_13;
        network_work_13 = cell_13_work_out;
        cell_13_link_in = network_link_13;
        ports_sum_13 = cell_13_sum_out;
        cell_14_clock = clock;
        cell_14_write_query = control_write_query;
        cell_14_write_photon = control_write_photon;
        cell_14_write_power = control_write_power;
        cell_14_write_work = control_write_work;
        cell_14_write_sum = control_write_sum;
        cell_14_work_source = control_work_source;
        cell_14_add_sum = control_add_sum;
        cell_14_query_in = ports_cell_query_14;
        cell_14_radius_sq_in = query_radius_sq;
        cell_14_photon_in = ports_cell_photon_14;
        cell_14_present_in = ports_cell_present_14;
        cell_14_power_in = ports_cell_power_14;
        network_work_14 = cell_14_work_out;
        cell_14_link_in = network_link_14;
        ports_sum_14 = cell_14_sum_out;
        cell_15_clock = clock;
        cell_15_write_query = control_write_query;
        cell_15_write_photon = control_write_photon;
        cell_15_write_power = control_write_power;
        cell_15_write_work = control_write_work;
        cell_15_write_sum = control_write_sum;
        cell_15_work_source = control_work_source;
        cell_15_add_sum = control_add_sum;
        cell_15_query_in = ports_cell_query_15;
        cell_15_radius_sq_in = query_radius_sq;
        cell_15_photon_in = ports_cell_photon_15;
        cell_15_present_in = ports_cell_present_15;
        cell_15_power_in = ports_cell_power_15;
        network_work_15 = cell_15_work_out;
        cell_15_link_in = network_link_15;
        ports_sum_15 = cell_15_sum_out;
        result_red = ports_result_red;
        result_green = ports_result_green;
        result_blue = ports_result_blue;
        result_count = ports_result_count;
    end
endmodule

module photoncube_paper_ports(query_x, query_y, query_z, present_0, present_1, present_2,
    present_3, x_0, x_1, x_2, x_3, y_0, y_1, y_2, y_3, z_0, z_1, z_2, z_3, red_0, red_1, red_2,
    red_3, green_0, green_1, green_2, green_3, blue_0, blue_1, blue_2, blue_3, sum_0, sum_1,
    sum_2, sum_3, sum_4, sum_5, sum_6, sum_7, sum_8, sum_9, sum_10, sum_11, sum_12, sum_13,
    sum_14, sum_15, cell_query_0, cell_query_1, cell_query_2, cell_query_3, cell_query_4,
    cell_query_5, cell_query_6, cell_query_7, cell_query_8, cell_query_9, cell_query_10,
    cell_query_11, cell_query_12, cell_query_13, cell_query_14, cell_query_15, cell_photon_0,
    cell_photon_1, cell_photon_2, cell_photon_3, cell_photon_4, cell_photon_5, cell_photon_6,
    cell_photon_7, cell_photon_8, cell_photon_9, cell_photon_10, cell_photon_11, cell_photon_12,
    cell_photon_13, cell_photon_14, cell_photon_15, cell_present_0, cell_present_1,
    cell_present_2, cell_present_3, cell_present_4, cell_present_5, cell_present_6,
    cell_present_7, cell_present_8, cell_present_9, cell_present_10, cell_present_11,
    cell_present_12, cell_present_13, cell_present_14, cell_present_15, cell_power_0,
    cell_power_1, cell_power_2, cell_power_3, cell_power_4, cell_power_5, cell_power_6,
    cell_power_7, cell_power_8, cell_power_9, cell_power_10, cell_power_11, cell_power_12,
    cell_power_13, cell_power_14, cell_power_15, result_red, result_green, result_blue,
    result_count);
    // Module arguments
    input wire [7:0] query_x;
    input wire [7:0] query_y;
    input wire [7:0] query_z;
    input wire present_0;
    input wire present_1;
    input wire present_2;
    input wire present_3;
    input wire [7:0] x_0;
    input wire [7:0] x_1;
    input wire [7:0] x_2;
    input wire [7:0] x_3;
    input wire [7:0] y_0;
    input wire [7:0] y_1;
    input wire [7:0] y_2;
    input wire [7:0] y_3;
    input wire [7:0] z_0;
    input wire [7:0] z_1;
    input wire [7:0] z_2;
    input wire [7:0] z_3;
    input wire [15:0] red_0;
    input wire [15:0] red_1;
    input wire [15:0] red_2;
    input wire [15:0] red_3;
    input wire [15:0] green_0;
    input wire [15:0] green_1;
    input wire [15:0] green_2;
    input wire [15:0] green_3;
    input wire [15:0] blue_0;
    input wire [15:0] blue_1;
    input wire [15:0] blue_2;
    input wire [15:0] blue_3;
    input wire [31:0] sum_0;
    input wire [31:0] sum_1;
    input wire [31:0] sum_2;
    input wire [31:0] sum_3;
    input wire [31:0] sum_4;
    input wire [31:0] sum_5;
    input wire [31:0] sum_6;
    input wire [31:0] sum_7;
    input wire [31:0] sum_8;
    input wire [31:0] sum_9;
    input wire [31:0] sum_10;
    input wire [31:0] sum_11;
    input wire [31:0] sum_12;
    input wire [31:0] sum_13;
    input wire [31:0] sum_14;
    input wire [31:0] sum_15;
    output reg [7:0] cell_query_0;
    output reg [7:0] cell_query_1;
    output reg [7:0] cell_query_2;
    output reg [7:0] cell_query_3;
    output reg [7:0] cell_query_4;
    output reg [7:0] cell_query_5;
    output reg [7:0] cell_query_6;
    output reg [7:0] cell_query_7;
    output reg [7:0] cell_query_8;
    output reg [7:0] cell_query_9;
    output reg [7:0] cell_query_10;
    output reg [7:0] cell_query_11;
    output reg [7:0] cell_query_12;
    output reg [7:0] cell_query_13;
    output reg [7:0] cell_query_14;
    output reg [7:0] cell_query_15;
    output reg [7:0] cell_photon_0;
    output reg [7:0] cell_photon_1;
    output reg [7:0] cell_photon_2;
    output reg [7:0] cell_photon_3;
    output reg [7:0] cell_photon_4;
    output reg [7:0] cell_photon_5;
    output reg [7:0] cell_photon_6;
    output reg [7:0] cell_photon_7;
    output reg [7:0] cell_photon_8;
    output reg [7:0] cell_photon_9;
    output reg [7:0] cell_photon_10;
    output reg [7:0] cell_photon_11;
    output reg [7:0] cell_photon_12;
    output reg [7:0] cell_photon_13;
    output reg [7:0] cell_photon_14;
    output reg [7:0] cell_photon_15;
    output reg cell_present_0;
    output reg cell_present_1;
    output reg cell_present_2;
    output reg cell_present_3;
    output reg cell_present_4;
    output reg cell_present_5;
    output reg cell_present_6;
    output reg cell_present_7;
    output reg cell_present_8;
    output reg cell_present_9;
    output reg cell_present_10;
    output reg cell_present_11;
    output reg cell_present_12;
    output reg cell_present_13;
    output reg cell_present_14;
    output reg cell_present_15;
    output reg [15:0] cell_power_0;
    output reg [15:0] cell_power_1;
    output reg [15:0] cell_power_2;
    output reg [15:0] cell_power_3;
    output reg [15:0] cell_power_4;
    output reg [15:0] cell_power_5;
    output reg [15:0] cell_power_6;
    output reg [15:0] cell_power_7;
    output reg [15:0] cell_power_8;
    output reg [15:0] cell_power_9;
    output reg [15:0] cell_power_10;
    output reg [15:0] cell_power_11;
    output reg [15:0] cell_power_12;
    output reg [15:0] cell_power_13;
    output reg [15:0] cell_power_14;
    output reg [15:0] cell_power_15;
    output reg [31:0] result_red;
    output reg [31:0] result_green;
    output reg [31:0] result_blue;
    output reg [31:0] result_count;
    // Update code
    always @(*) begin
        cell_query_0 = query_x;
        cell_photon_0 = x_0;
        cell_present_0 = present_0;
        cell_power_0 = red_0;
        cell_query_1 = query_x;
        cell_photon_1 = x_1;
        cell_present_1 = present_1;
        cell_power_1 = red_1;
        cell_query_2 = query_x;
        cell_photon_2 = x_2;
        cell_present_2 = present_2;
        cell_power_2 = red_2;
        cell_query_3 = query_x;
        cell_photon_3 = x_3;
        cell_present_3 = present_3;
        cell_power_3 = red_3;
        cell_query_4 = query_y;
        cell_photon_4 = y_0;
        cell_present_4 = present_0;
        cell_power_4 = green_0;
        cell_query_5 = query_y;
        cell_photon_5 = y_1;
        cell_present_5 = present_1;
        cell_power_5 = green_1;
        cell_query_6 = query_y;
        cell_photon_6 = y_2;
        cell_present_6 = present_2;
        cell_power_6 = green_2;
        cell_query_7 = query_y;
        cell_photon_7 = y_3;
        cell_present_7 = present_3;
        cell_power_7 = green_3;
        cell_query_8 = query_z;
        cell_photon_8 = z_0;
        cell_present_8 = present_0;
        cell_power_8 = blue_0;
        cell_query_9 = query_z;
        cell_photon_9 = z_1;
        cell_present_9 = present_1;
        cell_power_9 = blue_1;
        cell_query_10 = query_z;
        cell_photon_10 = z_2;
        cell_present_10 = present_2;
        cell_power_10 = blue_2;
        cell_query_11 = query_z;
        cell_photon_11 = z_3;
        cell_present_11 = present_3;
        cell_power_11 = blue_3;
        cell_query_12 = 8'h0;
        cell_photon_12 = 8'h0;
        cell_present_12 = present_0;
        cell_power_12 = 16'h1;
        cell_query_13 = 8'h0;
        cell_photon_13 = 8'h0;
        cell_present_13 = present_1;
        cell_power_13 = 16'h1;
        cell_query_14 = 8'h0;
        cell_photon_14 = 8'h0;
        cell_present_14 = present_2;
        cell_power_14 = 16'h1;
        cell_query_15 = 8'h0;
        cell_photon_15 = 8'h0;
        cell_present_15 = present_3;
        cell_power_15 = 16'h1;
        result_red = sum_0;
        result_green = sum_4;
        result_blue = sum_8;
        result_count = sum_12;
    end
endmodule

module photoncube_paper_network(axis, work_0, work_1, work_2, work_3, work_4, work_5,
    work_6, work_7, work_8, work_9, work_10, work_11, work_12, work_13, work_14, work_15, link_0,
    link_1, link_2, link_3, link_4, link_5, link_6, link_7, link_8, link_9, link_10, link_11,
    link_12, link_13, link_14, link_15);
    // Module arguments
    input wire [3:0] axis;
    input wire [17:0] work_0;
    input wire [17:0] work_1;
    input wire [17:0] work_2;
    input wire [17:0] work_3;
    input wire [17:0] work_4;
    input wire [17:0] work_5;
    input wire [17:0] work_6;
    input wire [17:0] work_7;
    input wire [17:0] work_8;
    input wire [17:0] work_9;
    input wire [17:0] work_10;
    input wire [17:0] work_11;
    input wire [17:0] work_12;
    input wire [17:0] work_13;
    input wire [17:0] work_14;
    input wire [17:0] work_15;
    output reg [17:0] link_0;
    output reg [17:0] link_1;
    output reg [17:0] link_2;
    output reg [17:0] link_3;
    output reg [17:0] link_4;
    output reg [17:0] link_5;
    output reg [17:0] link_6;
    output reg [17:0] link_7;
    output reg [17:0] link_8;
    output reg [17:0] link_9;
    output reg [17:0] link_10;
    output reg [17:0] link_11;
    output reg [17:0] link_12;
    output reg [17:0] link_13;
    output reg [17:0] link_14;
    output reg [17:0] link_15;
    // Update code
    always @(*) begin
        link_0 = 18'b0;
        link_1 = 18'b0;
        link_2 = 18'b0;
        link_3 = 18'b0;
        link_4 = 18'b0;
        link_5 = 18'b0;
        link_6 = 18'b0;
        link_7 = 18'b0;
        link_8 = 18'b0;
        link_9 = 18'b0;
        link_10 = 18'b0;
        link_11 = 18'b0;
        link_12 = 18'b0;
        link_13 = 18'b0;
        link_14 = 18'b0;
        link_15 = 18'b0;
        if (axis[32'h0]) begin
            link_0 = link_0 | work_1;
            link_1 = link_1 | work_0;
            link_2 = link_2 | work_3;
            link_3 = link_3 | work_2;
            link_4 = link_4 | work_5;
            link_5 = link_5 | work_4;
            link_6 = link_6 | work_7;
            link_7 = link_7 | work_6;
            link_8 = link_8 | work_9;
            link_9 = link_9 | work_8;
            link_10 = link_10 | work_11;
            link_11 = link_11 | work_10;
            link_12 = link_12 | work_13;
            link_13 = link_13 | work_12;
            link_14 = link_14 | work_15;
            link_15 = link_15 | work_14;
        end
        if (axis[32'h1]) begin
            link_0 = link_0 | work_2;
            link_1 = link_1 | work_3;
            link_2 = link_2 | work_0;
            link_3 = link_3 | work_1;
            link_4 = link_4 | work_6;
            link_5 = link_5 | work_7;
            link_6 = link_6 | work_4;
            link_7 = link_7 | work_5;
            link_8 = link_8 | work_10;
            link_9 = link_9 | work_11;
            link_10 = link_10 | work_8;
            link_11 = link_11 | work_9;
            link_12 = link_12 | work_14;
            link_13 = link_13 | work_15;
            link_14 = link_14 | work_12;
            link_15 = link_15 | work_13;
        end
        if (axis[32'h2]) begin
            link_0 = link_0 | work_4;
            link_1 = link_1 | work_5;
            link_2 = link_2 | work_6;
            link_3 = link_3 | work_7;
            link_4 = link_4 | work_0;
            link_5 = link_5 | work_1;
            link_6 = link_6 | work_2;
            link_7 = link_7 | work_3;
            link_8 = link_8 | work_12;
            link_9 = link_9 | work_13;
            link_10 = link_10 | work_14;
            link_11 = link_11 | work_15;
            link_12 = link_12 | work_8;
            link_13 = link_13 | work_9;
            link_14 = link_14 | work_10;
            link_15 = link_15 | work_11;
        end
        if (axis[32'h3]) begin
            link_0 = link_0 | work_8;
            link_1 = link_1 | work_9;
            link_2 = link_2 | work_10;
            link_3 = link_3 | work_11;
            link_4 = link_4 | work_12;
            link_5 = link_5 | work_13;
            link_6 = link_6 | work_14;
            link_7 = link_7 | work_15;
            link_8 = link_8 | work_0;
            link_9 = link_9 | work_1;
            link_10 = link_10 | work_2;
            link_11 = link_11 | work_3;
            link_12 = link_12 | work_4;
            link_13 = link_13 | work_5;
            link_14 = link_14 | work_6;
            link_15 = link_15 | work_7;
        end
    end
endmodule

module photoncube_paper_control(clock, reset, query_valid, query_ready, group_valid,
    group_last, group_ready, result_valid, result_ready, write_query, write_photon, write_power,
    write_work, write_sum, work_source, add_sum, axis);
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
    output reg write_photon;
    output reg write_power;
    output reg write_work;
    output reg write_sum;
    output reg [1:0] work_source;
    output reg add_sum;
    output reg [3:0] axis;
    // Constant declarations
    localparam iteration_address = 4'h1;
    localparam final_address = 4'h9;
    // Stub signals
    reg [3:0] address_d;
    wire [3:0] address_q;
    reg address_clock;
    reg last_d;
    wire last_q;
    reg last_clock;
    reg done_d;
    wire done_q;
    reg done_clock;
    reg [3:0] store_address;
    wire [14:0] store_word;
    reg [14:0] decoder_word;
    wire decoder_write_query;
    wire decoder_write_photon;
    wire decoder_write_power;
    wire decoder_write_work;
    wire decoder_write_sum;
    wire [1:0] decoder_work_source;
    wire decoder_add_sum;
    wire decoder_takes_query;
    wire decoder_reads_group;
    wire decoder_takes_group;
    wire [3:0] decoder_axis;
    // Local signals
    reg runs;
    reg at_end;
    reg taken;
    // Sub module instances
    photoncube_paper_register_4 address(
        .d(address_d),
        .q(address_q),
        .clock(address_clock)
    );
    photoncube_paper_register_1 last(
        .d(last_d),
        .q(last_q),
        .clock(last_clock)
    );
    photoncube_paper_register_1 done(
        .d(done_d),
        .q(done_q),
        .clock(done_clock)
    );
    photoncube_paper_store store(
        .address(store_address),
        .word(store_word)
    );
    photoncube_paper_decoder decoder(
        .word(decoder_word),
        .write_query(decoder_write_query),
        .write_photon(decoder_write_photon),
        .write_power(decoder_write_power),
        .write_work(decoder_write_work),
        .write_sum(decoder_write_sum),
        .work_source(decoder_work_source),
        .add_sum(decoder_add_sum),
        .takes_query(decoder_takes_query),
        .reads_group(decoder_reads_group),
        .takes_group(decoder_takes_group),
        .axis(decoder_axis)
    );
    // Update code
    always @(*) begin
        address_clock = clock;
        last_clock = clock;
        done_clock = clock;
        address_d = address_q;
        last_d = last_q;
        done_d = done_q;
        store_address = address_q;
        decoder_word = store_word;
        runs = 1'b1;
        if (decoder_takes_query) begin
            runs = query_valid;
        end
        if (decoder_reads_group) begin
            runs = group_valid;
        end
        if (done_q) begin
            runs = 1'b0;
        end
        query_ready = decoder_takes_query;
        group_ready = decoder_takes_group;
        if (done_q) begin
            query_ready = 1'b0;
            group_ready = 1'b0;
        end
        result_valid = done_q;
        write_query = decoder_write_query & runs;
        write_photon = decoder_write_photon & runs;
        write_power = decoder_write_power & runs;
        write_work = decoder_write_work & runs;
        write_sum = decoder_write_sum & runs;
        work_source = decoder_work_source;
        add_sum = decoder_add_sum;
        axis = decoder_axis;
        at_end = address_q == final_address;
        if (runs) begin
            address_d = address_q + 32'h1;
            if (at_end) begin
                address_d = iteration_address;
                if (last_q) begin
                    address_d = 32'h0;
                    done_d = 1'b1;
                end
            end
            if (decoder_takes_group) begin
                last_d = group_last;
            end
        end
        taken = done_q & result_ready;
        if (taken) begin
            done_d = 1'b0;
        end
        if (reset) begin
            address_d = 32'h0;
            last_d = 1'b0;
            done_d = 1'b0;
        end
    end
endmodule

module photoncube_paper_cell(clock, write_query, write_photon, write_power, write_work,
    write_sum, work_source, add_sum, query_in, radius_sq_in, photon_in, present_in, power_in,
    link_in, work_out, sum_out);
    // Module arguments
    input wire clock;
    input wire write_query;
    input wire write_photon;
    input wire write_power;
    input wire write_work;
    input wire write_sum;
    input wire [1:0] work_source;
    input wire add_sum;
    input wire [7:0] query_in;
    input wire [17:0] radius_sq_in;
    input wire [7:0] photon_in;
    input wire present_in;
    input wire [15:0] power_in;
    input wire [17:0] link_in;
    output reg [17:0] work_out;
    output reg [31:0] sum_out;
    // Constant declarations
    localparam high_bits = 32'hfffc0000;
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
    reg [15:0] power_d;
    wire [15:0] power_q;
    reg power_clock;
    reg [17:0] work_d;
    wire [17:0] work_q;
    reg work_clock;
    reg [31:0] sum_d;
    wire [31:0] sum_q;
    reg sum_clock;
    reg [7:0] square_unit_a;
    reg [7:0] square_unit_b;
    wire [15:0] square_unit_square;
    reg [17:0] gate_unit_a;
    reg [17:0] gate_unit_b;
    reg [15:0] gate_unit_power;
    wire [17:0] gate_unit_gated;
    reg [31:0] add_unit_a;
    reg [31:0] add_unit_b;
    wire [31:0] add_unit_sum;
    // Local signals
    reg [17:0] addend;
    reg [17:0] sum_low;
    reg [31:0] sum_high;
    reg [31:0] wide_addend;
    // Sub module instances
    photoncube_paper_register_8 query(
        .d(query_d),
        .q(query_q),
        .clock(query_clock)
    );
    photoncube_paper_register_18 radius_sq(
        .d(radius_sq_d),
        .q(radius_sq_q),
        .clock(radius_sq_clock)
    );
    photoncube_paper_register_8 photon(
        .d(photon_d),
        .q(photon_q),
        .clock(photon_clock)
    );
    photoncube_paper_register_16 power(
        .d(power_d),
        .q(power_q),
        .clock(power_clock)
    );
    photoncube_paper_register_18 work(
        .d(work_d),
        .q(work_q),
        .clock(work_clock)
    );
    photoncube_paper_register_32 sum(
        .d(sum_d),
        .q(sum_q),
        .clock(sum_clock)
    );
    photoncube_paper_square_unit square_unit(
        .a(square_unit_a),
        .b(square_unit_b),
        .square(square_unit_square)
    );
    photoncube_paper_gate_unit gate_unit(
        .a(gate_unit_a),
        .b(gate_unit_b),
        .power(gate_unit_power),
        .gated(gate_unit_gated)
    );
    photoncube_paper_add_unit add_unit(
        .a(add_unit_a),
        .b(add_unit_b),
        .sum(add_unit_sum)
    );
    // Update code
    always @(*) begin
        query_clock = clock;
        radius_sq_clock = clock;
        photon_clock = clock;
        power_clock = clock;
        work_clock = clock;
        sum_clock = clock;
        query_d = query_q;
        radius_sq_d = radius_sq_q;
        photon_d = photon_q;
        power_d = power_q;
        work_d = work_q;
        sum_d = sum_q;
        square_unit_a = query_q;
        square_unit_b = photon_q;
        gate_unit_a = work_q;
        gate_unit_b = radius_sq_q;
        gate_unit_power = power_q;
        sum_low = 32'h0;
        if (add_sum) begin
            sum_low = ((sum_q) & 18'h3ffff);
        end
        addend = link_in | sum_low;
        sum_high = sum_q & high_bits;
        wide_addend = ((addend) & 32'hffffffff);
        add_unit_a = ((work_q) & 32'hffffffff);
        add_unit_b = sum_high | wide_addend;
        if (write_query) begin
            query_d = query_in;
            radius_sq_d = radius_sq_in;
            sum_d = 32'h0;
        end
        if (write_photon) begin
            photon_d = photon_in;
        end
        if (write_power) begin
            power_d = power_in;
            if (~present_in) begin
                power_d = 32'h0;
            end
        end
        if (write_work) begin
            case (work_source)
                0:
                    begin
                        work_d = ((square_unit_square) & 18'h3ffff);
                    end
                1:
                    begin
                        work_d = ((add_unit_sum) & 18'h3ffff);
                    end
                default:
                    begin
                        work_d = gate_unit_gated;
                    end
            endcase
        end
        if (write_sum) begin
            sum_d = add_unit_sum;
        end
        work_out = work_q;
        sum_out = sum_q;
    end
endmodule

module photoncube_paper_register_32(d, q, clock);
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

module photoncube_paper_register_1(d, q, clock);
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

module photoncube_paper_store(address, word);
    // Module arguments
    input wire [3:0] address;
    output reg [14:0] word;
    // Update code
    always @(*) begin
        case (address)
            4'd0:
                begin
                    word = 15'b100000001;
                end
            4'd1:
                begin
                    word = 15'b1000000010;
                end
            4'd2:
                begin
                    word = 15'b11000000100;
                end
            4'd3:
                begin
                    word = 15'b1000;
                end
            4'd4:
                begin
                    word = 15'b10000000101000;
                end
            4'd5:
                begin
                    word = 15'b100000000101000;
                end
            4'd6:
                begin
                    word = 15'b1001000;
                end
            4'd7:
                begin
                    word = 15'b100000101000;
                end
            4'd8:
                begin
                    word = 15'b1000000101000;
                end
            4'd9:
                begin
                    word = 15'b10010000;
                end
            default:
                begin
                    word = 15'b0;
                end
        endcase
    end
endmodule

module photoncube_paper_register_16(d, q, clock);
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

module photoncube_paper_register_8(d, q, clock);
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

module photoncube_paper_decoder(word, write_query, write_photon, write_power, write_work,
    write_sum, work_source, add_sum, takes_query, reads_group, takes_group, axis);
    // Module arguments
    input wire [14:0] word;
    output reg write_query;
    output reg write_photon;
    output reg write_power;
    output reg write_work;
    output reg write_sum;
    output reg [1:0] work_source;
    output reg add_sum;
    output reg takes_query;
    output reg reads_group;
    output reg takes_group;
    output reg [3:0] axis;
    // Update code
    always @(*) begin
        write_query = word[32'h0];
        write_photon = word[32'h1];
        write_power = word[32'h2];
        write_work = word[32'h3];
        write_sum = word[32'h4];
        work_source = word[(32'h5)+:(2)];
        add_sum = word[32'h7];
        takes_query = word[32'h8];
        reads_group = word[32'h9];
        takes_group = word[32'ha];
        axis = word[(32'hb)+:(4)];
    end
endmodule

module photoncube_paper_register_4(d, q, clock);
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

module photoncube_paper_add_unit(a, b, sum);
    // Module arguments
    input wire [31:0] a;
    input wire [31:0] b;
    output reg [31:0] sum;
    // Update code
    always @(*) begin
        sum = a + b;
    end
endmodule

module photoncube_paper_register_18(d, q, clock);
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

module photoncube_paper_gate_unit(a, b, power, gated);
    // Module arguments
    input wire [17:0] a;
    input wire [17:0] b;
    input wire [15:0] power;
    output reg [17:0] gated;
    // Local signals
    reg [17:0] wide_b;
    reg out_of_range;
    // Update code
    always @(*) begin
        wide_b = ((b) & 18'h3ffff);
        out_of_range = a > wide_b;
        gated = ((power) & 18'h3ffff);
        if (out_of_range) begin
            gated = 32'h0;
        end
    end
endmodule

module photoncube_paper_square_unit(a, b, square);
    // Module arguments
    input wire [7:0] a;
    input wire [7:0] b;
    output reg [15:0] square;
    // Stub signals
    reg [7:0] difference_a;
    reg [7:0] difference_b;
    wire [7:0] difference_magnitude;
    reg [7:0] squarer_root;
    wire [15:0] squarer_square;
    // Sub module instances
    photoncube_paper_difference difference(
        .a(difference_a),
        .b(difference_b),
        .magnitude(difference_magnitude)
    );
    photoncube_paper_squarer squarer(
        .root(squarer_root),
        .square(squarer_square)
    );
    // Update code
    always @(*) begin
        difference_a = a;
        difference_b = b;
        squarer_root = difference_magnitude;
        square = squarer_square;
    end
endmodule

module photoncube_paper_squarer(root, square);
    // Module arguments
    input wire [7:0] root;
    output reg [15:0] square;
    // Update code (custom)
    function [7:0] digit_square;
      input [3:0] digit;
      case (digit)
        4'd0: digit_square = 8'd0;
        4'd1: digit_square = 8'd1;
        4'd2: digit_square = 8'd4;
        4'd3: digit_square = 8'd9;
        4'd4: digit_square = 8'd16;
        4'd5: digit_square = 8'd25;
        4'd6: digit_square = 8'd36;
        4'd7: digit_square = 8'd49;
        4'd8: digit_square = 8'd64;
        4'd9: digit_square = 8'd81;
        4'd10: digit_square = 8'd100;
        4'd11: digit_square = 8'd121;
        4'd12: digit_square = 8'd144;
        4'd13: digit_square = 8'd169;
        4'd14: digit_square = 8'd196;
        default: digit_square = 8'd225;
      endcase
    endfunction
    function [7:0] digit_product;
      input [3:0] first;
      input [3:0] second;
      reg [5:0] low;
      reg [5:0] high;
      begin
        low = (first[0] ? {2'd0, second} : 6'd0) + (first[1] ? {1'd0, second, 1'd0} : 6'd0);
        high = (first[2] ? {2'd0, second} : 6'd0) + (first[3] ? {1'd0, second, 1'd0} : 6'd0);
        digit_product = {2'd0, low} + {high, 2'd0};
      end
    endfunction
    wire [3:0] digit_0 = root[3:0];
    wire [3:0] digit_1 = root[7:4];
    always @(*) square = {digit_square(digit_1), digit_square(digit_0)}
        + {digit_product(digit_0, digit_1), 5'd0};
endmodule

module photoncube_paper_difference(a, b, magnitude);
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
