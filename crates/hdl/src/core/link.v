// Flow control by credits, between a stream and the queue for its words at a chain. A word that moves is on its way to the queue for as many
// clocks as it has stages to pass, and so is the credit that comes back. So no path leads from the chain to the stream.
module @TOP@_link(clock, reset, in_valid, in_ready, moves, taken);
    // The queue has 2^(BITS - 1) places.
    parameter BITS = 1;
    parameter STAGES = 1;
    input wire clock;
    input wire reset;
    input wire in_valid;
    output wire in_ready;
    // The word leaves the stream.
    output wire moves;
    // A word leaves the queue.
    input wire taken;
    reg [STAGES - 1:0] returning;
    wire [STAGES:0] come_back = {returning, taken};
    // The credits: the places that are left, less one. So the sign says that there is none.
    reg [BITS - 1:0] left;
    localparam [BITS - 1:0] ALL_LEFT = {BITS{1'b1}} >> 1;
    initial returning = {STAGES{1'b0}};
    initial left = ALL_LEFT;
    assign in_ready = ~left[BITS - 1];
    assign moves = in_valid & in_ready & ~reset;
    always @(posedge clock) begin
        returning <= reset ? {STAGES{1'b0}} : come_back[STAGES - 1:0];
        left <= reset ? ALL_LEFT : left - moves + returning[STAGES - 1];
    end
endmodule
