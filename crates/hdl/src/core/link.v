// Flow control by credits, between a stream and the places for its words at a chain. A word goes to the chain where a place is left.
// A register holds what comes back from the chain, so no path leads from the chain to the stream.
module @TOP@_link(clock, reset, in_valid, in_ready, moves, taken);
    // The chain has 2^(BITS - 1) places.
    parameter BITS = 1;
    input wire clock;
    input wire reset;
    input wire in_valid;
    output wire in_ready;
    // The word goes to its place.
    output wire moves;
    // A word leaves its place.
    input wire taken;
    reg returned;
    // The credits: the places that are left, less one. So the sign says that there is none.
    reg [BITS - 1:0] left;
    localparam [BITS - 1:0] ALL_LEFT = {BITS{1'b1}} >> 1;
    initial returned = 1'b0;
    initial left = ALL_LEFT;
    assign in_ready = ~left[BITS - 1] & ~reset;
    assign moves = in_valid & in_ready;
    always @(posedge clock) begin
        returned <= taken & ~reset;
        left <= reset ? ALL_LEFT : left - moves + returned;
    end
endmodule
