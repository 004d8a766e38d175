// SPDX-License-Identifier: MIT
// An example of how to drive stream: two sets of photons and 2 queries, 1 at once.
// Written by photoncube 0.2.0, `photoncube generate --machine stream`; do not edit.
//
//   iverilog -g2005 -o example photoncube_stream.v photoncube_stream_tb.v
//   vvp example
//
// The head of photoncube_stream.v has the rules of the ports. The golden model computed the expected results.

module photoncube_stream_tb;
    reg [45:0] queries [0:1];
    reg [220:0] groups [0:5];
    reg [80:0] results [0:1];
    initial begin
        // query_x, query_y, query_z, query_radius_sq
        queries[0] = {10'd547, 10'd574, 10'd464, 16'd36864};
        queries[1] = {10'd475, 10'd550, 10'd502, 16'd36864};

        // group_last, photon_present_0, photon_x_0, photon_y_0, photon_z_0, photon_red_0, photon_green_0, photon_blue_0,
        // photon_present_1, photon_x_1, photon_y_1, photon_z_1, photon_red_1, photon_green_1, photon_blue_1,
        // photon_present_2, photon_x_2, photon_y_2, photon_z_2, photon_red_2, photon_green_2, photon_blue_2,
        // photon_present_3, photon_x_3, photon_y_3, photon_z_3, photon_red_3, photon_green_3, photon_blue_3
        groups[0] = {1'd0,
            1'd1, 10'd385, 10'd724, 10'd478, 8'd173, 8'd38, 8'd101,
            1'd1, 10'd497, 10'd541, 10'd601, 8'd103, 8'd143, 8'd183,
            1'd1, 10'd589, 10'd495, 10'd645, 8'd135, 8'd159, 8'd75,
            1'd1, 10'd338, 10'd559, 10'd544, 8'd66, 8'd150, 8'd168};
        groups[1] = {1'd0,
            1'd1, 10'd344, 10'd658, 10'd598, 8'd87, 8'd217, 8'd47,
            1'd1, 10'd728, 10'd296, 10'd304, 8'd12, 8'd0, 8'd247,
            1'd1, 10'd611, 10'd657, 10'd278, 8'd166, 8'd30, 8'd241,
            1'd1, 10'd576, 10'd322, 10'd623, 8'd184, 8'd118, 8'd206};
        groups[2] = {1'd1,
            1'd1, 10'd420, 10'd623, 10'd593, 8'd120, 8'd237, 8'd249,
            165'd0};
        groups[3] = {1'd0,
            1'd1, 10'd755, 10'd571, 10'd419, 8'd55, 8'd231, 8'd48,
            1'd1, 10'd573, 10'd353, 10'd721, 8'd121, 8'd232, 8'd47,
            1'd1, 10'd581, 10'd523, 10'd447, 8'd235, 8'd29, 8'd248,
            1'd1, 10'd622, 10'd616, 10'd690, 8'd185, 8'd177, 8'd217};
        groups[4] = {1'd0,
            1'd1, 10'd359, 10'd507, 10'd357, 8'd35, 8'd196, 8'd23,
            1'd1, 10'd749, 10'd437, 10'd256, 8'd215, 8'd136, 8'd106,
            1'd1, 10'd396, 10'd674, 10'd485, 8'd21, 8'd79, 8'd104,
            1'd1, 10'd289, 10'd351, 10'd474, 8'd213, 8'd184, 8'd199};
        groups[5] = {1'd1,
            1'd1, 10'd691, 10'd703, 10'd594, 8'd127, 8'd146, 8'd165,
            165'd0};

        // result_red, result_green, result_blue, result_count
        results[0] = {22'd223, 22'd380, 22'd432, 15'd2};
        results[1] = {22'd291, 22'd304, 22'd375, 15'd3};
    end

    reg clock = 1'b0;
    reg reset = 1'b1;
    integer clocks = 0, query = 0, group = 0, result = 0, wrong = 0, quiet = 0;
    always #5 clock = ~clock;

    wire query_valid;
    wire [9:0] query_x, query_y, query_z;
    wire [15:0] query_radius_sq;
    wire group_valid, group_last, photon_present_0;
    wire [9:0] photon_x_0, photon_y_0, photon_z_0;
    wire [7:0] photon_red_0, photon_green_0, photon_blue_0;
    wire photon_present_1;
    wire [9:0] photon_x_1, photon_y_1, photon_z_1;
    wire [7:0] photon_red_1, photon_green_1, photon_blue_1;
    wire photon_present_2;
    wire [9:0] photon_x_2, photon_y_2, photon_z_2;
    wire [7:0] photon_red_2, photon_green_2, photon_blue_2;
    wire photon_present_3;
    wire [9:0] photon_x_3, photon_y_3, photon_z_3;
    wire [7:0] photon_red_3, photon_green_3, photon_blue_3;
    wire result_ready, query_ready, group_ready, result_valid;
    wire [21:0] result_red, result_green, result_blue;
    wire [14:0] result_count;

    // A word is on the pins, and does not change, while valid is 1. It moves at a rising edge at which ready is 1 too.
    assign query_valid = !reset && query < 2;
    assign group_valid = !reset && group < 6;
    // The testbench is slow to take results, so the machine must keep them.
    assign result_ready = !reset && clocks % 4 == 3;
    assign {query_x, query_y, query_z, query_radius_sq}
        = query_valid ? queries[query] : 46'd0;
    assign {group_last, photon_present_0, photon_x_0, photon_y_0, photon_z_0, photon_red_0, photon_green_0, photon_blue_0,
        photon_present_1, photon_x_1, photon_y_1, photon_z_1, photon_red_1, photon_green_1, photon_blue_1,
        photon_present_2, photon_x_2, photon_y_2, photon_z_2, photon_red_2, photon_green_2, photon_blue_2,
        photon_present_3, photon_x_3, photon_y_3, photon_z_3, photon_red_3, photon_green_3, photon_blue_3}
        = group_valid ? groups[group] : 221'd0;
    wire [80:0] found = {result_red, result_green, result_blue, result_count};

    photoncube_stream machine(
        .clock(clock), .reset(reset), .query_valid(query_valid), .query_x(query_x), .query_y(query_y), .query_z(query_z),
        .query_radius_sq(query_radius_sq), .group_valid(group_valid), .group_last(group_last),
        .photon_present_0(photon_present_0), .photon_x_0(photon_x_0), .photon_y_0(photon_y_0), .photon_z_0(photon_z_0),
        .photon_red_0(photon_red_0), .photon_green_0(photon_green_0), .photon_blue_0(photon_blue_0),
        .photon_present_1(photon_present_1), .photon_x_1(photon_x_1), .photon_y_1(photon_y_1), .photon_z_1(photon_z_1),
        .photon_red_1(photon_red_1), .photon_green_1(photon_green_1), .photon_blue_1(photon_blue_1),
        .photon_present_2(photon_present_2), .photon_x_2(photon_x_2), .photon_y_2(photon_y_2), .photon_z_2(photon_z_2),
        .photon_red_2(photon_red_2), .photon_green_2(photon_green_2), .photon_blue_2(photon_blue_2),
        .photon_present_3(photon_present_3), .photon_x_3(photon_x_3), .photon_y_3(photon_y_3), .photon_z_3(photon_z_3),
        .photon_red_3(photon_red_3), .photon_green_3(photon_green_3), .photon_blue_3(photon_blue_3),
        .result_ready(result_ready), .query_ready(query_ready), .group_ready(group_ready), .result_valid(result_valid),
        .result_red(result_red), .result_green(result_green), .result_blue(result_blue), .result_count(result_count));

    always @(posedge clock) begin
        clocks <= clocks + 1;
        reset <= clocks < 3;
        if (query_valid && query_ready) query <= query + 1;
        if (group_valid && group_ready) group <= group + 1;
        if (result_valid && result_ready) begin
            result <= result + 1;
            if (found !== results[result]) begin
                wrong <= wrong + 1;
                $display("result %0d is %h, expected %h", result, found, results[result]);
            end
        end
        // The end is behind many clocks in which no word moves.
        if (query_valid && query_ready || group_valid && group_ready || result_valid && result_ready) quiet <= 0;
        else quiet <= quiet + 1;
        if (quiet == 300) begin
            if (result == 2 && wrong == 0) $display("PASSED: %0d results", result);
            else $display("FAILED: %0d of 2 results came, %0d of them wrong", result, wrong);
            $finish;
        end
    end
endmodule
