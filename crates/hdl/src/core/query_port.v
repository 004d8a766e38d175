// The queue of queries in front of a chain.
module @TOP@_query_port(clock, reset, query_valid, query_ready, query_given, query, out_valid, out_ready, out_word);
    parameter WIDTH = 1;
    // The queue has 2^PLACE places.
    parameter PLACE = 1;
    input wire clock;
    input wire reset;
    input wire query_valid;
    output wire query_ready;
    output wire query_given;
    input wire [WIDTH - 1:0] query;
    output wire out_valid;
    input wire out_ready;
    output wire [WIDTH - 1:0] out_word;
    reg [WIDTH - 1:0] words [0:(1 << PLACE) - 1];
    // The places of the next word to write and to give; one more bit says whether all are full where the places are the same.
    reg [PLACE:0] write;
    reg [PLACE:0] read;
    initial write = {(PLACE + 1){1'b0}};
    initial read = {(PLACE + 1){1'b0}};
    wire taken = out_valid & out_ready;
    @TOP@_link #(.BITS(PLACE + 1)) link(.clock(clock), .reset(reset), .in_valid(query_valid), .in_ready(query_ready),
        .moves(query_given), .taken(taken));
    assign out_valid = write != read;
    assign out_word = words[read[PLACE - 1:0]];
    always @(posedge clock) begin
        if (query_given) words[write[PLACE - 1:0]] <= query;
        write <= reset ? {(PLACE + 1){1'b0}} : write + query_given;
        read <= reset ? {(PLACE + 1){1'b0}} : read + taken;
    end
endmodule
