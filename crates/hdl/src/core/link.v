// Lets the words of a stream go to a chain that is far away: a word goes where a place at the chain is empty and no word is under way to it.
// Both ways are registers, so no path leads from the chain to the stream.
module @TOP@_link(clock, reset, in_valid, in_ready, arrives, taken);
    // The chain has 2^(BITS - 1) places.
    parameter BITS = 1;
    input wire clock;
    input wire reset;
    input wire in_valid;
    output wire in_ready;
    // The word that left the stream in the clock before is at the chain.
    output reg arrives;
    // A word leaves its place at the chain.
    input wire taken;
    reg returned;
    // One less than the places that are left: the sign says that there is none.
    reg [BITS - 1:0] left;
    localparam [BITS - 1:0] ALL_LEFT = {BITS{1'b1}} >> 1;
    initial arrives = 1'b0;
    initial returned = 1'b0;
    initial left = ALL_LEFT;
    assign in_ready = ~left[BITS - 1] & ~reset;
    wire moves = in_valid & in_ready;
    always @(posedge clock) begin
        arrives <= moves & ~reset;
        returned <= taken & ~reset;
        left <= reset ? ALL_LEFT : left - moves + returned;
    end
endmodule
