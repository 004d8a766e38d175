// Takes the leaves of a chain into two places beside the chain, gives them to the chain as groups, and drops those for which the chain's bank has
// no room.
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
    // The places, from the highest bit: two groups, last, facing, the photons. Leaves go to them in turn.
    reg [2 * GROUP + FACING + 1:0] even;
    reg [2 * GROUP + FACING + 1:0] odd;
    reg even_full;
    reg odd_full;
    reg writes_odd;
    // The group that is given.
    reg reads_odd;
    reg reads_second;
    initial number = {NUMBER{1'b0}};
    initial drops = 1'b0;
    initial even_full = 1'b0;
    initial odd_full = 1'b0;
    initial writes_odd = 1'b0;
    initial reads_odd = 1'b0;
    initial reads_second = 1'b0;
    // Only the last leaf of a set may have a single group.
    wire [2 * GROUP + FACING + 1:0] word = {leaf_has_second | ~leaf_last, leaf_last, facing, leaf};
    wire [2 * GROUP + FACING + 1:0] front = reads_odd ? odd : even;
    wire ends = reads_second | ~front[2 * GROUP + FACING + 1];
    wire group_moves = group_valid & group_ready;
    wire has_place;
    @TOP@_link #(.BITS(2)) link(.clock(clock), .reset(reset), .in_valid(leaf_valid & ~drops), .in_ready(has_place),
        .moves(leaf_given), .taken(group_moves & ends));
    assign leaf_ready = has_place | drops;
    assign leaf_refused = leaf_valid & drops;
    assign set_too_long = leaf_given & ~leaf_last & (&number);
    assign group_valid = reads_odd ? odd_full : even_full;
    assign group_last = ends & front[2 * GROUP + FACING];
    assign group_facing = front[2 * GROUP +: FACING];
    assign group = reads_second ? front[2 * GROUP - 1:GROUP] : front[GROUP - 1:0];
    always @(posedge clock) begin
        if (leaf_given) number <= leaf_last ? {NUMBER{1'b0}} : number + 1'b1;
        if (set_too_long) drops <= 1'b1;
        if (leaf_refused & leaf_last) drops <= 1'b0;
        if (~even_full) even <= word;
        if (~odd_full) odd <= word;
        if (leaf_given) begin
            if (writes_odd) odd_full <= 1'b1;
            else even_full <= 1'b1;
            writes_odd <= ~writes_odd;
        end
        if (group_moves) reads_second <= ~ends;
        if (group_moves & ends) begin
            if (reads_odd) odd_full <= 1'b0;
            else even_full <= 1'b0;
            reads_odd <= ~reads_odd;
        end
        if (reset) begin
            number <= {NUMBER{1'b0}};
            drops <= 1'b0;
            even_full <= 1'b0;
            odd_full <= 1'b0;
            writes_odd <= 1'b0;
            reads_odd <= 1'b0;
            reads_second <= 1'b0;
        end
    end
endmodule
