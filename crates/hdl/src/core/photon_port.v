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
    // A register, since it leads through all chains' to every place of the slice.
    output reg leaf_ready;
    output wire leaf_given;
    output wire leaf_refused;
    output wire set_too_long;
    // A leaf leaves the queue.
    input wire leaf_taken;
    // The number of the next leaf in its set.
    reg [NUMBER - 1:0] number;
    reg drops;
    initial number = {NUMBER{1'b0}};
    initial drops = 1'b0;
    initial leaf_ready = 1'b1;
    wire has_place;
    @TOP@_link #(.BITS(PLACE + 1), .STAGES(STAGES)) link(.clock(clock), .reset(reset), .in_valid(leaf_valid & leaf_ready & ~drops),
        .in_ready(has_place), .moves(leaf_given), .taken(leaf_taken));
    assign leaf_refused = leaf_valid & drops;
    assign set_too_long = leaf_given & ~leaf_last & (&number);
    wire drops_next = set_too_long | (drops & ~(leaf_valid & leaf_last));
    always @(posedge clock) begin
        if (leaf_given) number <= leaf_last ? {NUMBER{1'b0}} : number + 1'b1;
        drops <= drops_next;
        // In the clock behind a leaf its second group comes, so no other leaf may.
        leaf_ready <= drops_next | (has_place & ~leaf_given);
        if (reset) begin
            number <= {NUMBER{1'b0}};
            drops <= 1'b0;
            leaf_ready <= 1'b1;
        end
    end
endmodule
