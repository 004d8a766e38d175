// SPDX-License-Identifier: MIT
// An example of how to drive paper: two sets of photons and 2 queries, 1 at once.
// Written by photoncube 0.2.0, `photoncube generate --machine paper`; do not edit.
//
//   iverilog -g2005 -o example photoncube_paper.v photoncube_paper_tb.v
//   vvp example
//
// The head of photoncube_paper.v has the rules of the ports. The golden model computed the expected results.

module photoncube_paper_tb;
    reg [41:0] queries [0:1];
    reg [292:0] groups [0:5];
    reg [127:0] results [0:1];
    initial begin
        // query_x, query_y, query_z, query_radius_sq
        queries[0] = {8'd137, 8'd144, 8'd116, 18'd2304};
        queries[1] = {8'd119, 8'd138, 8'd125, 18'd2304};

        // group_last, photon_present_0, photon_x_0, photon_y_0, photon_z_0, photon_red_0, photon_green_0, photon_blue_0,
        // photon_present_1, photon_x_1, photon_y_1, photon_z_1, photon_red_1, photon_green_1, photon_blue_1,
        // photon_present_2, photon_x_2, photon_y_2, photon_z_2, photon_red_2, photon_green_2, photon_blue_2,
        // photon_present_3, photon_x_3, photon_y_3, photon_z_3, photon_red_3, photon_green_3, photon_blue_3
        groups[0] = {1'd0,
            1'd1, 8'd96, 8'd181, 8'd120, 16'd44516, 16'd9913, 16'd25897,
            1'd1, 8'd124, 8'd135, 8'd150, 16'd26509, 16'd36773, 16'd46876,
            1'd1, 8'd147, 8'd124, 8'd162, 16'd34803, 16'd40782, 16'd19240,
            1'd1, 8'd84, 8'd140, 8'd136, 16'd17122, 16'd38469, 16'd43116};
        groups[1] = {1'd0,
            1'd1, 8'd86, 8'd165, 8'd150, 16'd22401, 16'd55772, 16'd12244,
            1'd1, 8'd182, 8'd74, 8'd76, 16'd3159, 16'd100, 16'd63311,
            1'd1, 8'd153, 8'd164, 8'd69, 16'd42684, 16'd7874, 16'd61705,
            1'd1, 8'd144, 8'd80, 8'd156, 16'd47298, 16'd30420, 16'd52756};
        groups[2] = {1'd1,
            1'd1, 8'd105, 8'd156, 8'd148, 16'd30793, 16'd60728, 16'd63766,
            219'd0};
        groups[3] = {1'd0,
            1'd1, 8'd189, 8'd143, 8'd105, 16'd14235, 16'd59163, 16'd12507,
            1'd1, 8'd143, 8'd88, 8'd180, 16'd31193, 16'd59535, 16'd12095,
            1'd1, 8'd145, 8'd131, 8'd112, 16'd60241, 16'd7454, 16'd63637,
            1'd1, 8'd156, 8'd154, 8'd173, 16'd47441, 16'd45453, 16'd55796};
        groups[4] = {1'd0,
            1'd1, 8'd89, 8'd127, 8'd89, 16'd9036, 16'd50300, 16'd6031,
            1'd1, 8'd188, 8'd109, 8'd64, 16'd55152, 16'd35004, 16'd27379,
            1'd1, 8'd99, 8'd169, 8'd121, 16'd5623, 16'd20417, 16'd26690,
            1'd1, 8'd72, 8'd88, 8'd118, 16'd54669, 16'd47196, 16'd51015};
        groups[5] = {1'd1,
            1'd1, 8'd173, 8'd176, 8'd149, 16'd32747, 16'd37535, 16'd42323,
            219'd0};

        // result_red, result_green, result_blue, result_count
        results[0] = {32'd57302, 32'd97501, 32'd110642, 32'd2};
        results[1] = {32'd65864, 32'd27871, 32'd90327, 32'd2};
    end

    reg clock = 1'b0;
    reg reset = 1'b1;
    integer clocks = 0, query = 0, group = 0, result = 0, wrong = 0, quiet = 0;
    always #5 clock = ~clock;

    wire query_valid;
    wire [7:0] query_x, query_y, query_z;
    wire [17:0] query_radius_sq;
    wire group_valid, group_last, photon_present_0;
    wire [7:0] photon_x_0, photon_y_0, photon_z_0;
    wire [15:0] photon_red_0, photon_green_0, photon_blue_0;
    wire photon_present_1;
    wire [7:0] photon_x_1, photon_y_1, photon_z_1;
    wire [15:0] photon_red_1, photon_green_1, photon_blue_1;
    wire photon_present_2;
    wire [7:0] photon_x_2, photon_y_2, photon_z_2;
    wire [15:0] photon_red_2, photon_green_2, photon_blue_2;
    wire photon_present_3;
    wire [7:0] photon_x_3, photon_y_3, photon_z_3;
    wire [15:0] photon_red_3, photon_green_3, photon_blue_3;
    wire result_ready, query_ready, group_ready, result_valid;
    wire [31:0] result_red, result_green, result_blue, result_count;

    // A word is on the pins, and does not change, while valid is 1. It moves at a rising edge at which ready is 1 too.
    assign query_valid = !reset && query < 2;
    assign group_valid = !reset && group < 6;
    // The testbench is slow to take results, so the machine must keep them.
    assign result_ready = !reset && clocks % 4 == 3;
    assign {query_x, query_y, query_z, query_radius_sq}
        = query_valid ? queries[query] : 42'd0;
    assign {group_last, photon_present_0, photon_x_0, photon_y_0, photon_z_0, photon_red_0, photon_green_0, photon_blue_0,
        photon_present_1, photon_x_1, photon_y_1, photon_z_1, photon_red_1, photon_green_1, photon_blue_1,
        photon_present_2, photon_x_2, photon_y_2, photon_z_2, photon_red_2, photon_green_2, photon_blue_2,
        photon_present_3, photon_x_3, photon_y_3, photon_z_3, photon_red_3, photon_green_3, photon_blue_3}
        = group_valid ? groups[group] : 293'd0;
    wire [127:0] found = {result_red, result_green, result_blue, result_count};

    photoncube_paper machine(
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
