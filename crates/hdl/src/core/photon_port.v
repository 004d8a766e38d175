// Says which leaves of the photon slice go to a chain, and drops those for which the chain's bank has no room.
module @TOP@_photon_port(clock, reset, leaf_valid, leaf_last, leaf_ready, leaf_given, leaf_refused, set_too_long, leaf_taken);
    parameter NUMBER = 1;
    // The queue has 2^PLACE places for leaves.
    parameter PLACE = 1;
    parameter STAGES = 1;
    input wire clock;
    input wire reset;
    input wire leaf_valid;
    input wire leaf_last;
    output wire leaf_ready;
    output wire leaf_given;
    output wire leaf_refused;
    output wire set_too_long;
    // A leaf leaves the queue.
    input wire leaf_taken;
    // The number of the next leaf in its set.
    reg [NUMBER - 1:0] number;
    reg drops;
    // A leaf was given in the clock before. Its second group comes now, so no other leaf may come.
    reg gave;
    initial number = {NUMBER{1'b0}};
    initial drops = 1'b0;
    initial gave = 1'b0;
    wire has_place;
    @TOP@_link #(.BITS(PLACE + 1), .STAGES(STAGES)) link(.clock(clock), .reset(reset), .in_valid(leaf_valid & ~drops & ~gave),
        .in_ready(has_place), .moves(leaf_given), .taken(leaf_taken));
    assign leaf_ready = (has_place & ~gave) | drops;
    assign leaf_refused = leaf_valid & drops;
    assign set_too_long = leaf_given & ~leaf_last & (&number);
    always @(posedge clock) begin
        if (leaf_given) number <= leaf_last ? {NUMBER{1'b0}} : number + 1'b1;
        if (set_too_long) drops <= 1'b1;
        if (leaf_refused & leaf_last) drops <= 1'b0;
        gave <= leaf_given;
        if (reset) begin
            number <= {NUMBER{1'b0}};
            drops <= 1'b0;
            gave <= 1'b0;
        end
    end
endmodule
