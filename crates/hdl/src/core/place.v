// A place for one word. Its ready depends on its own state alone, so no path leads through it.
module @TOP@_place(clock, reset, in_valid, in_ready, in_word, out_valid, out_ready, out_word);
    parameter WIDTH = 1;
    input wire clock;
    input wire reset;
    input wire in_valid;
    output wire in_ready;
    input wire [WIDTH - 1:0] in_word;
    output wire out_valid;
    input wire out_ready;
    output wire [WIDTH - 1:0] out_word;
    reg full;
    reg [WIDTH - 1:0] word;
    initial full = 1'b0;
    assign in_ready = ~full;
    assign out_valid = full;
    assign out_word = word;
    always @(posedge clock) begin
        full <= ~reset & (full ? ~out_ready : in_valid);
        if (~full) word <= in_word;
    end
endmodule
