// The queue of queries in front of a chain. The stream gives it a word only where it has a place.
module @TOP@_query_queue(clock, reset, in_valid, in_word, out_valid, out_ready, out_word, taken);
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
    output wire taken;
    reg [WIDTH - 1:0] words [0:(1 << PLACE) - 1];
    // The places of the next word to write and to give; one more bit says whether all are full where the places are the same.
    reg [PLACE:0] write;
    reg [PLACE:0] read;
    initial write = {(PLACE + 1){1'b0}};
    initial read = {(PLACE + 1){1'b0}};
    assign taken = out_valid & out_ready;
    assign out_valid = write != read;
    assign out_word = words[read[PLACE - 1:0]];
    always @(posedge clock) begin
        if (in_valid) words[write[PLACE - 1:0]] <= in_word;
        write <= reset ? {(PLACE + 1){1'b0}} : write + in_valid;
        read <= reset ? {(PLACE + 1){1'b0}} : read + taken;
    end
endmodule
