// A slice of a stream. It has two places, so that no ready passes through it.
module @TOP@_slice(clock, reset, in_valid, in_ready, in_word, out_valid, out_ready, out_word);
    parameter WIDTH = 1;
    input wire clock;
    input wire reset;
    input wire in_valid;
    output wire in_ready;
    input wire [WIDTH - 1:0] in_word;
    output wire out_valid;
    input wire out_ready;
    output wire [WIDTH - 1:0] out_word;
    reg first_full;
    reg second_full;
    reg [WIDTH - 1:0] first_word;
    reg [WIDTH - 1:0] second_word;
    initial first_full = 1'b0;
    initial second_full = 1'b0;
    wire first_takes = ~first_full | out_ready;
    assign in_ready = ~second_full;
    assign out_valid = first_full;
    assign out_word = first_word;
    always @(posedge clock) begin
        if (first_takes) begin
            first_full <= second_full | (in_valid & in_ready);
            second_full <= 1'b0;
            if (second_full) first_word <= second_word;
            else first_word <= in_word;
        end else if (in_valid & in_ready) second_full <= 1'b1;
        if (~second_full) second_word <= in_word;
        if (reset) begin
            first_full <= 1'b0;
            second_full <= 1'b0;
        end
    end
endmodule
