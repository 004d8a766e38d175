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
    // From the highest bit: whether it is the last of its leaf, and of its set; the facing; the photons.
    reg [GROUP + FACING + 1:0] groups [0:(1 << PLACE) - 1];
    // The places of the next group to write and to give; one more bit says whether all are full where the places are the same.
    reg [PLACE:0] write;
    reg [PLACE:0] read;
    reg second_comes;
    reg second_last;
    reg [FACING - 1:0] second_facing;
    initial write = {(PLACE + 1){1'b0}};
    initial read = {(PLACE + 1){1'b0}};
    initial second_comes = 1'b0;
    // Only the last leaf of a set may have a single group.
    wire has_two = leaf_has_second | ~leaf_last;
    wire comes = leaf_valid | second_comes;
    wire [GROUP + FACING + 1:0] first_in = {~has_two, leaf_last & ~has_two, leaf_facing, first};
    wire [GROUP + FACING + 1:0] second_in = {1'b1, second_last, second_facing, second};
    wire [GROUP + FACING + 1:0] front = groups[read[PLACE - 1:0]];
    wire group_moves = group_valid & group_ready;
    assign group_valid = write != read;
    assign leaf_taken = group_moves & front[GROUP + FACING + 1];
    assign group_last = front[GROUP + FACING];
    assign group_facing = front[GROUP +: FACING];
    assign group = front[GROUP - 1:0];
    always @(posedge clock) begin
        if (comes) groups[write[PLACE - 1:0]] <= second_comes ? second_in : first_in;
        write <= reset ? {(PLACE + 1){1'b0}} : write + comes;
        read <= reset ? {(PLACE + 1){1'b0}} : read + group_moves;
        second_comes <= leaf_valid & has_two & ~reset;
        second_last <= leaf_last;
        second_facing <= leaf_facing;
    end
endmodule
