// The queue of leaves in front of a chain, as groups. The second group of a leaf comes a clock after its first.
module @TOP@_photon_queue(clock, reset, leaf_valid, leaf_has_second, leaf_last, leaf_facing, first, second, leaf_taken,
    group_valid, group_ready, group_last, group_facing, group);
    parameter GROUP = 1;
    parameter FACING = 1;
    // The queue has 2^PLACE places for groups.
    parameter PLACE = 1;
    input wire clock;
    input wire reset;
    input wire leaf_valid;
    input wire leaf_has_second;
    input wire leaf_last;
    input wire [FACING - 1:0] leaf_facing;
    input wire [GROUP - 1:0] first;
    // The second group of the leaf that came in the clock before.
    input wire [GROUP - 1:0] second;
    output wire leaf_taken;
    output wire group_valid;
    input wire group_ready;
    output wire group_last;
    output wire [FACING - 1:0] group_facing;
    output wire [GROUP - 1:0] group;
    reg second_comes;
    reg second_last;
    reg [FACING - 1:0] second_facing;
    initial second_comes = 1'b0;
    // Only the last leaf of a set may have a single group.
    wire has_two = leaf_has_second | ~leaf_last;
    // From the highest bit: whether it is the last of its leaf, and of its set; the facing; the photons.
    wire [GROUP + FACING + 1:0] first_in = {~has_two, leaf_last & ~has_two, leaf_facing, first};
    wire [GROUP + FACING + 1:0] second_in = {1'b1, second_last, second_facing, second};
    wire ends;
    @TOP@_queue #(.WIDTH(GROUP + FACING + 2), .PLACE(PLACE)) queue(.clock(clock), .reset(reset),
        .in_valid(leaf_valid | second_comes), .in_word(second_comes ? second_in : first_in),
        .out_valid(group_valid), .out_ready(group_ready), .out_word({ends, group_last, group_facing, group}));
    assign leaf_taken = group_valid & group_ready & ends;
    always @(posedge clock) begin
        second_comes <= leaf_valid & has_two & ~reset;
        second_last <= leaf_last;
        second_facing <= leaf_facing;
    end
endmodule
