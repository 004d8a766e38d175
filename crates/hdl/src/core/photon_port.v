// Gives the leaves of a chain to it as groups, and drops the leaves for which the chain's bank has no place.
module @TOP@_photon_port(clock, reset, leaf_valid, leaf_last, leaf_has_second, leaf, facing, leaf_ready,
    leaf_given, leaf_refused, set_too_long, group_valid, group_ready, group_last, group_facing, group);
    parameter GROUP = 1;
    parameter FACING = 1;
    parameter PLACE = 1;
    input wire clock;
    input wire reset;
    input wire leaf_valid;
    input wire leaf_last;
    input wire leaf_has_second;
    input wire [2 * GROUP - 1:0] leaf;
    input wire [FACING - 1:0] facing;
    output wire leaf_ready;
    output wire leaf_given;
    output wire leaf_refused;
    output wire set_too_long;
    output wire group_valid;
    input wire group_ready;
    output wire group_last;
    output wire [FACING - 1:0] group_facing;
    output wire [GROUP - 1:0] group;
    reg second_valid;
    reg second_last;
    reg [FACING - 1:0] second_facing;
    reg [GROUP - 1:0] second_group;
    // The number of the next leaf in its set.
    reg [PLACE - 1:0] place;
    reg drops;
    initial second_valid = 1'b0;
    initial place = {PLACE{1'b0}};
    initial drops = 1'b0;
    wire first_valid = leaf_valid & ~drops & ~second_valid;
    // Only the last leaf of a set may have a single group.
    wire two_groups = leaf_has_second | ~leaf_last;
    assign leaf_ready = drops | (~second_valid & group_ready);
    assign leaf_given = first_valid & group_ready;
    assign leaf_refused = leaf_valid & drops;
    assign set_too_long = leaf_given & ~leaf_last & (&place);
    assign group_valid = second_valid | first_valid;
    assign group_last = second_valid ? second_last : ~two_groups;
    assign group_facing = second_valid ? second_facing : facing;
    assign group = second_valid ? second_group : leaf[GROUP - 1:0];
    always @(posedge clock) begin
        if (second_valid & group_ready) second_valid <= 1'b0;
        if (leaf_given) begin
            place <= leaf_last ? {PLACE{1'b0}} : place + 1'b1;
            second_valid <= two_groups;
            second_last <= leaf_last;
            second_facing <= facing;
            second_group <= leaf[2 * GROUP - 1:GROUP];
        end
        if (set_too_long) drops <= 1'b1;
        if (leaf_refused & leaf_last) drops <= 1'b0;
        if (reset) begin
            second_valid <= 1'b0;
            place <= {PLACE{1'b0}};
            drops <= 1'b0;
        end
    end
endmodule
