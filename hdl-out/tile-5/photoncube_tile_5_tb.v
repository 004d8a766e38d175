// SPDX-License-Identifier: MIT
// An example of how to drive tile-5: two sets of photons and 4 queries, 2 at once.
// Written by photoncube 0.2.0, `photoncube generate --machine tile-5`; do not edit.
//
//   iverilog -g2005 -o example photoncube_tile_5.v photoncube_tile_5_tb.v
//   vvp example
//
// The head of photoncube_tile_5.v has the rules of the ports. The golden model computed the expected results.

module photoncube_tile_5_tb;
    reg [26:0] queries [0:3];
    reg [184:0] groups [0:5];
    reg [66:0] results [0:3];
    initial begin
        // query_x, query_y, query_z
        queries[0] = {9'd274, 9'd287, 9'd232};
        queries[1] = {9'd274, 9'd234, 9'd286};
        queries[2] = {9'd237, 9'd275, 9'd251};
        queries[3] = {9'd236, 9'd246, 9'd253};

        // group_last, photon_present_0, photon_x_0, photon_y_0, photon_z_0, photon_red_0, photon_green_0, photon_blue_0,
        // photon_present_1, photon_x_1, photon_y_1, photon_z_1, photon_red_1, photon_green_1, photon_blue_1,
        // photon_present_2, photon_x_2, photon_y_2, photon_z_2, photon_red_2, photon_green_2, photon_blue_2,
        // photon_present_3, photon_x_3, photon_y_3, photon_z_3, photon_red_3, photon_green_3, photon_blue_3
        groups[0] = {1'd0,
            1'd1, 9'd192, 9'd362, 9'd239, 6'd43, 6'd9, 6'd25,
            1'd1, 9'd248, 9'd270, 9'd301, 6'd25, 6'd35, 6'd45,
            1'd1, 9'd295, 9'd247, 9'd323, 6'd33, 6'd39, 6'd18,
            1'd1, 9'd169, 9'd280, 9'd272, 6'd16, 6'd37, 6'd42};
        groups[1] = {1'd0,
            1'd1, 9'd172, 9'd329, 9'd299, 6'd21, 6'd54, 6'd11,
            1'd1, 9'd364, 9'd148, 9'd152, 6'd3, 6'd0, 6'd61,
            1'd1, 9'd306, 9'd328, 9'd139, 6'd41, 6'd7, 6'd60,
            1'd1, 9'd288, 9'd161, 9'd312, 6'd46, 6'd29, 6'd51};
        groups[2] = {1'd1,
            1'd1, 9'd210, 9'd312, 9'd297, 6'd30, 6'd59, 6'd62,
            138'd0};
        groups[3] = {1'd0,
            1'd1, 9'd378, 9'd286, 9'd209, 6'd13, 6'd57, 6'd12,
            1'd1, 9'd287, 9'd177, 9'd361, 6'd30, 6'd58, 6'd11,
            1'd1, 9'd291, 9'd261, 9'd224, 6'd58, 6'd7, 6'd62,
            1'd1, 9'd311, 9'd308, 9'd345, 6'd46, 6'd44, 6'd54};
        groups[4] = {1'd0,
            1'd1, 9'd179, 9'd254, 9'd178, 6'd8, 6'd49, 6'd5,
            1'd1, 9'd375, 9'd219, 9'd128, 6'd53, 6'd34, 6'd26,
            1'd1, 9'd198, 9'd337, 9'd243, 6'd5, 6'd19, 6'd26,
            1'd1, 9'd144, 9'd175, 9'd237, 6'd53, 6'd46, 6'd49};
        groups[5] = {1'd1,
            1'd1, 9'd346, 9'd352, 9'd297, 6'd31, 6'd36, 6'd41,
            138'd0};

        // result_red, result_green, result_blue, result_count
        results[0] = {18'd188, 18'd186, 18'd252, 13'd6};
        results[1] = {18'd150, 18'd199, 18'd218, 13'd5};
        results[2] = {18'd117, 18'd119, 18'd147, 13'd4};
        results[3] = {18'd124, 18'd121, 18'd142, 13'd4};
    end

    reg clock = 1'b0;
    reg reset = 1'b1;
    integer clocks = 0, query = 0, group = 0, result = 0, wrong = 0, quiet = 0;
    always #5 clock = ~clock;

    wire query_valid;
    wire [8:0] query_x, query_y, query_z;
    wire group_valid, group_last, photon_present_0;
    wire [8:0] photon_x_0, photon_y_0, photon_z_0;
    wire [5:0] photon_red_0, photon_green_0, photon_blue_0;
    wire photon_present_1;
    wire [8:0] photon_x_1, photon_y_1, photon_z_1;
    wire [5:0] photon_red_1, photon_green_1, photon_blue_1;
    wire photon_present_2;
    wire [8:0] photon_x_2, photon_y_2, photon_z_2;
    wire [5:0] photon_red_2, photon_green_2, photon_blue_2;
    wire photon_present_3;
    wire [8:0] photon_x_3, photon_y_3, photon_z_3;
    wire [5:0] photon_red_3, photon_green_3, photon_blue_3;
    wire result_ready, query_ready, group_ready, result_valid;
    wire [17:0] result_red, result_green, result_blue;
    wire [12:0] result_count;

    // A word is on the pins, and does not change, while valid is 1. It moves at a rising edge at which ready is 1 too.
    assign query_valid = !reset && query < 4;
    assign group_valid = !reset && group < 6;
    // The testbench is slow to take results, so the machine must keep them.
    assign result_ready = !reset && clocks % 4 == 3;
    assign {query_x, query_y, query_z}
        = query_valid ? queries[query] : 27'd0;
    assign {group_last, photon_present_0, photon_x_0, photon_y_0, photon_z_0, photon_red_0, photon_green_0, photon_blue_0,
        photon_present_1, photon_x_1, photon_y_1, photon_z_1, photon_red_1, photon_green_1, photon_blue_1,
        photon_present_2, photon_x_2, photon_y_2, photon_z_2, photon_red_2, photon_green_2, photon_blue_2,
        photon_present_3, photon_x_3, photon_y_3, photon_z_3, photon_red_3, photon_green_3, photon_blue_3}
        = group_valid ? groups[group] : 185'd0;
    wire [66:0] found = {result_red, result_green, result_blue, result_count};

    photoncube_tile_5 machine(
        .clock(clock), .reset(reset), .query_valid(query_valid), .query_x(query_x), .query_y(query_y), .query_z(query_z),
        .group_valid(group_valid), .group_last(group_last), .photon_present_0(photon_present_0), .photon_x_0(photon_x_0),
        .photon_y_0(photon_y_0), .photon_z_0(photon_z_0), .photon_red_0(photon_red_0), .photon_green_0(photon_green_0),
        .photon_blue_0(photon_blue_0), .photon_present_1(photon_present_1), .photon_x_1(photon_x_1),
        .photon_y_1(photon_y_1), .photon_z_1(photon_z_1), .photon_red_1(photon_red_1), .photon_green_1(photon_green_1),
        .photon_blue_1(photon_blue_1), .photon_present_2(photon_present_2), .photon_x_2(photon_x_2),
        .photon_y_2(photon_y_2), .photon_z_2(photon_z_2), .photon_red_2(photon_red_2), .photon_green_2(photon_green_2),
        .photon_blue_2(photon_blue_2), .photon_present_3(photon_present_3), .photon_x_3(photon_x_3),
        .photon_y_3(photon_y_3), .photon_z_3(photon_z_3), .photon_red_3(photon_red_3), .photon_green_3(photon_green_3),
        .photon_blue_3(photon_blue_3), .result_ready(result_ready), .query_ready(query_ready), .group_ready(group_ready),
        .result_valid(result_valid), .result_red(result_red), .result_green(result_green), .result_blue(result_blue),
        .result_count(result_count));

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
            if (result == 4 && wrong == 0) $display("PASSED: %0d results", result);
            else $display("FAILED: %0d of 4 results came, %0d of them wrong", result, wrong);
            $finish;
        end
    end
endmodule
