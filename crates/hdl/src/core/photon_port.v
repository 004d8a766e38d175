// Takes the leaves of a chain into a place, gives them to the chain as groups, and drops those for which the chain's bank has no room.
module @TOP@_photon_port(clock, reset, leaf_valid, leaf_last, leaf_has_second, leaf, facing, leaf_ready,
    leaf_given, leaf_refused, set_too_long, group_valid, group_ready, group_last, group_facing, group);
    parameter GROUP = 1;
    parameter FACING = 1;
    parameter NUMBER = 1;
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
    // The number of the next leaf in its set.
    reg [NUMBER - 1:0] number;
    reg drops;
    reg second_valid;
    reg second_last;
    reg [FACING - 1:0] second_facing;
    reg [GROUP - 1:0] second_group;
    initial number = {NUMBER{1'b0}};
    initial drops = 1'b0;
    initial second_valid = 1'b0;
    wire leaf_moves = leaf_valid & leaf_ready;
    assign leaf_given = leaf_moves & ~drops;
    assign leaf_refused = leaf_moves & drops;
    assign set_too_long = leaf_given & ~leaf_last & (&number);
    // Only the last leaf of a set may have a single group.
    wire leaf_has_two = leaf_has_second | ~leaf_last;
    wire first_valid;
    wire first_ready = ~second_valid & group_ready;
    wire first_has_two;
    wire first_last;
    wire [FACING - 1:0] first_facing;
    wire [2 * GROUP - 1:0] first_leaf;
    @TOP@_place #(.WIDTH(2 * GROUP + FACING + 2)) leaf_place(.clock(clock), .reset(reset),
        .in_valid(leaf_valid & ~drops), .in_ready(leaf_ready), .in_word({leaf_has_two, leaf_last, facing, leaf}),
        .out_valid(first_valid), .out_ready(first_ready), .out_word({first_has_two, first_last, first_facing, first_leaf}));
    assign group_valid = second_valid | first_valid;
    assign group_last = second_valid ? second_last : ~first_has_two;
    assign group_facing = second_valid ? second_facing : first_facing;
    assign group = second_valid ? second_group : first_leaf[GROUP - 1:0];
    always @(posedge clock) begin
        if (leaf_given) number <= leaf_last ? {NUMBER{1'b0}} : number + 1'b1;
        if (set_too_long) drops <= 1'b1;
        if (leaf_refused & leaf_last) drops <= 1'b0;
        if (second_valid & group_ready) second_valid <= 1'b0;
        if (first_valid & first_ready) begin
            second_valid <= first_has_two;
            second_last <= first_last;
            second_facing <= first_facing;
            second_group <= first_leaf[2 * GROUP - 1:GROUP];
        end
        if (reset) begin
            number <= {NUMBER{1'b0}};
            drops <= 1'b0;
            second_valid <= 1'b0;
        end
    end
endmodule
