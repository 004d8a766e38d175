// A queue in front of a chain. It has no ready: a word comes only where a place is left, which the link of its stream knows.
module @TOP@_queue(clock, reset, in_valid, in_word, out_valid, out_ready, out_word);
    parameter WIDTH = 1;
    // The queue has 2^PLACE places.
    parameter PLACE = 1;
    input wire clock;
    input wire reset;
    input wire in_valid;
    input wire [WIDTH - 1:0] in_word;
    output wire out_valid;
    input wire out_ready;
    output wire [WIDTH - 1:0] out_word;
    reg [WIDTH - 1:0] words [0:(1 << PLACE) - 1];
    // The places of the next word to write and to give; one more bit says whether all are full where the places are the same.
    reg [PLACE:0] write;
    reg [PLACE:0] read;
    initial write = {(PLACE + 1){1'b0}};
    initial read = {(PLACE + 1){1'b0}};
    assign out_valid = write != read;
    assign out_word = words[read[PLACE - 1:0]];
    always @(posedge clock) begin
        if (in_valid) words[write[PLACE - 1:0]] <= in_word;
        write <= reset ? {(PLACE + 1){1'b0}} : write + in_valid;
        read <= reset ? {(PLACE + 1){1'b0}} : read + (out_valid & out_ready);
    end
endmodule
